/*---------------------------------------------------------------------------*\
    cghsFoam | coarse-grained hard spheres in OpenFOAM
    GPL-3.0-or-later, see LICENSE
\*---------------------------------------------------------------------------*/

#include "column.H"
#include "complaint.H"

#include <sstream>

constexpr Foam::scalar Foam::cghs::column::d;
constexpr Foam::scalar Foam::cghs::column::mass;
constexpr Foam::scalar Foam::cghs::column::deltaT;
constexpr Foam::scalar Foam::cghs::column::g;


namespace Foam
{
namespace cghs
{

static autoPtr<contactModel> modelOf(const column::settings& s)
{
    std::ostringstream text;
    text<< "contactModel hardSphere; hardSphereCoeffs { parcelParcel {"
        << " restitutionCoefficient " << s.e << ';'
        << " tangentialRestitutionCoefficient 0.95;"
        << " frictionCoefficient 0.1; }"
        << " parcelWall { $parcelParcel; } restitutionScaling unscaled; "
        << s.correction << '}';

    return contactModel::New(dictionaryOf(text.str().c_str()), 1);
}


//- What a contact of the step before left for this one
static contactMemory memoryOf(const contact& c, const contactList& former)
{
    forAll(former.memories, i)
    {
        if (former.contacts[i].slot == c.slot)
        {
            return former.memories[i];
        }
    }
    return contactMemory();
}

}
}


std::string Foam::cghs::velocityCorrectionEntries
(
    const label nSweeps,
    const scalar overlapShare
)
{
    std::ostringstream text;
    text<< "correctionModel velocity; velocityCoeffs { nSweeps " << nSweeps
        << "; overlapShare " << overlapShare << "; velocityShare 1; }";
    return text.str();
}


Foam::cghs::column::column
(
    const label n,
    const settings& s,
    const scalar gap
)
:
    settings_(s),
    model_(modelOf(s)),
    n_(n),
    scene_(n + 1)
{
    for (label i = 0; i < n; ++i)
    {
        const scalar z = (0.5 + i)*d + (i + 1)*gap;
        scene_.spheres[i] = sphere(vector(0, 0, z), d/2);
        scene_.motions[i] = motion(Zero, 1/mass);
    }
}


Foam::cghs::contact Foam::cghs::column::contactBelow(const label i) const
{
    const label below = i == 0 ? n_ : i - 1;
    const List<sphere>& s = scene_.spheres;

    return makeContact
    (
        i,
        below,
        i == 0 ? contact::parcelWall : contact::parcelParcel,
        i,
        s[below].x - s[i].x,
        s[i].r + s[below].r
    );
}


void Foam::cghs::column::findContacts()
{
    contactList former;
    former.swap(scene_);

    for (label i = 0; i < n_; ++i)
    {
        const label above = settings_.topDown ? n_ - 1 - i : i;
        const contact c = contactBelow(above);
        const contactMemory memory(memoryOf(c, former));

        // A gap is only a contact if it bore load
        if (c.overlap > 0 || memory.load > 0)
        {
            scene_.append(c, memory);
        }
    }

    if (!model_->needsMemory())
    {
        scene_.memories.clear();
    }
}


void Foam::cghs::column::kick(const scalar share)
{
    for (label i = 0; i < n_; ++i)
    {
        scene_.motions[i].v.z() -= share*g*deltaT;
    }
}


void Foam::cghs::column::move()
{
    for (label i = 0; i < n_; ++i)
    {
        scene_.spheres[i].x += deltaT*scene_.motions[i].v + scene_.shifts[i];
    }
}


void Foam::cghs::column::step()
{
    bodies b(scene_.view());
    const stepScales scales{deltaT, g*deltaT};

    scene_.shifts = Zero;
    findContacts();
    kick(settings_.kickBefore);
    for (label sweepi = 0; sweepi < model_->nImpactSweeps(); ++sweepi)
    {
        model_->sweep(sweepi, scene_, b, scales);
    }
    kick(1 - settings_.kickBefore);

    for
    (
        label sweepi = model_->nImpactSweeps();
        sweepi < model_->nSweeps();
        ++sweepi
    )
    {
        model_->sweep(sweepi, scene_, b, scales);
    }
    move();
}


Foam::scalar Foam::cghs::column::overlap() const
{
    scalar largest = -GREAT;
    for (label i = 0; i < n_; ++i)
    {
        largest = max(largest, contactBelow(i).overlap);
    }
    return largest/d;
}


Foam::scalar Foam::cghs::column::restlessness() const
{
    scalar sum = 0;
    for (label i = 0; i < n_; ++i)
    {
        sum += magSqr(scene_.motions[i].v);
    }
    return sum/n_/sqr(g*deltaT);
}

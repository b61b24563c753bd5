/*---------------------------------------------------------------------------*\
    cghsFoam | coarse-grained hard spheres in OpenFOAM
    GPL-3.0-or-later, see LICENSE
\*---------------------------------------------------------------------------*/

#include "reactorBalance.H"


Foam::cghs::reactorBalance::reactorBalance
(
    const reactionScheme& scheme,
    const content& start
)
:
    scheme_(scheme)
{
    items_.append({"mass", false, false, 0, 0, 0});
    wordHashSet elements;
    for (const substances* list : {&scheme.fluid(), &scheme.solids()})
    {
        for (const substance& s : *list)
        {
            elements.insert(s.elements().toc());
        }
    }
    wordHashSet missed;
    for (const auto* place : {&scheme.inParticles(), &scheme.inFluid()})
    {
        for (const reaction& r : *place)
        {
            missed.insert(r.equation().defects().toc());
        }
    }
    for (const word& element : elements.sortedToc())
    {
        items_.append({element, true, missed.found(element), 0, 0, 0});
    }
    if (scheme.energetic())
    {
        items_.append({"enthalpy", false, false, 0, 0, 0});
    }

    const scalarField now(count(start));
    forAll(items_, i)
    {
        items_[i].start = now[i];
    }
}


Foam::scalarField Foam::cghs::reactorBalance::count(const content& c) const
{
    scalarField sums(items_.size(), 0);

    const auto add = [&](const substances& list, const scalarField& n)
    {
        sums[0] += list.massOf(n);
        forAll(list, k)
        {
            forAll(items_, i)
            {
                const auto e = list[k].elements().cfind(items_[i].name);
                if (e.found())
                {
                    sums[i] += n[k]*e.val();
                }
            }
        }
    };
    add(scheme_.fluid(), c.fluid);
    add(scheme_.solids(), c.solids);

    if (scheme_.energetic())
    {
        sums.last() = c.enthalpy;
    }
    return sums;
}


void Foam::cghs::reactorBalance::set
(
    const content& stored,
    const content& passed
)
{
    const scalarField now(count(stored));
    const scalarField through(count(passed));
    forAll(items_, i)
    {
        items_[i].stored = now[i];
        items_[i].passed = through[i];
    }
}


Foam::scalar Foam::cghs::reactorBalance::defect(const item& i) const
{
    scalar size = max(i.size(), VSMALL);
    if (i.isElement)
    {
        // Not the dust of an element that there is not: a mole in a kilogram
        size = max(size, items_[0].size());
        for (const item& other : items_)
        {
            size = other.isElement ? max(size, other.size()) : size;
        }
    }
    return mag(i.missing())/size;
}


Foam::scalar Foam::cghs::reactorBalance::worst() const
{
    scalar largest = 0;
    for (const item& i : items_)
    {
        largest = max(largest, i.lumped ? 0 : defect(i));
    }
    return largest;
}


void Foam::cghs::reactorBalance::report(Ostream& os) const
{
    os  << "Balance since the start (kg, mol of atoms, J)" << nl;
    for (const item& i : items_)
    {
        os  << "    " << i.name << ": stored " << i.stored << ", "
            << i.stored - i.start << " more than at the start; in less out "
            << i.passed << "; relative defect " << defect(i)
            << (i.lumped ? ", as lumped reactions miss it" : "") << nl;
    }
}

/*---------------------------------------------------------------------------*\
    cghsFoam | coarse-grained hard spheres in OpenFOAM
    GPL-3.0-or-later, see LICENSE
\*---------------------------------------------------------------------------*/

#include "cellKernels.H"
#include "closestPoint.H"
#include "PstreamReduceOps.H"
#include "ops.H"

namespace Foam
{
namespace cghs
{

//- Reach of the kernel in cubes: 1.5 sides, in moments of second order
static const scalar maxReach = 1.5*::sqrt(12.0);

//- A kernel that ends on the rim of its own cell would leave none for points
//  there
static const scalar minReach = 1.02;


//- The triangular U with U^T U = a: lengths |U x| are those that a measures.
//  A direction that a does not measure is left out
static tensor lengthsOf(const symmTensor& a)
{
    tensor u(Zero);

    const auto over = [](const scalar x, const scalar pivot)
    {
        return pivot > 0 ? x/pivot : 0;
    };

    u.xx() = ::sqrt(max(a.xx(), scalar(0)));
    u.xy() = over(a.xy(), u.xx());
    u.xz() = over(a.xz(), u.xx());
    u.yy() = ::sqrt(max(a.yy() - sqr(u.xy()), scalar(0)));
    u.yz() = over(a.yz() - u.xy()*u.xz(), u.yy());
    u.zz() = ::sqrt(max(a.zz() - sqr(u.xz()) - sqr(u.yz()), scalar(0)));

    return u;
}


//- Distance of a face from x, where U measures; not followed up, and returned
//  as it is found, where it must exceed a bound
static scalar distance
(
    const polyMesh& mesh,
    const label facei,
    const point& x,
    const tensor& U,
    const scalar bound
)
{
    const face& f = mesh.faces()[facei];
    const pointField& points = mesh.points();
    const point centre(U & (mesh.faceCentres()[facei] - x));
    scalar least = GREAT;

    forAll(f, i)
    {
        const point a(U & (points[f[i]] - x));
        const point b(U & (points[f.nextLabel(i)] - x));
        const vector normal((a - centre) ^ (b - centre));
        const scalar size = mag(normal);

        if (size > VSMALL && mag(centre & normal) > bound*size)
        {
            continue;
        }

        least = min(least, mag(closestPoint(centre, a, b, Zero).point));
    }

    return least;
}

} // End namespace cghs
} // End namespace Foam

// * * * * * * * * * * * * * * * * The shapes  * * * * * * * * * * * * * * * //

Foam::symmTensor Foam::cghs::cellKernels::moment(const label celli) const
{
    const point& centre = mesh_.cellCentres()[celli];
    symmTensor sum(Zero);
    scalar volume = 0;

    for (const label facei : mesh_.cells()[celli])
    {
        const face& f = mesh_.faces()[facei];
        const vector c(mesh_.faceCentres()[facei] - centre);

        forAll(f, i)
        {
            const vector a(mesh_.points()[f[i]] - centre);
            const vector b(mesh_.points()[f.nextLabel(i)] - centre);
            const scalar v = mag(c & (a ^ b))/6;

            volume += v;
            sum += v/20*(sqr(a) + sqr(b) + sqr(c) + sqr(a + b + c));
        }
    }

    return sum/max(volume, VSMALL);
}


Foam::List<Foam::symmTensor> Foam::cghs::cellKernels::shapes() const
{
    List<symmTensor> shape(rings_.nCells());
    const Vector<label>& used = mesh_.geometricD();

    const symmTensor mask
    (
        used.x() > 0,
        used.x() > 0 && used.y() > 0,
        used.x() > 0 && used.z() > 0,
        used.y() > 0,
        used.y() > 0 && used.z() > 0,
        used.z() > 0
    );
    const symmTensor rest(1 - mask.xx(), 0, 0, 1 - mask.yy(), 0, 1 - mask.zz());

    forAll(shape, celli)
    {
        const symmTensor m(moment(celli));
        const scalar scale = tr(m);

        shape[celli] = cmptMultiply(mask, m) + scale*rest;
        shape[celli] =
            cmptMultiply(mask, inv(shape[celli]/scale))/scale;
    }

    return shape;
}


void Foam::cghs::cellKernels::endBefore
(
    const label celli,
    const UList<symmTensor>& shape,
    scalarList& reach
) const
{
    const SubList<label> ring(rings_.ring(celli));

    for (const label facei : mesh_.cells()[celli])
    {
        const label boundary = facei - mesh_.nInternalFaces();

        if (boundary >= 0 && !rings_.passed()[boundary])
        {
            continue;
        }

        const labelHashSet touching(rings_.aboutFace(facei));

        for (const label image : ring)
        {
            if (touching.found(image))
            {
                continue;
            }

            scalar& end = reach[rings_.slot(image)];

            // A hair less, lest round-off tells faces of a row apart
            end =
                min
                (
                    end,
                    distance
                    (
                        mesh_,
                        facei,
                        rings_.centre(image),
                        lengthsOf(shape[rings_.slot(image)]),
                        (1 - 1e-9)*end
                    )
                );
        }
    }
}


Foam::scalar Foam::cghs::cellKernels::extent
(
    const label celli,
    const symmTensor& shape
) const
{
    const tensor U(lengthsOf(shape));
    scalar furthest = 0;

    for (const label pointi : mesh_.cellPoints()[celli])
    {
        furthest =
            max
            (
                furthest,
                mag(U & (mesh_.points()[pointi] - mesh_.cellCentres()[celli]))
            );
    }

    return furthest;
}


Foam::scalarList Foam::cghs::cellKernels::reaches
(
    const UList<symmTensor>& shape
) const
{
    List<symmTensor> bySlot(shape);
    rings_.fetch(bySlot);

    scalarList reach(rings_.nSlots(), maxReach);

    for (label celli = 0; celli < rings_.nCells(); ++celli)
    {
        endBefore(celli, bySlot, reach);
    }
    rings_.collect(reach, minEqOp<scalar>(), maxReach);

    for (label celli = 0; celli < rings_.nCells(); ++celli)
    {
        reach[celli] =
            max(reach[celli], minReach*extent(celli, shape[celli]));
    }

    return reach;
}

// * * * * * * * * * * * * * * * * The factors * * * * * * * * * * * * * * * //

template<class Visitor>
void Foam::cghs::cellKernels::visitSamples
(
    const label celli,
    const Visitor& visitor
) const
{
    const point& centre = mesh_.cellCentres()[celli];

    for (const label facei : mesh_.cells()[celli])
    {
        const face& f = mesh_.faces()[facei];
        const point& c = mesh_.faceCentres()[facei];

        forAll(f, i)
        {
            const point& a = mesh_.points()[f[i]];
            const point& b = mesh_.points()[f.nextLabel(i)];

            visitor
            (
                0.25*(centre + a + b + c),
                mag((c - centre) & ((a - centre) ^ (b - centre)))/6
            );
        }
    }
}


void Foam::cghs::cellKernels::integrate
(
    const label celli,
    scalarList& sums
) const
{
    const SubList<label> ring(rings_.ring(celli));
    scalarList shares(ring.size(), Zero);

    near_.gather(kernels_, ring);

    visitSamples
    (
        celli,
        [&](const point& x, const scalar volume)
        {
            const scalar sum = near_.weigh(x);

            if (sum < VSMALL)
            {
                sums[celli] += volume;
                return;
            }

            const scalar scale = volume/sum;

            forAll(shares, i)
            {
                shares[i] += scale*near_.weights()[i];
            }
        }
    );

    forAll(ring, i)
    {
        sums[rings_.slot(ring[i])] += shares[i];
    }
}


Foam::scalarList Foam::cghs::cellKernels::integrals() const
{
    scalarList sums(rings_.nSlots(), Zero);

    for (label celli = 0; celli < rings_.nCells(); ++celli)
    {
        integrate(celli, sums);
    }

    rings_.collect(sums, plusEqOp<scalar>(), scalar(0));
    return sums;
}


void Foam::cghs::cellKernels::adopt(scalarList&& factors)
{
    rings_.fetch(factors);

    for (kernel& k : kernels_)
    {
        k.factor = factors[k.slot];
    }

    near_.forget();
}


Foam::scalar Foam::cghs::cellKernels::improve
(
    scalarList& factors,
    scalarList& steps
) const
{
    // m_c <- m_c V_c/int w_c turns an error of ln m into P times it, with
    // P_ck = int w_c w_k/V_c: one that is smooth, as beside cells of another
    // size, hardly falls. Twice the step, with half of the last one in it, is
    // as stable, since P has eigenvalues from 0 to 1, and where one step leaves
    // 0.96 of the error it leaves 0.71
    constexpr scalar length = 2;
    constexpr scalar momentum = 0.5;

    // Far from the end steps could grow without bound
    constexpr scalar longest = 0.7;

    const scalarList sums(integrals());
    scalar worst = 0;

    forAll(factors, celli)
    {
        const scalar ratio =
            mesh_.cellVolumes()[celli]/max(sums[celli], VSMALL);
        const scalar missing = max(min(::log(ratio), longest), -longest);

        worst = max(worst, mag(ratio - 1));
        steps[celli] = length*missing + momentum*steps[celli];
        factors[celli] *= ::exp(steps[celli]);
    }

    return returnReduce(worst, maxOp<scalar>());
}


void Foam::cghs::cellKernels::setFactors()
{
    constexpr label patience = 50;
    constexpr scalar enough = 1e-3;

    scalarList factors(rings_.nCells(), scalar(1));
    scalarList steps(rings_.nCells(), Zero);
    scalar worst = GREAT;

    for (label round = 0; round < patience && worst > enough; ++round)
    {
        worst = improve(factors, steps);
        adopt(scalarList(factors));
    }

    if (worst > enough)
    {
        WarningInFunction
            << "Parcels that fill the mesh evenly would fill a cell by "
            << 100*worst << " % too much or too little: its neighbours differ"
            << " so much from it in size or shape" << endl;
    }
}

// * * * * * * * * * * * * * * * * * Public  * * * * * * * * * * * * * * * * //

Foam::cghs::cellKernels::cellKernels
(
    const polyMesh& mesh,
    const labelUList& plates
)
:
    mesh_(mesh),
    rings_(mesh, plates),
    kernels_(rings_.nImages()),
    near_(rings_.maxSize())
{
    List<symmTensor> shape(shapes());
    const scalarList reach(reaches(shape));

    forAll(shape, celli)
    {
        shape[celli] /= sqr(reach[celli]);
    }
    rings_.fetch(shape);

    forAll(kernels_, image)
    {
        const label slot = rings_.slot(image);
        kernels_[image] =
            kernel{rings_.centre(image), shape[slot], 1, slot};
    }

    setFactors();
}

/*---------------------------------------------------------------------------*\
    cghsFoam | coarse-grained hard spheres in OpenFOAM
    GPL-3.0-or-later, see LICENSE
\*---------------------------------------------------------------------------*/

#include "solidsProfile.H"
#include "arena.H"
#include "checkedEntry.H"
#include "knownEntries.H"
#include "PstreamReduceOps.H"
#include "volFields.H"

// * * * * * * * * * * * * * * * * The bins  * * * * * * * * * * * * * * * * //

namespace Foam
{
namespace cghs
{

//- A mandatory vector, made one of unit length
static vector unitVector(const dictionary& dict, const word& entry)
{
    const vector v(dict.get<vector>(entry));

    if (!(mag(v) > VSMALL))
    {
        FatalIOErrorInFunction(dict)
            << "Entry " << entry << " is " << v
            << " but must be a direction: a vector of some length" << nl
            << exit(FatalIOError);
    }

    return v/mag(v);
}

} // End namespace cghs
} // End namespace Foam


Foam::scalarField Foam::cghs::solidsProfile::coordinates
(
    const dictionary& dict,
    const fvMesh& mesh
)
{
    const vectorField& centres = mesh.cellCentres();

    if (dict.found("along") == dict.found("axis"))
    {
        FatalIOErrorInFunction(dict)
            << "Profile " << dict.dictName() << " needs either along, the"
            << " direction of a line, or axis and origin, for the distance"
            << " from an axis; " << (dict.found("axis") ? "both" : "none")
            << " of them found" << nl
            << exit(FatalIOError);
    }

    if (dict.found("along"))
    {
        return centres & unitVector(dict, "along");
    }

    const vector axis(unitVector(dict, "axis"));
    const vectorField arms(centres - dict.get<vector>("origin"));

    return mag(arms - (arms & axis)*axis);
}


Foam::boolList Foam::cghs::solidsProfile::inSlab
(
    const dictionary& dict,
    const fvMesh& mesh
)
{
    boolList inside(mesh.nCells(), true);

    if (dict.found("slab"))
    {
        const dictionary& slab = dict.subDict("slab");
        warnUnknownEntries
        (
            slab,
            wordList({"normal", "position", "thickness"})
        );

        const vector normal(unitVector(slab, "normal"));
        const scalar position = slab.get<scalar>("position");
        const scalar half = 0.5*positiveScalar(slab, "thickness");
        const vectorField& centres = mesh.cellCentres();

        forAll(inside, celli)
        {
            inside[celli] = mag((centres[celli] & normal) - position) <= half;
        }
    }

    return inside;
}


void Foam::cghs::solidsProfile::sortCells
(
    const dictionary& dict,
    const fvMesh& mesh
)
{
    const scalarField coordinate(coordinates(dict, mesh));
    const boolList inside(inSlab(dict, mesh));

    forAll(binOf_, celli)
    {
        const scalar place = (coordinate[celli] - from_)/width_;

        if (inside[celli] && place >= 0 && place < bins_.size())
        {
            binOf_[celli] = label(place);
            volumes_[binOf_[celli]] += mesh.V()[celli];
        }
    }

    reduce(volumes_, sumOp<scalarField>());

    forAll(volumes_, bin)
    {
        if (!(volumes_[bin] > 0))
        {
            FatalIOErrorInFunction(dict)
                << "No cell has its centre in bin " << bin << " of "
                << bins_.size() << " of profile " << name_ << ", from "
                << from_ + bin*width_ << " to " << from_ + (bin + 1)*width_
                << nl
                << "Choose fewer bins, a thicker slab, or a range from .. to"
                << " within the mesh " << mesh.bounds() << nl
                << exit(FatalIOError);
        }
    }
}


Foam::cghs::solidsProfile::solidsProfile
(
    const dictionary& dict,
    const fvMesh& mesh
)
:
    name_(dict.dictName()),
    from_(dict.get<scalar>("from")),
    width_
    (
        (scalarInRange(dict, "to", from_ + SMALL*max(1, mag(from_)), GREAT)
      - from_)/labelFrom(dict, "bins", 1)
    ),
    binOf_(mesh.nCells(), -1),
    volumes_(labelFrom(dict, "bins", 1), Zero),
    bins_(volumes_.size(), blockMoments(N))
{
    warnUnknownEntries
    (
        dict,
        wordList({"along", "axis", "origin", "from", "to", "bins", "slab"})
    );

    sortCells(dict, mesh);
}

// * * * * * * * * * * * * * * * The statistics  * * * * * * * * * * * * * * //

void Foam::cghs::solidsProfile::sum
(
    const arena& parcels,
    SubList<scalar>& sums
) const
{
    for (label i = 0; i < parcels.size(); ++i)
    {
        const label bin = binOf_[parcels.cells[i]];

        if (bin >= 0)
        {
            const vector& v = parcels.motions[i].v;
            const scalar mass = parcels.motions[i].mass();
            scalar* s = &sums[bin*N];

            s[FRACTION] += parcels.volume(i);
            s[MASS] += mass;
            s[SQUARE] += mass*magSqr(v);
            for (direction d = 0; d < 3; ++d)
            {
                s[MOMENTUM + d] += mass*v[d];
            }
        }
    }
}


void Foam::cghs::solidsProfile::add
(
    const UList<scalar>& sums,
    const scalar deltaT
)
{
    scalarField sample(N, deltaT);

    forAll(bins_, bin)
    {
        for (label k = 1; k < N; ++k)
        {
            sample[k] = deltaT*sums[bin*N + k]/volumes_[bin];
        }
        bins_[bin].add(sample);
    }
}


Foam::cghs::blockMoments::estimate Foam::cghs::solidsProfile::temperature
(
    const blockMoments& bin
)
{
    scalarField gradient(N, Zero);
    const scalar M = bin.mean(MASS);

    if (!(M > 0))
    {
        return bin.function(0, gradient);
    }

    scalar squaredSpeed = 0;
    for (direction d = 0; d < 3; ++d)
    {
        const scalar U = bin.mean(MOMENTUM + d)/M;
        squaredSpeed += sqr(U);
        gradient[MOMENTUM + d] = -2*U/(3*M);
    }

    const scalar meanSquare = bin.mean(SQUARE)/M;
    gradient[SQUARE] = 1/(3*M);
    gradient[MASS] = (2*squaredSpeed - meanSquare)/(3*M);

    return bin.function((meanSquare - squaredSpeed)/3, gradient);
}


void Foam::cghs::solidsProfile::write(Ostream& os) const
{
    os  << "# coordinate";
    for
    (
        const char* column
      : {
            "solidsFraction", "velocityX", "velocityY", "velocityZ",
            "massFluxX", "massFluxY", "massFluxZ", "granularTemperature"
        }
    )
    {
        os  << ' ' << column << ' ' << column << "Error";
    }
    os  << " certain" << nl;

    forAll(bins_, bin)
    {
        const blockMoments& b = bins_[bin];
        bool certain = true;

        os  << from_ + (bin + 0.5)*width_;
        for
        (
            const blockMoments::estimate& e
          : {
                b.ratio(FRACTION, DURATION),
                b.ratio(MOMENTUM, MASS),
                b.ratio(MOMENTUM + 1, MASS),
                b.ratio(MOMENTUM + 2, MASS),
                b.ratio(MOMENTUM, DURATION),
                b.ratio(MOMENTUM + 1, DURATION),
                b.ratio(MOMENTUM + 2, DURATION),
                temperature(b)
            }
        )
        {
            os  << ' ' << e.value << ' ' << e.error;
            certain = certain && e.certain;
        }
        os  << ' ' << label(certain) << nl;
    }
    os.flush();
}

// * * * * * * * * * * * * * * * Across a restart  * * * * * * * * * * * * * //

Foam::List<Foam::scalar> Foam::cghs::solidsProfile::state() const
{
    DynamicList<scalar> numbers;

    for (const blockMoments& bin : bins_)
    {
        numbers.append(bin.state());
    }

    return List<scalar>(std::move(numbers));
}


bool Foam::cghs::solidsProfile::setState(const UList<scalar>& state)
{
    // All bins have seen as many samples
    const label size = state.size()/bins_.size();
    bool good = size*bins_.size() == state.size();

    for (label bin = 0; good && bin < bins_.size(); ++bin)
    {
        good = bins_[bin].setState(SubList<scalar>(state, size, bin*size));
    }

    return good;
}

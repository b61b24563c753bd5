/*---------------------------------------------------------------------------*\
    cghsFoam | coarse-grained hard spheres in OpenFOAM
    GPL-3.0-or-later, see LICENSE
\*---------------------------------------------------------------------------*/

#include "solidsProfile.H"
#include "arena.H"
#include "cellSlab.H"
#include "checkedEntry.H"
#include "knownEntries.H"
#include "windowReport.H"
#include "PstreamReduceOps.H"
#include "volFields.H"

// * * * * * * * * * * * * * * * * The bins  * * * * * * * * * * * * * * * * //

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


void Foam::cghs::solidsProfile::sortCells
(
    const dictionary& dict,
    const fvMesh& mesh
)
{
    const scalarField coordinate(coordinates(dict, mesh));
    const boolList inside(cghs::inSlab(dict, mesh));

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
    const UList<label>& places = parcels.places();

    labelList binAt(binOf_);
    parcels.visiting.fetch(binAt);

    for (label i = 0; i < parcels.size(); ++i)
    {
        const label bin = binAt[places[i]];

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


Foam::cghs::blockMoments::derived Foam::cghs::solidsProfile::temperature
(
    const blockMoments& bin
)
{
    blockMoments::derived T{0, scalarField(N, Zero)};
    const scalar M = bin.mean(MASS);

    if (!(M > 0))
    {
        return T;
    }

    scalar squaredSpeed = 0;
    for (direction d = 0; d < 3; ++d)
    {
        const scalar U = bin.mean(MOMENTUM + d)/M;
        squaredSpeed += sqr(U);
        T.gradient[MOMENTUM + d] = -2*U/(3*M);
    }

    const scalar meanSquare = bin.mean(SQUARE)/M;
    T.gradient[SQUARE] = 1/(3*M);
    T.gradient[MASS] = (2*squaredSpeed - meanSquare)/(3*M);
    T.value = (meanSquare - squaredSpeed)/3;

    return T;
}

// * * * * * * * * * * * * * * * * The table * * * * * * * * * * * * * * * * //

namespace Foam
{
namespace cghs
{

//- In the order of solidsProfile::quantities
static const wordList columns
({
    "solidsFraction", "velocityX", "velocityY", "velocityZ",
    "massFluxX", "massFluxY", "massFluxZ", "granularTemperature"
});

} // End namespace cghs
} // End namespace Foam


Foam::List<Foam::cghs::blockMoments::derived>
Foam::cghs::solidsProfile::quantities(const blockMoments& bin)
{
    return List<blockMoments::derived>
    ({
        bin.ratio(FRACTION, DURATION),
        bin.ratio(MOMENTUM, MASS),
        bin.ratio(MOMENTUM + 1, MASS),
        bin.ratio(MOMENTUM + 2, MASS),
        bin.ratio(MOMENTUM, DURATION),
        bin.ratio(MOMENTUM + 1, DURATION),
        bin.ratio(MOMENTUM + 2, DURATION),
        temperature(bin)
    });
}


Foam::List<Foam::List<Foam::cghs::blockMoments::estimate>>
Foam::cghs::solidsProfile::estimates() const
{
    List<List<blockMoments::derived>> rows(bins_.size());
    List<blockErrors> together(columns.size());

    forAll(bins_, bin)
    {
        rows[bin] = quantities(bins_[bin]);

        forAll(together, q)
        {
            together[q].join(bins_[bin].errors(rows[bin][q].gradient));
        }
    }

    List<List<blockMoments::estimate>> result(bins_.size());

    forAll(bins_, bin)
    {
        result[bin].resize(columns.size());

        forAll(together, q)
        {
            result[bin][q] =
                bins_[bin].judge(rows[bin][q], together[q].choose());
        }
    }

    return result;
}


void Foam::cghs::solidsProfile::writeHeader(Ostream& os)
{
    os  << "# coordinate";
    for (const word& column : columns)
    {
        os  << ' ' << column << ' ' << column << "Error";
    }
    os  << " correlationTime windowLongEnough" << nl;
}


void Foam::cghs::solidsProfile::write(Ostream& os, const word& owner) const
{
    const blockMoments& anyBin = bins_[0];
    windowReport report(anyBin.nSamples()*anyBin.mean(DURATION));

    writeHeader(os);

    const List<List<blockMoments::estimate>> rows(estimates());

    forAll(rows, bin)
    {
        scalar longest = 0;
        bool longEnough = true;

        os  << from_ + (bin + 0.5)*width_;
        forAll(columns, q)
        {
            const blockMoments::estimate& e = rows[bin][q];

            os  << ' ' << e.value << ' ' << e.error;
            longest = max(longest, report.correlationTime(e));
            longEnough = longEnough && e.longEnough;
            report.see(columns[q], e);
        }
        os  << ' ' << longest << ' ' << label(longEnough) << nl;
    }
    os.flush();

    report.write(owner + ' ' + name_);
}

// * * * * * * * * * * * * * * * Across a restart  * * * * * * * * * * * * * //

Foam::List<Foam::scalar> Foam::cghs::solidsProfile::state() const
{
    return blockMoments::stateOf(bins_);
}


bool Foam::cghs::solidsProfile::setState(const UList<scalar>& state)
{
    return blockMoments::setStateOf(bins_, state);
}

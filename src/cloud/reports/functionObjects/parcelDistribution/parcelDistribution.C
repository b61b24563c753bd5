/*---------------------------------------------------------------------------*\
    cghsFoam | coarse-grained hard spheres in OpenFOAM
    GPL-3.0-or-later, see LICENSE
\*---------------------------------------------------------------------------*/

#include "parcelDistribution.H"
#include "cellSlab.H"
#include "cghsCloud.H"
#include "checkedEntry.H"
#include "knownEntries.H"
#include "meshNames.H"
#include "parcelNumber.H"
#include "windowReport.H"
#include "PstreamReduceOps.H"
#include "modelList.H"
#include "addToRunTimeSelectionTable.H"

namespace Foam
{
namespace cghs
{
    defineTypeNameAndDebug(parcelDistribution, 0);
    addToRunTimeSelectionTable
    (
        functionObject,
        parcelDistribution,
        dictionary
    );
    describeFunction
    (
        parcelDistribution,
        "how a property is distributed among parcels"
    );
}
}

// * * * * * * * * * * * * * * * Those that leave  * * * * * * * * * * * * * //

Foam::cghs::parcelDistribution::exitCount::exitCount
(
    const word& number,
    const labelList& patches,
    const histogramMeans& bins
)
:
    number(number),
    patches(patches),
    bins(bins),
    sums(bins.nSums(), Zero)
{}


void Foam::cghs::parcelDistribution::exitCount::noteOut
(
    const arena& parcels,
    const label i,
    const label patchi
)
{
    if (patches.found(patchi))
    {
        const parcelNumber x(number, parcels);

        bins.count(sums, x(i), parcels.motions[i].mass());
    }
}

// * * * * * * * * * * * * * * * Construction  * * * * * * * * * * * * * * * //

Foam::cghs::parcelDistribution::parcelDistribution
(
    const word& name,
    const Time& time,
    const dictionary& dict
)
:
    cloudFunctionObject(name, time, dict),
    writeFile(mesh_, name, typeName),
    number_(),
    quantiles_(),
    range_(),
    means_(),
    inside_(),
    exits_(),
    countedStep_(-1)
{
    read(dict);
}


bool Foam::cghs::parcelDistribution::read(const dictionary& dict)
{
    warnUnknownOfFunction
    (
        dict,
        wordList
        ({
            "cloud", "property", "from", "to", "bins", "quantiles", "cellZone",
            "slab", "patches"
        })
    );

    cloudFunctionObject::read(dict);
    writeFile::read(dict);

    if (means_.valid())
    {
        // Asked for again during the run
        keepState();
    }

    readBins(dict);
    findParcels(dict);
    resume(dict);

    return true;
}


void Foam::cghs::parcelDistribution::readBins(const dictionary& dict)
{
    number_ = dict.get<word>("property");

    // cghsFoam -postProcess makes the cloud later than this
    if (!postProcess)
    {
        const wordList valid(parcelNumber::choices(parcels()));

        if (!valid.found(number_))
        {
            FatalIOErrorInFunction(dict)
                << "Entry property is " << number_
                << " but parcels have no number of that name" << nl
                << "Valid choices: " << flatOutput(valid) << nl
                << exit(FatalIOError);
        }
    }

    const scalar from = dict.get<scalar>("from");
    const scalar to =
        scalarInRange(dict, "to", from + SMALL*max(1, mag(from)), GREAT);
    const label bins = labelFrom(dict, "bins", 1);

    range_ = scalarList({from, to, scalar(bins)});
    means_.reset(new histogramMeans(from, to, bins));

    quantiles_ =
        dict.getOrDefault("quantiles", scalarList({0.1, 0.5, 0.9}));

    for (const scalar q : quantiles_)
    {
        if (!(q > 0 && q < 1))
        {
            FatalIOErrorInFunction(dict)
                << "Entry quantiles is " << flatOutput(quantiles_)
                << " but its numbers must be between 0 and 1" << nl
                << exit(FatalIOError);
        }
    }
}


void Foam::cghs::parcelDistribution::findParcels(const dictionary& dict)
{
    exits_.reset();

    if (dict.found("patches"))
    {
        watchExits(dict);
        return;
    }

    inside_ = inSlab(dict, mesh_);

    if (dict.found("cellZone"))
    {
        const label zonei =
            cellZoneNamed
            (
                dict.get<word>("cellZone"),
                "cellZone",
                dict,
                mesh_
            );
        const cellZone& zone = mesh_.cellZones()[zonei];

        forAll(inside_, celli)
        {
            inside_[celli] = inside_[celli] && zone.whichCell(celli) >= 0;
        }
    }
}


void Foam::cghs::parcelDistribution::watchExits(const dictionary& dict)
{
    if (dict.found("cellZone") || dict.found("slab"))
    {
        FatalIOErrorInFunction(dict)
            << "There are both patches, for parcels that leave, and "
            << (dict.found("slab") ? "slab" : "cellZone")
            << ", for parcels in the mesh" << nl
            << "Use two function objects" << nl
            << exit(FatalIOError);
    }
    if (postProcess)
    {
        FatalIOErrorInFunction(dict)
            << "Entry patches asks for parcels that leave, which are not"
            << " written" << nl
            << "Have the function object in controlDict during the run" << nl
            << exit(FatalIOError);
    }

    exits_ =
        std::make_shared<exitCount>(number_, exitPatches(dict), means_());
    parcels().watchedBy(exits_);
    countedStep_ = mesh_.time().timeIndex();
}

// * * * * * * * * * * * * * * * Across a restart  * * * * * * * * * * * * * //

void Foam::cghs::parcelDistribution::keepState()
{
    setProperty("number", number_);
    setProperty("range", range_);
    setProperty("leaving", exits_ ? 1 : 0);
    setProperty("means", means_->state());
}


void Foam::cghs::parcelDistribution::resume(const dictionary& dict)
{
    word formerNumber;
    if (!getProperty("number", formerNumber))
    {
        return;
    }

    scalarList formerRange;
    label formerLeaving = 0;
    List<scalar> state;
    getProperty("range", formerRange);
    getProperty("leaving", formerLeaving);
    getProperty("means", state);

    bool same =
        formerNumber == number_ && formerLeaving == (exits_ ? 1 : 0)
     && formerRange.size() == range_.size();

    forAll(range_, k)
    {
        // They went through a file, with the digits of the case
        same = same && mag(formerRange[k] - range_[k]) <= 1e-5*mag(range_[k]);
    }

    if (!same || !means_->setState(state))
    {
        FatalIOErrorInFunction(dict)
            << "Entries property, from, to, bins and patches ask for "
            << number_ << " over " << flatOutput(range_) << " but until time "
            << mesh_.time().timeName() << " it was " << formerNumber
            << " over " << flatOutput(formerRange)
            << (formerLeaving ? ", of those that leave" : "") << nl
            << "Ask for the same, or rename the function object to start"
            << " anew" << nl
            << exit(FatalIOError);
    }
}

// * * * * * * * * * * * * * * * * The sums  * * * * * * * * * * * * * * * * //

Foam::scalarField Foam::cghs::parcelDistribution::countInside() const
{
    const arena& parcels = this->parcels();
    const UList<label>& places = parcels.places();
    const parcelNumber x(number_, parcels);

    boolList inside(inside_);
    parcels.visiting.fetch(inside);

    scalarField sums(means_->nSums(), Zero);

    for (label i = 0; i < parcels.size(); ++i)
    {
        if (inside[places[i]])
        {
            means_->count(sums, x(i), parcels.motions[i].mass());
        }
    }

    return sums;
}


Foam::scalarField Foam::cghs::parcelDistribution::takeExits()
{
    const label step = mesh_.time().timeIndex();
    const bool known = countedStep_ == step - 1;
    countedStep_ = step;

    const scalarField sums(known ? exits_->sums : scalarField());
    exits_->sums = Zero;

    return sums;
}


bool Foam::cghs::parcelDistribution::execute()
{
    const scalar deltaT = mesh_.time().deltaTValue();
    scalarField sums(exits_ ? takeExits() : countInside());

    if (sums.empty())
    {
        return true;
    }

    reduce(sums, sumOp<scalarField>());

    if (!exits_)
    {
        sums *= deltaT;
    }
    means_->add(sums, deltaT);

    return true;
}

// * * * * * * * * * * * * * * * * The tables  * * * * * * * * * * * * * * * //

void Foam::cghs::parcelDistribution::writeHeader(Ostream& os) const
{
    DynamicList<word> columns;

    columns.append(exits_ ? "outflow" : "mass");
    columns.append("mean");
    columns.append("deviation");
    for (const scalar q : quantiles_)
    {
        columns.append("quantile(" + Foam::name(q) + ')');
    }

    os  << "# time";
    for (const word& column : columns)
    {
        os  << ' ' << column << ' ' << column << "Error";
    }
    os  << " below above correlationTime windowLongEnough" << endl;
}


void Foam::cghs::parcelDistribution::writeRow
(
    Ostream& os,
    windowReport& report
) const
{
    DynamicList<blockMoments::estimate> estimates;

    estimates.append(means_->massByWeight());
    estimates.append(means_->mean());
    estimates.append(means_->deviation());
    for (const scalar q : quantiles_)
    {
        estimates.append(means_->quantile(q));
    }

    scalar longest = 0;
    bool longEnough = true;

    os  << mesh_.time().value();
    for (const blockMoments::estimate& e : estimates)
    {
        os  << ' ' << e.value << ' ' << e.error;
        longest = max(longest, report.correlationTime(e));
        longEnough = longEnough && e.longEnough;
    }
    report.see("mean", estimates[1]);
    report.see("deviation", estimates[2]);

    os  << ' ' << means_->lost() << ' ' << means_->lostAbove() << ' '
        << longest << ' ' << label(longEnough) << endl;
}


void Foam::cghs::parcelDistribution::writeBins
(
    Ostream& os,
    windowReport& report
) const
{
    const List<blockMoments::estimate> shares(means_->shares());
    const List<blockMoments::estimate> below(means_->cumulative());

    os  << "# x share shareError cumulative cumulativeError" << nl;
    forAll(shares, bin)
    {
        os  << means_->middle(bin)
            << ' ' << shares[bin].value << ' ' << shares[bin].error
            << ' ' << below[bin].value << ' ' << below[bin].error << nl;
        report.see("share", shares[bin]);
    }
    os.flush();
}


bool Foam::cghs::parcelDistribution::write()
{
    if (means_->nSamples() > 0)
    {
        windowReport report(means_->nSamples()*means_->weight());

        if (writeToFile())
        {
            if (!filePtr_.valid())
            {
                resetFile(fileName_);
                writeHeader(file());
                file().precision(writePrecision_);
            }
            writeRow(file(), report);
        }

        autoPtr<OFstream> table
        (
            createFile("histogram", mesh_.time().value())
        );
        if (table.valid())
        {
            table->precision(writePrecision_);
            writeBins(table(), report);
        }
        report.write(name());
    }
    keepState();

    return true;
}

/*---------------------------------------------------------------------------*\
    cghsFoam | coarse-grained hard spheres in OpenFOAM
    GPL-3.0-or-later, see LICENSE
\*---------------------------------------------------------------------------*/

#include "solidsAverages.H"
#include "arena.H"
#include "blockErrors.H"
#include "checkedEntry.H"
#include "knownEntries.H"
#include "parcelNumber.H"
#include "PstreamReduceOps.H"
#include "modelList.H"
#include "addToRunTimeSelectionTable.H"

namespace Foam
{
namespace cghs
{
    defineTypeNameAndDebug(solidsAverages, 0);
    addToRunTimeSelectionTable(functionObject, solidsAverages, dictionary);
    describeFunction
    (
        solidsAverages,
        "means and variances of the solids, as fields"
    );


//- Take a sample into a mean, of which it then is this share
template<class Type>
static void addTo(Field<Type>& mean, const Field<Type>& x, const scalar share)
{
    mean += share*(x - mean);
}


//- The same with the variance about the mean, to be called before addTo
template<class Variance, class Type>
static void addToVariance
(
    Field<Variance>& variance,
    const Field<Type>& mean,
    const Field<Type>& x,
    const scalar share
)
{
    variance = (1 - share)*(variance + share*sqr(x - mean));
}


//- Name of a field that keeps the blocks
static word stateName(const label k)
{
    return "blockState" + Foam::name(k);
}

} // End namespace cghs
} // End namespace Foam

// * * * * * * * * * * * * * * * Construction  * * * * * * * * * * * * * * * //

template<class Type>
Foam::GeometricField<Type, Foam::fvPatchField, Foam::volMesh>
Foam::cghs::solidsAverages::averageField
(
    const word& name,
    const dimensionSet& dimensions
) const
{
    return cellField<Type>(this->name() + ':' + name, dimensions);
}


Foam::cghs::solidsAverages::solidsAverages
(
    const word& name,
    const Time& time,
    const dictionary& dict
)
:
    cloudFunctionObject(name, time, dict),
    duration_(0),
    fraction_(averageField<scalar>("fractionMean", dimless)),
    fractionVariance_(averageField<scalar>("fractionPrime2Mean", dimless)),
    density_(averageField<scalar>("densityMean", dimDensity)),
    flux_(averageField<vector>("massFluxMean", dimDensity*dimVelocity)),
    fluxVariance_
    (
        averageField<symmTensor>
        (
            "massFluxPrime2Mean",
            sqr(dimDensity*dimVelocity)
        )
    ),
    stress_(mesh_.nCells(), Zero),
    inCell_(mesh_.nCells(), Zero),
    voidage_(averageField<scalar>("voidageMean", dimless)),
    velocity_(averageField<vector>("velocityMean", dimVelocity)),
    velocityVariance_
    (
        averageField<symmTensor>("velocityPrime2Mean", sqr(dimVelocity))
    ),
    temperature_
    (
        averageField<scalar>("granularTemperature", sqr(dimVelocity))
    ),
    temperatureInCell_
    (
        averageField<scalar>("granularTemperatureInCell", sqr(dimVelocity))
    )
{
    warnUnknownOfFunction(dict, wordList({"cloud", "blockTime", "properties"}));
    read(dict);
    makeProperties(dict);

    if (getProperty("duration", duration_))
    {
        checkResumed(dict);
        resumeAll();
    }
    if (dict.found("blockTime"))
    {
        makeBlocks(dict);
    }
}


template<class Type>
void Foam::cghs::solidsAverages::resume
(
    GeometricField<Type, fvPatchField, volMesh>& field
) const
{
    const GeometricField<Type, fvPatchField, volMesh> written
    (
        IOobject
        (
            field.name(),
            mesh_.time().timeName(),
            mesh_,
            IOobject::MUST_READ,
            IOobject::NO_WRITE,
            false
        ),
        mesh_
    );

    field.primitiveFieldRef() = written.primitiveField();
}


void Foam::cghs::solidsAverages::resumeAll()
{
    resume(fraction_);
    resume(fractionVariance_);
    resume(density_);
    resume(flux_);
    resume(fluxVariance_);
    resume(velocityVariance_);
    resume(temperatureInCell_);

    const scalarField& M = density_.primitiveField();
    const vectorField& P = flux_.primitiveField();

    forAll(M, celli)
    {
        if (M[celli] > 0)
        {
            stress_[celli] =
                M[celli]*velocityVariance_[celli] + sqr(P[celli])/M[celli];
        }
        inCell_[celli] = M[celli]*temperatureInCell_[celli];
    }
    resumeProperties();

    Info<< type() << ' ' << name() << ": goes on with the means of "
        << duration_ << " s" << nl << endl;
}

// * * * * * * * * * * * * * * *  Properties * * * * * * * * * * * * * * * * //

Foam::wordList Foam::cghs::solidsAverages::propertyNames() const
{
    wordList names(properties_.size());

    forAll(names, k)
    {
        names[k] = properties_[k].name;
    }

    return names;
}


void Foam::cghs::solidsAverages::makeProperties(const dictionary& dict)
{
    const wordList names(dict.getOrDefault("properties", wordList()));

    // cghsFoam -postProcess makes the cloud later than this
    const wordList valid
    (
        postProcess ? names : parcelNumber::choices(parcels())
    );

    for (const word& name : names)
    {
        const bool known = valid.found(name);

        if (!known || propertyNames().found(name))
        {
            FatalIOErrorInFunction(dict)
                << "Entry properties is " << flatOutput(names) << " but "
                << (known ? "names " : "parcels have no number ") << name
                << (known ? " twice" : "") << nl
                << "Valid choices: " << flatOutput(valid) << nl
                << exit(FatalIOError);
        }

        properties_.append
        (
            new propertyMeans
            {
                name,
                scalarField(mesh_.nCells(), Zero),
                scalarField(mesh_.nCells(), Zero),
                averageField<scalar>(name + "Mean", dimless),
                averageField<scalar>(name + "Prime2Mean", dimless)
            }
        );
    }
}


void Foam::cghs::solidsAverages::checkResumed(const dictionary& dict) const
{
    wordList before;
    getProperty("properties", before);

    if (before != propertyNames())
    {
        FatalIOErrorInFunction(dict)
            << "Entry properties is " << flatOutput(propertyNames())
            << " but until time " << mesh_.time().timeName() << " it was "
            << flatOutput(before) << nl
            << "Leave it, or rename the function object to start anew" << nl
            << exit(FatalIOError);
    }
}


void Foam::cghs::solidsAverages::resumeProperties()
{
    const scalarField& M = density_.primitiveField();

    for (propertyMeans& p : properties_)
    {
        resume(p.mean);
        resume(p.variance);

        const scalarField& mean = p.mean.primitiveField();
        p.content = M*mean;
        p.square = M*(p.variance.primitiveField() + sqr(mean));
    }
}


void Foam::cghs::solidsAverages::addProperties
(
    const UList<scalar>& V,
    cellSums& sums
) const
{
    const arena& parcels = this->parcels();
    const UList<label>& places = parcels.places();

    forAll(properties_, k)
    {
        const parcelNumber value(properties_[k].name, parcels);

        for (label i = 0; i < parcels.size(); ++i)
        {
            const label placei = places[i];
            const scalar content =
                parcels.motions[i].mass()/V[placei]*value(i);

            sums.content[k][placei] += content;
            sums.square[k][placei] += content*value(i);
        }
    }
}


void Foam::cghs::solidsAverages::writeProperties()
{
    const scalarField& M = density_.primitiveField();

    forAll(properties_, k)
    {
        propertyMeans& p = properties_[k];

        forAll(M, celli)
        {
            if (M[celli] > 0)
            {
                p.mean[celli] = p.content[celli]/M[celli];
                p.variance[celli] =
                    p.square[celli]/M[celli] - sqr(p.mean[celli]);
            }
        }

        for (volScalarField* field : {&p.mean, &p.variance})
        {
            field->correctBoundaryConditions();
            field->write();
        }

        if (blocks_.valid() && blocks_->nBlocks() > 1)
        {
            writeValues
            (
                p.name + "MeanError",
                dimless,
                blocks_->propertyError(k)
            );
        }
    }

    setProperty("properties", propertyNames());
}

// * * * * * * * * * * * * * * * The errors  * * * * * * * * * * * * * * * * //

void Foam::cghs::solidsAverages::makeBlocks(const dictionary& dict)
{
    blocks_.reset
    (
        new solidsBlocks
        (
            positiveScalar(dict, "blockTime"),
            mesh_.nCells(),
            properties_.size()
        )
    );

    scalar formerLength;
    if (!getProperty("blockTime", formerLength))
    {
        return;
    }

    if (mag(formerLength - blocks_->length()) > 1e-6*formerLength)
    {
        FatalIOErrorInFunction(dict)
            << "Entry blockTime is " << blocks_->length() << " but until time "
            << mesh_.time().timeName() << " it was " << formerLength << nl
            << "Leave it, or rename the function object to start anew" << nl
            << exit(FatalIOError);
    }

    List<tensorField> state(blocks_->nStates());
    forAll(state, k)
    {
        auto field = averageField<tensor>(stateName(k), dimless);
        resume(field);
        state[k] = field.primitiveField();
    }

    scalar nBlocks = 0;
    scalar elapsed = 0;
    getProperty("nBlocks", nBlocks);
    getProperty("blockElapsed", elapsed);
    blocks_->setState(nBlocks, elapsed, state);
}


template<class Type>
void Foam::cghs::solidsAverages::writeValues
(
    const word& name,
    const dimensionSet& dimensions,
    const Field<Type>& values
) const
{
    auto field = averageField<Type>(name, dimensions);

    field.primitiveFieldRef() = values;
    field.correctBoundaryConditions();
    field.write();
}


void Foam::cghs::solidsAverages::writeErrors()
{
    if (blocks_->nBlocks() > 1)
    {
        writeValues("fractionMeanError", dimless, blocks_->fractionError());
        writeValues
        (
            "massFluxMeanError",
            dimDensity*dimVelocity,
            blocks_->fluxError()
        );
        writeValues("velocityMeanError", dimVelocity, blocks_->velocityError());
        writeValues
        (
            "granularTemperatureError",
            sqr(dimVelocity),
            blocks_->temperatureError()
        );
    }

    const List<tensorField> state(blocks_->state());
    forAll(state, k)
    {
        writeValues(stateName(k), dimless, state[k]);
    }
    setProperty("blockTime", blocks_->length());
    setProperty("nBlocks", scalar(blocks_->nBlocks()));
    setProperty("blockElapsed", blocks_->elapsed());

    Info<< type() << ' ' << name() << ": errors from " << blocks_->nBlocks()
        << " blocks of " << blocks_->length() << " s" << nl;
    if (blocks_->nBlocks() > 1)
    {
        writeWindow();
    }
    Info<< endl;
}


bool Foam::cghs::solidsAverages::varies(const label celli) const
{
    return fractionVariance_[celli] > sqr(1e-8*fraction_[celli]);
}


void Foam::cghs::solidsAverages::writeWindow() const
{
    scalarField time(mesh_.nCells(), Zero);
    scalarField longEnough(mesh_.nCells(), 1);
    label nVarying = 0;
    label nShort = 0;

    forAll(time, celli)
    {
        if (varies(celli))
        {
            const scalar variance = fractionVariance_[celli];
            const bool isLong = blocks_->longEnough(celli, variance);

            time[celli] =
                duration_/(2*max(blocks_->independent(celli, variance), 1));
            longEnough[celli] = isLong;
            ++nVarying;
            nShort += !isLong;
        }
    }

    writeValues("fractionCorrelationTime", dimTime, time);
    writeValues("windowLongEnough", dimless, longEnough);

    reduce(nVarying, sumOp<label>());
    reduce(nShort, sumOp<label>());

    if (nShort > 0)
    {
        Info<< "    window too short in " << nShort << " of " << nVarying
            << " cells: at least " << label(blockErrors::minBlocks)
            << " blocks that are not alike and "
            << label(2*blockErrors::leastIndependent)
            << " correlation times needed" << nl;
    }
}

// * * * * * * * * * * * * * * * * The means * * * * * * * * * * * * * * * * //

Foam::cghs::cellSums Foam::cghs::solidsAverages::instant() const
{
    const arena& parcels = this->parcels();
    const UList<label>& places = parcels.places();

    scalarField V(mesh_.V());
    cellSums s(mesh_.nCells(), properties_.size());

    parcels.visiting.fetch(V);
    s.extend(parcels.visiting);

    for (label i = 0; i < parcels.size(); ++i)
    {
        const label placei = places[i];
        const vector& v = parcels.motions[i].v;
        const scalar density = parcels.motions[i].mass()/V[placei];

        s.fraction[placei] += parcels.volume(i)/V[placei];
        s.density[placei] += density;
        s.flux[placei] += density*v;
        s.stress[placei] += density*sqr(v);
    }
    addProperties(V, s);

    s.collect(parcels.visiting);

    return s;
}


bool Foam::cghs::solidsAverages::execute()
{
    const cellSums now(instant());
    const scalar deltaT = mesh_.time().deltaTValue();

    duration_ += deltaT;
    const scalar share = deltaT/duration_;

    addToVariance
    (
        fractionVariance_.primitiveFieldRef(),
        fraction_.primitiveField(),
        now.fraction,
        share
    );
    addToVariance
    (
        fluxVariance_.primitiveFieldRef(),
        flux_.primitiveField(),
        now.flux,
        share
    );
    addTo(fraction_.primitiveFieldRef(), now.fraction, share);
    addTo(density_.primitiveFieldRef(), now.density, share);
    addTo(flux_.primitiveFieldRef(), now.flux, share);
    addTo(stress_, now.stress, share);
    addTo
    (
        inCell_,
        scalarField
        (
            (tr(now.stress) - magSqr(now.flux)/max(now.density, VSMALL))/3
        ),
        share
    );

    forAll(properties_, k)
    {
        addTo(properties_[k].content, now.content[k], share);
        addTo(properties_[k].square, now.square[k], share);
    }

    if (blocks_.valid())
    {
        blocks_->add(now, deltaT);
    }

    return true;
}


void Foam::cghs::solidsAverages::deriveFields()
{
    voidage_.primitiveFieldRef() = 1 - fraction_.primitiveField();

    forAll(density_, celli)
    {
        const scalar M = density_[celli];

        if (M > 0)
        {
            const vector U(flux_[celli]/M);

            velocity_[celli] = U;
            velocityVariance_[celli] = stress_[celli]/M - sqr(U);
            temperatureInCell_[celli] = inCell_[celli]/M;
        }
        temperature_[celli] = tr(velocityVariance_[celli])/3;
    }
}


bool Foam::cghs::solidsAverages::write()
{
    deriveFields();

    for
    (
        volScalarField* field
      : {
            &fraction_, &fractionVariance_, &voidage_, &density_,
            &temperature_, &temperatureInCell_
        }
    )
    {
        field->correctBoundaryConditions();
        field->write();
    }
    for (volVectorField* field : {&flux_, &velocity_})
    {
        field->correctBoundaryConditions();
        field->write();
    }
    for (volSymmTensorField* field : {&fluxVariance_, &velocityVariance_})
    {
        field->correctBoundaryConditions();
        field->write();
    }

    writeProperties();
    setProperty("duration", duration_);

    if (blocks_.valid())
    {
        writeErrors();
    }

    return true;
}

/*---------------------------------------------------------------------------*\
    cghsFoam | coarse-grained hard spheres in OpenFOAM
    GPL-3.0-or-later, see LICENSE
\*---------------------------------------------------------------------------*/

#include "suspension.H"
#include "sortedIndices.H"

Foam::cghs::suspension::suspension
(
    const dictionary& subModels,
    const vector& g,
    const label nCells,
    const cellKernels* kernels
)
:
    g_(g),
    law_(dragModel::New(subModels)),
    forces_(nullptr),
    kernels_(kernels),
    nCells_(nCells),
    volume_(nCells, Zero),
    impulse_(nCells, Zero),
    response_(nCells, Zero),
    yieldToVelocity_(nCells, Zero),
    yieldToGradient_(nCells, Zero),
    drag_(kernels ? nCells : 0, Zero),
    received_(Zero),
    carried_(0),
    flows_(blockSize_),
    D_(blockSize_),
    holds_(false),
    burdened_(false)
{
    PtrList<forceModel> forces(forceModel::New(subModels));

    if (forces.size())
    {
        forces_.reset(new fluidForces(std::move(forces)));
    }
}


void Foam::cghs::suspension::addColumns(arena& parcels)
{
    parcels.add(rates_);
    rates_.UList<scalar>::operator=(Zero);

    if (kernels_)
    {
        parcels.add(met_);
        parcels.add(taken_);
        taken_.UList<vector>::operator=(Zero);
        parcels.keep(*this);
    }
    if (forces_.valid())
    {
        forces_->addColumns(parcels, kernels_);
    }
}

// * * * * * * * * * * * * * * *  What is met * * * * * * * * * * * * * * * * //

Foam::labelList Foam::cghs::suspension::cellByCell(const arena& parcels) const
{
    labelList start;
    return
        sortedIndices
        (
            SubList<label>(parcels.cells, parcels.size()),
            nCells_,
            start
        );
}


template<class Row>
Row Foam::cghs::suspension::read
(
    const List<Row>& bySlot,
    const arena& parcels,
    const label i
) const
{
    Row sum;

    kernels_->visit
    (
        parcels.spheres[i].x,
        parcels.cells[i],
        [&](const label slot, const scalar share)
        {
            sum.add(share, bySlot[slot]);
        }
    );

    return sum;
}


void Foam::cghs::suspension::meet
(
    const arena& parcels,
    List<carrier>&& byCell,
    List<turning>&& turnings
)
{
    fluid_ = std::move(byCell);

    if (forces_.valid())
    {
        forces_->fluid() = std::move(turnings);
    }
    if (!kernels_)
    {
        return;
    }

    kernels_->rings().fetch(fluid_);

    const labelList order(cellByCell(parcels));

    for (const label i : order)
    {
        met_[i] = read(fluid_, parcels, i);
        taken_[i] = Zero;
    }

    if (forces_.valid())
    {
        kernels_->rings().fetch(forces_->fluid());

        for (const label i : order)
        {
            forces_->meet(i, read(forces_->fluid(), parcels, i));
        }
    }
}

// * * * * * * * * * * * * * * *  Solids steps  * * * * * * * * * * * * * * * //

void Foam::cghs::suspension::startFluidStep()
{
    impulse_ = Zero;
    response_ = Zero;
    received_ = Zero;
}


void Foam::cghs::suspension::findRates
(
    const arena& parcels,
    const label from,
    const label n
)
{
    for (label k = 0; k < n; ++k)
    {
        const label i = from + k;
        const carrier& c = carrierOf(parcels, i);

        flows_[k] = slipFlow
        {
            c.voidage(),
            mag(c.u() - parcels.motions[i].v),
            parcels.diameters[i],
            c.rho(),
            c.mu()
        };
    }

    SubList<scalar> D(D_, n);
    law_->coefficients(SubList<slipFlow>(flows_, n), D);

    for (label k = 0; k < n; ++k)
    {
        const label i = from + k;

        rates_[i] = D_[k]*parcels.volume(i)*parcels.motions[i].invMass;
    }
}


inline Foam::vector Foam::cghs::suspension::accelerate
(
    arena& parcels,
    const label i,
    const scalar time,
    const carrier& c,
    vector& impulse
) const
{
    motion& m = parcels.motions[i];

    const scalar K = rates_[i];
    const scalar mass = m.mass();
    const vector u(c.u());
    const vector g(forces_.valid() ? forces_->field(i, g_) : g_);
    const vector field(g - (parcels.displaced(i)*m.invMass)*c.gradP());
    const vector before(m.v);

    m.v = (m.v + time*(K*u + field))/(1 + time*K);

    impulse += (time*K*mass)*(u - m.v);

    return mass*(m.v - before - time*field);
}


void Foam::cghs::suspension::accelerate
(
    arena& parcels,
    const label from,
    const label n,
    const scalar time
)
{
    vector received(Zero);

    if (kernels_)
    {
        for (label i = from; i < from + n; ++i)
        {
            received += accelerate(parcels, i, time, met_[i], taken_[i]);
        }
    }
    else
    {
        const UList<label>& places = parcels.places();

        for (label i = from; i < from + n; ++i)
        {
            const label placei = places[i];

            received +=
                accelerate(parcels, i, time, fluid_[placei], impulse_[placei]);
        }
    }

    received_ += received;
}


inline void Foam::cghs::suspension::burden
(
    arena& parcels,
    const label i,
    const scalar halfSteps,
    const scalar share
)
{
    motion& m = parcels.motions[i];

    invMasses_[i] = m.invMass;
    addImpulse(parcels, i, (share/m.invMass)*m.v);
    change_[parcels.places()[i]] -= m.v/m.invMass/(1 + halfSteps);
    m.invMass /= 1 + share;
}


inline void Foam::cghs::suspension::unburden
(
    arena& parcels,
    const label i,
    const scalar halfSteps,
    const scalar share
)
{
    motion& m = parcels.motions[i];

    m.invMass = invMasses_[i];
    addImpulse(parcels, i, (-share/m.invMass)*m.v);
    change_[parcels.places()[i]] += m.v/m.invMass/(1 + halfSteps);
}


bool Foam::cghs::suspension::kick(arena& parcels, const scalar halfDeltaT)
{
    const label nOwn = parcels.size();
    scalar fastest = 0;

    if (!kernels_)
    {
        parcels.visiting.fetch(fluid_);
        parcels.visiting.extend(impulse_);
    }
    if (forces_.valid())
    {
        takeForces(parcels);
    }

    for (label from = 0; from < nOwn; from += blockSize_)
    {
        const label n = min(blockSize_, nOwn - from);

        findRates(parcels, from, n);
        accelerate(parcels, from, n, halfDeltaT);

        if (holds_)
        {
            fastest = max(fastest, max(SubList<scalar>(rates_, n, from)));
        }
    }

    burdened_ =
        holds_ && halfDeltaT*returnReduce(fastest, maxOp<scalar>()) > slack_;

    if (burdened_)
    {
        takeBurdens(parcels, halfDeltaT);
    }

    return burdened_ || forces_.valid();
}


void Foam::cghs::suspension::takeForces(arena& parcels)
{
    const label nOwn = parcels.size();

    if (!kernels_)
    {
        parcels.visiting.fetch(forces_->fluid());
    }

    forces_->start(nOwn);

    for (label from = 0; from < nOwn; from += blockSize_)
    {
        forces_->take
        (
            parcels,
            from,
            min(blockSize_, nOwn - from),
            [&](const label i) -> const carrier&
            {
                return carrierOf(parcels, i);
            }
        );
    }
}


void Foam::cghs::suspension::releaseForces
(
    arena& parcels,
    const scalar deltaT
)
{
    for (label i = 0; i < parcels.size(); ++i)
    {
        addImpulse(parcels, i, forces_->release(parcels, i, deltaT));
        rates_[i] *= forces_->burden(i);
    }
}


void Foam::cghs::suspension::takeBurdens
(
    arena& parcels,
    const scalar halfDeltaT
)
{
    invMasses_.resize(parcels.size());
    change_.resize(nCells_);
    change_ = Zero;
    parcels.visiting.extend(change_);

    for (label i = 0; i < parcels.size(); ++i)
    {
        const scalar s = halfDeltaT*rates_[i];

        if (holds(s))
        {
            burden(parcels, i, s, earlyShare(s));
        }
    }
}


bool Foam::cghs::suspension::kickAgain
(
    arena& parcels,
    const scalar halfDeltaT
)
{
    if (!burdened_)
    {
        accelerate(parcels, 0, parcels.size(), halfDeltaT);
        return false;
    }

    for (label i = 0; i < parcels.size(); ++i)
    {
        const scalar s = halfDeltaT*rates_[i];

        if (holds(s))
        {
            unburden(parcels, i, s, earlyShare(s));
            accelerate(parcels, i, 1, halfDeltaT);
            burden(parcels, i, 0, lateShare(s));
        }
        else
        {
            accelerate(parcels, i, 1, halfDeltaT);
        }
    }

    return true;
}


void Foam::cghs::suspension::settle
(
    arena& parcels,
    const scalar halfDeltaT,
    const bool last,
    const scalar fluidDeltaT
)
{
    heldShares_.clear();

    if (burdened_)
    {
        for (label i = 0; i < parcels.size(); ++i)
        {
            const scalar s = halfDeltaT*rates_[i];

            if (holds(s))
            {
                unburden(parcels, i, 0, lateShare(s));
            }
        }
        if (last)
        {
            findHeld(parcels);
        }
    }
    if (forces_.valid())
    {
        releaseForces(parcels, 2*halfDeltaT);
    }

    if (!kernels_)
    {
        parcels.visiting.collect(impulse_);

        if (last)
        {
            sumResponses(parcels, fluidDeltaT);
        }
    }
}


void Foam::cghs::suspension::findHeld(const arena& parcels)
{
    const UList<label>& places = parcels.places();

    // Momentum as it would be without the contacts
    vectorField free(-change_);

    for (label i = 0; i < parcels.size(); ++i)
    {
        const motion& m = parcels.motions[i];

        free[places[i]] += m.v/m.invMass;
    }

    parcels.visiting.collect(free);
    parcels.visiting.collect(change_);

    scalarField held(nCells_);

    forAll(held, celli)
    {
        const scalar stopped = -(change_[celli] & free[celli]);

        held[celli] =
            stopped > 0 ? min(stopped/magSqr(free[celli]), scalar(1)) : 0;
    }

    parcels.visiting.fetch(held);
    heldShares_.resize(parcels.size());

    forAll(heldShares_, i)
    {
        heldShares_[i] = held[places[i]];
    }
}


void Foam::cghs::suspension::sumResponses
(
    const arena& parcels,
    const scalar fluidDeltaT
)
{
    respondingPlaces_ = SubList<label>(parcels.places(), parcels.size());
    respondingVisits_ = parcels.visiting;
    parcels.visiting.extend(response_);

    for (label i = 0; i < parcels.size(); ++i)
    {
        response_[respondingPlaces_[i]] += responseOf(parcels, i, fluidDeltaT);
    }

    parcels.visiting.collect(response_);
}

// * * * * * * * * * * * * * * *  What is left * * * * * * * * * * * * * * * //

inline Foam::cghs::deposit Foam::cghs::suspension::depositOf
(
    const arena& parcels,
    const label i,
    const scalar fluidDeltaT
) const
{
    const scalar V = parcels.displaced(i);
    const scalar volumeByMass = V*parcels.motions[i].invMass;
    const scalar k = yielding(i, fluidDeltaT);

    cghs::deposit l;
    l.volume() = V;
    l.response() = responseOf(parcels, i, fluidDeltaT);
    l.yieldToVelocity() = k*V;
    l.yieldToGradient() = (1 - k)*fluidDeltaT*V*volumeByMass;

    return l;
}


void Foam::cghs::suspension::sumInCells
(
    const arena& parcels,
    const scalar fluidDeltaT
)
{
    const UList<label>& places = parcels.places();

    for (scalarField* sum : {&volume_, &yieldToVelocity_, &yieldToGradient_})
    {
        *sum = Zero;
        parcels.visiting.extend(*sum);
    }

    for (label i = 0; i < parcels.size(); ++i)
    {
        const label placei = places[i];
        cghs::deposit own(depositOf(parcels, i, fluidDeltaT));

        volume_[placei] += own.volume();
        yieldToVelocity_[placei] += own.yieldToVelocity();
        yieldToGradient_[placei] += own.yieldToGradient();
    }

    for (scalarField* sum : {&volume_, &yieldToVelocity_, &yieldToGradient_})
    {
        parcels.visiting.collect(*sum);
    }
}


void Foam::cghs::suspension::spreadDeposits
(
    const arena& parcels,
    const scalar fluidDeltaT
)
{
    List<cghs::deposit> sums(kernels_->rings().nSlots());

    for (const label i : cellByCell(parcels))
    {
        cghs::deposit own(depositOf(parcels, i, fluidDeltaT));
        own.setVector(1, taken_[i]);
        own.drag() = rates_[i]/parcels.motions[i].invMass;

        kernels_->visit
        (
            parcels.spheres[i].x,
            parcels.cells[i],
            [&](const label slot, const scalar share)
            {
                sums[slot].add(share, own);
            }
        );
    }

    kernels_->rings().collect(sums, plusEqRow(), cghs::deposit());

    for (label celli = 0; celli < nCells_; ++celli)
    {
        cghs::deposit& sum = sums[celli];

        volume_[celli] = sum.volume();
        impulse_[celli] += sum.impulse();
        response_[celli] = sum.response();
        yieldToVelocity_[celli] = sum.yieldToVelocity();
        yieldToGradient_[celli] = sum.yieldToGradient();
        drag_[celli] = sum.drag();
    }
}


void Foam::cghs::suspension::leave
(
    const arena& parcels,
    const scalar fluidDeltaT
)
{
    if (kernels_)
    {
        spreadDeposits(parcels, fluidDeltaT);
    }
    else
    {
        sumInCells(parcels, fluidDeltaT);
    }
}


Foam::scalarField Foam::cghs::suspension::dissipation
(
    const arena& parcels
) const
{
    const auto power = [&](const label i, const carrier& c)
    {
        const motion& m = parcels.motions[i];

        return rates_[i]/m.invMass*magSqr(c.u() - m.v);
    };

    scalarField sums(kernels_ ? kernels_->rings().nSlots() : nCells_, Zero);

    if (!kernels_)
    {
        // Parcels have moved since they met the fluid
        List<carrier> fluid(fluid_);
        parcels.visiting.fetch(fluid);
        parcels.visiting.extend(sums);

        const UList<label>& places = parcels.places();

        for (label i = 0; i < parcels.size(); ++i)
        {
            sums[places[i]] += power(i, fluid[places[i]]);
        }
        parcels.visiting.collect(sums);

        return sums;
    }

    for (const label i : cellByCell(parcels))
    {
        const scalar own = power(i, met_[i]);

        kernels_->visit
        (
            parcels.spheres[i].x,
            parcels.cells[i],
            [&](const label slot, const scalar share)
            {
                sums[slot] += share*own;
            }
        );
    }

    kernels_->rings().collect(sums, plusEqOp<scalar>(), scalar(0));
    sums.resize(nCells_);

    return sums;
}


inline Foam::vector Foam::cghs::suspension::answer
(
    arena& parcels,
    const label i,
    const change& c,
    const scalar fluidDeltaT
) const
{
    motion& m = parcels.motions[i];

    const vector before(m.v);
    const vector push
    (
        (1 - yielding(i, fluidDeltaT))*parcels.displaced(i)*c.gradP()
    );

    m.v +=
        (fluidDeltaT*m.invMass)
       *(responseOf(parcels, i, fluidDeltaT)*c.u() - push);

    return m.mass()*(m.v - before) + fluidDeltaT*push;
}


void Foam::cghs::suspension::complete
(
    arena& parcels,
    List<change>&& byCell,
    const scalar fluidDeltaT
)
{
    if (kernels_)
    {
        kernels_->rings().fetch(byCell);
    }
    else
    {
        respondingVisits_.fetch(byCell);
    }

    const labelList order(kernels_ ? cellByCell(parcels) : labelList());
    carried_ = 0;

    for (label k = 0; k < parcels.size(); ++k)
    {
        const label i = kernels_ ? order[k] : k;

        received_ +=
            answer
            (
                parcels,
                i,
                kernels_
              ? read(byCell, parcels, i)
              : byCell[respondingPlaces_[i]],
                fluidDeltaT
            );

        const motion& m = parcels.motions[i];
        carried_ += m.mass()*mag(m.v);
    }

    law_->warnOutsideRange();
}

/*---------------------------------------------------------------------------*\
    cghsFoam | coarse-grained hard spheres in OpenFOAM
    GPL-3.0-or-later, see LICENSE
-------------------------------------------------------------------------------
Description
    A model of a test's own: each parcel gives one species to the fluid and
    takes another from it, at constant rates, as if it had an endless store.
    What is given has the enthalpy of its temperature, what is taken that of
    the gas.

\*---------------------------------------------------------------------------*/

#include "exchange.H"
#include "fvMesh.H"
#include "basicSpecieMixture.H"
#include "PstreamReduceOps.H"
#include "addToRunTimeSelectionTable.H"

namespace Foam
{
namespace cghs
{

class giver
:
    public exchange
{
    const fvMesh& mesh_;

    const word gives_;
    const word takes_;

    //- Of each parcel [kg/s]
    const scalar given_;
    const scalar taken_;

    //- What the sum of species is told wrong by
    const scalar wrong_;

    //- Of what is given [K]
    const scalar T_;

    //- By place, of this step
    scalarField in_;
    scalarField out_;
    scalarField energy_;
    vectorField momentum_;
    scalarField takenEnthalpy_;
    scalar givenEnthalpy_;

    scalar partialPressure_;
    scalar changed_;


    template<class Type>
    tmp<GeometricField<Type, fvPatchField, volMesh>> rate
    (
        const Field<Type>& sums,
        const dimensionSet& dimensions
    ) const
    {
        auto result = GeometricField<Type, fvPatchField, volMesh>::New
        (
            "giver:rate",
            mesh_,
            dimensioned<Type>("0", dimensions, Zero)
        );
        result.ref().primitiveFieldRef() = sums/mesh_.V();

        return result;
    }

    //- In the mesh, of all ranks
    static scalar mean(const scalarField& f)
    {
        return gSum(f)/returnReduce(f.size(), sumOp<label>());
    }


public:

    TypeName("giver");

    giver(const dictionary& dict, const fvMesh& mesh)
    :
        mesh_(mesh),
        gives_(dict.get<word>("gives")),
        takes_(dict.getOrDefault<word>("takes", "nothing")),
        given_(dict.get<scalar>("given")),
        taken_(dict.getOrDefault<scalar>("taken", 0)),
        wrong_(dict.getOrDefault<scalar>("wrong", 0)),
        T_(dict.getOrDefault<scalar>("T", 300)),
        in_(mesh.nCells()),
        out_(mesh.nCells()),
        energy_(mesh.nCells()),
        momentum_(mesh.nCells()),
        takenEnthalpy_(mesh.nCells(), 0),
        givenEnthalpy_(0),
        partialPressure_(0),
        changed_(0)
    {}

    virtual void addColumns(arena&) {}

    virtual void meet(const arena& parcels, carrierFluid& fluid)
    {
        const basicSpecieMixture* gas = fluid.composition();
        const scalarField& Y = fluid.field(gives_).primitiveField();

        if (!gas)
        {
            return;
        }

        const scalarField& T = fluid.field("T").primitiveField();
        const scalarField& p = fluid.p().primitiveField();
        const label k = gas->species()[gives_];

        givenEnthalpy_ = gas->Hs(k, p[0], T_);

        scalarField moles(Y.size(), Zero);
        forAll(gas->species(), i)
        {
            moles +=
                fluid.field(gas->species()[i]).primitiveField()/gas->W(i);
        }
        partialPressure_ = mean(p*Y/gas->W(k)/moles);

        if (taken_ > 0)
        {
            forAll(T, celli)
            {
                takenEnthalpy_[celli] =
                    gas->Hs(gas->species()[takes_], p[celli], T[celli]);
            }
        }
    }

    virtual void leave(const arena& parcels, const scalar)
    {
        const UList<label>& places = parcels.places();

        in_ = Zero;
        out_ = Zero;
        energy_ = Zero;
        momentum_ = Zero;
        parcels.visiting.extend(in_);
        parcels.visiting.extend(out_);
        parcels.visiting.extend(momentum_);

        for (label i = 0; i < parcels.size(); ++i)
        {
            in_[places[i]] += given_;
            out_[places[i]] += taken_;
            momentum_[places[i]] += given_*parcels.motions[i].v;
        }

        parcels.visiting.collect(in_);
        parcels.visiting.collect(out_);
        parcels.visiting.collect(momentum_);
        energy_ = in_*givenEnthalpy_ - out_*takenEnthalpy_;
    }

    virtual exchangeTerms terms(const word& quantity) const
    {
        const dimensionSet massRate(dimDensity/dimTime);
        exchangeTerms result;

        if (quantity == gives_)
        {
            result.given = rate<scalar>((1 + wrong_)*in_, massRate);
        }
        if (quantity == takes_)
        {
            result.given = rate<scalar>(-out_, massRate);
        }
        if (quantity == "energy")
        {
            result.given = rate(energy_, dimPower/dimVolume);
        }

        return result;
    }

    virtual massTerms massGiven() const
    {
        const dimensionSet massRate(dimDensity/dimTime);
        massTerms result;

        result.in = rate(in_, massRate);
        result.out = rate(out_, massRate);
        result.momentum = rate(momentum_, massRate*dimVelocity);

        return result;
    }

    virtual void complete(arena&, const carrierFluid& fluid, const scalar)
    {
        changed_ = mean(fluid.change(gives_)().primitiveField());
    }

    virtual void report(const arena&, Ostream& os) const
    {
        os  << "giver: partial pressure " << partialPressure_
            << " Pa, fraction changed by " << changed_ << nl;
    }
};

defineTypeNameAndDebug(giver, 0);
addToRunTimeSelectionTable(exchange, giver, dictionary);

}
}

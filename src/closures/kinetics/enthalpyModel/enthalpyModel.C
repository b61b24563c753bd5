/*---------------------------------------------------------------------------*\
    cghsFoam | coarse-grained hard spheres in OpenFOAM
    GPL-3.0-or-later, see LICENSE
\*---------------------------------------------------------------------------*/

#include "FlatOutput.H"
#include "enthalpyModel.H"

#include "specie.H"
#include "perfectGas.H"
#include "hConstThermo.H"
#include "hPolynomialThermo.H"
#include "janafThermo.H"
#include "MinMax.H"
#include <type_traits>
#include "addToRunTimeSelectionTable.H"

namespace Foam
{
namespace cghs
{
    defineTypeNameAndDebug(enthalpyModel, 0);
    defineRunTimeSelectionTable(enthalpyModel, dictionary);


// A heat capacity that is a constant
template<class Thermo>
struct hasConstantCp
:
    std::false_type
{};

template<class State>
struct hasConstantCp<hConstThermo<State>>
:
    std::true_type
{};


// What OpenFOAM has. An ideal gas, as enthalpies do not depend on pressure
template<class Thermo>
class foamEnthalpy
:
    public enthalpyModel
{
    const Thermo thermo_;

    scalarMinMax range_;

    // Where nothing depends on it
    static constexpr scalar p_ = 1e5;


public:

    foamEnthalpy(const dictionary& dict)
    :
        thermo_(dict),
        range_
        (
            dict.subDict("thermodynamics").getOrDefault<scalar>("Tlow", 0),
            dict.subDict("thermodynamics").getOrDefault<scalar>("Thigh", GREAT)
        )
    {}

    virtual scalar h(const scalar T) const
    {
        const scalar within = range_.clip(T);
        return
            thermo_.Ha(p_, within)
          + (T == within ? 0 : (T - within)*thermo_.Cp(p_, within));
    }

    virtual scalar formation() const { return thermo_.Hc(); }

    virtual scalar Cp(const scalar T) const
    {
        return thermo_.Cp(p_, range_.clip(T));
    }

    virtual bool straight() const { return hasConstantCp<Thermo>::value; }
};


#define addEnthalpy(Name, Thermo)                                              \
                                                                               \
    typedef foamEnthalpy<Thermo> Name##Enthalpy;                               \
                                                                               \
    addNamedToRunTimeSelectionTable                                            \
    (                                                                          \
        enthalpyModel,                                                         \
        Name##Enthalpy,                                                        \
        dictionary,                                                            \
        Name                                                                   \
    )

typedef hPolynomialThermo<perfectGas<specie>, 8> polynomialThermo;

addEnthalpy(hConst, hConstThermo<perfectGas<specie>>);
addEnthalpy(janaf, janafThermo<perfectGas<specie>>);
addEnthalpy(hPolynomial, polynomialThermo);

} // End namespace cghs
} // End namespace Foam


Foam::autoPtr<Foam::cghs::enthalpyModel>
Foam::cghs::enthalpyModel::New(const word& modelType, const dictionary& dict)
{
    auto cstrIter = dictionaryConstructorTablePtr_->cfind(modelType);

    if (!cstrIter.found())
    {
        FatalIOErrorInFunction(dict)
            << "Thermodynamics " << modelType
            << " are not known for a substance that reacts" << nl
            << "Valid choices: "
            << flatOutput(dictionaryConstructorTablePtr_->sortedToc()) << nl
            << exit(FatalIOError);
    }

    return cstrIter()(dict);
}


Foam::wordList Foam::cghs::enthalpyModel::entries()
{
    return
        wordList
        ({
            "Cp", "Hf", "Sf", "CpCoeffs<8>", "Tlow", "Thigh", "Tcommon",
            "lowCpCoeffs", "highCpCoeffs"
        });
}

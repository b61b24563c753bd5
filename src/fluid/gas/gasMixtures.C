/*---------------------------------------------------------------------------*\
    cghsFoam | coarse-grained hard spheres in OpenFOAM
    GPL-3.0-or-later, see LICENSE
-------------------------------------------------------------------------------
Description
    Ideal gases of several species that OpenFOAM v1912 lacks: sutherland
    transport with constant heat capacities, constant transport with janaf, and
    polynomials of T for all (v1912 has only constants of all, of which hConst
    without an internal energy, and sutherland with janaf).

\*---------------------------------------------------------------------------*/

#include "makeReactionThermo.H"
#include "psiReactionThermo.H"
#include "hePsiThermo.H"
#include "multiComponentMixture.H"
#include "specie.H"
#include "perfectGas.H"
#include "hConstThermo.H"
#include "janafThermo.H"
#include "hPolynomialThermo.H"
#include "constTransport.H"
#include "sutherlandTransport.H"
#include "polynomialTransport.H"
#include "sensibleEnthalpy.H"
#include "sensibleInternalEnergy.H"
#include "thermo.H"

namespace Foam
{

#define makeGas(Transport, Energy, Thermo)                                     \
                                                                               \
    makeReactionThermos                                                        \
    (                                                                          \
        psiThermo,                                                             \
        psiReactionThermo,                                                     \
        hePsiThermo,                                                           \
        multiComponentMixture,                                                 \
        Transport,                                                             \
        Energy,                                                                \
        Thermo,                                                                \
        perfectGas,                                                            \
        specie                                                                 \
    )

makeGas(constTransport, sensibleInternalEnergy, hConstThermo);
makeGas(sutherlandTransport, sensibleEnthalpy, hConstThermo);
makeGas(sutherlandTransport, sensibleInternalEnergy, hConstThermo);
makeGas(constTransport, sensibleEnthalpy, janafThermo);
makeGas(constTransport, sensibleInternalEnergy, janafThermo);
makeGas(polynomialTransport, sensibleEnthalpy, hPolynomialThermo);
makeGas(polynomialTransport, sensibleInternalEnergy, hPolynomialThermo);

} // End namespace Foam

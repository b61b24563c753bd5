/*---------------------------------------------------------------------------*\
    cghsFoam | coarse-grained hard spheres in OpenFOAM
    GPL-3.0-or-later, see LICENSE
-------------------------------------------------------------------------------
Description
    Ideal gases whose heat capacity, viscosity and conductivity are polynomials
    of T. OpenFOAM v1912 has these only with PengRobinsonGas, whose psi changes
    with p.

\*---------------------------------------------------------------------------*/

#include "makeThermo.H"
#include "specie.H"
#include "perfectGas.H"
#include "hPolynomialThermo.H"
#include "polynomialTransport.H"
#include "sensibleEnthalpy.H"
#include "sensibleInternalEnergy.H"
#include "thermo.H"
#include "psiThermo.H"
#include "hePsiThermo.H"
#include "pureMixture.H"
#include "addToRunTimeSelectionTable.H"

namespace Foam
{

makeThermos
(
    psiThermo,
    hePsiThermo,
    pureMixture,
    polynomialTransport,
    sensibleEnthalpy,
    hPolynomialThermo,
    perfectGas,
    specie
);

makeThermos
(
    psiThermo,
    hePsiThermo,
    pureMixture,
    polynomialTransport,
    sensibleInternalEnergy,
    hPolynomialThermo,
    perfectGas,
    specie
);

} // End namespace Foam

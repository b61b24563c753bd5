/*---------------------------------------------------------------------------*\
    cghsFoam | coarse-grained hard spheres in OpenFOAM
    GPL-3.0-or-later, see LICENSE
\*---------------------------------------------------------------------------*/

#include "FlatOutput.H"
#include "substances.H"


Foam::cghs::substances::substances
(
    const wordList& names,
    const dictionary& dict,
    const word& thermo
)
:
    PtrList<substance>(names.size()),
    names_(names)
{
    forAll(names, i)
    {
        if (!dict.isDict(names[i]))
        {
            FatalIOErrorInFunction(dict)
                << "There is no dictionary " << names[i]
                << " of the substance of this name" << nl
                << "Give its elements and thermodynamics" << nl
                << exit(FatalIOError);
        }
        set(i, new substance(names[i], dict.subDict(names[i]), thermo));
        straight_ = straight_ && operator[](i).straight();
    }
}

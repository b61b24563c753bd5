/*---------------------------------------------------------------------------*\
    cghsFoam | coarse-grained hard spheres in OpenFOAM
    GPL-3.0-or-later, see LICENSE
\*---------------------------------------------------------------------------*/

#include "conductionModel.H"
#include "selectModel.H"
#include "HashSet.H"
#include "modelList.H"

namespace Foam
{
namespace cghs
{
    defineTypeNameAndDebug(conductionModel, 0);
    defineRunTimeSelectionTable(conductionModel, dictionary);
    describeFamily
    (
        conductionModel,
        "heat between neighbours: conduction of heatCoeffs, any number"
    );
}
}


Foam::PtrList<Foam::cghs::conductionModel>
Foam::cghs::conductionModel::New(const dictionary& dict)
{
    PtrList<conductionModel> models;
    wordHashSet names;

    for
    (
        const word& name
      : dict.getOrDefault<wordList>("conduction", wordList())
    )
    {
        if (!names.insert(name))
        {
            FatalIOErrorInFunction(dict)
                << "Entry conduction lists " << name << " twice" << nl
                << "Its heat would pass twice: list each model once" << nl
                << exit(FatalIOError);
        }

        models.append
        (
            selectNamed<conductionModel>
            (
                name,
                dict,
                *dictionaryConstructorTablePtr_
            ).ptr()
        );
    }

    return models;
}

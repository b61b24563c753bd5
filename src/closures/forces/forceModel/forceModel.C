/*---------------------------------------------------------------------------*\
    cghsFoam | coarse-grained hard spheres in OpenFOAM
    GPL-3.0-or-later, see LICENSE
\*---------------------------------------------------------------------------*/

#include "forceModel.H"
#include "selectModel.H"
#include "FlatOutput.H"
#include "wordList.H"
#include "modelList.H"

namespace Foam
{
namespace cghs
{
    defineTypeNameAndDebug(forceModel, 0);
    defineRunTimeSelectionTable(forceModel, dictionary);
    describeFamily
    (
        forceModel,
        "forces beside drag: forces of subModels, any number"
    );


static void checkOnce(const dictionary& subModels, const wordList& names)
{
    forAll(names, i)
    {
        if (names.find(names[i]) != i)
        {
            FatalIOErrorInFunction(subModels)
                << "Entry forces is " << flatOutput(names) << ": it names "
                << names[i] << " twice" << nl
                << "Name each force once" << nl
                << exit(FatalIOError);
        }
    }
}

} // End namespace cghs
} // End namespace Foam


Foam::PtrList<Foam::cghs::forceModel> Foam::cghs::forceModel::New
(
    const dictionary& subModels
)
{
    PtrList<forceModel> models;
    const wordList names
    (
        subModels.getOrDefault<wordList>("forces", wordList())
    );

    checkOnce(subModels, names);

    for (const word& name : names)
    {
        models.append
        (
            selectNamed<forceModel>
            (
                name,
                subModels,
                *dictionaryConstructorTablePtr_
            ).ptr()
        );
    }

    return models;
}

/*---------------------------------------------------------------------------*\
    cghsFoam | coarse-grained hard spheres in OpenFOAM
    GPL-3.0-or-later, see LICENSE
\*---------------------------------------------------------------------------*/

#include "exchange.H"
#include "selectModel.H"
#include "fvMesh.H"
#include "modelList.H"

namespace Foam
{
namespace cghs
{
    defineTypeNameAndDebug(exchange, 0);
    defineRunTimeSelectionTable(exchange, dictionary);
    describeFamily
    (
        exchange,
        "what parcels exchange and have: exchanges of subModels, any number"
    );
}
}


Foam::cghs::exchange::lookRound Foam::cghs::exchange::lookAt
(
    const UList<property*>& shown,
    const UList<property*>& collected
)
{
    for (const UList<property*>* list : {&shown, &collected})
    {
        for (const property* p : *list)
        {
            if (!p->lent())
            {
                FatalErrorInFunction
                    << "Property " << p->name() << " is to be there where parcels"
                    << " touch, but is not lent: see property" << nl
                    << exit(FatalError);
            }
        }
    }

    return lookRound{shown, collected};
}


void Foam::cghs::exchange::lookAtContacts
(
    const UList<property*>& shown,
    const UList<property*>& collected
)
{
    contactRounds_.append(lookAt(shown, collected));
}


void Foam::cghs::exchange::lookAtNeighbours
(
    const UList<property*>& shown,
    const UList<property*>& collected
)
{
    neighbourRounds_.append(lookAt(shown, collected));
}


Foam::PtrList<Foam::cghs::exchange> Foam::cghs::exchange::New
(
    const dictionary& subModels,
    const fvMesh& mesh,
    arena& parcels
)
{
    PtrList<exchange> models;

    if (!subModels.found("exchanges"))
    {
        return models;
    }

    // Libraries make the table when they bring the first model
    const dictionaryConstructorTable none;
    const dictionaryConstructorTable& table =
        dictionaryConstructorTablePtr_
      ? *dictionaryConstructorTablePtr_
      : none;

    const wordList names(subModels.get<wordList>("exchanges"));

    forAll(names, i)
    {
        const word& name = names[i];

        if (names.find(name) != i)
        {
            FatalIOErrorInFunction(subModels)
                << "Entry exchanges is " << flatOutput(names) << ": it names "
                << name << " twice" << nl
                << "Name each exchange once" << nl
                << exit(FatalIOError);
        }

        models.append
        (
            selectNamed<exchange>(name, subModels, table, mesh).ptr()
        );
    }

    for (exchange& model : models)
    {
        model.checkCase(subModels.topDict());
    }
    for (exchange& model : models)
    {
        model.join(models);
    }
    for (exchange& model : models)
    {
        model.addColumns(parcels);
    }

    return models;
}

/*---------------------------------------------------------------------------*\
    cghsFoam | coarse-grained hard spheres in OpenFOAM
    GPL-3.0-or-later, see LICENSE
\*---------------------------------------------------------------------------*/

#include "contactConduction.H"
#include "conductionScaling.H"
#include "checkedEntry.H"
#include "knownEntries.H"
#include "modelList.H"
#include "addToRunTimeSelectionTable.H"

namespace Foam
{
namespace cghs
{
    defineTypeNameAndDebug(contactConduction, 0);
    addToRunTimeSelectionTable(conductionModel, contactConduction, dictionary);
    describeModel
    (
        conductionModel,
        contactConduction,
        "through the area in which parcels touch"
    );


    //- A number, or one for each material
    static scalarList numbers
    (
        const dictionary& dict,
        const word& entry,
        const scalar low,
        const scalar high
    )
    {
        ITstream& is = dict.lookup(entry);
        const bool several = is.first().isPunctuation();
        const scalarList values
        (
            several
          ? dict.get<scalarList>(entry)
          : scalarList(1, dict.get<scalar>(entry))
        );

        if (values.empty())
        {
            FatalIOErrorInFunction(dict)
                << "Entry " << entry << " is an empty list" << nl
                << "Give a number, or one for each material" << nl
                << exit(FatalIOError);
        }

        for (const scalar value : values)
        {
            checkRange(dict, entry, value, low, high);
        }
        return values;
    }
}
}


Foam::List<Foam::cghs::contactConduction::solid>
Foam::cghs::contactConduction::read(const dictionary& dict)
{
    const scalarList kappa(numbers(dict, "kappa", SMALL, GREAT));
    const scalarList E(numbers(dict, "YoungsModulus", SMALL, GREAT));
    const scalarList nu(numbers(dict, "PoissonRatio", 0, 0.5));

    List<solid> solids(max(kappa.size(), max(E.size(), nu.size())));

    const auto of = [&](const scalarList& list, const label i)
    {
        if (list.size() > 1 && list.size() != solids.size())
        {
            FatalIOErrorInFunction(dict)
                << "Entries kappa, YoungsModulus and PoissonRatio list "
                << kappa.size() << ", " << E.size() << " and " << nu.size()
                << " materials" << nl
                << "Give one number for all, or one for each" << nl
                << exit(FatalIOError);
        }
        return list[list.size() > 1 ? i : 0];
    };

    forAll(solids, i)
    {
        solids[i] =
            solid{of(kappa, i), elasticity{of(E, i), of(nu, i)}};
    }
    return solids;
}


Foam::cghs::contactConduction::contactConduction(const dictionary& dict)
:
    solids_(read(dict)),
    wall_
    (
        dict.found("wall") ? read(dict.subDict("wall")) : List<solid>()
    ),
    warned_(false)
{
    warnUnknownEntries
    (
        dict,
        wordList({"kappa", "YoungsModulus", "PoissonRatio", "wall"})
    );

    if (dict.found("wall"))
    {
        warnUnknownEntries
        (
            dict.subDict("wall"),
            wordList({"kappa", "YoungsModulus", "PoissonRatio"})
        );
    }

    if (wall_.size() > 1)
    {
        FatalIOErrorInFunction(dict)
            << "Entry wall has " << wall_.size() << " materials, but is one"
            << nl << "Give one number for each of its entries" << nl
            << exit(FatalIOError);
    }
}


Foam::cghs::contactNeeds Foam::cghs::contactConduction::needs() const
{
    contactNeeds needs;
    needs.approaches = true;
    return needs;
}


void Foam::cghs::contactConduction::addColumns(arena& parcels)
{
    if (solids_.size() > 1 && solids_.size() != parcels.nMaterials())
    {
        FatalErrorInFunction
            << "contactCoeffs of heat list " << solids_.size()
            << " materials, but the contact model has "
            << parcels.nMaterials() << nl
            << "Give one number for all, or one for each material" << nl
            << exit(FatalError);
    }
}


void Foam::cghs::contactConduction::warn() const
{
    warned_ = true;

    WarningInFunction
        << "The contact model does not remember what contacts bear: only"
        << " impacts conduct, and resting contacts too little" << nl
        << "    Choose softSphere, or hardSphere with the correctionModel"
        << " accumulatedImpulse" << nl << endl;
}


Foam::scalar Foam::cghs::contactConduction::passes
(
    const conductingPair& pair,
    const arena& parcels
) const
{
    const contact& c = pair.c;
    const bool wall = c.atWall();

    if (pair.load < 0 && !warned_)
    {
        warn();
    }
    if (pair.load <= 0 && pair.approach <= 0)
    {
        return 0;
    }

    const solid& a = solidOf(parcels.materialOf(c.a));
    const solid& b =
        !wall ? solidOf(parcels.materialOf(c.b))
      : wall_.empty() ? a
      : wall_[0];

    const scalar ra = parcels.spheres[c.a].r;
    const scalar rb = parcels.spheres[c.b].r;
    const scalar re = wall ? ra : ra*rb/(ra + rb);
    const scalar kn0 = hertzStiffness(re, a.elastic, b.elastic);
    const scalar factor =
        wall ? wallFactor(parcels.weights[c.a]) : 1;

    if (pair.load > 0)
    {
        const scalar overlap = hertzOverlap(pair.load/pair.deltaT, kn0);

        return
            factor*pair.deltaT
           *contactConductance(hertzRadius(re, overlap), a.kappa, b.kappa);
    }

    const scalar me =
        1/(parcels.motions[c.a].invMass + parcels.motions[c.b].invMass);

    return
        factor
       *impactHeat(impactOf(pair.approach, me, re, kn0), a.kappa, b.kappa);
}

/*---------------------------------------------------------------------------*\
    cghsFoam | coarse-grained hard spheres in OpenFOAM
    GPL-3.0-or-later, see LICENSE
\*---------------------------------------------------------------------------*/

#include "hardSphere.H"
#include "restitutionScaling.H"
#include "checkedEntry.H"
#include "addToRunTimeSelectionTable.H"

namespace Foam
{
namespace cghs
{
    defineTypeNameAndDebug(hardSphere, 0);
    addToRunTimeSelectionTable(contactModel, hardSphere, dictionary);

    static impactCoeffs readCoeffs(const dictionary& dict)
    {
        return impactCoeffs
        {
            scalarInRange(dict, "restitutionCoefficient", 0, 1),
            scalarInRange(dict, "tangentialRestitutionCoefficient", 0, 1),
            scalarInRange(dict, "frictionCoefficient", 0, GREAT)
        };
    }


    static impactTable readTable
    (
        const dictionary& dict,
        const scalar parcelWeight
    )
    {
        const dictionary& pairs = dict.subDict("parcelParcel");

        impactTable table
        ({
            readCoeffs(pairs),
            readCoeffs(dict.subDict("parcelWall"))
        });

        scalar& e = table[contact::parcelParcel].en;
        e = restitutionScaling::New(dict)->ofParcel(pairs, e, parcelWeight);

        return table;
    }
}
}


Foam::cghs::hardSphere::hardSphere
(
    const dictionary& dict,
    const scalar parcelWeight
)
:
    coeffs_(readTable(dict, parcelWeight)),
    correction_(correctionModel::New(dict))
{}


bool Foam::cghs::hardSphere::needsSpin() const
{
    return
        coeffs_[contact::parcelParcel].mu > 0
     || coeffs_[contact::parcelWall].mu > 0;
}


void Foam::cghs::hardSphere::sweep
(
    const label sweepi,
    contactList& list,
    bodies& b,
    const stepScales& step
)
{
    if (sweepi < nImpactSweeps() - 1)
    {
        correction_->begin(list, b, coeffs_, step);
    }
    else if (sweepi < nImpactSweeps())
    {
        const scalar restingSpeed = correction_->restingSteps()*step.speed;

        forAll(list.contacts, i)
        {
            // A contact that bears load is no impact
            if (list.memories.empty() || list.memories[i].held == 0)
            {
                const contact& c = list.contacts[i];
                collide(c, b, coeffs_[c.surface], step.deltaT, restingSpeed);
            }
        }
    }
    else
    {
        tally_.correctionWork +=
            correction_->sweep
            (
                sweepi - nImpactSweeps(),
                list,
                b,
                coeffs_,
                step
            );
    }
}

/*---------------------------------------------------------------------------*\
    cghsFoam | coarse-grained hard spheres in OpenFOAM
    GPL-3.0-or-later, see LICENSE
\*---------------------------------------------------------------------------*/

#include "hardSphere.H"
#include "restitutionScaling.H"
#include "surfaceTable.H"
#include "frictionEntries.H"
#include "knownEntries.H"
#include "modelList.H"
#include "addToRunTimeSelectionTable.H"

namespace Foam
{
namespace cghs
{
    defineTypeNameAndDebug(hardSphere, 0);
    addToRunTimeSelectionTable(contactModel, hardSphere, dictionary);
    describeModel
    (
        contactModel,
        hardSphere,
        "time-driven impacts with friction and spin, then a correction"
    );

    static impactCoeffs readCoeffs(const dictionary& dict)
    {
        warnUnknownEntries
        (
            dict,
            wordList
            ({
                "restitutionCoefficient", "tangentialRestitutionCoefficient",
                "frictionCoefficient", "rollingFrictionCoefficient"
            })
        );

        return impactCoeffs
        (
            scalarInRange(dict, "restitutionCoefficient", 0, 1),
            scalarInRange(dict, "tangentialRestitutionCoefficient", 0, 1),
            scalarInRange(dict, "frictionCoefficient", 0, GREAT),
            rollingFrictionFrom(dict)
        );
    }


    static impactTable readTable
    (
        const dictionary& dict,
        const scalar parcelWeight
    )
    {
        warnUnknownEntries
        (
            dict,
            wordList
            ({
                "restitutionScaling", "correctionModel", "materials",
                "parcelParcel", "parcelWall"
            })
        );

        const auto scaling = restitutionScaling::New(dict);

        return readSurfaces<impactCoeffs>
        (
            dict,
            [&](const dictionary& surface, const contact::surfaceType type)
            {
                impactCoeffs k(readCoeffs(surface));

                if (type != contact::parcelWall)
                {
                    k.en = scaling->ofParcel
                    (
                        surface,
                        restitution{k.en, k.et, k.mu},
                        parcelWeight
                    );
                }
                return k;
            }
        );
    }
}
}


Foam::cghs::hardSphere::hardSphere
(
    const dictionary& dict,
    const scalar parcelWeight
)
:
    contactModel(materialsOf(dict)),
    coeffs_(readTable(dict, parcelWeight)),
    correction_(correctionModel::New(dict))
{}


bool Foam::cghs::hardSphere::needsSpin() const
{
    return anyOf(coeffs_, [](const impactCoeffs& k) { return k.mu > 0; });
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

/*---------------------------------------------------------------------------*\
    cghsFoam | coarse-grained hard spheres in OpenFOAM
    GPL-3.0-or-later, see LICENSE
-------------------------------------------------------------------------------
Description
    Wrong input is answered with file, entry and what would be right.

\*---------------------------------------------------------------------------*/

#include "contactModel.H"
#include "complaint.H"
#include "claim.H"

#include <catch2/catch.hpp>

namespace Foam
{
namespace cghs
{

namespace
{

const char* const rightInput =
    "contactModel hardSphere;"
    "hardSphereCoeffs"
    "{"
    "    parcelParcel"
    "    {"
    "        restitutionCoefficient 0.9;"
    "        tangentialRestitutionCoefficient 0.33;"
    "        frictionCoefficient 0.1;"
    "    }"
    "    parcelWall { $parcelParcel; }"
    "    restitutionScaling unscaled;"
    "    correctionModel velocity;"
    "    velocityCoeffs { nSweeps 3; overlapShare 0.1; velocityShare 1; }"
    "}";


//- What is said to the right input with one thing made wrong
template<class Spoil>
void settleSpoilt
(
    const char* name,
    const std::initializer_list<const char*>& words,
    const Spoil& spoil
)
{
    dictionary dict(dictionaryOf(rightInput));
    spoil(dict.subDict("hardSphereCoeffs"));
    settleComplaint(name, words, [&]{ contactModel::New(dict, 8); });
}


//- One entry out of its range
template<class Number>
void settleRange
(
    const char* name,
    const char* place,
    const char* entry,
    const Number value,
    const char* range
)
{
    settleSpoilt
    (
        name,
        {"bedProperties", place, entry, range},
        [&](dictionary& dict) { dict.subDict(place).set(entry, value); }
    );
}


//- One entry gone
void settleMissing(const char* name, const char* place, const char* entry)
{
    settleSpoilt
    (
        name,
        {"bedProperties", place, entry},
        [&](dictionary& dict) { dict.subDict(place).remove(entry); }
    );
}

}


TEST_CASE("The right input is taken without complaint", "[input]")
{
    claim taken("input.right", 0);
    const dictionary dict(dictionaryOf(rightInput));
    taken.count
    (
        complaintOf([&]{ contactModel::New(dict, 8); }).empty()
    );
    taken.settle();
}


TEST_CASE("Coefficients out of their range are refused", "[input]")
{
    settleRange
    (
        "input.restitutionAboveOne",
        "parcelParcel", "restitutionCoefficient", 1.01, "[0, 1]"
    );
    settleRange
    (
        "input.restitutionBelowZero",
        "parcelWall", "restitutionCoefficient", -0.01, "[0, 1]"
    );
    settleRange
    (
        "input.tangentialRestitutionAboveOne",
        "parcelWall", "tangentialRestitutionCoefficient", 1.5, "[0, 1]"
    );
    settleRange
    (
        "input.tangentialRestitutionBelowZero",
        "parcelParcel", "tangentialRestitutionCoefficient", -0.5, "[0, 1]"
    );
    settleRange
    (
        "input.negativeFriction",
        "parcelParcel", "frictionCoefficient", -0.1, "[0, "
    );
    settleRange
    (
        "input.negativeSweeps", "velocityCoeffs", "nSweeps", -1, "[0, "
    );
    settleRange
    (
        "input.overlapShareAboveOne",
        "velocityCoeffs", "overlapShare", 1.1, "[0, 1]"
    );
    settleRange
    (
        "input.velocityShareBelowZero",
        "velocityCoeffs", "velocityShare", -1.0, "[0, 1]"
    );
}


TEST_CASE("The limits themselves are in the range", "[input]")
{
    claim taken("input.limits", 0);

    for (const scalar e : {0, 1})
    {
        dictionary dict(dictionaryOf(rightInput));
        dictionary& coeffs = dict.subDict("hardSphereCoeffs");
        dictionary& pairs = coeffs.subDict("parcelParcel");
        dictionary& correction = coeffs.subDict("velocityCoeffs");
        pairs.set("restitutionCoefficient", e);
        pairs.set("tangentialRestitutionCoefficient", e);
        pairs.set("frictionCoefficient", 0);
        correction.set("nSweeps", 0);
        correction.set("overlapShare", e);
        correction.set("velocityShare", e);
        taken.count
        (
            complaintOf([&]{ contactModel::New(dict, 8); }).empty()
        );
    }

    taken.settle();
}


TEST_CASE("A missing entry is asked for by name and place", "[input]")
{
    settleMissing
    (
        "input.missingRestitution", "parcelParcel", "restitutionCoefficient"
    );
    settleMissing
    (
        "input.missingTangentialRestitution",
        "parcelParcel", "tangentialRestitutionCoefficient"
    );
    settleMissing
    (
        "input.missingFriction", "parcelWall", "frictionCoefficient"
    );
    settleMissing
    (
        "input.missingOverlapShare", "velocityCoeffs", "overlapShare"
    );
    settleSpoilt
    (
        "input.missingWall",
        {"bedProperties", "hardSphereCoeffs", "parcelWall"},
        [](dictionary& dict) { dict.remove("parcelWall"); }
    );
    settleSpoilt
    (
        "input.missingScaling",
        {"bedProperties", "hardSphereCoeffs", "restitutionScaling"},
        [](dictionary& dict) { dict.remove("restitutionScaling"); }
    );
    settleSpoilt
    (
        "input.missingCorrection",
        {"bedProperties", "hardSphereCoeffs", "correctionModel"},
        [](dictionary& dict) { dict.remove("correctionModel"); }
    );
}


TEST_CASE("Missing coefficients are asked for at their own place", "[input]")
{
    settleSpoilt
    (
        "input.missingCoeffs",
        {"bedProperties", "velocityCoeffs", "nSweeps"},
        [](dictionary& dict) { dict.remove("velocityCoeffs"); }
    );

    // Entries of the parent are not what was asked for
    settleSpoilt
    (
        "input.coeffsInParent",
        {"bedProperties", "velocityCoeffs", "nSweeps"},
        [](dictionary& dict)
        {
            const dictionary coeffs(dict.subDict("velocityCoeffs"));
            dict.remove("velocityCoeffs");
            dict.merge(coeffs);
        }
    );
}


TEST_CASE("A misspelt model gets the list of those there are", "[input]")
{
    settleSpoilt
    (
        "input.misspeltCorrection",
        {"bedProperties", "correctionModel", "velosity", "none", "velocity"},
        [](dictionary& dict) { dict.set("correctionModel", "velosity"); }
    );
    settleSpoilt
    (
        "input.misspeltScaling",
        {
            "bedProperties", "restitutionScaling", "kinetic",
            "kineticTheory", "logarithmic", "unscaled"
        },
        [](dictionary& dict) { dict.set("restitutionScaling", "kinetic"); }
    );
    settleComplaint
    (
        "input.misspeltContact",
        {"bedProperties", "contactModel", "hardSfere", "none", "hardSphere"},
        []{ contactModel::New(dictionaryOf("contactModel hardSfere;"), 8); }
    );
    settleComplaint
    (
        "input.missingContact",
        {"bedProperties", "contactModel"},
        []{ contactModel::New(dictionaryOf("other none;"), 8); }
    );
}

} // End namespace cghs
} // End namespace Foam

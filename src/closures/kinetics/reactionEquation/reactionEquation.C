/*---------------------------------------------------------------------------*\
    cghsFoam | coarse-grained hard spheres in OpenFOAM
    GPL-3.0-or-later, see LICENSE
\*---------------------------------------------------------------------------*/

#include "FlatOutput.H"
#include "reactionEquation.H"
#include "IStringStream.H"
#include "ops.H"

namespace Foam
{
namespace cghs
{

// What counts as balanced
static const scalar balanced = 1e-9;


[[noreturn]] static void refuse
(
    const dictionary& dict,
    const string& text,
    const string& why
)
{
    FatalIOErrorInFunction(dict)
        << "The equation \"" << text.c_str() << "\" " << why.c_str() << nl
        << "Write it as \"C + 0.5 O2 = CO\"" << nl
        << exit(FatalIOError);
    ::abort();
}

} // End namespace cghs
} // End namespace Foam


Foam::cghs::reactionEquation::reactionEquation
(
    const dictionary& dict,
    const substances& fluid,
    const substances& solids
)
:
    fluid_(fluid),
    solids_(solids),
    fluidGain_(fluid.size(), 0),
    solidGain_(solids.size(), 0),
    fluidProducts_(fluid.size(), 0),
    fluidReactants_(fluid.size(), 0),
    solidReactants_(solids.size(), 0)
{
    const string text(dict.get<string>("equation"));
    const auto middle = text.find('=');

    if (middle == string::npos || text.find('=', middle + 1) != string::npos)
    {
        refuse(dict, text, "does not have one sign =");
    }

    readSide(text.substr(0, middle), -1, dict);
    readSide(text.substr(middle + 1), 1, dict);

    if (max(max(mag(fluidGain_)()), max(mag(solidGain_)())) < balanced)
    {
        refuse(dict, text, "changes nothing");
    }

    if (dict.getOrDefault("lumped", false))
    {
        closeMass(dict);
    }
    checkElements(dict);
}


void Foam::cghs::reactionEquation::readSide
(
    const string& text,
    const scalar sign,
    const dictionary& dict
)
{
    // A sum of names, each with a number before it or not
    std::istringstream words(text);
    std::string next;
    scalar coefficient = 1;
    bool sum = false;
    bool named = false;

    while (words >> next)
    {
        scalar number;
        if (next == "+")
        {
            if (!named)
            {
                refuse(dict, text, "has a + with nothing before it");
            }
            sum = true;
            named = false;
        }
        else if (named)
        {
            refuse(dict, text, "lacks a + before " + next);
        }
        else if (readScalar(next, number))
        {
            if (!(number > 0))
            {
                refuse(dict, text, "has the coefficient " + next);
            }
            coefficient = number;
        }
        else
        {
            add(next, coefficient, sign, dict);
            coefficient = 1;
            named = true;
            sum = false;
        }
    }

    if (!named || sum)
    {
        refuse(dict, text, "has a side that ends without a name");
    }
}


void Foam::cghs::reactionEquation::add
(
    const word& name,
    const scalar coefficient,
    const scalar sign,
    const dictionary& dict
)
{
    const label inFluid = fluid_.find(name);
    const label inSolids = solids_.find(name);

    if ((inFluid < 0) == (inSolids < 0))
    {
        FatalIOErrorInFunction(dict)
            << "The equation \"" << dict.get<string>("equation").c_str()
            << "\" has a substance " << name << " that "
            << (inFluid < 0 ? "is not known" : "is in both, fluid and solids")
            << nl << "Species of the fluid: " << flatOutput(fluid_.names())
            << nl << "Solids: " << flatOutput(solids_.names()) << nl
            << exit(FatalIOError);
    }

    if (inFluid >= 0)
    {
        fluidGain_[inFluid] += sign*coefficient;
        (sign > 0 ? fluidProducts_ : fluidReactants_)[inFluid] += coefficient;
    }
    else
    {
        solidGain_[inSolids] += sign*coefficient;
        if (sign < 0)
        {
            solidReactants_[inSolids] += coefficient;
        }
    }
}


Foam::scalar Foam::cghs::reactionEquation::massGain() const
{
    scalar gain = 0;
    forAll(fluidGain_, k)
    {
        gain += fluidGain_[k]*fluid_[k].M();
    }
    forAll(solidGain_, s)
    {
        gain += solidGain_[s]*solids_[s].M();
    }
    return gain;
}


Foam::scalar Foam::cghs::reactionEquation::massTurned() const
{
    scalar turned = 0;
    forAll(fluidGain_, k)
    {
        turned += mag(fluidGain_[k])*fluid_[k].M();
    }
    forAll(solidGain_, s)
    {
        turned += mag(solidGain_[s])*solids_[s].M();
    }
    return turned;
}


void Foam::cghs::reactionEquation::closeMass(const dictionary& dict)
{
    const word name(dict.get<word>("remainder"));
    const label inFluid = fluid_.find(name);
    const label inSolids = solids_.find(name);

    if (inFluid < 0 && inSolids < 0)
    {
        FatalIOErrorInFunction(dict)
            << "Entry remainder is " << name << ", which is not known" << nl
            << "Valid choices: " << flatOutput(fluid_.names()) << ' '
            << flatOutput(solids_.names()) << nl
            << exit(FatalIOError);
    }

    if (inFluid >= 0)
    {
        fluidGain_[inFluid] -= massGain()/fluid_[inFluid].M();
        fluidProducts_[inFluid] = max(fluidGain_[inFluid], scalar(0));
        fluidReactants_[inFluid] = max(-fluidGain_[inFluid], scalar(0));
    }
    else
    {
        solidGain_[inSolids] -= massGain()/solids_[inSolids].M();
        solidReactants_[inSolids] = max(-solidGain_[inSolids], scalar(0));
    }
}


void Foam::cghs::reactionEquation::checkElements(const dictionary& dict)
{
    HashTable<scalar> gain;
    HashTable<scalar> turned;
    const auto count = [&]
    (
        const scalarField& coefficients,
        const substances& list
    )
    {
        forAll(coefficients, i)
        {
            forAllConstIters(list[i].elements(), element)
            {
                const scalar atoms = coefficients[i]*element.val();
                gain(element.key()) += atoms;
                turned(element.key()) += 0.5*mag(atoms);
            }
        }
    };
    for (const substances* list : {&fluid_, &solids_})
    {
        for (const substance& s : *list)
        {
            forAllConstIters(s.elements(), element)
            {
                gain.set(element.key(), 0);
                turned.set(element.key(), 0);
            }
        }
    }
    count(fluidGain_, fluid_);
    count(solidGain_, solids_);

    const bool lumped = dict.getOrDefault("lumped", false);
    const string text(dict.get<string>("equation"));

    for (const word& element : gain.sortedToc())
    {
        if (turned[element] == 0)
        {
            continue;
        }
        const scalar defect = gain[element]/turned[element];
        if (mag(defect) > balanced && lumped)
        {
            defects_.set(element, defect);
        }
        else if (mag(defect) > balanced)
        {
            FatalIOErrorInFunction(dict)
                << "The equation \"" << text.c_str()
                << "\" has " << gain[element] << " atoms of " << element
                << " more on its right side" << nl
                << "Correct the coefficients; or say lumped yes with a"
                << " remainder, if it is a lumped scheme" << nl
                << exit(FatalIOError);
        }
    }

    if (mag(massGain()) > balanced*massTurned())
    {
        FatalIOErrorInFunction(dict)
            << "The equation \"" << text.c_str() << "\" makes "
            << 1e3*massGain() << " g of " << 5e2*massTurned() << " g" << nl
            << "Correct the coefficients or molar masses; or say lumped yes"
            << " with a remainder, if it is a lumped scheme" << nl
            << exit(FatalIOError);
    }
}


bool Foam::cghs::reactionEquation::hasSolid() const
{
    return max(mag(solidGain_)()) > 0 || max(solidReactants_) > 0;
}

/*---------------------------------------------------------------------------*\
    cghsFoam | coarse-grained hard spheres in OpenFOAM
    GPL-3.0-or-later, see LICENSE
\*---------------------------------------------------------------------------*/

#include "substance.H"
#include "checkedEntry.H"
#include "knownEntries.H"
#include "atomicWeights.H"


Foam::cghs::substance::substance
(
    const word& name,
    const dictionary& dict,
    const word& thermo
)
:
    name_(name),
    M_(0),
    rho_(dict.subOrEmptyDict("equationOfState").getOrDefault<scalar>("rho", 0)),
    straight_(false),
    h0_(0),
    Cp_(0)
{
    const atomicWeightTable weights;

    for (const entry& element : dict.subOrEmptyDict("elements"))
    {
        const scalar n = readScalar(element.stream());
        if (!weights.found(element.keyword()))
        {
            FatalIOErrorInFunction(dict)
                << "Substance " << name << " has an element "
                << element.keyword() << " that nobody knows" << nl
                << "Valid choices: symbols of the periodic table, e.g. C, O"
                << nl << exit(FatalIOError);
        }
        elements_.insert(element.keyword(), n);
        M_ += 1e-3*n*weights[element.keyword()];
    }

    const dictionary& specie = dict.subOrEmptyDict("specie");
    if (elements_.empty())
    {
        if (!specie.found("molWeight"))
        {
            FatalIOErrorInFunction(dict)
                << "Substance " << name
                << " has neither elements nor specie { molWeight ...; }"
                << nl << "Give its elements, e.g. elements { C 1; O 2; }; or,"
                << " for a lump, only its molWeight [kg/kmol]" << nl
                << exit(FatalIOError);
        }
        M_ = 1e-3*positiveScalar(specie, "molWeight");
    }
    else if (specie.found("molWeight"))
    {
        const scalar given = 1e-3*specie.get<scalar>("molWeight");
        if (mag(given/M_ - 1) > 1e-3)
        {
            FatalIOErrorInFunction(specie)
                << "Entry molWeight of " << name << " is " << 1e3*given
                << " but its elements weigh " << 1e3*M_ << " kg/kmol" << nl
                << "Correct the one or the other" << nl
                << exit(FatalIOError);
        }
    }

    if (!thermo.empty())
    {
        // OpenFOAM's specie wants a mass, which enthalpies are counted by
        dictionary whole(dict);
        if (!specie.found("molWeight"))
        {
            dictionary weight;
            weight.add("molWeight", 1e3*M_);
            whole.set("specie", weight);
        }
        enthalpy_ = enthalpyModel::New(thermo, whole);

        // Of a line any two places tell all
        straight_ = enthalpy_->straight();
        if (straight_)
        {
            const scalar T = 300;
            Cp_ = M_*enthalpy_->Cp(T);
            h0_ = M_*enthalpy_->h(T) - Cp_*T;
        }
    }
}


void Foam::cghs::substance::warnUnknown(const dictionary& dict)
{
    const auto warn = [&](const word& part, const wordList& known)
    {
        if (dict.isDict(part))
        {
            warnUnknownEntries(dict.subDict(part), known);
        }
    };
    warn("specie", wordList({"molWeight"}));
    warn("equationOfState", wordList({"rho"}));
    warn("thermodynamics", enthalpyModel::entries());

    warnUnknownEntries
    (
        dict,
        wordList({"elements", "specie", "thermodynamics", "equationOfState"})
    );
}

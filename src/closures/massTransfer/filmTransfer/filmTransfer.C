/*---------------------------------------------------------------------------*\
    cghsFoam | coarse-grained hard spheres in OpenFOAM
    GPL-3.0-or-later, see LICENSE
\*---------------------------------------------------------------------------*/

#include "filmTransfer.H"
#include "checkedEntry.H"
#include "knownEntries.H"
#include "noHeatTransfer.H"

Foam::cghs::filmTransfer::filmTransfer
(
    const dictionary& dict,
    const wordList& asking
)
:
    constant_(0),
    law_(),
    D_(0),
    Sc_(0)
{
    const bool given = dict.found("massTransfer");

    if (asking.size() && !given)
    {
        FatalIOErrorInFunction(dict)
            << "Entry massTransfer is missing, but the laws of "
            << flatOutput(asking) << " in constant/reactions ask for the film"
            << " about particles" << nl
            << "Add massTransfer 0.1; [m/s], or massTransfer { model Gunn;"
            << " D 2e-5; }, or write film no in constant/reactions" << nl
            << exit(FatalIOError);
    }

    if (given && asking.empty())
    {
        WarningInFunction
            << "Entry massTransfer in " << dict.name() << " has no effect: no"
            << " law of constant/reactions asks for a film" << nl
            << "    Remove it, or write film yes there" << nl << endl;
    }
    else if (dict.isDict("massTransfer"))
    {
        readLaw(dict.subDict("massTransfer"));
    }
    else if (given)
    {
        constant_ = positiveScalar(dict, "massTransfer");
    }
}


void Foam::cghs::filmTransfer::readLaw(const dictionary& dict)
{
    const word name(dict.get<word>("model"));

    DynamicList<word> laws;
    for (const word& law : heatTransferModel::names())
    {
        // By which nothing would pass
        if (law != noHeatTransfer::typeName)
        {
            laws.append(law);
        }
    }
    if (!laws.found(name))
    {
        FatalIOErrorInFunction(dict)
            << "Entry model is " << name
            << ", which is no law of mass transfer" << nl
            << "Valid choices: " << flatOutput(laws) << nl
            << "Or write massTransfer as a number [m/s]" << nl
            << exit(FatalIOError);
    }

    law_ = heatTransferModel::New(name, dict);
    readDiffusivity(dict);
    warnUnknownEntries(dict, wordList({"model", "D", "Sc"}));
}


void Foam::cghs::filmTransfer::readDiffusivity(const dictionary& dict)
{
    const bool constant = dict.found("D");
    const bool bySchmidt = dict.found("Sc");

    if (constant == bySchmidt)
    {
        FatalIOErrorInFunction(dict)
            << (constant ? "Both D and Sc are" : "Neither D nor Sc is")
            << " given, but one of them must say how the reactant diffuses"
            << nl << "Write D [m^2/s], e.g. 2e-5 in a gas or 1e-9 in a liquid;"
            << " or Sc = mu/(rho D), e.g. 0.7 or 1000" << nl
            << exit(FatalIOError);
    }

    (constant ? D_ : Sc_) = positiveScalar(dict, constant ? "D" : "Sc");
}


Foam::cghs::heatedFlow Foam::cghs::filmTransfer::diffusing
(
    const heatedFlow& flow
) const
{
    heatedFlow result(flow);
    result.Cp = 1;
    result.kappa = D_ > 0 ? D_*flow.rho : flow.mu/Sc_;

    return result;
}


void Foam::cghs::filmTransfer::coefficients
(
    const UList<heatedFlow>& flows,
    UList<scalar>& k
) const
{
    List<heatedFlow> diffusions(flows.size());
    forAll(flows, i)
    {
        diffusions[i] = diffusing(flows[i]);
    }

    law_->nusselts(diffusions, k);

    forAll(k, i)
    {
        const heatedFlow& f = diffusions[i];

        // Sh D/d
        k[i] *= f.kappa/(f.rho*f.d);
    }
}

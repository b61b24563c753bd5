/*---------------------------------------------------------------------------*\
    cghsFoam | coarse-grained hard spheres in OpenFOAM
    GPL-3.0-or-later, see LICENSE
-------------------------------------------------------------------------------
Description
    Laws of convection: values worked out by hand, the limit of a still fluid,
    batches, and a sphere that cools in a stream.

\*---------------------------------------------------------------------------*/

#include "heatTransferModel.H"
#include "complaint.H"
#include "sampler.H"
#include "scalarField.H"
#include "claim.H"

#include <catch2/catch.hpp>

#include <cmath>

namespace Foam
{
namespace cghs
{

static autoPtr<heatTransferModel> heatLawOf(const std::string& law)
{
    return heatTransferModel::New
    (
        dictionaryOf(("heatTransferModel " + law + ';').c_str())
    );
}


//- A flow with these rho u d/mu and mu Cp/kappa
static heatedFlow flowAt(const scalar e, const scalar Re, const scalar Pr)
{
    const scalar d = 2e-4, rho = 1.2, mu = 1.8e-5, kappa = 0.026;

    return heatedFlow
    (
        slipFlow{e, Re*mu/(rho*d), d, rho, mu},
        Pr*kappa/mu,
        kappa
    );
}


TEST_CASE("Nusselt numbers are those worked out by hand", "[heat]")
{
    struct sample
    {
        const char* law;
        scalar e, Re, Pr;       // Re without voidage
        scalar Nu;
    };

    // 1024^0.2 = 4, 1024^0.7 = 128, 10^0.33 = 2.1379620895, 32^0.6 = 8
    const sample samples[] =
    {
        {"Gunn", 1, 1, 1, 2*1.7 + 0.13},
        {"Gunn", 0.5, 2, 1, 3.25*1.7 + 0.43},
        {"Gunn", 0.5, 2048, 1, 3.25*3.8 + 0.43*128},
        {"Gunn", 0.5, 2, 10, 3.25 + 2.705*2.1379620895},
        {"Gunn", 0.4, 0, 1, 3.8},
        {"RanzMarshall", 1, 100, 8, 14},
        {"RanzMarshall", 0.5, 100, 8, 14},
        {"RanzMarshall", 1, 1e4, 0.125, 32},
        {"Wakao", 1, 32, 8, 19.6},
        {"Wakao", 0.5, 64, 8, 19.6},
        {"Wakao", 0.4, 2560, 1e-3, 9.04}
    };

    claim byHand("heatTransfer.byHand", 1e-10);
    for (const sample& s : samples)
    {
        const scalar Nu = heatLawOf(s.law)->nusselt(flowAt(s.e, s.Re, s.Pr));
        byHand.see(mag(Nu/s.Nu - 1));
    }
    byHand.settle();
}


TEST_CASE("Nu of a single sphere falls to 2 in a still fluid", "[heat]")
{
    claim still("heatTransfer.still", 0);
    claim nearlyStill("heatTransfer.nearlyStill", 1e-7);

    for (const word& name : heatTransferModel::names())
    {
        const autoPtr<heatTransferModel> law(heatLawOf(name));
        const scalar limit = name == "none" ? 0 : 2;
        still.see(mag(law->nusselt(flowAt(1, 0, 0.7)) - limit));
        nearlyStill.see(mag(law->nusselt(flowAt(1, 1e-40, 0.7)) - limit));
    }
    still.settle();
    nearlyStill.settle();
}


TEST_CASE("A batch of Nu has the numbers of one after the other", "[heat]")
{
    claim same("heatTransfer.batch", 0);
    sampler random(1);
    List<heatedFlow> flows(200);
    for (heatedFlow& flow : flows)
    {
        flow = flowAt
        (
            random.between(0.3, 1),
            random.acrossDecades(1e-6, 1e5),
            random.acrossDecades(1e-3, 1e3)
        );
    }

    for (const word& name : heatTransferModel::names())
    {
        const autoPtr<heatTransferModel> law(heatLawOf(name));
        scalarField Nu(flows.size());
        law->nusselts(flows, Nu);
        forAll(flows, i)
        {
            same.see(mag(Nu[i] - law->nusselt(flows[i])));
        }
    }
    same.settle();
}


namespace
{

//- Ask for a batch of one, as the parcels do, at the law's own Re
void ask(const heatTransferModel& law, const scalar e, const scalar Re)
{
    const bool interstitial = law.type() == "RanzMarshall";
    scalarField Nu(1);

    law.nusselts
    (
        List<heatedFlow>(1, flowAt(e, interstitial ? Re : Re/e, 0.7)),
        Nu
    );
}

}


TEST_CASE("Beyond its range a law of convection warns once", "[heat]")
{
    claim once("heatTransfer.warnings", 0);

    for (const word law : {"Gunn", "RanzMarshall", "Wakao"})
    {
        const flowRange range(heatLawOf(law)->range());
        const scalarMinMax& e = range.voidage;
        const scalarMinMax& Re = range.Re;

        const struct { scalar e, Re; } beyond[] =
        {
            {0.99*e.min(), 0.5*Re.max()},
            {1.01*e.max(), 0.5*Re.max()},
            {e.min(), 0.99*Re.min()},
            {e.min(), 1.01*Re.max()}
        };

        for (const auto& asked : beyond)
        {
            if (asked.Re == 0)
            {
                continue;   // there is nothing below
            }

            const autoPtr<heatTransferModel> model(heatLawOf(law));

            once.count(!model->warnOutsideRange());
            ask(*model, 1.001*e.min(), 1.001*Re.min());
            ask(*model, 0.999*e.max(), 0.999*Re.max());
            once.count(!model->warnOutsideRange());

            ask(*model, asked.e, asked.Re);
            once.count(model->warnOutsideRange());
            ask(*model, asked.e, asked.Re);
            once.count(!model->warnOutsideRange());
        }

        // One value alone is not noted
        const autoPtr<heatTransferModel> model(heatLawOf(law));
        model->nusselt(flowAt(0.1, 1e7, 0.7));
        once.count(!model->warnOutsideRange());
    }

    const autoPtr<heatTransferModel> none(heatLawOf("none"));
    ask(*none, 0.1, 1e7);
    once.count(!none->warnOutsideRange());
    once.settle();
}


// A sphere in a stream by Ranz and Marshall: a verification case of MFiX, whose
// rate is 0.87863 1/s. Its inputs are known to half of their last digits:
// conductivity 0.0519 to 1e-3, of which the rate takes 0.70; viscosity 1.86e-5
// to 2.7e-3, of which it takes 0.15; heat capacity 999 to 5e-4, 0.30. That is
// 1.3e-3 in all
TEST_CASE("A sphere cools in a stream at the rate of MFiX", "[heat]")
{
    const scalar d = 3.6e-3, rho = 8850, cp = 55;
    const heatedFlow stream(slipFlow{1, 6, d, 1.1854, 1.86e-5}, 999, 0.0519);

    const scalar Nu = heatLawOf("RanzMarshall")->nusselt(stream);
    const scalar capacity = rho*M_PI/6*pow3(d)*cp;
    const scalar rate = convectiveConductance(stream, Nu)/capacity;

    // 6 Nu kappa/(rho cp d^2) with Re = 1376.5935484 and Pr = 0.3580231214
    settle("heatTransfer.coolingRate", mag(rate/0.87903429779 - 1), 1e-10);
    settle("heatTransfer.coolingRateOfMFiX", mag(rate/0.87863 - 1), 1.3e-3);

    claim temperature("heatTransfer.cooledTo", 1.3e-3);
    for (const scalar t : {1.0, 5.0})
    {
        // Relative to what the rate's tolerance makes of it, 75 t exp(-rate t)
        const scalar difference = 75*exp(-rate*t);
        const scalar ofMFiX = (t == 1 ? 329.30 : 299.08) - 298.15;
        temperature.see
        (
            max(mag(difference - ofMFiX) - 0.005, scalar(0))
           /(rate*t*difference)
        );
    }
    temperature.settle();
}


TEST_CASE("An unknown law of convection is refused", "[heat]")
{
    settleComplaint
    (
        "heatTransfer.unknownLaw",
        {
            "bedProperties", "heatTransferModel", "Gun", "Gunn",
            "RanzMarshall", "Wakao"
        },
        []{ heatLawOf("Gun"); }
    );
}

} // End namespace cghs
} // End namespace Foam

/*---------------------------------------------------------------------------*\
    cghsFoam | coarse-grained hard spheres in OpenFOAM
    GPL-3.0-or-later, see LICENSE
-------------------------------------------------------------------------------
Description
    What drag laws share: batches, ranges, published coefficients, input.

\*---------------------------------------------------------------------------*/

#include "dragSamples.H"
#include "sampler.H"
#include "scalarField.H"
#include "claim.H"

#include <catch2/catch.hpp>

namespace Foam
{
namespace cghs
{

TEST_CASE("A batch has the numbers of one after the other", "[drag]")
{
    claim same("drag.batch", 0);
    sampler random(1);
    const label n = 200;
    List<slipFlow> flows(n);
    scalarField D(n);
    for (slipFlow& f : flows)
    {
        f.e = random.between(0.3, 1);
        f.u = random.acrossDecades(1e-6, 10);
        f.d = random.acrossDecades(1e-5, 1e-3);
        f.rho = random.acrossDecades(0.1, 1000);
        f.mu = random.acrossDecades(1e-6, 1e-3);
    }

    for (const word& name : dragModel::names())
    {
        const autoPtr<dragModel> law(dragLawOf(name));
        law->coefficients(flows, D);
        for (label i = 0; i < n; ++i)
        {
            same.see(mag(D[i] - law->coefficient(flows[i])));
        }
    }
    same.settle();
}


namespace
{

//- Ask for a batch of one, as the parcels do
void ask(const dragModel& law, const scalar e, const scalar Re)
{
    const scalar d = 1e-3;
    scalarField D(1);
    law.coefficients
    (
        List<slipFlow>(1, air.past(e, Re*air.mu/(e*air.rho*d), d)),
        D
    );
}

}


TEST_CASE("Beyond its range a law warns once for each limit", "[drag]")
{
    claim once("drag.warnings", 0);
    for (const word& name : lawsWithDrag())
    {
        const autoPtr<dragModel> law(dragLawOf(name));
        const flowRange range(law->range());

        ask(*law, max(range.voidage.min(), scalar(0.05)), 0.99*range.Re.max());
        once.count(!law->warnOutsideRange());

        ask(*law, 0.9, 1.01*range.Re.max());
        once.count(law->warnOutsideRange());
        once.count(!law->warnOutsideRange());

        if (range.voidage.min() > 0)
        {
            ask(*law, 0.99*range.voidage.min(), 2*range.Re.max());
            once.count(law->warnOutsideRange());
            once.count(!law->warnOutsideRange());
        }
    }

    // One value alone, as who looks for a root asks, is not noted
    const autoPtr<dragModel> bvk(dragLawOf("BVK"));
    overStokes(*bvk, 0.1, 1e6);
    once.count(!bvk->warnOutsideRange());
    once.settle();
}


TEST_CASE("Published coefficients serve where the case has none", "[drag]")
{
    claim published("drag.published", 0);
    const dictionary none(dictionaryOf("other 1;"));

    for (const word& name : lawsWithDrag())
    {
        const autoPtr<dragModel> law(dragModel::NewOrPublished(name, none));
        const bool ofTheCase = name == "Gao" || name == "Igci";
        published.count(law.valid() != ofTheCase);

        if (law.valid() && name != "SyamlalOBrien")
        {
            const autoPtr<dragModel> given(dragLawOf(name));
            for (const scalar e : {0.42, 0.81, 0.94, 0.999})
            {
                published.count
                (
                    overStokes(*law, e, 10) == overStokes(*given, e, 10)
                );
            }
        }
    }

    // The original has no voidage in Re; the case's own coefficients win
    const dictionary original
    (
        dragDict("WenYu", "SyamlalOBrienCoeffs { voidageInRe false; }")
    );
    for (const bool own : {true, false})
    {
        published.count
        (
            overStokes
            (
                dragModel::NewOrPublished
                (
                    "SyamlalOBrien",
                    own ? original : none
                )(),
                0.5,
                10
            )
         == overStokes
            (
                dragLawOf
                (
                    "SyamlalOBrien",
                    "SyamlalOBrienCoeffs { voidageInRe false; }"
                )(),
                0.5,
                10
            )
        );
    }
    published.settle();
}


TEST_CASE("Impossible coefficients of drag laws are refused", "[drag]")
{
    settleComplaint
    (
        "drag.unknownLaw",
        {"bedProperties", "BVKs", "BVK", "EMMS", "Gao", "HillKochLadd", "Igci"},
        []{ dragLawOf("BVKs"); }
    );
    settleComplaint
    (
        "drag.EMMSMissing",
        {"bedProperties", "EMMSCoeffs", "dense"},
        []{ dragModel::New(dictionaryOf("dragModel EMMS;")); }
    );
    settleComplaint
    (
        "drag.EMMSBase",
        {"bedProperties", "EMMSCoeffs", "dilute", "-1650", "-0.5409"},
        []
        {
            dragLawOf
            (
                "EMMS",
                "EMMSCoeffs { dilute (1649.4591 -1650 -0.08597); }"
            );
        }
    );
    settleComplaint
    (
        "drag.EMMSDense",
        {"bedProperties", "EMMSCoeffs", "dense", "zero"},
        []{ dragLawOf("EMMS", "EMMSCoeffs { dense (0.1 1.6 0 20); }"); }
    );
    settleComplaint
    (
        "drag.EMMSOrder",
        {"bedProperties", "EMMSCoeffs", "middleEnd", "0.3", "0.4924"},
        []{ dragLawOf("EMMS", "EMMSCoeffs { middleEnd 0.3; }"); }
    );
    settleComplaint
    (
        "drag.GaoBlend",
        {"bedProperties", "GaoCoeffs", "blendWidth", "0.1", "[0, 0.09]"},
        []{ dragLawOf("Gao", "GaoCoeffs { blendWidth 0.1; }"); }
    );
    settleComplaint
    (
        "drag.GaoDiameter",
        {"bedProperties", "GaoCoeffs", "effectiveDiameter", "zero"},
        []{ dragLawOf("Gao", "GaoCoeffs { effectiveDiameter 0; }"); }
    );
    settleComplaint
    (
        "drag.IgciFilter",
        {"bedProperties", "IgciCoeffs", "filterSize", "-1", "zero"},
        []{ dragLawOf("Igci", "IgciCoeffs { filterSize -1; }"); }
    );
}

} // End namespace cghs
} // End namespace Foam

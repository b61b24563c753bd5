/*---------------------------------------------------------------------------*\
    cghsFoam | coarse-grained hard spheres in OpenFOAM
    GPL-3.0-or-later, see LICENSE
-------------------------------------------------------------------------------
Description
    The partner search against asking each of each.

\*---------------------------------------------------------------------------*/

#include "pairSearch.H"
#include "claim.H"
#include "sampler.H"

#include <catch2/catch.hpp>

#include <algorithm>
#include <iterator>
#include <utility>
#include <vector>

namespace Foam
{
namespace cghs
{

namespace
{

typedef std::vector<std::pair<label, label>> pairList;

//- Spheres with their ids. Guests stand at the end
struct scene
{
    List<sphere> spheres;
    labelList ids;
    label nOwn;
    scalar skin;
};


scene sceneOf(const List<sphere>& spheres, const label nGuests, sampler& random)
{
    scene s;
    s.spheres = spheres;
    s.ids = random.shuffled(spheres.size());
    s.nOwn = spheres.size() - nGuests;
    s.skin = 1e-4;
    return s;
}


scalar reachOf(const scene& s)
{
    scalar largest = 0;
    for (const sphere& i : s.spheres)
    {
        largest = max(largest, i.r);
    }
    return 2*largest + s.skin;
}


//- The same scene, its own spheres in this order
scene reordered(const scene& s, const labelUList& order)
{
    scene t(s);
    forAll(order, i)
    {
        t.spheres[i] = s.spheres[order[i]];
        t.ids[i] = s.ids[order[i]];
    }
    return t;
}


//- Lay the grid, and put the scene into its order
scene sorted(pairSearch& search, const scene& s)
{
    const SubList<sphere> own(s.spheres, s.nOwn);
    const SubList<label> ids(s.ids, s.nOwn);
    return reordered(s, search.order(own, ids, s.skin));
}


std::pair<label, label> pairOf(const label i, const label j)
{
    return std::make_pair(min(i, j), max(i, j));
}


//- The ids of all pairs, as often as the search gives them
pairList found(const pairSearch& search, const scene& s)
{
    pairList pairs;
    search.forOwnPairs([&](const label i, const label j)
    {
        pairs.push_back(pairOf(s.ids[i], s.ids[j]));
    });
    for (const labelPair& p : search.guestPairs())
    {
        pairs.push_back(pairOf(s.ids[p.first()], s.ids[p.second()]));
    }
    std::sort(pairs.begin(), pairs.end());
    return pairs;
}


//- The ids of all pairs but those of two guests, each asked of each
pairList expected(const scene& s, const scalar skin)
{
    pairList pairs;
    for (label i = 0; i < s.nOwn; ++i)
    {
        for (label j = i + 1; j < s.spheres.size(); ++j)
        {
            const sphere& a = s.spheres[i];
            const sphere& b = s.spheres[j];

            if (magSqr(b.x - a.x) < sqr(a.r + b.r + skin))
            {
                pairs.push_back(pairOf(s.ids[i], s.ids[j]));
            }
        }
    }
    std::sort(pairs.begin(), pairs.end());
    return pairs;
}


//- How many pairs are in one list only, or more often in one
label mismatch(const pairList& p, const pairList& q)
{
    pairList difference;
    std::set_symmetric_difference
    (
        p.begin(), p.end(), q.begin(), q.end(), std::back_inserter(difference)
    );
    return difference.size();
}


//- Check that the search finds the pairs of a scene, whichever way it runs,
//  and that there are at least so many
void settleScene(const char* name, const scene& s, const size_t atLeast)
{
    claim complete(name, 0);

    for (direction axis = 0; axis < 3; ++axis)
    {
        pairSearch search(axis);
        const scene t(sorted(search, s));
        search.build(t.spheres, t.nOwn, t.skin);

        const pairList pairs(found(search, t));
        complete.see(mismatch(pairs, expected(s, s.skin)));
        complete.see(mag(search.nPairs() - label(pairs.size())));
    }

    CHECK(expected(s, s.skin).size() >= atLeast);
    complete.settle();
}


//- Spheres in the box between two corners, of radii 1e-3 to 1e-3 times ratio
List<sphere> scattered
(
    const label n,
    const vector& low,
    const vector& high,
    const scalar ratio,
    sampler& random
)
{
    List<sphere> spheres(n);
    for (sphere& s : spheres)
    {
        const scalar r = 1e-3*(ratio > 1 ? random.acrossDecades(1, ratio) : 1);
        s = sphere(random.inBox(low, high), r);
    }
    return spheres;
}

const vector origin(0, 0, 0);

}


TEST_CASE("All pairs of a crowd are found, each once", "[search]")
{
    sampler random(71);
    const vector box(0.03, 0.02, 0.025);

    settleScene
    (
        "search.monodisperse",
        sceneOf(scattered(2000, origin, box, 1, random), 0, random),
        1000
    );
    settleScene
    (
        "search.tenToOne",
        sceneOf(scattered(1500, origin, 4*box, 10, random), 0, random),
        1000
    );
    settleScene
    (
        "search.farFromOrigin",
        sceneOf
        (
            scattered
            (
                1000,
                vector(-1e3, 2e3, 5e2),
                vector(-1e3, 2e3, 5e2) + box,
                3,
                random
            ),
            0,
            random
        ),
        1000
    );
}


TEST_CASE("Flat and thin crowds are no different", "[search]")
{
    sampler random(72);

    for (direction d = 0; d < 3; ++d)
    {
        static const char* const plane[3] =
            {"search.planeX", "search.planeY", "search.planeZ"};
        static const char* const line[3] =
            {"search.lineX", "search.lineY", "search.lineZ"};

        vector flat(vector::uniform(0.1));
        flat[d] = 0;
        settleScene
        (
            plane[d],
            sceneOf(scattered(1000, origin, flat, 2, random), 0, random),
            100
        );

        vector thin(Zero);
        thin[d] = 1;
        settleScene
        (
            line[d],
            sceneOf(scattered(500, origin, thin, 1, random), 0, random),
            100
        );
    }
}


TEST_CASE("Spheres on a lattice touch across the cells of the grid", "[search]")
{
    sampler random(73);
    List<sphere> spheres;

    // As far apart as the search may look: cells end where spheres stand
    for (label i = 0; i < 8*8*8; ++i)
    {
        const vector x(i % 8, i/8 % 8, i/64);
        spheres.append(sphere(2.0999e-3*x, 1e-3));
    }

    settleScene("search.lattice", sceneOf(spheres, 0, random), 3*7*8*8);
}


TEST_CASE("Few large among many small ones, and the other way", "[search]")
{
    sampler random(84);
    const vector box(0.04, 0.03, 0.05);

    for (const scalar ratio : {10, 30})
    {
        static const char* const names[2][3] =
        {
            {"search.fewLarge10", "search.manyLarge10", "search.even10"},
            {"search.fewLarge30", "search.manyLarge30", "search.even30"}
        };
        const label nLarge[3] = {5, 1000, 200};
        const label nSmall[3] = {3000, 10, 200};

        for (label k = 0; k < 3; ++k)
        {
            List<sphere> spheres(scattered(nSmall[k], origin, box, 1, random));
            for (const sphere& s : scattered(nLarge[k], origin, box, 1, random))
            {
                spheres.append(sphere(s.x, ratio*s.r));
            }

            // Guests are the last ones: large
            scene s(sceneOf(spheres, nLarge[k]/3, random));
            s.skin = 1e-3;
            settleScene(names[ratio > 10][k], s, 100);
        }
    }
}


TEST_CASE("Clusters of any sizes are no different", "[search]")
{
    sampler random(85);

    for (const scalar ratio : {10, 30, 3000})
    {
        static const char* const names[3] =
            {"search.clusters10", "search.clusters30", "search.clusters3000"};

        List<sphere> spheres;
        for (label cluster = 0; cluster < 12; ++cluster)
        {
            const vector centre(random.inBox(origin, vector::uniform(3)));
            const vector size
            (
                vector::uniform(random.acrossDecades(0.003, 0.3))
            );
            spheres.append
            (
                scattered(100, centre - size, centre + size, ratio, random)
            );
        }

        // Strays, as far off as parcels ever are
        spheres.append
        (
            scattered
            (
                20,
                vector::uniform(-1e4),
                vector::uniform(1e4),
                ratio,
                random
            )
        );

        const label n = spheres.size();
        const List<sphere> twins(spheres);
        spheres.append(twins);
        for (label i = n; i < 2*n; ++i)
        {
            spheres[i].x += 3e-3*random.direction();
        }

        settleScene
        (
            names[ratio > 1000 ? 2 : ratio > 10],
            sceneOf(spheres, n/2, random),
            1000
        );
    }
}


namespace
{

//- Spheres of radius 1e-3 among larger ones that take up as much room, at
//  random in a box that they fill to about 0.6
List<sphere> mixture(const label nSmall, const scalar ratio, sampler& random)
{
    const label nLarge = nSmall/pow3(ratio);
    const scalar volume = 4.19e-9*(nSmall + nLarge*pow3(ratio));
    const vector box(vector::uniform(cbrt(volume/0.6)));

    List<sphere> spheres;
    for (const sphere& s : scattered(nLarge, origin, box, 1, random))
    {
        spheres.append(sphere(s.x, ratio*s.r));
    }

    // Small ones keep out of large ones, as they do where they collide
    while (spheres.size() < nLarge + nSmall)
    {
        const sphere s(random.inBox(origin, box), 1e-3);
        bool free = true;
        for (label i = 0; i < nLarge && free; ++i)
        {
            free = magSqr(spheres[i].x - s.x) > sqr(spheres[i].r);
        }
        if (free)
        {
            spheres.append(s);
        }
    }
    return spheres;
}


//- Distances that a search measures for each sphere
scalar checksPerSphere(const List<sphere>& spheres, sampler& random)
{
    scene s(sceneOf(spheres, 0, random));
    s.skin = 4e-4;
    pairSearch search(1);
    s = sorted(search, s);
    search.build(s.spheres, s.nOwn, s.skin);
    return scalar(search.nChecks(s.spheres, s.nOwn, s.skin))/s.nOwn;
}

}


TEST_CASE("What a search costs does not grow with the ratio of sizes",
    "[search]")
{
    sampler random(86);
    const scalar equal = checksPerSphere(mixture(30000, 1, random), random);

    static const char* const names[3] =
        {"search.checks3to1", "search.checks10to1", "search.checks30to1"};
    const scalar ratios[3] = {3, 10, 30};

    for (label k = 0; k < 3; ++k)
    {
        // The small ones fill what the large ones leave, less densely than
        // equal ones: no more is to be checked
        settle
        (
            names[k],
            checksPerSphere(mixture(30000, ratios[k], random), random)/equal,
            1
        );
    }

    // A broad distribution, all sizes in equal volumes
    List<sphere> spheres;
    for (label octave = 0; octave < 5; ++octave)
    {
        const scalar r = 1e-3*(1 << octave);
        for (const sphere& s : scattered
        (
            40000 >> 3*octave, origin, vector::uniform(0.11), 1, random
        ))
        {
            spheres.append(sphere(s.x, r*random.between(1, 2)));
        }
    }
    settle
    (
        "search.checksBroad",
        checksPerSphere(spheres, random)/equal,
        3
    );
}


TEST_CASE("Few spheres are no different", "[search]")
{
    sampler random(74);
    const List<sphere> two
    ({
        sphere(vector(1, 2, 3), 1e-3), sphere(vector(1.001, 2, 3), 1e-3)
    });

    settleScene("search.none", sceneOf(List<sphere>(), 0, random), 0);
    settleScene("search.one", sceneOf(List<sphere>(1, two[0]), 0, random), 0);
    settleScene("search.two", sceneOf(two, 0, random), 1);
    settleScene("search.oneAndGuest", sceneOf(two, 1, random), 1);
    settleScene("search.guestsAlone", sceneOf(two, 2, random), 0);
}


TEST_CASE("Coincident spheres are pairs, each once", "[search]")
{
    sampler random(75);
    List<sphere> spheres(60, sphere(vector(0.1, 0.2, 0.3), 1e-3));
    settleScene("search.coincident", sceneOf(spheres, 0, random), 60*59/2);

    // And beside a crowd, twice on the same spot
    spheres = scattered(300, origin, vector::uniform(0.01), 1, random);
    const List<sphere> twins(spheres);
    spheres.append(twins);
    settleScene("search.twins", sceneOf(spheres, 50, random), 300);
}


TEST_CASE("A scene of 1e6 radii costs no more memory than a crowd", "[search]")
{
    sampler random(76);
    const label n = 600;

    static const char* const names[4] =
    {
        "search.sparseBox", "search.sparsePlane", "search.sparseLine",
        "search.sparseWithHeap"
    };
    const vector boxes[4] =
    {
        vector::uniform(1e3), vector(1e3, 0, 1e3), vector(0, 1e3, 0),
        vector::uniform(1e3)
    };
    claim memory("search.sparseBytesPerSphere", 200);

    for (label b = 0; b < 4; ++b)
    {
        List<sphere> spheres(scattered(n, origin, boxes[b], 1, random));

        // Some partners, or there were none to find; at last a whole heap
        const label nPartners = b == 3 ? n - 1 : 50;
        for (label i = 0; i < nPartners; ++i)
        {
            const vector near(spheres[b == 3 ? n - 1 : 2*i].x);
            const scalar distance = random.between(0, b == 3 ? 0.01 : 0.002);
            spheres[b == 3 ? i : 2*i + 1].x =
                near + distance*random.direction();
        }

        const scene s(sceneOf(spheres, 0, random));
        settleScene(names[b], s, 50);

        if (b < 3)
        {
            pairSearch search(2);
            const scene t(sorted(search, s));
            search.build(t.spheres, t.nOwn, t.skin);
            memory.see(scalar(search.bytes())/n);
        }
    }

    memory.settle();
}


TEST_CASE("Guests pair with own spheres, never with each other", "[search]")
{
    sampler random(77);
    const vector box(0.03, 0.02, 0.025);

    // All among the own ones
    settleScene
    (
        "search.guestsAmong",
        sceneOf(scattered(1500, origin, box, 3, random), 500, random),
        1000
    );

    // All around them: own in the middle third of the box
    List<sphere> spheres(scattered(400, box/3, 2*box/3, 2, random));
    const label nAround = 3000;
    spheres.append(scattered(nAround, -0.2*box, 1.2*box, 2, random));
    settleScene
    (
        "search.guestsAround", sceneOf(spheres, nAround, random), 1000
    );

    // Beyond all reach
    spheres = scattered(200, origin, box, 1, random);
    spheres.append(scattered(200, 1e3*box, 2e3*box, 1, random));
    spheres.append(scattered(200, -2e9*box, -1e9*box, 1, random));
    settleScene("search.guestsFarOff", sceneOf(spheres, 400, random), 10);
}


TEST_CASE("The order does not depend on the order before", "[search]")
{
    claim same("search.orderOfPermuted", 0);
    sampler random(78);
    const scene s
    (
        sceneOf
        (
            scattered(800, origin, vector(0.02, 0.03, 0.04), 4, random),
            0,
            random
        )
    );

    for (direction axis = 0; axis < 3; ++axis)
    {
        pairSearch search(axis);
        const scene once(sorted(search, s));

        for (label trial = 0; trial < 20; ++trial)
        {
            const scene shuffled(reordered(s, random.shuffled(s.nOwn)));
            same.count(sorted(search, shuffled).ids == once.ids);
        }
    }

    same.settle();
}


TEST_CASE("The order is a permutation, by layers along the chosen axis",
    "[search]")
{
    claim permutation("search.orderIsPermutation", 0);
    claim layered("search.layersFollow", 0);
    sampler random(79);
    const vector box(0.02, 0.03, 0.04);
    const scene s
    (
        sceneOf(scattered(3000, origin, box, 1, random), 0, random)
    );

    for (direction axis = 0; axis < 3; ++axis)
    {
        pairSearch search(axis);
        scene t(sorted(search, s));

        scalar low = GREAT;
        for (const sphere& i : t.spheres)
        {
            low = min(low, i.x[axis]);
        }

        label lastLayer = 0;
        for (const sphere& i : t.spheres)
        {
            const label layer((i.x[axis] - low)/reachOf(s));
            layered.count(layer >= lastLayer);
            lastLayer = layer;
        }

        labelList ids(t.ids);
        std::sort(ids.begin(), ids.end());
        forAll(ids, i)
        {
            permutation.count(ids[i] == i);
        }
    }

    permutation.settle();
    layered.settle();
}


TEST_CASE("Own pairs are visited by rising first sphere", "[search]")
{
    claim rising("search.visitsRise", 0);
    sampler random(80);
    pairSearch search(1);

    for (const scalar ratio : {1, 10})
    {
        const scene s
        (
            sorted
            (
                search,
                sceneOf
                (
                    scattered
                    (
                        500, origin, vector::uniform(0.02), ratio, random
                    ),
                    0,
                    random
                )
            )
        );
        search.build(s.spheres, s.nOwn, s.skin);

        label last = 0;
        search.forOwnPairs([&](const label i, const label j)
        {
            rising.count(i >= last && j > i);
            last = i;
        });
    }

    rising.settle();
}


TEST_CASE("The pairs stay complete while nobody moves by half the skin",
    "[search]")
{
    claim complete("search.skinKeepsPairs", 0);
    sampler random(81);

    for (label trial = 0; trial < 10; ++trial)
    {
        pairSearch search(trial % 3);
        scene s
        (
            sceneOf
            (
                scattered(800, origin, vector::uniform(0.025), 3, random),
                200,
                random
            )
        );
        s.skin = 5e-4;
        s = sorted(search, s);
        search.build(s.spheres, s.nOwn, s.skin);
        const pairList listed(found(search, s));

        for (sphere& i : s.spheres)
        {
            i.x += (0.499*s.skin)*random.direction();
        }

        for (const std::pair<label, label>& touching : expected(s, 0))
        {
            complete.count
            (
                std::binary_search(listed.begin(), listed.end(), touching)
            );
        }
    }

    complete.settle();
}


TEST_CASE("A search can be used again and again", "[search]")
{
    claim complete("search.reused", 0);
    sampler random(82);
    pairSearch search(2);

    for (const label n : {500, 3, 0, 1000, 1, 200})
    {
        const vector box(random.inBox(origin, vector::uniform(0.05)));
        const scene s
        (
            sceneOf(scattered(n, origin, box, 2, random), n/5, random)
        );
        const scene t(sorted(search, s));
        search.build(t.spheres, t.nOwn, t.skin);

        const pairList pairs(found(search, t));
        complete.see(mismatch(pairs, expected(s, s.skin)));
        complete.see(mag(search.nPairs() - label(pairs.size())));
    }

    complete.settle();
}

} // End namespace cghs
} // End namespace Foam

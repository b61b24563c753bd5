/*---------------------------------------------------------------------------*\
    cghsFoam | coarse-grained hard spheres in OpenFOAM
    GPL-3.0-or-later, see LICENSE
\*---------------------------------------------------------------------------*/

#include "departures.H"
#include "Pstream.H"

#include <algorithm>

Foam::cghs::departures::departures(const label nPatches)
:
    n_(0),
    mass_(nPatches, Zero),
    keeps_(false),
    kept_()
{}


void Foam::cghs::departures::note
(
    const arena& parcels,
    const label i,
    const label patchi
)
{
    ++n_;
    mass_[patchi] += parcels.motions[i].mass();
    parcels.noteOut(i, patchi);

    if (keeps_)
    {
        kept_.append
        (
            departure
            {
                parcels.diameters[i],
                parcels.weights[i],
                parcels.density(i),
                parcels.ids[i],
                patchi,
                parcels.row(i)
            }
        );
    }
}


Foam::List<Foam::cghs::departure>
Foam::cghs::departures::collect()
{
    List<List<departure>> ofRanks(Pstream::nProcs());
    ofRanks[Pstream::myProcNo()] = kept_;
    kept_.clear();

    Pstream::gatherList(ofRanks);
    Pstream::scatterList(ofRanks);

    DynamicList<departure> all;
    for (const List<departure>& ofRank : ofRanks)
    {
        all.append(ofRank);
    }

    std::sort
    (
        all.begin(),
        all.end(),
        [](const departure& a, const departure& b) { return a.id < b.id; }
    );

    return List<departure>(std::move(all));
}

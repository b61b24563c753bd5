/*---------------------------------------------------------------------------*\
    cghsFoam | coarse-grained hard spheres in OpenFOAM
    GPL-3.0-or-later, see LICENSE
\*---------------------------------------------------------------------------*/

#include "parcelKinds.H"
#include "cloudProperties.H"
#include "particleSizes.H"
#include "HashTable.H"
#include "Pstream.H"
#include "IOstreams.H"

#include <algorithm>

namespace Foam
{
namespace cghs
{

typedef FixedList<label, 3> kindKey;
typedef HashTable<parcelKind, kindKey, kindKey::Hash<>> kindTable;

//- More are summed up
constexpr label fewKinds = 6;


//- The same for what differs by less than about a percent
static label rounded(const scalar value)
{
    return label(std::lround(100*std::log(value)));
}


//- Add parcels of one kind. d, rho and W are sums until they are divided
static void add(kindTable& kinds, const parcelKind& k)
{
    parcelKind& sum =
        kinds(kindKey({rounded(k.d), rounded(k.rho), rounded(k.W)}));

    sum.d += k.nParcels*k.d;
    sum.rho += k.nParcels*k.rho;
    sum.W += k.nParcels*k.W;
    sum.nParcels += k.nParcels;
    sum.nParticles += k.nParticles;
    sum.mass += k.mass;
}


//- Divide by the number
static List<parcelKind> meansOf(const kindTable& kinds)
{
    DynamicList<parcelKind> means;
    forAllConstIters(kinds, it)
    {
        parcelKind k(it());
        k.d /= k.nParcels;
        k.rho /= k.nParcels;
        k.W /= k.nParcels;
        means.append(k);
    }
    return List<parcelKind>(std::move(means));
}


static List<parcelKind> ofThisRank(const arena& parcels)
{
    kindTable kinds;
    for (label i = 0; i < parcels.size(); ++i)
    {
        parcelKind k;
        k.d = parcels.diameters[i];
        k.rho = parcels.density(i);
        k.W = parcels.weights[i];
        k.nParcels = 1;
        k.nParticles = k.W;
        k.mass = parcels.motions[i].mass();
        add(kinds, k);
    }
    return meansOf(kinds);
}


static List<parcelKind> ofAllRanks(const arena& parcels)
{
    const List<parcelKind> own(ofThisRank(parcels));
    List<List<scalar>> packed(Pstream::nProcs());
    List<scalar>& mine = packed[Pstream::myProcNo()];

    for (const parcelKind& k : own)
    {
        mine.append
        (
            List<scalar>({k.d, k.rho, k.W, k.nParcels, k.nParticles, k.mass})
        );
    }
    Pstream::gatherList(packed);
    Pstream::scatterList(packed);

    kindTable kinds;
    for (const List<scalar>& rows : packed)
    {
        for (label i = 0; i < rows.size(); i += 6)
        {
            parcelKind k;
            k.d = rows[i];
            k.rho = rows[i + 1];
            k.W = rows[i + 2];
            k.nParcels = rows[i + 3];
            k.nParticles = rows[i + 4];
            k.mass = rows[i + 5];
            add(kinds, k);
        }
    }
    return meansOf(kinds);
}


//- Of a feeder, or of constantProperties: the largest of a distribution
static parcelKind toCome(const dictionary& properties, const dictionary& feeder)
{
    const particleProperties particle(properties, feeder);
    Random random(1);

    parcelKind k;
    k.d = particleSizes(feeder, particle, random).largest();
    k.rho = particle.density;
    k.W = particle.weight;
    return k;
}


static List<parcelKind> allToCome(const dictionary& properties)
{
    DynamicList<parcelKind> kinds;
    for (const entry& e : properties.subOrEmptyDict("feeding"))
    {
        if (e.isDict() && e.dict().found("massFlowRate"))
        {
            kinds.append(toCome(properties, e.dict()));
        }
    }
    if
    (
        kinds.empty()
     && properties.subDict("constantProperties").found("diameter")
    )
    {
        kinds.append(toCome(properties, dictionary::null));
    }
    return List<parcelKind>(std::move(kinds));
}


//- The smallest, one of the mean volume for all, and the largest
static List<parcelKind> summedUp(const List<parcelKind>& kinds)
{
    parcelKind smallest(kinds.first());
    parcelKind mean(sumOf(kinds));
    parcelKind largest(kinds.last());

    for (parcelKind* end : {&smallest, &largest})
    {
        mean.nParcels -= end->nParcels;
        mean.nParticles -= end->nParticles;
        mean.mass -= end->mass;
    }
    return List<parcelKind>({smallest, mean, largest});
}

} // End namespace cghs
} // End namespace Foam


Foam::scalar Foam::cghs::parcelKind::parcelMass() const
{
    return rho*constant::mathematical::pi/6*pow3(d)*W;
}


Foam::List<Foam::cghs::parcelKind> Foam::cghs::parcelKindsOf
(
    const caseView& view
)
{
    List<parcelKind> kinds(ofAllRanks(view.cloud.parcels()));
    std::sort(kinds.begin(), kinds.end());

    if (kinds.empty())
    {
        return allToCome(view.cloud.properties());
    }
    return kinds.size() > fewKinds ? summedUp(kinds) : kinds;
}


Foam::cghs::parcelKind Foam::cghs::sumOf(const UList<parcelKind>& kinds)
{
    parcelKind sum;
    scalar volume = 0;
    for (const parcelKind& k : kinds)
    {
        sum.nParcels += k.nParcels;
        sum.nParticles += k.nParticles;
        sum.mass += k.mass;
        volume += k.mass/k.rho;
    }
    if (sum.nParcels > 0)
    {
        sum.rho = sum.mass/volume;
        sum.W = sum.nParticles/sum.nParcels;
        sum.d = cbrt(6*volume/(constant::mathematical::pi*sum.nParticles));
    }
    return sum;
}


Foam::scalar Foam::cghs::largestParcel(const UList<parcelKind>& kinds)
{
    scalar d = 0;
    for (const parcelKind& k : kinds)
    {
        d = max(d, k.parcelDiameter());
    }
    return d;
}


Foam::scalar Foam::cghs::smallestParcel(const UList<parcelKind>& kinds)
{
    scalar d = GREAT;
    for (const parcelKind& k : kinds)
    {
        d = min(d, k.parcelDiameter());
    }
    return d;
}

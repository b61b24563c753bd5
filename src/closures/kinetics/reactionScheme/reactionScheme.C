/*---------------------------------------------------------------------------*\
    cghsFoam | coarse-grained hard spheres in OpenFOAM
    GPL-3.0-or-later, see LICENSE
\*---------------------------------------------------------------------------*/

#include "reactionScheme.H"
#include "knownEntries.H"

namespace Foam
{
namespace cghs
{

static wordList speciesOf(const dictionary& thermophysics)
{
    wordList names;
    if (!thermophysics.readIfPresent("species", names) || names.empty())
    {
        FatalIOErrorInFunction(thermophysics)
            << "There are no species in the fluid" << nl
            << "Add an entry species, e.g. (O2 CO2 N2)" << nl
            << exit(FatalIOError);
    }
    return names;
}


static bool readSize(const dictionary& dict, const substances& solids)
{
    const word size
    (
        dict.getOrDefault<word>("size", "constantDiameter")
    );

    if (size != "constantDiameter" && size != "constantDensity")
    {
        FatalIOErrorInFunction(dict)
            << "Entry size is " << size << nl
            << "Valid choices: constantDiameter constantDensity" << nl
            << exit(FatalIOError);
    }

    const bool constantDensity = size == "constantDensity";
    for (const substance& solid : solids)
    {
        if (constantDensity && !(solid.rho() > 0))
        {
            FatalIOErrorInFunction(dict)
                << "The solid " << solid.name() << " has no density, but size"
                << " is constantDensity" << nl
                << "Add to it: equationOfState { rho ...; } [kg/m^3]" << nl
                << exit(FatalIOError);
        }
    }
    return constantDensity;
}


static void warnUnknown(const dictionary& dict)
{
    wordList known({"solids", "solidThermo", "size", "reactions", "species"});

    // Of a liquid
    const wordList species(dict.getOrDefault("species", wordList()));
    for (const word& name : species)
    {
        substance::warnUnknown(dict.subOrEmptyDict(name));
    }
    known.append(species);

    for (const entry& solid : dict.subOrEmptyDict("solids"))
    {
        substance::warnUnknown(solid.dict());
    }

    // Others may be variables
    warnUnknownEntries(dict, known, true);
}

} // End namespace cghs
} // End namespace Foam


Foam::cghs::reactionScheme::reactionScheme
(
    const dictionary& dict,
    const dictionary& thermophysics,
    const bool energetic
)
:
    energetic_(energetic),
    fluid_
    (
        speciesOf(thermophysics),
        thermophysics,
        energetic
      ? thermophysics.subDict("thermoType").get<word>("thermo")
      : word()
    ),
    solids_
    (
        dict.subOrEmptyDict("solids").toc(),
        dict.subOrEmptyDict("solids"),
        energetic ? dict.getOrDefault<word>("solidThermo", "hConst") : word()
    ),
    constantDensity_(readSize(dict, solids_))
{
    warnUnknown(dict);

    const dictionary& list = dict.subDict("reactions");

    for (const entry& e : list)
    {
        autoPtr<reaction> made
        (
            new reaction(e.keyword(), e.dict(), fluid_, solids_)
        );

        PtrList<reaction>& place =
            made->inFluid() ? inFluid_ : inParticles_;
        place.append(made.ptr());
    }
}


Foam::wordList Foam::cghs::reactionScheme::askingForFilm() const
{
    DynamicList<word> asking;

    for (const reaction& r : inParticles_)
    {
        bool asks = false;
        for (const rateArgument& a : r.law().arguments())
        {
            asks = asks || a.what == rateArgument::film;
        }
        if (asks)
        {
            asking.append(r.name());
        }
    }
    return wordList(asking);
}


void Foam::cghs::reactionScheme::report(Ostream& os) const
{
    for (const PtrList<reaction>* place : {&inParticles_, &inFluid_})
    {
        for (const reaction& r : *place)
        {
            os  << "Reaction " << r.name()
                << (r.inFluid() ? ", in the fluid" : ", in particles") << nl;

            const HashTable<scalar>& defects = r.equation().defects();
            for (const word& element : defects.sortedToc())
            {
                os  << "    lumped: turns " << 100*defects[element]
                    << " % of its " << element << " into nothing or makes it"
                    << nl;
            }
        }
    }
}

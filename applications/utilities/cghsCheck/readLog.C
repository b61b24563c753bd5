/*---------------------------------------------------------------------------*\
    cghsFoam | coarse-grained hard spheres in OpenFOAM
    GPL-3.0-or-later, see LICENSE
\*---------------------------------------------------------------------------*/

#include "readLog.H"

#include <dlfcn.h>

// * * * * * * * * * * * In place of the library's own * * * * * * * * * * * //

Foam::dictionary::const_searcher Foam::dictionary::csearch
(
    const word& keyword,
    enum keyType::option matchOpt
) const
{
    typedef const_searcher (*search)
    (
        const dictionary*,
        const word&,
        enum keyType::option
    );
    static const search librarys = reinterpret_cast<search>
    (
        dlsym
        (
            RTLD_NEXT,
            "_ZNK4Foam10dictionary7csearchERKNS_4wordENS_7keyType6optionE"
        )
    );

    if (!librarys)
    {
        FatalErrorInFunction
            << "This OpenFOAM has another dictionary::csearch than v1912" << nl
            << "Its name is to be mended in readLog.C" << nl
            << abort(FatalError);
    }

    const const_searcher finder(librarys(this, keyword, matchOpt));
    cghs::readLog::log().note(*this, keyword, finder.ptr());

    return finder;
}

// * * * * * * * * * * * * * * * * * Public  * * * * * * * * * * * * * * * * //

Foam::cghs::readLog& Foam::cghs::readLog::log()
{
    // Asked for by others when they end, after statics of this file might have
    static readLog* only = new readLog;
    return *only;
}


void Foam::cghs::readLog::note
(
    const dictionary& dict,
    const word& asked,
    const entry* found
)
{
    questions& q = byDictionary_(dict.name());

    if (found)
    {
        q.found.insert(found->keyword());
    }
    else
    {
        q.missed.insert(asked);
    }
}


bool Foam::cghs::readLog::found
(
    const dictionary& dict,
    const keyType& keyword
) const
{
    const auto q = byDictionary_.cfind(dict.name());

    return q.found() && q().found.found(keyword);
}


bool Foam::cghs::readLog::anyFound(const dictionary& dict) const
{
    const auto q = byDictionary_.cfind(dict.name());

    return q.found() && q().found.size();
}


Foam::wordList Foam::cghs::readLog::missed(const dictionary& dict) const
{
    // Not by a search, which would be noted
    const wordHashSet there(dict.toc());
    DynamicList<word> names;
    const auto q = byDictionary_.cfind(dict.name());

    if (q.found())
    {
        for (const string& name : q().missed.sortedToc())
        {
            const word asked(name, false);

            if (!there.found(asked))
            {
                names.append(asked);
            }
        }
    }

    return wordList(std::move(names));
}


bool Foam::cghs::readLog::works()
{
    // By the library's lookup, which asks its own search or this one
    dictionary probe("readLogProbe");
    probe.add("asked", 1);
    probe.lookupEntry("asked", keyType::LITERAL);

    return log().found(probe, "asked");
}

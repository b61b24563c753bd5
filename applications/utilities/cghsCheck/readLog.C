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

    const const_searcher finder(librarys(this, keyword, matchOpt));
    cghs::readLog::log().note
    (
        *this,
        keyword,
        finder.ptr(),
        matchOpt == keyType::LITERAL
    );

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
    const entry* found,
    const bool literal
)
{
    questions& q = byDictionary_(dict.name());

    if (found)
    {
        (literal ? q.literal : q.found).insert(found->keyword());
    }
    else
    {
        q.missed.insert(asked);
    }
}


void Foam::cghs::readLog::forgetParsing()
{
    forAllIters(byDictionary_, it)
    {
        it().literal.clear();
    }
}


bool Foam::cghs::readLog::found
(
    const dictionary& dict,
    const keyType& keyword
) const
{
    const auto q = byDictionary_.cfind(dict.name());

    return
        q.found()
     && (q().found.found(keyword) || q().literal.found(keyword));
}


bool Foam::cghs::readLog::anyFound(const dictionary& dict) const
{
    const auto q = byDictionary_.cfind(dict.name());

    return q.found() && (q().found.size() || q().literal.size());
}


Foam::wordList Foam::cghs::readLog::missed(const dictionary& dict) const
{
    DynamicList<word> names;
    const auto q = byDictionary_.cfind(dict.name());

    if (q.found())
    {
        for (const string& name : q().missed.sortedToc())
        {
            if (!dict.found(name, keyType::LITERAL))
            {
                names.append(word(name, false));
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

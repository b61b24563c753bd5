/*---------------------------------------------------------------------------*\
    cghsFoam | coarse-grained hard spheres in OpenFOAM
    GPL-3.0-or-later, see LICENSE
\*---------------------------------------------------------------------------*/

#include "complaint.H"
#include "claim.H"
#include "IStringStream.H"

#include <catch2/catch.hpp>

std::string Foam::cghs::complaintOf(const std::function<void()>& action)
{
    const bool threw = FatalIOError.throwExceptions();
    std::string text;

    try
    {
        action();
    }
    catch (const IOerror& e)
    {
        text = e.ioFileName() + ": " + e.message();
    }

    FatalIOError.throwExceptions(threw);
    return text;
}


void Foam::cghs::settleComplaint
(
    const char* name,
    const std::initializer_list<const char*>& words,
    const std::function<void()>& action
)
{
    claim complete(name, 0);
    const std::string text(complaintOf(action));
    complete.count(!text.empty());

    for (const char* word : words)
    {
        complete.count(text.find(word) != std::string::npos);
    }

    INFO("The complaint was '" << text << '\'');
    complete.settle();
}


Foam::dictionary Foam::cghs::dictionaryOf(const char* text)
{
    return dictionary
    (
        "constant/bedProperties",
        dictionary::null,
        IStringStream(text)()
    );
}

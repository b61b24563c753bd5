/*---------------------------------------------------------------------------*\
    cghsFoam | coarse-grained hard spheres in OpenFOAM
    GPL-3.0-or-later, see LICENSE
\*---------------------------------------------------------------------------*/

#include "checks.H"
#include "page.H"
#include "knownEntries.H"
#include "localIOdictionary.H"
#include "readLog.H"
#include "primitiveEntry.H"

namespace Foam
{
namespace cghs
{

//- Goes through dictionaries for entries that nobody has asked for.
//
//  Such an entry may lie ready for another model or a later part of the run. It
//  is a finding where an entry of about its name was asked for in the same
//  dictionary and is not there: then it is one that is misspelt.
class unreadEntries
{
    const printedWarnings& warnings_;

    findings& found_;

    label nEntries_ = 0;

    //- Files that have been looked at: some are registered under two names
    HashSet<fileName> seen_;


    //- Has anyone looked it up, or come upon it and read its value?
    static bool isRead(const entry& e, const dictionary& dict)
    {
        const ITstream* tokens = dynamic_cast<const ITstream*>(&e);

        return
            readLog::log().found(dict, e.keyword())
         || (tokens && tokens->tokenIndex() > 0);
    }

    //- Have constructors warned of it?
    bool known(const entry& e, const dictionary& dict) const
    {
        return warnings_.mention
        (
            "Entry " + e.keyword() + " in " + dict.name() + " has no effect"
        );
    }

    void judge
    (
        const entry& e,
        const dictionary& dict,
        const string& file,
        const string& path
    )
    {
        const word name(e.keyword(), false);
        const word meant(nearestWord(name, readLog::log().missed(dict)));

        if (meant.empty() || known(e, dict))
        {
            return;
        }
        found_.warn
        (
            place
            (
                file,
                path + name,
                e.isDict() ? string("{...}") : valueOf(e)
            ),
            "nothing has read it, but " + meant + " was asked for and is not"
            " there",
            "name it " + meant + ", or remove it"
        );
    }

    static string valueOf(const entry& e)
    {
        OStringStream os;
        e.write(os);
        string text(os.str());
        text.replace(e.keyword(), "");
        text.removeEnd("\n");
        text.removeEnd(";");

        return text.substr(text.find_first_not_of(' '));
    }


public:

    unreadEntries(const printedWarnings& warnings, findings& found)
    :
        warnings_(warnings),
        found_(found)
    {}

    //- file, path: how findings name it
    void look
    (
        const dictionary& dict,
        const string& file,
        const string& path = ""
    )
    {
        if (path.empty() && !seen_.insert(dict.name()))
        {
            return;
        }

        for (const entry& e : dict)
        {
            if (e.keyword().isPattern())
            {
                continue;
            }

            ++nEntries_;
            if (e.isDict() && readLog::log().anyFound(e.dict()))
            {
                look(e.dict(), file, path + e.keyword() + '.');
            }
            else if (!isRead(e, dict))
            {
                judge(e, dict, file, path);
            }
        }
    }

    label nEntries() const { return nEntries_; }
};


//- Dictionaries that have been read as files
static void lookAtDictionaries(const objectRegistry& db, unreadEntries& unread)
{
    for (const word& name : db.sortedNames<IOdictionary>())
    {
        const IOdictionary& dict = db.lookupObject<IOdictionary>(name);

        unread.look(dict, dict.instance()/name);
    }
}


//- Fields, whose files are read again as their constructors keep none
template<class Field>
static void lookAtFields(const caseView& view, unreadEntries& unread)
{
    for (const word& name : view.mesh.sortedNames<Field>())
    {
        const IOobject file
        (
            name,
            view.startTime,
            view.mesh,
            IOobject::MUST_READ,
            IOobject::NO_WRITE,
            false
        );

        if (IOobject(file).typeHeaderOk<Field>(true))
        {
            unread.look
            (
                localIOdictionary(file, Field::typeName),
                view.startTime/name
            );
        }
    }
}

} // End namespace cghs
} // End namespace Foam


void Foam::cghs::checkEntriesRead
(
    const caseView& view,
    const printedWarnings& warnings,
    findings& found
)
{
    page::title("Entries that nothing reads");

    if (!readLog::works())
    {
        page::line("entries", "this OpenFOAM does not let itself be watched");
        return;
    }

    unreadEntries unread(warnings, found);

    unread.look(view.runTime.controlDict(), "system/controlDict");
    unread.look(view.cloud.properties(), view.propertiesFile());
    unread.look(view.mesh.solutionDict(), "system/fvSolution");
    unread.look(view.mesh.schemesDict(), "system/fvSchemes");
    lookAtDictionaries(view.runTime, unread);
    lookAtDictionaries(view.mesh, unread);
    lookAtFields<volScalarField>(view, unread);
    lookAtFields<volVectorField>(view, unread);

    page::line
    (
        "entries looked at",
        textOf
        (
            unread.nEntries(), "; of those that nobody has read, only such as"
            " look like one that is missing are told"
        )
    );
}

/*---------------------------------------------------------------------------*\
    cghsFoam | coarse-grained hard spheres in OpenFOAM
    GPL-3.0-or-later, see LICENSE
\*---------------------------------------------------------------------------*/

#include "figureTable.H"
#include "OSspecific.H"
#include "Pstream.H"

Foam::cghs::figureTable::figureTable
(
    const Time& time,
    const word& group,
    const word& name,
    const int digits
)
:
    time_(time),
    digits_(digits),
    named_(false)
{
    if (Pstream::master())
    {
        const fileName folder
        (
            time.globalPath()/"postProcessing"/group/time.timeName()
        );

        mkDir(folder);
        table_.reset(new OFstream(folder/(name + ".dat")));
    }
}


void Foam::cghs::figureTable::writeNames(const UList<figure>& figures)
{
    table_() << "# time";
    for (const figure& f : figures)
    {
        table_() << token::SPACE << f.name;
    }
    table_() << endl;
}


void Foam::cghs::figureTable::write(const UList<figure>& figures)
{
    if (!table_.valid())
    {
        return;
    }
    if (!named_)
    {
        writeNames(figures);
        named_ = true;
    }

    table_().precision(16);
    table_() << time_.value();
    table_().precision(digits_);
    for (const figure& f : figures)
    {
        table_() << token::SPACE << f.value;
    }
    table_() << nl;

    if (time_.writeTime() || time_.timeIndex() % 50 == 0)
    {
        table_().flush();
    }
}

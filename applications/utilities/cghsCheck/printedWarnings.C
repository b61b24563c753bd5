/*---------------------------------------------------------------------------*\
    cghsFoam | coarse-grained hard spheres in OpenFOAM
    GPL-3.0-or-later, see LICENSE
\*---------------------------------------------------------------------------*/

#include "printedWarnings.H"

Foam::cghs::printedWarnings::printedWarnings()
:
    terminal_(std::cout.rdbuf()),
    within_(false),
    count_(0)
{
    std::cout.rdbuf(this);
}


Foam::cghs::printedWarnings::~printedWarnings()
{
    std::cout.rdbuf(terminal_);
}


void Foam::cghs::printedWarnings::endLine()
{
    if (line_.find("--> FOAM Warning") != std::string::npos)
    {
        within_ = true;
        ++count_;
    }
    else if (line_.empty())
    {
        within_ = false;
    }

    if (within_)
    {
        text_ += line_ + '\n';
    }
    line_.clear();
}


std::streambuf::int_type Foam::cghs::printedWarnings::overflow(int_type c)
{
    if (c == traits_type::eof())
    {
        return traits_type::not_eof(c);
    }

    const char letter = traits_type::to_char_type(c);

    if (letter == '\n')
    {
        endLine();
    }
    else
    {
        line_ += letter;
    }
    return terminal_->sputc(letter);
}


int Foam::cghs::printedWarnings::sync()
{
    return terminal_->pubsync();
}

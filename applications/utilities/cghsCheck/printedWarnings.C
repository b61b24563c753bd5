/*---------------------------------------------------------------------------*\
    cghsFoam | coarse-grained hard spheres in OpenFOAM
    GPL-3.0-or-later, see LICENSE
\*---------------------------------------------------------------------------*/

#include "printedWarnings.H"

#include <algorithm>
#include <cctype>

Foam::cghs::printedWarnings::printedWarnings()
:
    terminal_(std::cout.rdbuf()),
    within_(false)
{
    std::cout.rdbuf(this);
}


Foam::cghs::printedWarnings::~printedWarnings()
{
    std::cout.rdbuf(terminal_);
}


void Foam::cghs::printedWarnings::endWarning()
{
    if (within_)
    {
        text_ += current_;
        current_.erase
        (
            std::remove_if
            (
                current_.begin(),
                current_.end(),
                [](const char c) { return std::isdigit(c) || c == '.'; }
            ),
            current_.end()
        );
        different_.insert(current_);
    }
    current_.clear();
    within_ = false;
}


void Foam::cghs::printedWarnings::endLine()
{
    const bool begins = line_.find("--> FOAM Warning") != std::string::npos;

    if (begins || line_.empty())
    {
        endWarning();
    }
    within_ = within_ || begins;

    if (within_)
    {
        current_ += line_ + '\n';
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

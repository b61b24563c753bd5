/*---------------------------------------------------------------------------*\
    cghsFoam | coarse-grained hard spheres in OpenFOAM
    GPL-3.0-or-later, see LICENSE
\*---------------------------------------------------------------------------*/

#include "progress.H"
#include "IOmanip.H"

namespace Foam
{
namespace cghs
{

//- Of large numbers the largest that can be converted
static int64_t whole(const scalar number)
{
    return int64_t(min(number, scalar(1e18)));
}


static string clockString(const scalar seconds)
{
    const int64_t s = whole(seconds);
    char text[32];
    std::snprintf
    (
        text, sizeof(text), "%ld:%02ld:%02ld",
        long(s/3600), long((s/60) % 60), long(s % 60)
    );

    return text;
}

} // End namespace cghs
} // End namespace Foam


Foam::cghs::progress::progress(const Time& time)
:
    time_(time),
    start_(time.value()),
    end_(GREAT),
    markTime_(time.value()),
    markClock_(time.elapsedClockTime()),
    speed_(0)
{}


bool Foam::cghs::progress::hasEnd()
{
    const scalar end = time_.endTime().value();
    const bool known = end < 0.5*GREAT;

    // The last step may end a little later
    end_ = max(known ? end : end_, time_.value());

    return known;
}


void Foam::cghs::progress::report(Ostream& os)
{
    const scalar clock = time_.elapsedClockTime();
    const scalar passed = clock - markClock_;

    if (passed > 0)
    {
        speed_ = (time_.value() - markTime_)/passed;
    }
    if (passed > 60)
    {
        markTime_ = time_.value();
        markClock_ = clock;
    }

    const bool known = hasEnd();
    const label share
    (
        1000*(time_.value() - start_)/max(end_ - start_, VSMALL)
    );

    os  << "progress " << share/10 << '.' << share % 10 << " %";

    if (!known)
    {
        os  << ", stops with the next time written";
    }
    else if (speed_ > 0)
    {
        os  << ", " << clockString((end_ - time_.value())/speed_).c_str()
            << " left";
    }

    if (speed_ > 0)
    {
        os  << ", " << whole(86400*speed_) << " simulated s per day";
    }

    os  << endl;
}

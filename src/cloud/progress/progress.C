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

static string clockString(const scalar seconds)
{
    const long s = long(seconds);
    char text[32];
    std::snprintf
    (
        text, sizeof(text), "%ld:%02ld:%02ld", s/3600, (s/60) % 60, s % 60
    );

    return text;
}

} // End namespace cghs
} // End namespace Foam


Foam::cghs::progress::progress(const Time& time)
:
    time_(time),
    start_(time.value()),
    markTime_(time.value()),
    markClock_(time.elapsedClockTime()),
    speed_(0)
{}


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

    // The last step may end a little later
    const scalar end = max(time_.endTime().value(), time_.value());
    const scalar share =
        (time_.value() - start_)/max(end - start_, VSMALL);

    os  << "progress " << 0.1*label(1000*share) << " %";

    if (speed_ > 0)
    {
        os  << ", " << clockString((end - time_.value())/speed_).c_str()
            << " left, " << label(86400*speed_)
            << " simulated s per day";
    }

    os  << endl;
}

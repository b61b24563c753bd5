# ------------------------------------------------------------------------------
# cghsFoam: coarse-grained hard-sphere fluidised beds for OpenFOAM
# Licence: GPL-3.0-or-later, see the file LICENSE
#
# Description
#     Is a window of time long enough for means and their errors? And means over
#     replicas, runs that differ by chance alone, beside means over time.
#
#     Samples at equal steps of time forget each other after the correlation time
#
#         tau = dt (1/2 + sum_k rho(k)),    rho the autocorrelation,
#
#     summed up to 5 tau (Sokal, 1997). A window T has T/(2 tau) independent
#     samples, and the error of its mean is the standard deviation over the
#     root of that. Of several series, such as a profile, rho is that of all
#     together.
#
#     A slow change behind fast noise, such as a column of bubbles that moves
#     from side to side, is missed by that sum. It shows in the means of a tenth
#     or a sixth of the window each: where these are not independent of their
#     neighbours, but alike, the window is shorter than what it should see.
#
#     This is for whole series, which evaluate and validate make from fields and
#     tables in files. What the solver sees step by step it judges itself, by
#     the same rule, from blocks of doubling length
#     (src/core/statistics/blockErrors): the columns correlationTime and
#     windowLongEnough of its tables.
# ------------------------------------------------------------------------------
"""How long a window must be, and means over replicas."""

from dataclasses import dataclass

import numpy as np

LEAST = 20      # independent samples that a standard error needs
BLOCKS = (10, 6)
ALIKE = 0.3     # correlation of neighbouring blocks: independent ones have
                # -0.1 +- 0.3 in one series, less scatter in a profile


@dataclass
class Window:
    """What a window can tell. Times in those of the step."""
    length: float
    correlation_time: float     # a lower bound, if it is not enough
    independent: float          # samples
    alike: float                # correlation of neighbouring blocks
    enough: bool
    needed: float               # length, at least

    def __str__(self):
        if self.enough:
            return (f"{self.length:.3g} s, {self.independent:.0f} independent"
                    f" samples (correlation time {self.correlation_time:.2g}"
                    " s)")
        return (f"window too short: {self.length:.3g} s, at least"
                f" {self.needed:.3g} s needed ({LEAST} independent samples;"
                f" correlation time {self.correlation_time:.2g} s or more)")


def _as_series(values):
    values = np.asarray(values, float)
    values = values.reshape(len(values), -1)
    return values - values.mean(axis=0)


def autocorrelation(values):
    """Of all series together, by lag in steps."""
    x = _as_series(values)
    n = len(x)
    transform = np.fft.rfft(x, 2*n, axis=0)
    power = (abs(transform)**2).sum(axis=1)
    products = np.fft.irfft(power)[:n]
    if products[0] <= 0:
        return np.r_[1.0, np.zeros(n - 1)]
    return products/products[0]


def correlation_time(values, dt=1.0):
    rho = autocorrelation(values)
    tau = 0.5 + np.cumsum(rho[1:])
    lags = np.arange(1, len(rho))
    closed = np.nonzero(lags >= 5*tau)[0]
    last = closed[0] if closed.size else len(tau) - 1
    return max(float(tau[last]), 0.5)*dt


def block_correlation(values, n):
    """Of the means of neighbouring blocks, over all series together."""
    blocks = np.array([part.mean(axis=0) for part in
                       np.array_split(_as_series(values), n)])
    whole = (blocks**2).sum()
    return float((blocks[1:]*blocks[:-1]).sum()/whole) if whole > 0 else 0.0


def judge(values, dt=1.0):
    """Window of samples at equal steps dt, the first index being time."""
    n = len(values)
    length = n*dt
    tau = correlation_time(values, dt)
    alike = max(block_correlation(values, n) for n in BLOCKS)
    if alike > ALIKE:
        # Blocks that know each other: what they see lasts about one, or longer
        tau = max(tau, length/max(BLOCKS)/2*(1 + alike)/(1 - min(alike, 0.9)))
    independent = length/(2*tau)
    enough = independent >= LEAST and alike <= ALIKE
    return Window(length, tau, independent, alike, enough,
                  max(2*tau*LEAST, 0 if enough else 1.5*length))


def student_t(share, freedom):
    """Within +- t of zero is that share of Student's distribution with so many
    degrees of freedom, a fraction if need be; infinite with none."""
    if not freedom > 0:
        return np.inf
    # Of t = root(freedom) tan(a) the density is cos(a)^(freedom - 1)
    angle = np.linspace(0, np.pi/2, 20001)
    density = np.cos(angle)**(freedom - 1)
    if freedom < 1:
        # Infinite, but integrable, at the end
        density[-1] = density[-2]
    within = np.r_[0, np.cumsum(0.5*(density[1:] + density[:-1]))]
    end = np.interp(share, within/within[-1], angle)
    return float(np.sqrt(freedom)*np.tan(end))


def spread_of_replicas(values):
    """Mean over runs that differ by chance alone, the first index, and its
    standard error, which n - 1 degrees of freedom belong to."""
    values = np.asarray(values, float)
    n = len(values)
    if n < 2:
        raise ValueError("one replica alone has no error: run two or more")
    return values.mean(axis=0), values.std(axis=0, ddof=1)/np.sqrt(n)


def mean_of_replicas(values):
    """The same with the error for 68 % confidence by Student's t."""
    mean, error = spread_of_replicas(values)
    return mean, student_t(0.6827, len(values) - 1)*error

# ------------------------------------------------------------------------------
# cghsFoam: coarse-grained hard-sphere fluidised beds for OpenFOAM
# Licence: GPL-3.0-or-later, see the file LICENSE
#
# Description
#     Systematic error told apart from noise.
#
#     A quantity has an estimate in each variant: a value and its standard
#     error, over replicas (runs that differ by chance alone) if there are two
#     or more, else by the correlation time within the window of the one run.
#     Degrees of freedom go with it, as two replicas know their spread badly.
#
#     The bias of a variant is its value less the reference's. Its standard
#     error is both of theirs together, with degrees of freedom by Welch and
#     Satterthwaite. It is told from zero if it is outside what chance would
#     make of no bias in 95 of 100 studies (Student's t). All of a share: of the
#     reference's value, or of the scale that the dictionary gives.
#
#     Replicas of variant and reference that share a seed may be held against
#     each other one by one ('paired'): what their starts do to both drops out.
#     In a bed that has forgotten its start nothing is gained.
#
#     A profile has one number, too: the root of the mean square along it of the
#     difference, over the reference's range (or mean). Noise alone makes one of
#     N > 0, the same of the standard errors; its square adds to that of the
#     bias, so the estimate is the root of what exceeds N^2. Whatever the points
#     of a profile know of each other, the difference exceeds t N by chance in 5
#     of 100 studies at most: as often as a scalar, if they move as one, else
#     less.
# ------------------------------------------------------------------------------
"""Estimates, biases, and what their noise is."""

from dataclasses import dataclass, replace

import numpy as np

import windows

CONFIDENCE = 0.95
ROUND_OFF = 1e-12


@dataclass
class Estimate:
    """Of a quantity in a variant. An error of nan is one that nothing tells."""
    value: object
    error: object
    freedom: float
    source: str             # of the error
    notes: tuple = ()
    coordinate: object = None
    enough: bool = True
    replicas: tuple = ()    # the value in each
    same: bool = False      # are these alike to all digits?

    def doubt(self):
        """Why its error is not to be relied upon, or nothing."""
        if self.same:
            return "replicas are identical"
        if not self.enough and len(self.replicas) < 2:
            return "window is too short for one run"
        return ""

    def without_noise_known(self):
        """The same, of replicas that chance has not made differ."""
        return replace(self, error=np.nan*self.error, same=True,
                       source="unknown: identical replicas")

    def number(self):
        """Of a profile its mean."""
        return float(np.mean(self.value))

    def noise(self):
        """Of a profile the root mean square of the errors."""
        return float(np.sqrt(np.mean(np.square(self.error))))


@dataclass
class Comparison:
    """Shares of the reference. error: the estimate of the bias, for a profile
    without its sign; noise: its standard error."""
    error: float
    noise: float
    freedom: float
    distinct: bool          # from zero
    scale: float            # what the shares are of
    doubts: tuple = ()      # why the noise is not to be relied upon

    def is_known(self):
        """Is its noise?"""
        return bool(np.isfinite(self.noise)) and not self.doubts

    def doubt_it(self, *doubts):
        """A noise that is not relied upon tells nothing from zero."""
        self.doubts += doubts
        self.distinct = self.distinct and not self.doubts

    def t(self):
        return windows.student_t(CONFIDENCE, min(self.freedom, 1000))

    def bound(self):
        """What the error is below with 95 % confidence."""
        if not self.is_known():
            return np.inf
        spread = self.t()*self.noise if self.noise > 0 else self.noise
        return abs(self.error) + spread

    def least(self):
        """What the error is above with 95 % confidence."""
        if not self.is_known():
            return 0.0
        spread = self.t()*self.noise if self.noise > 0 else 0.0
        return max(abs(self.error) - spread, 0.0)

    def seen(self):
        """An error is not known to be less than its noise."""
        return max(abs(self.error), self.noise)


def same_points(measurements):
    """Profiles on the coordinate of the first."""
    first = measurements[0].coordinate
    if first is None:
        return [m.value for m in measurements]
    return [np.interp(first, m.coordinate, m.value) for m in measurements]


def over_replicas(measurements, deterministic=False):
    """The estimate from one run or more."""
    first = measurements[0]
    notes = tuple(f"replica {i}: {m.note}" for i, m in
                  enumerate(measurements, 1) if not m.enough)
    if deterministic:
        return Estimate(first.value, 0*first.value, np.inf, "deterministic",
                        (), first.coordinate)
    if len(measurements) == 1:
        known = np.all(np.isfinite(first.error))
        return Estimate(
            first.value, first.error, first.freedom,
            "correlation time" if known else "unknown: one replica", notes,
            first.coordinate, first.enough)
    values = same_points(measurements)
    mean, error = windows.spread_of_replicas(values)
    return Estimate(mean, error, len(values) - 1, f"{len(values)} replicas",
                    notes, first.coordinate,
                    all(m.enough for m in measurements), tuple(values))


def are_identical(estimates):
    """Has chance made no difference in any of a variant's quantities? One that
    is the same in all replicas, such as a mass, may be so."""
    return bool(estimates) and all(
        len(e.replicas) > 1 and np.all(np.ptp(e.replicas, axis=0) == 0)
        for e in estimates)


def welch(one, freedom_one, other, freedom_other):
    """Degrees of freedom of a difference, from both standard errors."""
    below = sum(e**4/f for e, f in ((one, freedom_one), (other, freedom_other))
                if e > 0)
    return (one**2 + other**2)**2/below if below > 0 else np.inf


def difference(estimate, reference):
    """Of two estimates that chance has made independent, on the points of the
    reference."""
    value, error, x = estimate.value, estimate.error, reference.coordinate
    if x is not None:
        value, error = (np.interp(x, estimate.coordinate, y)
                        for y in (value, error))
    freedom = welch(estimate.noise(), estimate.freedom,
                    reference.noise(), reference.freedom)
    return Estimate(value - reference.value,
                    np.hypot(error, reference.error), freedom, "both")


def paired_difference(estimate, reference):
    """Of two whose replicas have the same chance, one by one: what they share
    drops out."""
    x, found = reference.coordinate, estimate.replicas
    if x is not None:
        found = [np.interp(x, estimate.coordinate, v) for v in found]
    pairs = [v - v0 for v, v0 in zip(found, reference.replicas)]
    value, error = windows.spread_of_replicas(pairs)
    return Estimate(value, error, len(pairs) - 1, "pairs")


def compare(estimate, reference, quantity, paired=False):
    """Of a variant with the reference."""
    made = compared(estimate, reference, quantity, paired)
    made.doubt_it(*(f"{whose} {of.doubt()}" for whose, of in (
        ("its", estimate), ("the reference's", reference)) if of.doubt()))
    return made


def compared(estimate, reference, quantity, paired):
    paired = (paired and not estimate.same and not reference.same
              and len(estimate.replicas) == len(reference.replicas) > 1)
    found = (paired_difference if paired else difference)(estimate, reference)
    if reference.coordinate is None:
        scale = quantity.scale or abs(reference.value)
        return judged(found.value, found.value, float(found.error),
                      found.freedom, scale)
    x = reference.coordinate
    noise2 = along(x, np.square(found.error))
    whole2 = along(x, np.square(found.value))
    excess2 = max(whole2 - noise2, 0) if np.isfinite(noise2) else whole2
    scale = quantity.scale or (
        np.ptp(reference.value) if quantity.relative_to == "range"
        else abs(along(x, reference.value)))
    return judged(np.sqrt(whole2), np.sqrt(excess2), np.sqrt(noise2),
                  found.freedom, scale)


def along(x, values):
    """Mean along a coordinate; a point counts for what is nearest to it."""
    width = np.gradient(x) if x.size > 1 else np.ones(1)
    return float((values*width).sum()/width.sum())


def judged(found, error, noise, freedom, scale):
    """found: the difference that there is; error: what of it is systematic."""
    made = Comparison(error, noise, freedom, False, scale)
    limit = made.t()*noise if noise > 0 else ROUND_OFF*abs(scale)
    made.distinct = bool(np.isfinite(noise) and abs(found) > limit)
    if not scale > 0:
        made.error = made.noise = np.nan
    else:
        made.error, made.noise = error/scale, noise/scale
    return made


# Work and precision


def pareto_front(points):
    """Names of those (name: cost, error) that nothing else is both cheaper than
    and better, the cheapest first."""
    front, best = [], np.inf
    for name, (_, error) in sorted(points.items(),
                                   key=lambda p: (p[1][0], p[1][1])):
        if error < best:
            front.append(name)
            best = error
    return front

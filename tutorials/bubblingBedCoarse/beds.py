# ------------------------------------------------------------------------------
# cghsFoam: coarse-grained hard-sphere fluidised beds for OpenFOAM
# Licence: GPL-3.0-or-later, see the file LICENSE
#
# Description
#     What the runs of the coarse bubbling bed have left, as numbers: the one
#     place from which evaluate, validate and the test take them.
# ------------------------------------------------------------------------------
"""The bed by three methods: profiles, scalars and cost, with their errors."""

import sys
from pathlib import Path

PROJECT = next((folder for folder in Path(__file__).resolve().parents
                if (folder / "etc" / "openfoam").exists()), None)
if PROJECT is None:
    sys.exit(f"{Path(__file__).parent} is not within a cghsFoam")
sys.path.append(str(PROJECT / "tutorials" / "lib"))
from methodBeds import MethodBed, rows_of_runs, runs_by_method  # noqa: E402
from tutorial import (  # noqa: E402
    BLOCKS, mean_of, np, of, option, ratio_of,
)

# The reference first; the others as the chapter's figures have them
METHODS = ("dem", "cgdem", "cghs")

HEIGHTS = {"low": 0.05, "high": 0.11}  # [m] of Figs 16 and 17


class Bed(MethodBed):
    """A run by one method."""

    def __init__(self, case):
        super().__init__(case)
        self.profiles_from = option(self.case, "profilesFrom")
        self.tables = sorted(
            (self.case / "postProcessing" / "profiles").glob("*"),
            key=lambda folder: float(folder.name),
        )
        start = max(self.average_from, self.profiles_from)
        self.averaged = [
            folder for folder in self.tables
            if float(folder.name) > start + 1e-6
        ]
        if len(self.averaged) >= 2 * max(BLOCKS):
            self.window = (start, float(self.averaged[-1].name))

    # Profiles

    def _cumulated(self, name):
        """x; and fraction and vertical flux, integrated over time from
        profilesFrom to the start of the window and to each averaged time."""
        before = [f for f in self.tables if f not in self.averaged][-1:]
        rows = []
        for folder in before + self.averaged:
            table = of.columns(folder / f"{name}.dat")
            duration = float(folder.name) - self.profiles_from
            rows.append(duration * np.array(
                [table["solidsFraction"], table["massFluxY"] / self.density]))
        if not before:
            rows.insert(0, np.zeros_like(rows[0]))
        return table["coordinate"], np.array(rows)

    def profile(self, name, folded=False):
        """x [m]; solids fraction [-] and vertical velocity [m/s] of a profile:
        mean over the window and standard error of each. The velocity is by mass:
        flux over fraction. Folded: mean of both sides of the middle."""
        x, sums = self._cumulated(name)
        frames = np.diff(sums, axis=0)
        if folded:
            frames = 0.5 * (frames + frames[..., ::-1])
        fraction, flux = frames.swapaxes(0, 1)
        length = (self.window[1] - self.window[0]) / len(frames)
        return {
            "x": x,
            "fraction": mean_of(fraction / length),
            "velocity": ratio_of(flux, fraction),
        }

    # Scalars

    def scalars(self):
        """Means and standard errors, by name."""
        drop, drop_error = self.mean(self.pressure_drop)
        return {
            "pressure drop over weight [-]":
                (drop / self.weight, drop_error / self.weight),
            "height of the bed's centre [m]":
                self.mean(self.parcels["centreY"]),
            "granular temperature [m2/s2]":
                self.mean(self.parcels["granularTemperature"]),
        }


def difference(bed, reference, name, quantity):
    """Root mean square, along a profile folded about the middle, of the
    difference between two runs; and what of it their standard errors alone
    would make."""
    mean, error = bed.profile(name, folded=True)[quantity]
    mean0, error0 = reference.profile(name, folded=True)[quantity]
    return (np.sqrt(((mean - mean0)**2).mean()),
            np.sqrt((error**2 + error0**2).mean()))


def beds_in(folder):
    """The runs in a folder, by the name of their method."""
    return runs_by_method(folder, METHODS, Bed)

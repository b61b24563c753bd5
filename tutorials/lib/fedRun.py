# ------------------------------------------------------------------------------
# cghsFoam: coarse-grained hard-sphere fluidised beds for OpenFOAM
# Licence: GPL-3.0-or-later, see the file LICENSE
#
# Description
#     A run of a vessel that solids are fed to and leave: risers, regenerators,
#     reactors. The case's controlDict has the function objects that are read:
#     parcels, and, for those who ask for what they show, inletPressure,
#     outletPressure, solidsProfiles, taps, balance, parcelDistributions.
# ------------------------------------------------------------------------------
"""A vessel that solids flow through."""

import re
from functools import cached_property

from tutorial import (
    Run, clock_series, columns, log_of, newest, np, number, of, ranks, runLog,
    seconds)


class FedRun(Run):
    """A run. Masses in kg, z upwards."""

    # Averages over less are none [s]
    least_window = 0.5

    # The speed is that from this time on [s]
    start_up = 1

    def __init__(self, case):
        super().__init__(case)
        self._taps = {}
        if self.end - self.average_from > self.least_window:
            self.window = (self.average_from, self.end)

    def read_inputs(self):
        super().read_inputs()
        self.read_parcels()

    def read_series(self):
        super().read_series()
        self.mass = self.parcels["mass"]
        self.escaped = self.parcels["escapedMass"]
        self.fed = self.parcels["fedMass"]
        # What parcels have taken up from the fluid, less what they have lost
        # to it, and what a slow clock has made in them
        self.gained = self._by_reactions("gained")
        self.ahead = self._by_reactions("ahead")

    def _by_reactions(self, name):
        """Total of a figure of reactions, as each step of the log has it."""
        steps = runLog.steps(
            log_of(self.case),
            re.compile(rf"^reactions:.* {name}[ =:]*({of.NUMBER})", re.M))
        if not steps:
            return np.zeros(self.time.size)
        rate = np.interp(self.time, *zip(*steps.items()))
        return np.cumsum(rate*self.dt)

    # Not all cases have these

    @cached_property
    def inlet_pressure(self):
        return self.at_steps("inletPressure")

    @cached_property
    def outlet_pressure(self):
        return self.at_steps("outletPressure")

    @cached_property
    def pressure_drop(self):
        return self.inlet_pressure - self.outlet_pressure

    # Balances

    def mean_flow(self, flow):
        """Over the run: steps are implicit, so that a flow holds for the step
        before its time."""
        return (flow*self.dt)[1:].sum()/self.dt[1:].sum()

    def gas_defect(self):
        """What of the gas has come from nowhere, over what has entered: gas_in,
        gas_out and gas_mass are read by whoever asks."""
        from_parcels = self.gained[0] - self.gained[-1]
        made = self.gas_mass[-1] - self.gas_mass[0] - from_parcels
        flowed = ((self.gas_in - self.gas_out)*self.dt)[1:].sum()
        return abs(made - flowed)/(self.gas_in*self.dt)[1:].sum()

    def solids_defect(self):
        """Furthest in the run, over what was there at the start."""
        mass = (self.mass + self.escaped - self.fed
                - self.gained - self.ahead)
        return abs(mass - mass[0]).max()/mass[0]

    def element_defects(self):
        """From nowhere, over what there is and flows: largest of the run, by
        the names of elements and species, and 'mass'."""
        found = ((re.fullmatch(r"element\.relative\((\w+)\)", name), value)
                 for name, value in columns(self.case, "balance").items())
        return {match[1]: float(abs(value).max())
                for match, value in found if match}

    def due(self):
        """The last time written, solids that were to be fed until then, and
        that were [s, kg]."""
        time = float(self.last())
        due = number(self.case / self.last()
                     / "uniform/lagrangian/parcels/flows", "due")
        return time, due, np.interp(time, self.time, self.fed)

    # Profiles that solidsProfiles has made, taps along the wall

    def profile(self, name):
        """The columns of a profile by their names, of the last time written;
        none before there are means."""
        return newest(self.case, "solidsProfiles", name)

    def leaving(self, name):
        """Of a distribution over what leaves its mean, the error of that and
        the deviation."""
        rows = newest(self.case, name, "parcelDistribution")
        return [rows[q][-1] for q in ("mean", "meanError", "deviation")]

    def surface(self, radius=lambda z: np.ones_like(z)):
        """Height below which 95 % of the solids are, in a vessel whose radius
        at a height may be given [m]."""
        height = self.profile("height")
        z = height["coordinate"]
        share = np.cumsum(height["solidsFraction"]*radius(z)**2)
        return float(np.interp(0.95, share/share[-1],
                               z + 0.5*(z[1] - z[0])))

    def _tap_table(self):
        """The columns of the taps' table by their names. There is none before
        means begin."""
        if not self._taps:
            self._taps = columns(self.case, "taps")
        return self._taps

    def tap_series(self, pair):
        """Times, and what a pair of taps has shown."""
        table = self._tap_table()
        return table["time"], table[pair]

    def tap_mean(self, pair):
        """Mean of a pair of taps over the window, and its standard error."""
        table = self._tap_table()
        return table[pair + "Mean"][-1], table[pair + "Error"][-1]

    def taps(self):
        """Heights, mean pressures over that at the top, errors [m, Pa]."""
        pairs = [name for name in self._tap_table()
                 if re.match(r"z[\d.]+$", name)]
        mean, error = np.transpose([self.tap_mean(pair) for pair in pairs])
        return np.array([float(pair[1:]) for pair in pairs]), mean, error

    # Fields of the last time written

    def last(self):
        return self.frames[-1]

    def field(self, name):
        return np.asarray(of.field(self.case, self.last(), name))

    # Cost

    def seconds(self):
        return seconds(self.case)

    def ranks(self):
        return ranks(self.case)

    def seconds_per_day(self):
        """Simulated seconds in a day, without the start."""
        time, spent = clock_series(self.case)
        start = min(self.start_up, 0.5*time[-1])
        used = spent[-1] - np.interp(start, time, spent)
        return 86400*(time[-1] - start)/max(used, 1e-3)

    # Checks that hold in any run

    def check_solids(self, checks, tolerance=1e-9, raised=0, who=""):
        """raised: in so many cells, mean of the run, voidage may lie at its
        bound. who: of several runs the name of this one and a colon."""
        checks.below(f"{who}solids there and gone, less those fed and what they have "
                     "taken up, of those at the start [-]",
                     self.solids_defect(), tolerance,
                     "balance: none is lost, to the digits written")
        cells = self.parcels["clippedCells"]
        if raised:
            checks.below(f"{who}voidage raised to its bound, mean of the run"
                         " [cells]",
                         cells.mean(), raised,
                         "limit: 1 % of the bed's, where each counts its own")
        else:
            checks.below(f"{who}voidage raised to its bound, most cells [-]",
                         cells.max(), 0,
                         "random packing stays above the bound")

    def check_feeding(self, checks, rate, allowed, source):
        """allowed: of what is due in a second may be late."""
        time, due, fed = self.due()
        checks.equal("solids due [kg/s]", due/time, rate, 1e-9, source)
        checks.below("solids due and not yet fed, of those due in a second [-]",
                     (due - fed)/rate, allowed,
                     "limit: made up for as soon as there is room")

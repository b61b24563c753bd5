# ------------------------------------------------------------------------------
# cghsFoam: coarse-grained hard-sphere fluidised beds for OpenFOAM
# Licence: GPL-3.0-or-later, see the file LICENSE
#
# Description
#     What a run of the burning bed has left, as numbers, and the two limits that
#     it is held against: the one place from which evaluate, validate and the
#     test take them.
# ------------------------------------------------------------------------------
"""Coke that burns from a fluidised bed."""

import sys
from pathlib import Path

PROJECT = next((folder for folder in Path(__file__).resolve().parents
                if (folder / "etc" / "openfoam").exists()), None)
if PROJECT is None:
    sys.exit(f"{Path(__file__).parent} is not within a cghsFoam")
sys.path.append(str(PROJECT / "tutorials" / "lib"))
from cokeChemistry import R, Chemistry  # noqa: E402
from tutorial import (  # noqa: E402
    clock_series, columns, np, number, of, ranks, series,
)

# What a mole of C or H turns into what
BURN = dict(C=dict(C=-1, O2=-1, CO2=1), H=dict(H=-1, O2=-0.25, H2O=0.5))
AIR = dict(O2=0.233, N2=0.767)
AREA = 0.03**2      # of the floor [m^2]


class Bed:
    """A run. Times in s, temperatures in K, rates in mol/s."""

    def __init__(self, case):
        self.case = Path(case)
        self._read_inputs()
        self._read_series()

    def _read_inputs(self):
        self.chemistry = Chemistry(self.case)
        self.M = self.chemistry.M
        bed = self.case / "constant" / "bed"
        self.share = {s: number(bed, name) for s, name in
                      (("C", "carbon"), ("H", "hydrogen"))}
        self.diameter = number(bed, "diameter")
        self.weight = number(bed, "weight")
        self.count = int(number(bed, "nParcels"))
        self.mass = (self.count * self.weight * number(bed, "density")
                     * np.pi / 6 * self.diameter**3)
        self.T0 = number(self.case / "0.orig" / "T",
                         r"internalField\s+uniform")
        self.p = number(self.case / "0.orig" / "p",
                        r"internalField\s+uniform")
        self.air = (self.p / (R * self.T0) * number(bed, "gasVelocity")
                    * AREA)                             # [mol/s]

    def _read_series(self):
        self.heat = columns(self.case, "heatHistory")
        self.reactions = columns(self.case, "reactionHistory")
        self.balance = columns(self.case, "balance")
        self.time = self.reactions["time"]
        self.dt = np.diff(self.time, prepend=0)
        self.end = float(self.time[-1])
        self.outlet = dict(zip(("time", "O2", "CO2", "H2O", "T"),
                               series(self.case, "outlet").T))
        self.frames = [t for t in of.times(self.case) if float(t) > 0]
        self.ranks = ranks(self.case)
        self.clock = clock_series(self.case, "ClockTime")[1][-1]

    # Over the run

    def burnt(self, solid):
        """In all [mol], by the rates of the reactions."""
        return float((self.reactions["burn" + solid] * self.dt).sum())

    def gas_gained(self, species):
        """What the gas that flowed out and that in the column have more of a
        species than what came in [kg]."""
        rate = sum(sign*self.balance[f"{what}({species})"] for what, sign in (
            ("stored", 1), ("in", -1), ("out", 1)))
        return float((rate * self.dt).sum())

    def heat_in_all(self):
        """That the gas and the parcels have got [J], by their balances."""
        log = self.case / "log.cghsFoam"
        to_gas = of.log_values(log, "walls [^ ]+ W, parcels")
        return float((to_gas * self.dt).sum()
                     + (self.heat["stored"] * self.dt).sum())

    def heat_of(self, solid, T):
        """Released by a mole of it at a temperature [J]."""
        return -sum(n * self.M[s] * self.chemistry.enthalpy(s, T)
                    for s, n in BURN[solid].items())

    def heat_released(self):
        """By the moles burnt, as if all were at 0 K [J]: what the enthalpies of
        formation do, whatever the temperatures are."""
        return sum(self.burnt(s) * self.heat_of(s, 0) for s in BURN)


def limit(bed, plug):
    """Times, share of the carbon that is left, temperature and mole fraction of
    oxygen that leaves, if the solids are well mixed and the gas flows through as
    a plug, or is mixed as well."""
    M, Cp = bed.M, bed.chemistry.heat_capacity
    n = {s: bed.mass * bed.share[s] / M[s] for s in BURN}
    start = n["C"]
    capacity = bed.mass * Cp("catalyst", bed.T0)
    moles = {s: y / M[s] for s, y in AIR.items()}
    x_in = moles["O2"] / sum(moles.values())
    per_mole = sum(AIR[s] * Cp(s, bed.T0) for s in AIR) / sum(moles.values())
    k = bed.chemistry.rate_constant
    T, t, dt = bed.T0, 0.0, 1e-3
    rows = []
    while t < bed.end + 0.5 * dt:
        wants = {s: -BURN[s]["O2"] * k("burn" + s, T) * n[s] for s in BURN}
        N = bed.p / 1e5 * sum(wants.values()) / bed.air
        x = x_in * (np.exp(-N) if plug else 1 / (1 + N))
        rows.append((t, n["C"] / start, T, x))
        used = bed.air * (x_in - x)
        total = max(sum(wants.values()), 1e-300)
        released = 0
        for s in BURN:
            rate = used * wants[s] / total / -BURN[s]["O2"]
            n[s] = max(n[s] - rate * dt, 0)
            released += rate * bed.heat_of(s, T)
        T += dt * (released - bed.air * per_mole * (T - bed.T0)) / capacity
        t += dt
    return np.array(rows).T

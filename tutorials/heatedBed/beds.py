# ------------------------------------------------------------------------------
# cghsFoam: coarse-grained hard-sphere fluidised beds for OpenFOAM
# Licence: GPL-3.0-or-later, see the file LICENSE
#
# Description
#     What the runs of the heated bed have left, as numbers: the one place from
#     which evaluate, validate and the test take them.
# ------------------------------------------------------------------------------
"""The bed of hot beads: temperatures, watts by mechanism, balance, cost."""

import re
import sys
from pathlib import Path

PROJECT = next((folder for folder in Path(__file__).resolve().parents
                if (folder / "etc" / "openfoam").exists()), None)
if PROJECT is None:
    sys.exit(f"{Path(__file__).parent} is not within a cghsFoam")
sys.path.append(str(PROJECT / "tutorials" / "lib"))
from methodBeds import MethodBed, rows_of_runs, runs_by_method  # noqa: E402
from tutorial import (  # noqa: E402
    BLOCKS, columns, np, number, of, series, vector,
)

# The finest first: against the first that there is, others are measured
METHODS = ("w1soft", "w1hard", "w8soft", "w8hard", "w27soft", "w27hard")

GAS_CONSTANT = 8314.47  # [J/kmol/K]

# Of exchangeHistory, what is no way by which heat comes
NO_MECHANISM = ("TMin", "TMean", "TMax", "stored")

# What the chapter's text says of the start and of 10 s [W]: Figs 20A and 20B;
# and of conduction by contact all the time, Fig 20C
CHAPTER_CONVECTION = (150.0, 100.0)
CHAPTER_CONDUCTION = (80.0, 50.0)
CHAPTER_CONTACT = 1.0
CHAPTER_END = 10.0  # [s]

BED_TOP = 0.08  # [m]: most parcels are below

ENERGY = ("stored", "inflow", "walls", "parcels")


class Bed(MethodBed):
    """A run by one method. Temperatures in K, heat in J, powers in W. inflow
    and outflow are superficial velocities at the inlet's density."""

    def __init__(self, case):
        super().__init__(case)
        start = max(self.average_from, self.gas_on or 0)
        if self.end - start > 0.5:
            self.window = (start, self.end)

    # Inputs

    def read_inputs(self):
        constant = self.case / "constant"
        parcels = constant / "parcelsProperties"
        thermo = constant / "thermophysicalProperties"
        self.hot = number(parcels, "T")
        self.cold = number(self.case / "0.orig" / "T",
                           r"internalField\s+uniform")
        self.outlet_pressure = number(self.case / "0.orig" / "p",
                                      r"internalField\s+uniform")
        self.gas_Cp = number(thermo, "Cp")
        self.conductivity = (
            number(thermo, "mu") * self.gas_Cp / number(thermo, "Pr"))
        self.psi = number(thermo, "molWeight") / (GAS_CONSTANT * self.cold)
        super().read_inputs()
        self.capacity = self.mass * number(parcels, "Cp")  # of parcels [J/K]

    def density_of_gas(self):
        """Of what comes in, at the outlet's pressure."""
        return self.psi * self.outlet_pressure

    def numbers_of_cells(self, mesh):
        text = (self.case / "constant" / "method").read_text()
        return vector(text, r"\bcells").astype(int)

    def inlet_velocity(self):
        """Mean over the floor, of which a rectangle is blocked."""
        method = self.case / "constant" / "method"
        nx, nz = self.cells[[0, 2]]
        dx = abs(self.centres(0) - 0.5 * self.size[0])
        dz = abs(self.centres(2) - 0.5 * self.size[2])
        blocked = ((dx < number(method, "blockedX")).sum()
                   * (dz < number(method, "blockedZ")).sum())
        return number(method, "gasVelocity") * (1 - blocked / (nx * nz))

    def mass_flow(self):
        """Of the gas, by the inputs [kg/s]."""
        return self.gas_density * self.gas_velocity * self.area

    # Series

    def read_gas(self):
        pressure = self.at_steps("inletPressure")
        density = self.psi * pressure * self.area
        self.gas_mass = self.at_steps("gasMass")
        self.pressure_drop = (pressure - self.outlet_pressure
                              - self.gas_mass * self.g / self.area)
        self.mass_in = -self.at_steps("inletFlow")
        self.mass_out = self.at_steps("outletFlow")
        self.inflow = self.mass_in / density
        self.outflow = self.mass_out / density
        self.heat_out = self.gas_Cp * self.at_steps("outletHeat")  # [W]

    def read_series(self):
        super().read_series()
        self.history = columns(self.case, "heatHistory")
        self.fluid = self._fluid_energy()

    def _fluid_energy(self):
        """Powers of the gas as the log has them [W], at the steps' ends."""
        text = (self.case / "log.cghsFoam").read_text()
        steps = re.findall(
            r"^Time = (\S+)$(?:(?!^Time =).*\n)*?"
            r"energy: stored (\S+) W, inflow (\S+) W, walls (\S+) W,"
            r" parcels (\S+) W", text, re.M)
        rows = np.array(steps, float).reshape(-1, 1 + len(ENERGY))
        # Of steps that were done again, by a run that goes on, the later ones
        ahead = np.minimum.accumulate(rows[::-1, 0])[::-1]
        rows = rows[rows[:, 0] <= ahead]
        rows = rows[np.r_[rows[1:, 0] > rows[:-1, 0], True]]
        return dict(zip(("time", *ENERGY), rows.T))

    # Heat

    def mechanisms(self):
        """The names of all ways by which parcels receive heat: convection is
        called fluid. Those that only restore or remove parcels too. Not what
        each wall gives: that is in the ways by which it does."""
        return [name for name in self.history
                if f"{name}Mean" in self.history and name not in NO_MECHANISM
                and not name.startswith("wall:")]

    def used_mechanisms(self):
        return [name for name in self.mechanisms()
                if abs(self.history[f"{name}Mean"]).max() > 0]

    def given(self, name):
        """Heat that parcels have given by a way, at the history's times [J]."""
        return -self.history[f"{name}Mean"] * self.history["time"]

    def given_at_steps(self, name):
        return np.interp(self.time, np.r_[0, self.history["time"]],
                         np.r_[0, self.given(name)])

    def to_walls(self):
        """Heat that the gas has given to the walls, at the steps [J]."""
        time = self.fluid["time"]
        total = np.cumsum(-self.fluid["walls"] * np.diff(time, prepend=0))
        return np.interp(self.time, np.r_[0, time], np.r_[0, total])

    def walls_at(self, time):
        """By rows of cells over the height, the floor in the first: heat that
        the gas gives the walls at a written time, through half a cell [W]."""
        def cells(name):
            field = np.asarray(of.field(self.case, time, name), float)
            return np.broadcast_to(field, self.cells.prod()).reshape(
                self.cells[::-1])

        flux = (2 * self.conductivity * cells("alpha")
                * (cells("T") - self.cold))  # over the cell's length [W/m]
        dx, dy, dz = self.size / self.cells
        watts = ((flux[:, :, 0] + flux[:, :, -1]).sum(axis=0) * dy * dz / dx
                 + (flux[0] + flux[-1]).sum(axis=1) * dx * dy / dz)
        watts[0] += flux[:, 0].sum() * dx * dz / dy
        return watts

    def walls_below(self, height, time):
        return self.walls_at(time)[self.centres(1) < height].sum()

    def temperature(self, figure="TMean"):
        """At the steps."""
        return np.interp(self.time, np.r_[0, self.history["time"]],
                         np.r_[self.hot, self.history[figure]])

    def cap(self, temperature):
        """What gas that leaves with this temperature takes along [W]."""
        return self.mass_flow() * self.gas_Cp * (temperature - self.cold)

    def mixed_limit(self, time):
        """Temperature of parcels that give heat to the gas alone, which leaves
        with their temperature: none can cool faster by convection, but for what
        the gas gives the walls."""
        rate = self.mass_flow() * self.gas_Cp / self.capacity
        since = np.maximum(time - (self.gas_on or 0), 0)
        return self.cold + (self.hot - self.cold) * np.exp(-rate * since)

    def outlet_temperature(self, step):
        """Middles of steps of time, mean of what leaves by its mass flow."""
        time, heat = self.smooth(self.heat_out, step)
        flow = self.smooth(self.mass_out, step)[1]
        return time, heat / np.where(flow > 0.1 * self.mass_flow(),
                                     self.gas_Cp * flow, np.nan)

    def balance_end(self):
        """The last time that all tables of a run that may be on have."""
        return min(self.end, self.history["time"][-1], self.fluid["time"][-1])

    def balance(self):
        """Since the start [J]."""
        end = self.balance_end()
        time = self.fluid["time"]
        stored = np.cumsum(self.fluid["stored"] * np.diff(time, prepend=0))

        def until(total):
            return float(np.interp(end, self.time, total))

        heat = {
            "parcels have lost": self.lost_by(end),
            "gas out of the outlet, less gas in": until(self.total(
                self.heat_out - self.gas_Cp * self.cold * self.mass_in)),
            "gas to walls": until(self.to_walls()),
            "gas in the column": float(np.interp(end, time, stored)),
        }
        if len(self.used_mechanisms()) > 1:
            heat["parcels to walls, fed, left"] = sum(
                until(self.given_at_steps(name))
                for name in self.mechanisms() if name != "fluid")
        lost, *gone = heat.values()
        heat["defect"] = lost - sum(gone)
        return heat

    def lost_by(self, time):
        """By the parcels' mean temperature [J]."""
        now = np.interp(time, self.time, self.temperature())
        return float(self.capacity * (self.hot - now))

    def gas_defect(self):
        """Gas from nowhere, over what has come in."""
        gained = self.gas_mass[-1] - self.gas_mass[0]
        flowed = self.total(self.mass_in - self.mass_out)
        return (abs(gained - (flowed[-1] - flowed[0]))
                / max(self.total(self.mass_in)[-1], self.gas_mass[0]))

    # Side by side

    def figures(self, window):
        """Means in a window and standard errors, or None, by name."""
        def power(total):
            return self.rate_of(total, window)

        end = np.interp(window[1], self.time, self.temperature())
        spread = self.temperature("TMax") - self.temperature("TMin")
        values = {"mean temperature at the end [K]": (end, None)}
        for name in self.used_mechanisms():
            values[f"parcels give: {name} [W]"] = power(
                self.given_at_steps(name))
        values |= {
            "gas gives walls [W]": power(self.to_walls()),
            "hottest less coldest parcel [K]": self.mean(spread, window),
            "height of the bed's centre [m]":
                self.mean(self.parcels["centreY"], window),
            "pressure drop over weight [-]": tuple(
                x / self.weight for x in self.mean(self.pressure_drop, window)),
        }
        return values


def common_window(bed, other):
    """Of two runs, or None."""
    if not bed.window or not other.window:
        return None
    start = max(bed.window[0], other.window[0])
    end = min(bed.window[1], other.window[1])
    return (start, end) if end - start > 0.5 else None


def least_loss():
    """[J] that the chapter's parcels lose at least, as their rates fall: the
    last of them all the time."""
    return CHAPTER_END * (CHAPTER_CONVECTION[1] + CHAPTER_CONDUCTION[1])


def beds_in(folder):
    """The runs in a folder, by the name of their method."""
    return runs_by_method(folder, METHODS, Bed)

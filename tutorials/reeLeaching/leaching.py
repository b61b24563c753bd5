# ------------------------------------------------------------------------------
# cghsFoam: coarse-grained hard-sphere fluidised beds for OpenFOAM
# Licence: GPL-3.0-or-later, see the file LICENSE
#
# Description
#     Rare earths leached from ore (Lu et al., 2018, 4.3): the inputs of Tables
#     12 to 14, Eqs 103 to 106, and what a run of a reactor has left, as numbers:
#     the one place from which limits.py, and evaluate and validate of each
#     folder, take them.
# ------------------------------------------------------------------------------
"""Leaching of rare earths: kinetics, reactors, and their runs."""

import re
import sys
from pathlib import Path

HERE = Path(__file__).resolve().parent
PROJECT = next((folder for folder in HERE.parents
                if (folder / "etc" / "openfoam").exists()), None)
if PROJECT is None:
    sys.exit(f"{HERE} is not within a cghsFoam")
sys.path.append(str(PROJECT / "tutorials" / "lib"))
from fedRun import FedRun  # noqa: E402
from tutorial import (  # noqa: E402
    columns, log_of, mean_of, newest, np, number, of, option, runLog, series,
    stop)
import dragLaws  # noqa: E402

# Table 12: ore, and what of it can be leached; liquid [kg/m3, Pa s]
ORE, RARE_EARTH = 1340.0, 0.00102
LIQUID, VISCOSITY = 1000.0, 1e-3
AMMONIUM = 0.002730                     # by mass of the fresh liquid
TEMPERATURE = 298.0                     # not given [K]

# As constant/reactions has them [kg/mol]: lanthanum stands for all of them
M_REE, M_NH4 = 138.9055e-3, 14.0067e-3 + 4*1.00797e-3
CATIONS = 3                             # for each of the rare earth: not given

# Of the ore that leaves, which takes the liquid between it along: not given
VOIDAGE = 0.4

HOUR, DAY = 3600.0, 86400.0

# A reactor is steady if its liquid stores less of what it takes up
STEADY = 0.02


# Eqs 103 to 106


def rate(d):
    """k of Eq 105, per second and not per minute, in the liquid of the
    experiment; d: diameter [m]."""
    return 0.011*(0.5e3*d)**-1.217*np.exp(-9480/(8.31446*TEMPERATURE))


def leached(kt):
    """The fraction a of Eq 103: by the radius x of the core, of which it is
    (1 - x)^2 (1 + 2 x)/3."""
    kt = np.clip(np.asarray(kt, float), 0, 1/3)
    low, high = np.zeros_like(kt), np.ones_like(kt)
    for _ in range(60):
        x = 0.5*(low + high)
        early = (1 - x)**2*(1 + 2*x)/3 < kt
        low, high = np.where(early, low, x), np.where(early, x, high)
    return 1 - (0.5*(low + high))**3


def leached_in(k, tau, tanks, n=20000):
    """Of solids that have the distribution of ages of so many equal mixed tanks
    in series, tau together [s]; None: plug flow."""
    if tanks is None:
        return float(leached(k*tau))
    # Equal shares of the time in units of tau, far beyond the mean
    t = (np.arange(n) + 0.5)*(1 + 12/np.sqrt(tanks))/n
    logs = (tanks - 1)*np.log(t) - tanks*t
    share = np.exp(logs - logs.max())
    return float((share*leached(k*tau*t)).sum()/share.sum())


# Reactors


class Reactor:
    """Sizes in m, flows in kg/s, inventory in kg, recycle: of the liquid. The
    pipe is half as wide as the column, if not given."""

    def __init__(self, scale, width, liquid, solids, inventory, d,
                 recycle=0.2, pipe=None):
        self.scale, self.width = scale, width
        self.liquid, self.solids = liquid/HOUR, solids/HOUR
        self.inventory, self.d, self.recycle = inventory, d, recycle
        self.diameter = 0.08*width
        self.pipe = pipe or 0.5*self.diameter
        self.area = np.pi/4*self.diameter**2
        self.tau = inventory/self.solids

    def fresh(self):
        """What must come from outside [kg/s]."""
        return (1 - self.recycle)*self.liquid

    def drained(self):
        """Liquid that leaves with the solids [kg/s]."""
        return self.solids/ORE*VOIDAGE/(1 - VOIDAGE)*LIQUID

    def volume(self):
        """Of the vessel: pipe, cone, column [m3]."""
        return self.area*self.scale*(0.25*0.08 + 7/12*0.01 + 0.55)

    def liquid_time(self):
        """What the outlet needs to come e times nearer to its steady state: the
        liquid there is over what leaves for good at the top [s]."""
        return (LIQUID*(self.volume() - self.inventory/ORE)
                / (self.fresh() - self.drained()))

    def steady_after(self, off=0.05):
        """Time when the outlet is within 1 % of its steady state, if it starts
        off by the share off; ore is renewed four times before [s]."""
        return max(4*self.tau, self.liquid_time()*np.log(off/0.01))

    def passing(self):
        """The most ore that the pipe can pass if none did [kg/s]: particles
        that fall in liquid at rest, as close as they do best."""
        area = np.pi/4*self.pipe**2
        return max(
            ORE*area*(1 - e)/e*dragLaws.carrying_velocity(
                "WenYu", self.d, LIQUID, VISCOSITY, ORE, e=e)
            for e in np.linspace(0.4, 0.95, 12))

    def outlet(self, a, below=1.0):
        """Mass fraction of rare earth in the liquid that leaves at the top, if
        the solids are leached by a. below: that of the liquid which leaves with
        them, over it: between 1 and, if nothing is leached down there, the
        share that is recycled."""
        return self.solids*RARE_EARTH*a/(
            self.fresh() - (1 - below)*self.drained())

    def top(self):
        """Liquid that leaves at the top [kg/s]."""
        return self.liquid - self.drained()

    def outlet_by_top(self, a, below=1.0):
        """The outlet if what is recycled is that share not of the liquid that
        enters, but of what leaves at the top."""
        fresh = self.liquid - self.recycle*self.top()
        return self.solids*RARE_EARTH*a/(fresh - (1 - below)*self.drained())

    def ammonium(self, a):
        """The same of what is left of the ammonium."""
        return AMMONIUM - CATIONS*M_NH4/M_REE*self.outlet(a)

    def made(self, a):
        """Rare earth [kg/day]."""
        return DAY*self.solids*RARE_EARTH*a

    def leached(self, tanks=None, cation=1.0):
        """cation: its mean concentration over that of the experiment."""
        return leached_in(cation*rate(self.d), self.tau, tanks)

    def poorest(self, tanks=None):
        """The same if all ore saw the liquid of the outlet."""
        a = 0.8
        for _ in range(60):
            a = 0.5*(a + self.leached(tanks, self.ammonium(a)/AMMONIUM))
        return a


# Table 13; Table 14 as mended: 288 kg/h and not 28.8
OPERATIONS = {
    "Base": Reactor(1, 1, 72, 18.41, 0.409, 4.5e-4),
    "Recycle50": Reactor(1, 1, 72, 18.41, 0.409, 4.5e-4, recycle=0.5),
    "L36": Reactor(1, 1, 36, 18.41, 0.409, 4.5e-4),
    # Table 14 has a pipe of 40 mm, which does not pass so much: see the README
    "L36S36": Reactor(1, 1, 36, 36.82, 0.409, 4.5e-4, pipe=0.057),
}
SIZES = {
    "small": Reactor(1, 1, 72, 18.41, 0.409, 4.5e-4),
    "medium": Reactor(2, 2, 288, 73.64, 3.273, 6e-4),
    "medium0.45": Reactor(2, 2, 288, 73.64, 3.273, 4.5e-4),
    "large": Reactor(4, 10, 7200, 1841, 163.644, 1.2e-3),
}
REACTORS = {**OPERATIONS, **SIZES}
# What the chapter's text says: outlet by mass [-], leached [-], kg/day
CHAPTER_OUTLET = {"Recycle50": 0.0004, "L36S36": 0.0012}
CHAPTER_LEACHED = {"small": 0.80, "medium": 0.80, "medium0.45": 0.93,
                   "large": 0.77}
CHAPTER_MADE = {"small": 0.36, "medium": 1.45, "large": 36.2}


def terminal(d):
    """Velocity at which one particle falls, by Wen and Yu [m/s]."""
    return dragLaws.terminal_velocity("WenYu", d, LIQUID, VISCOSITY, ORE)


def expanded(d, U):
    """Voidage at which a superficial velocity carries the solids, by Wen and
    Yu: a fluidised bed."""
    low, high = 0.3, 1 - 1e-9
    for _ in range(60):
        e = 0.5*(low + high)
        carries = dragLaws.carrying_velocity(
            "WenYu", d, LIQUID, VISCOSITY, ORE, e=e)
        low, high = (e, high) if carries < U else (low, e)
    return e


# Runs


class Leaching(FedRun):
    """A run of ore in liquid, and how far it has been leached."""

    start_up = 10

    def read_inputs(self):
        self.average_from = option(
            self.case, "averageFrom", "constant/method", 0)
        method = self.case / "constant" / "method"
        self.diameter = number(method, "diameter")
        self.weight = number(method, "weight")
        self.parcel_mass = np.pi/6*self.diameter**3*ORE*self.weight

    def leached_there(self):
        """Times, and what has been leached of the ore in the mesh."""
        rows = columns(self.case, "reactionHistory")
        return rows["time"], 1 - rows["Y.REE"]/RARE_EARTH

    def species_defect(self, name):
        """All that has come from nowhere since the start, over what there is
        and what has come in, as fast as at the end: by the log, in which it
        begins anew with each start of the solver."""
        found = [re.findall(rf"species {name}: .*, in (\S+) kg/s.*\n.*; (\S+)"
                            rf" kg, from nowhere (\S+) kg", part)
                 for part in runLog.starts(log_of(self.case))]
        last = np.array([part[-1] for part in found if part], float)
        inflow, there, _ = last[-1]
        return abs(last[:, 2].sum())/(there + inflow*self.end)

    def least_ammonium(self):
        """Times, and the lowest of all cells over that of the fresh liquid: by
        the log."""
        steps = runLog.steps(
            log_of(self.case),
            re.compile(r"species NH4: .*\n.*; Y from (\S+) to"))
        time, least = zip(*steps.items())
        return np.array(time), np.array(least)/AMMONIUM


class Operation(Leaching):
    """A run of a counter-current reactor."""

    def read_inputs(self):
        super().read_inputs()
        self.reactor = REACTORS[self.case.name]
        self.least_window = 0.5*self.reactor.tau

    def read_series(self):
        super().read_series()
        # Times, rare earth and ammonium, by mass
        self.liquids = {name: series(self.case, name)[:, :3].T
                        for name in ("outlet", "recycled", "drained")}
        self.outlet_time, self.outlet, self.outlet_ammonium = (
            self.liquids["outlet"])
        self.flows = {name: series(self.case, name)[:, :2].T
                      for name in ("outletFlow", "freshFlow", "recycleFlow",
                                   "drainFlow")}
        self.drained = self.liquids["drained"][:2]

    def is_long(self):
        """Has the ore been renewed four times?"""
        return self.window is not None and self.end > 4*self.reactor.tau

    def drift(self):
        """Rare earth that the liquid in the reactor stores, over what it takes
        up from the ore, means of the window."""
        rows = columns(self.case, "balance")
        return abs(rows["stored(REEaq)Mean"][-1]
                   / rows["gained(REEaq)Mean"][-1])

    def is_steady(self):
        """Ore and liquid."""
        return self.is_long() and self.drift() <= STEADY

    def has_ended(self):
        return self.end > option(
            self.case, "endTime", "constant/method") - 1e-6

    def bed_cells(self):
        """As many as fill the bed that the liquid carries."""
        cells = number(self.case / "log.checkMesh", r"    cells:")
        reactor = self.reactor
        U = reactor.liquid/LIQUID/reactor.area
        bed = reactor.inventory/ORE/(1 - expanded(reactor.d, U))
        return cells*bed/reactor.volume()

    def flow(self, name):
        """Out of the mesh, mean of the run from its second step on [kg/s]."""
        time, flow = self.flows[name]
        return LIQUID*np.average(flow[1:], weights=np.diff(time))

    def mean_outlet(self):
        """Rare earth of the liquid that leaves, by mass, and error."""
        return self.windowed(self.outlet_time, self.outlet)

    def mean_drained(self):
        """The same of the liquid that leaves with the ore."""
        return self.windowed(*self.drained)

    def windowed(self, time, values):
        return mean_of(np.interp(np.linspace(*self.window, 1000), time, values))

    def balanced_outlet(self):
        """What it would be in a steady state: what the ore loses, less what it
        takes along, over what leaves for good at the top; and error."""
        lost, error = self.leached_leaving()
        fed = self.reactor.solids*RARE_EARTH
        down = self.reactor.drained()
        up = self.reactor.fresh() - down
        along, other = self.mean_drained()
        return ((fed*lost - down*along)/up,
                np.hypot(fed*error, down*other)/up)

    def leached_leaving(self):
        """Of the ore that leaves, and error."""
        mean, error, _ = self.leaving("leftInLeaving")
        return 1 - mean/RARE_EARTH, error/RARE_EARTH

    def histogram(self, name):
        """Middles of bins, share of the mass that leaves in each."""
        rows = newest(self.case, name, "histogram")
        return rows["x"], rows["share"]

    def by_ages(self, cation=1.0):
        """What Eq 103 leaches of ore of the ages that the ore has that leaves.
        cation: ammonium over that of the liquid of the experiment."""
        ages, share = self.histogram("ageOfLeaving")
        kt = cation*rate(self.diameter)*ages
        return float(share @ leached(kt)/share.sum())

    def tanks(self):
        """How many mixed tanks in series have ages that vary as much."""
        mean, _, deviation = self.leaving("ageOfLeaving")
        return (mean/deviation)**2

    def made(self):
        """Rare earth that leaves for good with liquid, at the top and with the
        ore [kg/day]."""
        mean, error = self.mean_outlet()
        along, other = self.mean_drained()
        up = self.flow("outletFlow") + self.flow("recycleFlow")
        down = self.flow("drainFlow")
        return (DAY*(up*mean + down*along),
                DAY*np.hypot(up*error, down*other))


def operations_in(folder, names):
    """Those of these runs that there are."""
    found = {name: Operation(Path(folder) / name) for name in names
             if (Path(folder) / name / "log.cghsFoam").exists()}
    if not found:
        stop(f"{folder} has no run: run ./Allrun first")
    return found

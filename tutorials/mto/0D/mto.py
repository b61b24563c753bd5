# ------------------------------------------------------------------------------
# cghsFoam: coarse-grained hard-sphere fluidised beds for OpenFOAM
# Licence: GPL-3.0-or-later, see the file LICENSE
#
# Description
#     The run of the stirred reactor for methanol to olefins: its table over
#     time, its parcels at the times that were written, and the numbers of the
#     chapter and of the plant that it is shown beside.
# ------------------------------------------------------------------------------
"""Reading the run of the stirred reactor."""

import re
import sys
from pathlib import Path

HERE = Path(__file__).resolve().parent
PROJECT = next((folder for folder in HERE.parents
                if (folder / "etc" / "openfoam").exists()), None)
if PROJECT is None:
    sys.exit(f"{HERE} is not within a cghsFoam")
sys.path.append(str(PROJECT / "tutorials" / "lib"))
from cokeChemistry import Chemistry, block, dictionary, value  # noqa: E402
from tutorial import np, stop  # noqa: E402

# Atoms of the lumps; coke is one, too, but stays on the catalyst
CARBON = dict(CH4=1, C2H4=2, C3H6=3, C3H8=3, C4H8=4, C5H10=5, coke=6)
HYDROGEN = dict(CH4=4, C2H4=4, C3H6=6, C3H8=8, C4H8=8, C5H10=10, coke=12)
GAS = [lump for lump in CARBON if lump != "coke"]
LIGHT = ("C2H4", "C3H6")

HOUR = 3600.0

# 4.2.3, by mass [%]: coke on the catalyst after 8 h, light olefins of products
CHAPTER_STIRRED, CHAPTER_3D, PLANT = 5.6, 5.9, 6.0
CHAPTER_LIGHT, PLANT_LIGHT = 81.2, 77.6

# Of Fig 36, told in the text: new catalyst after half an hour, and where most
# of the coke's distribution is after 8 h [%]
NEW, PEAK = 40.0, 7.5


def fractions(text):
    """The mass fractions Y of a dictionary's text."""
    return {name: float(y) for name, y in
            re.findall(r"(\w+)\s+([\d.eE+-]+)\s*;", block(text, "Y"))}


class Inputs:
    """What the case's dictionaries say, in SI."""

    def __init__(self, case):
        text = dictionary(case, "reactorProperties")
        self.chemistry = Chemistry(case)
        solids, inflow = block(text, "solids"), block(text, "inflow")
        feed = block(solids, "feed")

        self.p = value(text, "p")
        self.volume = value(text, "volume")
        self.density = value(solids, "rho")
        self.T = value(inflow, "T")
        self.gas = value(inflow, "massFlowRate")
        self.gas_Y = fractions(inflow)
        self.inventory = value(solids, "inventory")
        self.feed = value(feed, "massFlowRate")
        self.feed_coke = fractions(feed)["coke"]
        self.start = option(case, "cokeAtStart",
                            value(text, "cokeAtStart"))
        self.parcels = int(option(case, "nParcels",
                                  value(text, "nParcels")))

    def coke_by_total(self):
        """Do the rates take coke over the particle, not over the catalyst?"""
        return "cokeOf" in self.chemistry.reactions and bool(
            re.search(r"\bcokeOf\s+particle\s*;", self.chemistry.reactions))

    def rates(self):
        """A [m3/kg/s] and alpha of each lump."""
        texts = [block(self.chemistry.reactions,
                       "to" + lump[0].upper() + lump[1:]) for lump in CARBON]
        return (np.array([value(text, "A") for text in texts]),
                np.array([value(text, "alpha") for text in texts]))


def option(case, name, default):
    """What Allrun has written for an entry, or the default."""
    path = Path(case) / "system" / "runOptions"
    found = value(path.read_text(), name) if path.exists() else None
    return default if found is None else found


class Run:
    """Columns over time, by names; parcels by times [s]."""

    def __init__(self, case):
        self.case = Path(case)
        self.inputs = Inputs(case)
        self.folder = self.case / "postProcessing" / "cghsReactor" / "0"
        table = self.folder / "reactor.dat"
        if not table.exists():
            stop(f"there is no {table}: run ./Allrun first")
        names = ["time", "T", "T_solids", "mass", "age",
                 *self.inputs.chemistry.gas, "coke", "SAPO34"]
        self.columns = dict(zip(names, np.loadtxt(table, ndmin=2).T))
        self.time = self.columns["time"]
        self.log = (self.case / "log.cghsReactor").read_text()

    def __getitem__(self, name):
        return self.columns[name]

    # Of what flows out

    def shares(self):
        """Of each lump in hydrocarbon gas, by mass, over time [-]."""
        all_of_them = sum(self[lump] for lump in GAS)
        return {lump: self[lump]/np.maximum(all_of_them, 1e-30)
                for lump in GAS}

    def light(self):
        shares = self.shares()
        return sum(shares[lump] for lump in LIGHT)

    def outflow(self):
        """Of gas [kg/s]: what comes in less the coke. As the gas is renewed in
        a second, what it stores is left out."""
        i = self.inputs
        clean = self["mass"]*self["SAPO34"]
        coke = 100*self["coke"]/self["SAPO34"]
        step = 60
        made = np.interp(self.time, self.time[::step],
                         np.gradient(coke[::step], self.time[::step]))
        fresh = 100*i.feed_coke/(1 - i.feed_coke)
        made = clean*made/100 + i.feed*(1 - i.feed_coke)*(coke - fresh)/100
        return i.gas - made

    def conversion(self):
        i = self.inputs
        return 1 - self.outflow()*self["MeOH"]/(i.gas*i.gas_Y["MeOH"])

    # Means

    def late(self):
        """The second half."""
        return self.time > 0.5*self.time[-1]

    def mean(self, values):
        """Of the second half, and its standard error by five blocks."""
        blocks = np.array([b.mean() for b in
                           np.array_split(values[self.late()], 5)])
        return blocks.mean(), blocks.std(ddof=1)/np.sqrt(blocks.size)

    # Parcels

    def times(self):
        return sorted(float(path.stem.split("_")[1])
                      for path in self.folder.glob("parcels_*.csv"))

    def parcels(self, time):
        """Age [s], coke by mass [%], mass [-] of each, by coke. All have as
        much of the catalyst itself."""
        rows = np.genfromtxt(self.folder / f"parcels_{time:g}.csv",
                             delimiter=",", names=True)
        rows = rows[np.argsort(rows["coke"])]
        mass = 1/rows["SAPO34"]
        return rows["age"], 100*rows["coke"], mass/mass.sum()

    # The log

    def defect(self, item):
        """Stored less at the start less in plus out: over the largest of these,
        and of it what is missing [kg or mol]."""
        lines = re.findall(
            rf"^    {item}: stored (\S+), (\S+) more than at the start; in less"
            r" out (\S+); relative defect ([\d.e+-]+)", self.log, re.M)
        _, more, passed, relative = map(float, lines[-1])
        return relative, more - passed

    def seconds(self):
        return float(re.findall(r"ClockTime = (\S+)", self.log)[-1])

    def processor(self):
        return float(re.findall(r"ExecutionTime = (\S+)", self.log)[-1])

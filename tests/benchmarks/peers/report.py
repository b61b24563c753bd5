#!/usr/bin/python3
# ------------------------------------------------------------------------------
# cghsFoam: coarse-grained hard-sphere fluidised beds for OpenFOAM
# Licence: GPL-3.0-or-later, see the file LICENSE
# ------------------------------------------------------------------------------
"""Figures of the benchmark peers: what each way to compute the bed costs, and
how far it is from springs between all particles. Means over the same window,
with the error that their correlation time leaves."""

import os
import sys
from pathlib import Path

import numpy as np

ROOT = os.environ["PROJECT_DIR"]
sys.path += [ROOT + "/etc/python", ROOT + "/tests/benchmarks/lib"]
import caseFiles as of
import measure as ms
import runLog
import windows

START, END, DT = 1.0, 4.0, 0.02
RHO = 1.2           # p is over the density of the gas
REFERENCE = "springs"
STUDY = Path("bed/study")
QUANTITIES = ("bedHeight", "pressureDrop", "granularTemperature")
ENOUGH = 5          # percent of error


class Means:
    """Mean and standard error of each quantity."""

    def __init__(self, **series):
        self.mean, self.error = {}, {}
        for name, (time, values) in series.items():
            grid = np.arange(START, END + DT/2, DT)
            sampled = np.interp(grid, time, values)
            window = windows.judge(sampled, DT)
            self.mean[name] = sampled.mean()
            self.error[name] = sampled.std(ddof=1)/np.sqrt(
                max(window.independent, 1))

    def bias(self, name, reference):
        """Difference from the reference and its noise [%]."""
        scale = 100/reference.mean[name]
        return ((self.mean[name] - reference.mean[name])*scale,
                np.hypot(self.error[name], reference.error[name])*scale)


def table(case, name, file, column):
    """Time and a column of what a run has written, over all its starts."""
    paths = sorted((case/"postProcessing"/name).glob(f"*/{file}"),
                   key=lambda path: float(path.parent.name))
    names = list(of.columns(paths[0]))
    rows = of.joined(paths)
    return rows[:, 0], rows[:, names.index(column)]


def pressure(case):
    time, p = table(case, "inletPressure", "surfaceFieldValue.dat",
                    "areaAverage(p)")
    return time, RHO*p


def ours(case):
    return Means(
        bedHeight=table(case, "parcels", "parcels.dat", "centreZ"),
        pressureDrop=pressure(case),
        granularTemperature=table(case, "parcels", "parcels.dat",
                                  "granularTemperature"))


def theirs(case):
    """From the parcels that it has written, all of the same mass."""
    times = [t for t in of.times(case) if float(t) >= START - 1e-9]
    height, temperature = [], []
    for time in times:
        v = of.cloud_field(case, time, "kinematicCloud", "U")
        height.append(of.positions(case, time, "kinematicCloud")[:, 2].mean())
        temperature.append(v.var(axis=0).sum()/3)
    times = np.array(times, float)
    return Means(bedHeight=(times, np.array(height)),
                 pressureDrop=pressure(case),
                 granularTemperature=(times, np.array(temperature)))


def cost(log, start=START):
    return runLog.cost(Path(log).read_text(), start=start)


variants = [path.parent.name for path in sorted(STUDY.glob("*/1"))]
means = {name: ours(STUDY/name/"1") for name in variants}
costs = {name: cost(STUDY/name/"1/log.cghsFoam") for name in variants}
means["MPPICFoam"] = theirs(Path("MPPICFoam"))
costs["MPPICFoam"] = cost("log.MPPICFoam")
dpm = ms.Log("log.DPMFoam").cpu_per_simulated_second
reference = means[REFERENCE]

print(f"\n| | CPU s for a simulated s | DPMFoam takes | MPPICFoam takes | "
      + " | ".join(QUANTITIES) + " |")
print("|---|--:|--:|--:|" + "--:|"*len(QUANTITIES))
print(f"| DPMFoam | {dpm:.0f} | 1 | {costs['MPPICFoam']/dpm:.2g} |"
      + " |"*len(QUANTITIES))
within = []
for name in sorted(means, key=costs.get, reverse=True):
    bias = [means[name].bias(q, reference) for q in QUANTITIES]
    if name == REFERENCE:
        said = [f"{reference.mean[q]:.4g} ± {reference.error[q]:.2g}"
                for q in QUANTITIES]
    else:
        said = [f"{b:+.1f} ± {n:.1f} %" for b, n in bias]
        if name in variants and max(abs(b) for b, _ in bias) <= ENOUGH:
            within.append(name)
    print(f"| {name} | {costs[name]:.1f} | {dpm/costs[name]:.0f} |"
          f" {costs['MPPICFoam']/costs[name]:.2g} | " + " | ".join(said) + " |")
print()

for name in sorted(means):
    ms.figure(f"peers.{name}.speedupOverDPMFoam", dpm/costs[name])
    ms.figure(f"peers.{name}.speedupOverMPPICFoam",
              costs["MPPICFoam"]/costs[name])
    for quantity in QUANTITIES:
        ms.figure(f"peers.{name}.{quantity}ErrorPercent",
                  means[name].bias(quantity, reference)[0])

if within:
    best = min(within, key=costs.get)
    print(f"\nAt most {ENOUGH} % in all three, by estimate: {best}")
    ms.figure("peers.speedupOverDPMFoam", dpm/costs[best])
    ms.figure("peers.speedupOverMPPICFoam", costs["MPPICFoam"]/costs[best])
else:
    print(f"\nNothing but {REFERENCE} is within {ENOUGH} % in all three")

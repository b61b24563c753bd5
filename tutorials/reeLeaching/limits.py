#!/usr/bin/python3
# ------------------------------------------------------------------------------
# cghsFoam: coarse-grained hard-sphere fluidised beds for OpenFOAM
# Licence: GPL-3.0-or-later, see the file LICENSE
#
# Script
#     limits.py
#
# Description
#     What balances and Eq 103 say of all reactors of this tutorial before any
#     is run: leached fraction if the solids pass in plug flow, in ten mixed
#     tanks, in one; with the ammonium of the fresh liquid, and, in brackets,
#     with that of the outlet; the rare earth in the liquid that leaves; why
#     liquid has to leave with the ore; what the recycled share is of; and how
#     long runs must be.
# ------------------------------------------------------------------------------
"""Limits of the leaching reactors."""

import sys

sys.dont_write_bytecode = True
from leaching import (  # noqa: E402
    AMMONIUM, CHAPTER_MADE, CHAPTER_OUTLET, HOUR, LIQUID, OPERATIONS, ORE,
    RARE_EARTH, REACTORS, SIZES, expanded, leached, np, rate, terminal)

TANKS = {"plug flow": None, "ten tanks": 10, "mixed": 1}


def flow(name, reactor):
    U = reactor.liquid/LIQUID/reactor.area
    e = expanded(reactor.d, U)
    print(f"{name}: {1e3*reactor.d:g} mm, U {1e3*U:.2f} mm/s, which carries a bed"
          f" of voidage {e:.3f}; one particle falls at"
          f" {1e3*terminal(reactor.d):.1f} mm/s; all solids in it:"
          f" {reactor.inventory/ORE/(1 - e)/reactor.area:.3f} m;"
          f" inventory over feed {reactor.tau:.1f} s; full after"
          f" {1/3/rate(reactor.d):.0f} s")


def leaching(reactor):
    for text, tanks in TANKS.items():
        a, least = reactor.leached(tanks), reactor.poorest(tanks)
        low, high = (100*reactor.outlet(a, below)
                     for below in (1, reactor.recycle))
        print(f"  {text}: leached {100*a:.1f} % ({100*least:.1f} %), outlet"
              f" {low:.4f} to {high:.4f} %, {reactor.made(a):.4g} kg/day")
    print(f"  the pipe passes {HOUR*reactor.passing():.4g} kg/h of ore in liquid"
          f" at rest, and is to pass {HOUR*reactor.solids:.4g} kg/h: with"
          f" {HOUR*reactor.drained():.3g} kg/h of the liquid between it")


def operations():
    """How the operations compare, in plug flow."""
    base = OPERATIONS["Base"]
    print("\nRare earth in the outlet over that of Base, if the liquid that"
          " leaves with the ore is as rich, and if it is as it comes in:")
    for name, reactor in OPERATIONS.items():
        equal = reactor.outlet(1)/base.outlet(1)
        plug = [reactor.outlet(reactor.leached(), below(reactor))
                / base.outlet(base.leached(), below(base))
                for below in (lambda r: 1, lambda r: r.recycle)]
        print(f"  {name}: {equal:.2f} at equal leached fraction,"
              f" {plug[0]:.2f} to {plug[1]:.2f} in plug flow")
    last = OPERATIONS["L36S36"]
    given = CHAPTER_OUTLET["L36S36"]
    print(f"The chapter's {100*given:.2g} % of L36S36 takes"
          f" {100*given/last.outlet(1):.0f}"
          f" % leached if no liquid, or such liquid, leaves with the ore, in"
          f" {last.tau:.0f} s: Eq 103 has {100*last.leached():.0f} %. With half"
          f" of that below, {100*given/last.outlet(1, 0.5):.0f} %. 'Six times'"
          f" less is 0.02 %: {100*2e-4/base.outlet(1):.0f} % leached in Base.")


# As runs have had it: leached, and the liquid below over the outlet
MEASURED = {"Base": (0.767, 1.07), "Recycle50": (0.768, 0.78),
            "L36": (0.773, 0.49), "L36S36": (0.583, 1.47)}


def recycled():
    """What the recycled share is of, and what it makes of the outlet."""
    print("\nThe share that is recycled is one of the liquid that enters. With"
          " what runs have leached and had below (in brackets), the outlet, and"
          " what it would be if it were that share of what leaves at the top:")
    for name, reactor in OPERATIONS.items():
        a, below = MEASURED[name]
        print(f"  {name} ({a:g}, {below:g}):"
              f" {100*reactor.recycle*reactor.liquid/reactor.top():.0f} % of"
              " what leaves at the top, outlet"
              f" {100*reactor.outlet(a, below):.4f} %; else {100*reactor.outlet_by_top(a, below):.4f} %")


def lengths():
    """How long a run must be."""
    print("\nTime constants of ore and liquid, and when an outlet that starts"
          " 5 % off is within 1 % of its steady state:")
    for name, reactor in REACTORS.items():
        print(f"  {name}: {reactor.tau:.0f} s, {reactor.liquid_time():.0f} s;"
              f" after {reactor.steady_after():.0f} s")


def main():
    print(f"Ore: {ORE*RARE_EARTH:.4f} kg/m3 of rare earth; liquid: ammonium"
          f" {AMMONIUM:g} by mass")
    for d in (4.5e-4, 6e-4, 1.2e-3):
        times = np.array([40, 80, 160, 320])
        print(f"{1e3*d:g} mm: k {rate(d):.4e} 1/s, leached after "
              + ", ".join(f"{t} s {100*a:.1f} %" for t, a in
                          zip(times, leached(rate(d)*times))))
    print()
    for name, reactor in REACTORS.items():
        flow(name, reactor)
        leaching(reactor)
    operations()
    recycled()
    lengths()
    print("\nAt 80 % leached: " + ", ".join(
        f"{name} {SIZES[name].made(0.8):.4g} kg/day (chapter {given})"
        for name, given in CHAPTER_MADE.items()))


if __name__ == "__main__":
    main()

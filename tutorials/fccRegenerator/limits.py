# ------------------------------------------------------------------------------
# cghsFoam: coarse-grained hard-sphere fluidised beds for OpenFOAM
# Licence: GPL-3.0-or-later, see the file LICENSE
#
# Description
#     The steady limits of the regenerator, by the balances of carbon, hydrogen,
#     the gas's species and enthalpy, see tutorials/lib/cokeChemistry.py. The flue
#     gas that comes with the spent catalyst is mixed with the air at the floor.
#     Run by itself it prints both:
#
#         python3 limits.py
# ------------------------------------------------------------------------------
"""Steady limits of the regenerator."""

import sys
from pathlib import Path

sys.dont_write_bytecode = True
from regenerator import (  # noqa: E402
    AIR, INVENTORY, SPENT, SPENT_GAS, VOIDAGE)
from cokeChemistry import Chemistry, CokeBed  # noqa: E402

# In the middle of the bed [Pa]; catalyst [kg/m3]
PRESSURE, DENSITY = 1.5e5, 1500.0


def limit(plug):
    """See CokeBed.limit."""
    bed = CokeBed(
        Chemistry(Path(__file__).resolve().parent),
        (SPENT, 753.0, dict(C=0.009, H=0.00072, catalyst=0.99028)),
        INVENTORY, PRESSURE, INVENTORY/DENSITY*VOIDAGE/(1 - VOIDAGE),
        ((AIR, 573.0, dict(O2=0.232, CO2=0.0005, N2=0.7675)),
         (SPENT_GAS, 753.0, dict(O2=0.0212, CO2=0.2617, CO=0.0093, H2O=0.0416,
                                 N2=0.6662))))
    return bed.limit(plug)


def main():
    for name, plug in (("gas in plug flow", True), ("gas mixed", False)):
        found = limit(plug)
        print(f"{name}: {found['T']:.1f} K, coke"
              f" {100*(found['C'] + found['H']):.3f} %; gas by mass, %: "
              + ", ".join(f"{s} {100*y:.3g}" for s, y in found.items()
                          if s not in ("C", "H", "T")))


if __name__ == "__main__":
    main()

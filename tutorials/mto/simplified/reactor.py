# ------------------------------------------------------------------------------
# cghsFoam: coarse-grained hard-sphere fluidised beds for OpenFOAM
# Licence: GPL-3.0-or-later, see the file LICENSE
#
# Description
#     The run of the lower part of the reactor, of mto/common, for evaluate,
#     validate and compareFactors.
# ------------------------------------------------------------------------------
"""The lower part of the reactor in three dimensions."""

import sys
from pathlib import Path

PROJECT = next((folder for folder in Path(__file__).resolve().parents
                if (folder / "etc" / "openfoam").exists()), None)
if PROJECT is None:
    sys.exit(f"{Path(__file__).parent} is not within a cghsFoam")
sys.path += [str(PROJECT / "tutorials" / folder)
             for folder in ("lib", "mto/common")]
from mtoRun import Reactor  # noqa: E402, F401
from tutorial import np, of  # noqa: E402, F401

# Of the vessel above the floor [m], as the script vessel has it
HEIGHT = 0.8

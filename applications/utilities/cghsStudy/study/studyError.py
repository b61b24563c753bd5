# ------------------------------------------------------------------------------
# cghsFoam: coarse-grained hard-sphere fluidised beds for OpenFOAM
# Licence: GPL-3.0-or-later, see the file LICENSE
#
# Description
#     Refusals, as the rest of cghsFoam words them: where, what was found, what
#     would do, what to do about it.
# ------------------------------------------------------------------------------
"""The error that ends a study, as its user is to read it."""


class StudyError(Exception):
    """Of the study itself: a variant that fails is none."""

    def __init__(self, file, entry, what, choices=(), remedy=None):
        place = f"{file}, entry {entry}" if entry else str(file)
        lines = [f"{place}: {what}"]
        if choices:
            lines.append("choose among: " + ", ".join(map(str, choices)))
        if remedy:
            lines.append(f"remedy: {remedy}")
        super().__init__("\n    ".join(lines))

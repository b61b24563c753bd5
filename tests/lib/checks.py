# ------------------------------------------------------------------------------
# cghsFoam: coarse-grained hard-sphere fluidised beds for OpenFOAM
# Licence: GPL-3.0-or-later, see the file LICENSE
#
# Description
#     The table of checks that the tutorials' validate scripts print.
# ------------------------------------------------------------------------------
"""Numbers of a run held against references, as a table."""

import sys


class Checks:
    """The lines of the table."""

    def __init__(self):
        self.rows = []

    def add(self, quantity, value, reference, error, tolerance, source):
        # Not 'error > tolerance', which would let nan pass
        passed = bool(error <= tolerance)
        self.rows.append((
            quantity, f"{value:.6g}", reference, f"{error:.3g}",
            f"{tolerance:.3g}", "ok" if passed else "OFF", source,
        ))

    def equal(self, quantity, value, reference, tolerance, source):
        """Relative error, or absolute where the reference is zero."""
        error = abs(value - reference) / (abs(reference) or 1)
        self.add(quantity, value, f"{reference:.6g}", error, tolerance, source)

    def below(self, quantity, value, bound, source):
        """Magnitudes: the value is the error."""
        self.add(quantity, value, f"<= {bound:.3g}", value, bound, source)

    def sign(self, quantity, mean_error, wanted, enough, source):
        """Of a mean over time enough the wanted sign must be certain, to two
        standard errors; a short one must not speak against it, to three."""
        mean, error = mean_error
        value = mean if wanted == ">" else -mean
        if enough:
            self.add(quantity, mean, f"{wanted} 0", error, 0.5 * value, source)
        else:
            self.add(quantity, mean, f"not {'<' if wanted == '>' else '>'} 0",
                     max(-value, 0), 3 * error, source)

    def failed(self):
        return [row[0] for row in self.rows if row[5] != "ok"]

    def within(self, quantity, value, low, high, source):
        """Between two bounds: the error is the distance from their middle."""
        middle, half = 0.5 * (low + high), 0.5 * (high - low)
        self.add(quantity, value, f"{low:g}..{high:g}", abs(value - middle),
                 half, source)

    def print(self):
        head = ("quantity", "value", "reference", "error", "tolerance",
                "verdict", "source of the reference")
        table = [head, *self.rows]
        widths = [max(len(row[i]) for row in table) for i in range(6)]
        for row in table:
            cells = [text.ljust(width) for text, width in zip(row, widths)]
            print("  ".join([*cells, row[6]]))

    def conclude(self):
        """Prints the table and ends the program: 0 only if all is well."""
        self.print()
        failed = self.failed()
        print(f"\nvalidate: {len(self.rows) - len(failed)} of "
              f"{len(self.rows)} numbers as they should be")
        for quantity in failed:
            print(f"validate: OFF: {quantity}", file=sys.stderr)
        sys.exit(bool(failed))

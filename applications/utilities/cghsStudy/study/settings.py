# ------------------------------------------------------------------------------
# cghsFoam: coarse-grained hard-sphere fluidised beds for OpenFOAM
# Licence: GPL-3.0-or-later, see the file LICENSE
#
# Description
#     The whole of studyDict as what the other modules work with.
# ------------------------------------------------------------------------------
"""The study that a dictionary describes."""

import itertools
import re
from functools import cached_property

from study import variants
from study.block import Block
from study.quantities import read_quantities
from study.studyError import StudyError
from study.variants import Knob, named_variant

CONTROL = "system/controlDict"
REFERENCE = "reference"     # name of a variant that only the reference is


class Study:
    """What to run, what to read from it, what to hold it against."""

    def __init__(self, case, path):
        block = Block.read(path)
        self.case, self.block = case, block
        self.folder = case / "study"
        self.prepare = block.words("prepare", ["blockMesh", "fillParcels"])
        self.command = block.word("run", "cghsFoam")
        self.copied = block.words("copy", [])
        self.deterministic = block.switch("deterministic", False)
        self.cost_from = block.number("costFrom", 0)
        self.thresholds = block.numbers("thresholds", [1, 5, 10])
        self.longest = block.number("hoursPerRun", float("inf"), 0)

        knobs = block.block("knobs")
        self.knobs = [Knob(k, knobs.block(k)) for k in knobs.keys()]
        self.variants = self._read_variants(block)
        self._read_reference(block)
        self._read_replicas(block)
        self.quantities = read_quantities(block.block("quantities"))
        block.refuse_others()

    def _read_variants(self, block):
        if block.is_block("variants"):
            made = variants.by_hand(self.knobs, block.block("variants"))
        else:
            how = {"each": variants.one_by_one, "all": variants.all_of}
            made = how[block.word("variants", "each", tuple(how))](self.knobs)
        return {variant.name: variant for variant in made}

    def _read_reference(self, block):
        """A variant's name, or an own variant, or data in a file."""
        self.reference = self.data = None
        if not block.is_block("reference"):
            self.reference = block.word("reference", None,
                                        tuple(self.variants))
            return
        inner = block.block("reference")
        if inner.has("file"):
            self.data = Block.read(self.case / inner.word("file"))
            inner.refuse_others()
            return
        self.reference = REFERENCE
        own = named_variant(self.knobs, REFERENCE, inner)
        self.variants = {REFERENCE: own, **self.variants}

    def _read_replicas(self, block):
        """How many; what makes them differ. One needs no seed."""
        self.replicas, self.seeds, self.paired = 1, None, False
        if not block.has("replicas"):
            return
        if not block.is_block("replicas"):
            self.replicas = block.count("replicas")
            if self.replicas > 1:
                block.fail("replicas", f"is {self.replicas}, but nothing makes"
                           " them differ", (), "write { number"
                           f" {self.replicas}; file system/fillParcelsDict;"
                           " entry seed; } in its place")
            return
        inner = block.block("replicas")
        self.replicas = inner.count("number")
        self.paired = inner.switch("paired", False)
        self.seeds = Knob("seed", SeedBlock(inner, self.replicas))

    # What follows

    @cached_property
    def files(self):
        """Contents of the case's inputs by their names; those of 0.orig are
        the start of a run."""
        start = "0.orig" if (self.case / "0.orig").exists() else "0"
        found = {}
        for top in (start, "constant", "system", *self.copied):
            place = self.case / top
            for path in sorted(place.rglob("*")) or [place]:
                name = str(path.relative_to(self.case))
                if path.is_file() and not name.startswith("system/studyDict"):
                    found[re.sub(r"^0\.orig/", "0/", name)] = path.read_bytes()
        if CONTROL not in found:
            raise StudyError(
                self.case, None, f"is no case: it has no {CONTROL}", (),
                "name one by -case")
        return found

    def settings(self, variant, replica):
        """Those of a run."""
        seed = [] if self.seeds is None else self.seeds.values[str(replica)]
        return self.variants[variant].settings + seed

    def pairs(self):
        """(variant, replica) of all runs in the order in which they are made:
        the reference first, then one replica of all, so that a study which
        pauses can be looked at."""
        names = sorted(self.variants, key=lambda name: name != self.reference)
        return [(name, replica) for replica, name in
                itertools.product(range(1, self.replicas + 1), names)]

    def varied(self):
        """Names of the knobs in which variants differ."""
        return [k.name for k in self.knobs if len(
            {v.labels[k.name] for v in self.variants.values()}) > 1]

    def describe(self, name):
        return self.variants[name].describe(self.varied()) or name

    def others(self):
        """All but the reference."""
        return [name for name in self.variants if name != self.reference]


class SeedBlock(Block):
    """The dictionary replicas as that of a knob with the values 1 2 ... n."""

    def __init__(self, block, n):
        super().__init__(block.text, block.file, block.entries, block.path)
        self.n = n
        self.asked = block.asked

    def is_block(self, name):
        return name != "values" and super().is_block(name)

    def raw(self, name):
        if name == "values":
            return "(" + " ".join(str(i + 1) for i in range(self.n)) + ")"
        return super().raw(name)

    def word(self, name, default=None, choices=()):
        return "1" if name == "default" else super().word(
            name, default, choices)

# ------------------------------------------------------------------------------
# cghsFoam: coarse-grained hard-sphere fluidised beds for OpenFOAM
# Licence: GPL-3.0-or-later, see the file LICENSE
#
# Description
#     What a study varies. A knob has values; each value sets entries of files
#     of the case. A variant is a value of each knob.
# ------------------------------------------------------------------------------
"""Knobs and the variants that they make."""

import itertools
import re
from dataclasses import dataclass

from study.dictionary import tokens


@dataclass
class Setting:
    """A value of an entry, and what in studyDict asks for it."""
    file: str
    entry: str
    value: str
    why: tuple


class Knob:
    """Values by their labels: lists of settings. One that sets entries to the
    value itself takes values beyond those that are listed, too."""

    def __init__(self, name, block):
        self.name, self.block = name, block
        self.targets = self._read_targets(block)
        self.values = (self._named_values(block.block("values"))
                       if block.is_block("values") else self._plain_values())
        self.default = block.word("default", next(iter(self.values)),
                                  tuple(self.values))
        block.refuse_others()

    def _read_targets(self, block):
        """(file, entry) that take the value itself, if the knob has such."""
        if block.is_block("values"):
            return []
        return [(block.word("file"), entry) for entry in block.words("entry")]

    def _plain_values(self):
        return {label: self.settings_of(label, self.block, "values")
                for label in self._elements(self.block.raw("values"))}

    def _elements(self, raw):
        """Of a list, brackets within it as they are: ((1 1 1) (2 2 2))."""
        words = re.findall(r'\([^()]*\)|"[^"]*"|[^\s()"]+', raw.strip()[1:-1])
        if not raw.startswith("(") or not words:
            self.block.fail("values", f"is {raw!r}, and should be a list"
                            " (1 8 27), or a dictionary of values with names")
        return words

    def settings_of(self, value, block, name):
        """Those that a value makes, which the entry of a block asks for."""
        return [Setting(file, entry, value, block.why(name))
                for file, entry in self.targets]

    @staticmethod
    def _named_values(block):
        values = {}
        for label in block.keys():
            files, values[label] = block.block(label), []
            for file in files.keys():
                entries = files.block(file)
                values[label] += [
                    Setting(file, entry, entries.raw(entry),
                            entries.why(entry))
                    for entry in entries.keys()]
        return values

    def settings(self, label, block):
        """Of a value that the dictionary block of a variant gives."""
        if label in self.values:
            return self.values[label]
        if not self.targets:
            block.fail(self.name, f"is {label!r}", tuple(self.values))
        return self.settings_of(label, block, self.name)


@dataclass
class Variant:
    """Labels by knob, and what to set in the case."""
    name: str
    labels: dict
    settings: list

    def describe(self, knobs):
        """'W = 8, step = 1e-4', of those knobs that make a difference."""
        return ", ".join(f"{k} = {plain(self.labels[k])}" for k in knobs)


def plain(label):
    """A value as it is read in a sentence."""
    return " ".join(tokens(label)).replace("( ", "(").replace(" )", ")")


def folder_name(text):
    """Of what may be in a value only what may be in the name of a folder."""
    return re.sub(r"[^\w.+-]+", "-", text).strip("-")


def make_variant(knobs, name, chosen=None, block=None):
    """With the default of each knob that is not chosen."""
    labels = {k.name: (chosen or {}).get(k.name, k.default) for k in knobs}
    settings = [s for k in knobs for s in k.settings(labels[k.name], block)]
    return Variant(name, labels, settings)


def one_by_one(knobs):
    """The defaults, and each other value of each knob by itself."""
    yield make_variant(knobs, "default")
    for knob in knobs:
        for label in knob.values:
            if label != knob.default:
                yield make_variant(knobs, folder_name(f"{knob.name}-{label}"),
                                   {knob.name: label})


def all_of(knobs):
    for labels in itertools.product(*(k.values for k in knobs)):
        chosen = dict(zip((k.name for k in knobs), labels))
        yield make_variant(knobs, "_".join(
            folder_name(f"{k}-{v}") for k, v in chosen.items()), chosen)


def by_hand(knobs, block):
    """A dictionary of variants by name, with those knobs that are not as by
    default."""
    for name in block.keys():
        if folder_name(name) != name:
            block.fail(name, "is no name of a folder", (),
                       "use letters, digits, - _ . and +")
        yield named_variant(knobs, name, block.block(name))


def named_variant(knobs, name, block):
    """From a dictionary of knobs."""
    known = {knob.name for knob in knobs}
    for key in block.keys():
        if key not in known:
            block.fail(key, "there is no such knob", sorted(known))
    chosen = {key: block.raw(key).strip('"') for key in block.keys()}
    return make_variant(knobs, name, chosen, block)

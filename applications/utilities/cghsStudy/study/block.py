# ------------------------------------------------------------------------------
# cghsFoam: coarse-grained hard-sphere fluidised beds for OpenFOAM
# Licence: GPL-3.0-or-later, see the file LICENSE
#
# Description
#     A dictionary of studyDict with its place, so that whatever is wrong with
#     an entry can be said with file, entry, value and choices. What nothing has
#     asked for is refused at the end: a misspelt entry would be a default.
# ------------------------------------------------------------------------------
"""Reading entries of studyDict by their kind."""

import re

from study.dictionary import scan, tokens
from study.studyError import StudyError

NUMBER = re.compile(r"[-+]?(?:\d+\.?\d*|\.\d+)(?:[eE][-+]?\d+)?")


class Block:
    """A dictionary in a file."""

    def __init__(self, text, file, entries, path=""):
        self.text, self.file = text, file
        self.entries, self.path = entries, path
        self.asked = {"FoamFile"}

    @classmethod
    def read(cls, path):
        try:
            text = path.read_text()
        except OSError as error:
            raise StudyError(path, None, error.strerror, (),
                             "write one, or name it by -dict") from None
        for line, content in enumerate(text.splitlines(), 1):
            if re.match(r"\s*(#include|\$)", content):
                raise StudyError(f"{path}, line {line}", None,
                                 "what stands elsewhere is not read", (),
                                 "write the entries themselves")
        return cls(text, path, scan(text, path))

    # Refusals

    def place(self, name):
        return f"{self.path}/{name}" if self.path else name

    def fail(self, name, what, choices=(), remedy=None):
        raise StudyError(self.file, self.place(name), what, choices, remedy)

    def why(self, name):
        """What to blame where the case does not have what an entry names."""
        return self.file, self.place(name)

    def refuse_others(self):
        """To be called when all entries have been asked for."""
        for name in self.entries:
            if name not in self.asked:
                self.fail(name, "there is no such entry",
                          sorted(self.asked - {"FoamFile"}),
                          "correct its name or remove it")

    # Entries of a kind

    def has(self, name):
        self.asked.add(name)
        return name in self.entries

    def keys(self):
        """All, where they are names that the user gives."""
        self.asked.update(self.entries)
        return list(self.entries)

    def is_block(self, name):
        return self.has(name) and self.entries[name].inner is not None

    def raw(self, name):
        if not self.has(name):
            self.fail(name, "is missing", (), "add it")
        entry = self.entries[name]
        return self.text[entry.start:entry.end]

    def block(self, name):
        raw = self.raw(name)
        if not self.is_block(name):
            self.fail(name, f"is {raw!r}, and should be a dictionary")
        return Block(self.text, self.file, self.entries[name].inner,
                     self.place(name))

    def word(self, name, default=None, choices=()):
        if not self.has(name) and default is not None:
            return default
        raw = self.raw(name)
        words = tokens(raw)
        if len(words) != 1 or self.is_block(name):
            self.fail(name, f"is {raw!r}, and should be one word or string",
                      choices)
        if choices and words[0] not in choices:
            self.fail(name, f"is {words[0]!r}", choices)
        return words[0]

    def number(self, name, default=None, above=None):
        if not self.has(name) and default is not None:
            return default
        word = self.word(name)
        if not NUMBER.fullmatch(word):
            self.fail(name, f"is {word!r}, and should be a number")
        if above is not None and not float(word) > above:
            self.fail(name, f"is {word}, and should be above {above:g}")
        return float(word)

    def count(self, name, default=None):
        number = self.number(name, default, 0)
        if number != int(number):
            self.fail(name, f"is {number:g}, and should be 1, 2, 3 ...")
        return int(number)

    def switch(self, name, default):
        return self.word(name, "yes" if default else "no",
                         ("yes", "no")) == "yes"

    def words(self, name, default=None):
        """Of a list in brackets, or of one word alone."""
        if not self.has(name) and default is not None:
            return default
        raw = self.raw(name)
        words = tokens(raw)
        if words[:1] == ["("] and words[-1] == ")":
            words = words[1:-1]
        if not words or set(words) & set("(){};"):
            self.fail(name, f"is {raw!r}, and should be a list (a b c)")
        return words

    def numbers(self, name, default=None, n=None):
        if not self.has(name) and default is not None:
            return default
        words = self.words(name)
        for word in words:
            if not NUMBER.fullmatch(word):
                self.fail(name, f"has {word!r}, which is no number")
        if n is not None and len(words) != n:
            self.fail(name, f"has {len(words)} numbers in place of {n}")
        return [float(word) for word in words]

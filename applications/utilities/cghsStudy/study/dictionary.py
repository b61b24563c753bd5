# ------------------------------------------------------------------------------
# cghsFoam: coarse-grained hard-sphere fluidised beds for OpenFOAM
# Licence: GPL-3.0-or-later, see the file LICENSE
#
# Description
#     Dictionaries as text with places. Of a file it finds where each entry's
#     value begins and ends, so that a variant's copy of a case differs from the
#     case in that value and in nothing else.
#
#     foamDictionary -set is not used for that: it writes all numbers of the
#     file anew, to six digits, and evaluates $ and # of the whole file, so that
#     what the case computes from a knob would keep the value before. For the
#     same reason studyDict is read with this, too: values such as #calc "8*$W"
#     go to the case as they are, and numbers with all their digits.
# ------------------------------------------------------------------------------
"""Finding and setting entries in the text of OpenFOAM's dictionaries."""

import re

from study.studyError import StudyError

TOKEN = re.compile(
    r"""(?P<skip>\s+|//[^\n]*|/\*.*?\*/)
      | (?P<verbatim>\#\{.*?\#\})
      | (?P<string>"(?:\\.|[^"\\])*")
      | (?P<mark>[{}();])
      | (?P<word>[^\s{}();"]+)""", re.X | re.S)

# Directives that stand in place of an entry end with their line
DIRECTIVE = re.compile(r"#(?!\{)[^\n]*")


class Entry:
    """One entry: text[start:end] is its value, with braces if it is a
    dictionary, whose entries are then in inner."""

    def __init__(self, start, end, inner=None):
        self.start, self.end, self.inner = start, end, inner


class Scanner:
    """Goes through a text, token by token."""

    def __init__(self, text, file):
        self.text, self.file, self.at = text, file, 0

    def fail(self, what, at=None):
        line = self.text.count("\n", 0, self.at if at is None else at) + 1
        raise StudyError(f"{self.file}, line {line}", None, what)

    def peek(self):
        """The next token, or none at the end."""
        while self.at < len(self.text):
            token = TOKEN.match(self.text, self.at)
            if not token:
                self.fail("a string that begins here has no end")
            if token.lastgroup != "skip":
                return token
            self.at = token.end()
        return None

    def word(self, token):
        """The end of a word: brackets that touch it are part of it."""
        end = token.end()
        while self.text[end:end + 1] == "(":
            depth = 0
            while end < len(self.text):
                depth += {"(": 1, ")": -1}.get(self.text[end], 0)
                end += 1
                if depth == 0:
                    break
            rest = re.compile(r'[^\s{}();"]*').match(self.text, end)
            end = rest.end()
        return end

    def entries(self, closing):
        """Those of a dictionary up to its closing brace or to the end."""
        found = {}
        while True:
            token = self.peek()
            if token is None:
                if closing:
                    self.fail("a } is missing at the end")
                return found
            if token[0] == "}" and closing:
                return found
            if token[0].startswith("#"):
                self.at = DIRECTIVE.match(self.text, self.at).end()
            elif token[0] == ";":
                self.at = token.end()
            elif token.lastgroup == "mark":
                self.fail(f"a keyword should be here in place of {token[0]}")
            else:
                key = self._key(token)
                found[key] = self._merged(found.get(key), self._entry(key))

    def _key(self, token):
        self.at = (token.end() if token.lastgroup == "string"
                   else self.word(token))
        return self.text[token.start():self.at].strip('"')

    @staticmethod
    def _merged(old, new):
        """OpenFOAM adds up dictionaries of one name; of values the last
        stands."""
        if old and old.inner is not None and new.inner is not None:
            new.inner = {**old.inner, **new.inner}
        return new

    def _entry(self, key):
        token = self.peek()
        if token and token[0] == "{":
            start, self.at = token.start(), token.end()
            inner = self.entries(closing=True)
            self.at = self.peek().end()
            return Entry(start, self.at, inner)
        return self._value(key)

    def _value(self, key):
        depth, begin, start, end = 0, self.at, None, self.at
        while True:
            token = self.peek()
            if token is None or (token[0] == "}" and depth == 0):
                self.fail(f"the entry {key} has no ; at its end", begin)
            if token[0] == ";" and depth == 0:
                self.at = token.end()
                return Entry(end if start is None else start, end)
            depth += {"(": 1, "{": 1, ")": -1, "}": -1}.get(token[0], 0)
            start = token.start() if start is None else start
            self.at = end = token.end()


def tokens(text):
    """The words of a value, without quotes."""
    scanner, found = Scanner(text, "a value"), []
    while token := scanner.peek():
        scanner.at = (scanner.word(token) if token.lastgroup == "word"
                      else token.end())
        found.append(text[token.start():scanner.at].strip('"'))
    return found


def scan(text, file):
    """The entries of a dictionary's text by their keywords."""
    return Scanner(text, file).entries(closing=False)


def find(text, file, path, why):
    """The entry of a path such as solution/maxDeltaT; why: what asks for it."""
    inner, so_far = scan(text, file), []
    for key in path.split("/"):
        if inner is None or key not in inner:
            place = "/".join(so_far)
            raise StudyError(
                *why, f"{file} has no entry {'/'.join([*so_far, key])}",
                sorted(k for k in inner or () if k != "FoamFile"),
                f"give the case's {file}{' in ' + place if place else ''} the"
                " entry, with the value of the default")
        entry = inner[key]
        inner = entry.inner
        so_far.append(key)
    return entry


def set_entry(text, file, path, value, why):
    """The text with another value of an entry; a dictionary takes the place of
    the whole one."""
    entry = find(text, file, path, why)
    is_dictionary = value.startswith("{")
    if is_dictionary != (entry.inner is not None):
        raise StudyError(
            *why, f"{file}, {path} is {'no' if is_dictionary else 'a'}"
            f" dictionary, and is to become {value!r}", (),
            "name an entry in it, or give a value of the same kind")
    return text[:entry.start] + value + text[entry.end:]

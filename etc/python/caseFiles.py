# ------------------------------------------------------------------------------
# cghsFoam: coarse-grained hard-sphere fluidised beds for OpenFOAM
# Licence: GPL-3.0-or-later, see the file LICENSE
#
# Description
#     Reads what a case has written, in ASCII format: for the tests, for the
#     tutorials' pages of results and for cghsStudy.
#
#         U = cloud_field(".", times(".")[-1], "parcels", "U")
# ------------------------------------------------------------------------------
"""Reading OpenFOAM's ASCII files with numpy."""

import gzip
import re
from pathlib import Path

import numpy as np

NUMBER = r"[-+]?(?:\d+\.?\d*|\.\d+|nan|inf)(?:[eE][-+]?\d+)?"


# Times and folders


def times(case="."):
    """Names of the case's times, in order, of all ranks if decomposed."""
    folders = [Path(case), *Path(case).glob("processor[0-9]*")]
    names = {
        entry.name
        for folder in folders
        for entry in folder.iterdir()
        if entry.is_dir() and re.fullmatch(NUMBER, entry.name)
    }
    return sorted(names, key=float)


def _folders(case, time):
    """The folder of the time, or those of the ranks if not reconstructed."""
    whole = Path(case) / str(time)
    if whole.is_dir():
        return [whole]
    ranks = sorted(
        Path(case).glob(f"processor[0-9]*/{time}"),
        key=lambda path: int(path.parent.name[len("processor"):]),
    )
    if not ranks:
        raise FileNotFoundError(f"{case} has no time {time}: {times(case)}")
    return ranks


def read(path):
    """Text of a file, packed or not, without comments and FoamFile header."""
    packed = path.with_name(path.name + ".gz")
    if path.exists():
        data = path.read_bytes()
    elif packed.exists():
        data = gzip.decompress(packed.read_bytes())
    else:
        raise FileNotFoundError(path)

    header = re.search(rb"FoamFile\s*\{(.*?)\}", data, re.S)
    lists = b"nonuniform" in data or "lagrangian" in path.parts
    if lists and header and re.search(rb"format\s+binary", header[1]):
        raise ValueError(f"{path} is binary: write it in ASCII")
    text = data[header.end():] if header else data
    return re.sub(r"//[^\n]*|/\*.*?\*/", "", text.decode(), flags=re.S)


# Lists


def _numbers(text):
    return np.array(text.replace("(", " ").replace(")", " ").split(), float)


def _shaped(values, n, text):
    """One row an element, unless the elements are single numbers."""
    columns = text.count("(") and values.size // max(n, 1)
    return values.reshape(n, columns) if columns else values


def read_list(text):
    """The list that the text begins with: 'N (a b c)' or 'N {a}'."""
    match = re.match(r"\s*(?:List<\w+>)?\s*(\d+)?\s*([({])", text)
    if not match:
        raise ValueError(f"no list of numbers: {text[:60]!r}")

    if match[2] == "{":
        n = int(match[1])
        value = text[match.end():text.index("}", match.end())]
        return _shaped(np.tile(_numbers(value), n), n, value)

    inner = text[match.end():_closing(text, match.end())]
    rows = inner.count("(")
    values = _numbers(inner)
    n = int(match[1]) if match[1] else rows or values.size
    return _shaped(values, n, inner)


def _closing(text, start):
    """Where the bracket that opened before start is closed."""
    depth = 1
    for bracket in re.compile(r"[()]").finditer(text, start):
        depth += 1 if bracket[0] == "(" else -1
        if depth == 0:
            return bracket.start()
    raise ValueError("unclosed bracket: the file is incomplete")


def _entry(text, name):
    """What 'name uniform ...;' or 'name nonuniform ...;' holds."""
    match = re.search(rf"\b{name}\s+(uniform|nonuniform)\s+", text)
    if not match:
        raise KeyError(name)
    if match[1] == "nonuniform":
        return read_list(text[match.end():])
    values = _numbers(text[match.end():text.index(";", match.end())])
    return values if values.size > 1 else values[0]


# Fields of the mesh


def _on_rank(folder, name):
    """Values of a rank's cells, whose number is a note in a file of its
    mesh."""
    text = read(folder / name)
    values = _entry(text, "internalField")
    if not re.search(r"\binternalField\s+uniform\b", text):
        return values
    owner = (folder.parent / "constant/polyMesh/owner").read_bytes()
    n = int(re.search(rb"nCells:\s*(\d+)", owner)[1])
    return np.broadcast_to(values, (n, *np.shape(values)))


def field(case, time, name):
    """Cell values of a field, or the one value of a uniform field."""
    folders = _folders(case, time)
    if len(folders) == 1:
        return _entry(read(folders[0] / name), "internalField")
    return np.concatenate([_on_rank(folder, name) for folder in folders])


def patch_field(case, time, name, patch):
    """Face values of a field on a patch (reconstructed cases only)."""
    text = read(_folders(case, time)[0] / name)
    boundary = text[text.index("boundaryField"):]
    match = re.search(rf"\b{patch}\s*\{{(.*?)\n\s*\}}", boundary, re.S)
    if not match:
        raise KeyError(f"{name} has no patch {patch}")
    return _entry(match[1], "value")


# Fields of a cloud


def cloud_field(case, time, cloud, name):
    """Values of a cloud's field, one row a parcel, rank after rank."""
    parts = [
        read_list(read(folder / "lagrangian" / cloud / name))
        for folder in _folders(case, time)
        if has(folder / "lagrangian" / cloud / name)
    ]
    if not parts:
        raise FileNotFoundError(f"{case}/{time}/lagrangian/{cloud}/{name}")
    return np.concatenate([part for part in parts if part.size] or parts[:1])


def has(path):
    return path.exists() or path.with_name(path.name + ".gz").exists()


def positions(case, time, cloud):
    """Cartesian positions of a cloud's parcels."""
    parts = []
    for folder in _folders(case, time):
        path = folder / "lagrangian" / cloud / "positions"
        if has(path):
            rows = re.findall(
                rf"\(\s*({NUMBER})\s+({NUMBER})\s+({NUMBER})\s*\)",
                read(path),
            )
            parts.append(np.array(rows, float).reshape(-1, 3))
    if not parts:
        raise FileNotFoundError(f"{case}/{time}/lagrangian/{cloud}/positions")
    return np.concatenate(parts)


def cloud_by_id(case, time, cloud, *names):
    """The named fields, all sorted by (origProcId, origId), so that two runs
    can be compared parcel by parcel; 'positions' is a name too."""
    identity = [
        cloud_field(case, time, cloud, name)
        for name in ("origId", "origProcId")
    ]
    order = np.lexsort(identity)
    read = {
        name: positions(case, time, cloud)
        if name == "positions"
        else cloud_field(case, time, cloud, name)
        for name in names
    }
    return {name: values[order] for name, values in read.items()}


# Logs


def log_values(path, text):
    """All numbers that follow the text in a log, one a line with it."""
    pattern = rf"{text}[ =:]*({NUMBER})"
    return np.array(re.findall(pattern, Path(path).read_text()), float)


def table(path):
    """Numbers of a function object's table, one row a time; vectors count as
    three columns. A last row that an interrupted run left unfinished is not
    read."""
    rows = [
        _numbers(line)
        for line in Path(path).read_text().splitlines()
        if line.strip() and not line.lstrip().startswith("#")
    ]
    if len(rows) > 1 and len(rows[-1]) < len(rows[0]):
        rows.pop()
    return np.array(rows)


def columns(path):
    """The columns of such a table by the names over them."""
    head = [line for line in Path(path).read_text().splitlines()
            if line.lstrip().startswith("#")][-1]
    names = head.strip(" #").split()
    return dict(zip(names, table(path).reshape(-1, len(names)).T))


def joined(paths):
    """The tables that one function object has written in the starts of a run,
    the earliest first, as one: what came later stands. No rows before there
    are any."""
    rows = np.empty((0, 0))
    for path in paths:
        new = table(path)
        if not new.size:
            continue
        old = rows[rows[:, 0] < new[0, 0]] if rows.size else new[:0]
        rows = np.vstack([old, new])
    return rows

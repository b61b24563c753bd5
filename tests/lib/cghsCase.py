# ------------------------------------------------------------------------------
# cghsFoam: coarse-grained hard-sphere fluidised beds for OpenFOAM
# Licence: GPL-3.0-or-later, see the file LICENSE
#
# Description
#     Small cases made from tests/cases/common, for the run scripts of tests
#     that are written in python:
#
#         #!/usr/bin/python3
#         import os, sys
#         sys.path.append(os.environ["PROJECT_DIR"] + "/tests/lib")
#         import cghsTest as of
#         from cghsCase import Case
#
#         case = Case("fall", cells=(1, 1, 1), endTime=0.1)
#         case.parcels([[0.5, 0.9, 0.5]])
#         case.solve()
#         of.result("speed", abs(case.U()[0, 1] + 0.981), 1e-12)
#
#     What can be varied, and the values it has otherwise, are in
#     tests/cases/common/case/parameters.
# ------------------------------------------------------------------------------
"""OpenFOAM cases by a few parameters."""

import os
import shutil
import subprocess
import sys
from pathlib import Path

import numpy as np

import cghsTest as of

PROJECT = Path(os.environ["PROJECT_DIR"])
COMMON = PROJECT / "tests/cases/common"
CLOUD = "parcels"

_HEADER = """FoamFile
{{
    version     2.0;
    format      ascii;
    class       {cls};
    object      {name};
}}

"""


def foam(value):
    """A python value as OpenFOAM writes it: (1, 2, 3) is '(1 2 3)'."""
    if isinstance(value, str):
        return value
    if isinstance(value, (bool, np.bool_)):
        return "true" if value else "false"
    if np.ndim(value) == 0:
        return repr(value) if isinstance(value, int) else f"{value:.17g}"
    return "(" + " ".join(foam(v) for v in value) + ")"


def ideal_gas(rho, mu, T=300, molWeight=28.96):
    """Parameters of an isothermal gas that has this density and viscosity."""
    return {"fluid": "gas", "T": T, "molWeight": molWeight,
            "p": rho*8314.46/molWeight*T, "muGas": mu}


def lattice(*numbers):
    """So many points along each axis, in the middle of as many equal parts of
    a box of side 1."""
    axes = [(np.arange(n) + 0.5)/n for n in numbers]
    return np.stack(np.meshgrid(*axes, indexing="ij"), -1).reshape(-1, 3)


def environment(folder):
    """OpenFOAM takes the current folder from PWD."""
    return {**os.environ, "PWD": str(Path(folder).resolve())}


def run(folder, *command):
    """Run a program in the folder, its output in log.<program>; when it fails
    show the last lines and stop the test."""
    program = next(word for word in command if not word[0].isdigit()
                   and word not in ("mpirun", "-np"))
    log = Path(folder) / f"log.{Path(program).name}"
    with open(log, "w") as output:
        status = subprocess.run(
            command, cwd=folder, stdin=subprocess.DEVNULL,
            env=environment(folder), stdout=output, stderr=subprocess.STDOUT,
            check=False,
        ).returncode
    if status != 0:
        print(f"{' '.join(command)} ended with status {status}, see {log}:")
        print("".join(log.read_text().splitlines(keepends=True)[-15:]))
        sys.exit(1)


class Case:
    """A case in a folder of its own below the current one."""

    def __init__(self, folder, overlay=None, mesh=True, **parameters):
        """overlay: a further folder of tests/cases/common, or a path, whose
        files are laid over the common ones."""
        self.folder = Path(folder)
        shutil.rmtree(self.folder, ignore_errors=True)
        shutil.copytree(COMMON / "case", self.folder)
        if overlay:
            shutil.copytree(COMMON / overlay, self.folder, dirs_exist_ok=True)
        (self.folder / "changes").touch()
        self.cells = parameters.get("cells", (10, 10, 10))
        self.set(**parameters)
        if mesh:
            self.run("blockMesh")

    def set(self, **parameters):
        """Change parameters of tests/cases/common/case/parameters."""
        with open(self.folder / "changes", "a") as file:
            for name, value in parameters.items():
                file.write(f"{name:<19} {foam(value)};\n")

    def append(self, path, text):
        """Add to a file of the case; entries of dictionaries merge."""
        with open(self.folder / path, "a") as file:
            file.write(text + "\n")

    def patches(self, field, **patches):
        """Conditions of a field at patches, as text."""
        self.append(f"0/{field}", "boundaryField { " + " ".join(
            f"{name} {{ {text} }}" for name, text in patches.items()) + " }")

    def sources(self, **fields):
        """Sources everywhere of fields, per volume: (explicit, implicit)."""
        (self.folder/"constant/fvOptions").write_text(
            _HEADER.format(cls="dictionary", name="fvOptions") + "".join(
                f"{field}Source {{ type scalarSemiImplicitSource;"
                " selectionMode all; volumeMode specific;"
                f" injectionRateSuSp {{ {field} {foam(rate)}; }} }}\n"
                for field, rate in fields.items()))

    def run(self, *command):
        run(self.folder, *command)

    def expand(self):
        """OpenFOAM itself cannot read #include with collated files."""
        for path in sorted([*self.folder.glob("[c0s]*/*")]):
            if path.is_file() and "#include" in path.read_text():
                text = subprocess.run(
                    ["foamDictionary", "-expand", str(path)],
                    env=environment(self.folder), capture_output=True,
                    text=True, check=True).stdout
                path.write_text(text[text.index("FoamFile"):])

    # The parcels

    def fill(self, **parameters):
        """Fill with parcels at random."""
        self.set(**parameters)
        self.run("fillParcels")

    def parcels(self, x, U=(0, 0, 0), d=1e-3, rho=2500, W=1, omega=None,
                material=None, T=None):
        """Write parcels of given positions, velocities and so on to time 0;
        what is given once holds for all."""
        x = np.array(x, float).reshape(-1, 3)
        n = len(x)
        scalars = {"d": d, "rho": rho, "nParticle": W}
        vectors = {"position": x, "U": U}
        if T is not None:
            scalars["T"] = T
        if omega is not None:
            vectors["omega"] = omega

        self._positions(x)
        for name, value in scalars.items():
            self._field("scalar", name, np.broadcast_to(value, n))
        for name, value in vectors.items():
            self._field("vector", name, np.broadcast_to(value, (n, 3)))
        if material is not None:
            self._field("label", "typeId", material)
        self._field("label", "origId", range(n))
        self._field("label", "origProcId", [0]*n)

    def temperatures(self, T):
        """Give temperatures to the parcels that are there."""
        self._field("scalar", "T", T)

    def _cloud_file(self, name):
        path = self.folder / "0/lagrangian" / CLOUD / name
        path.parent.mkdir(parents=True, exist_ok=True)
        return path

    def _positions(self, x):
        # OpenFOAM is told that these are positions and not coordinates, and
        # looks for the cells itself where they are -1
        properties = self.folder / "0/uniform/lagrangian" / CLOUD
        properties.mkdir(parents=True, exist_ok=True)
        (properties / "cloudProperties").write_text(
            _HEADER.format(cls="dictionary", name="cloudProperties")
            + "geometry positions;\n"
        )
        self._cloud_file("positions").write_text(
            _HEADER.format(cls=f"Cloud<{CLOUD}>", name="positions")
            + f"{len(x)}\n(\n"
            + "".join(f"{foam(row)} -1\n" for row in x)
            + ")\n"
        )

    def _field(self, kind, name, values):
        self._cloud_file(name).write_text(
            _HEADER.format(cls=f"{kind}Field", name=name)
            + f"{len(values)}\n(\n"
            + "".join(f"{foam(value)}\n" for value in values)
            + ")\n"
        )

    # The run

    def solve(self, ranks=1):
        if ranks == 1:
            self.run("cghsFoam")
            return
        self.run("decomposePar", "-force")
        # It has written coordinates, but copied the note that says positions
        for folder in self.folder.glob("processor*/0/uniform"):
            folder.unlink()  # a link to that of the whole case
        self.run("mpirun", "-np", str(ranks), "cghsFoam", "-parallel")

    def go_on(self, until, ranks=1):
        """From the last time that was written."""
        self.set(startFrom="latestTime", endTime=until)
        self.solve(ranks)

    def refused(self, *texts, command=("cghsFoam",)):
        """The solver must refuse the case, with OpenFOAM's error: how many of
        the texts that one does not say, and one more if it is none."""
        done = subprocess.run(
            command, cwd=self.folder, env=environment(self.folder),
            stdin=subprocess.DEVNULL, capture_output=True, text=True,
            check=False)
        said = done.stdout + done.stderr
        (self.folder / "log.cghsFoam").write_text(said)
        missing = [text for text in ("FOAM FATAL", *texts) if text not in said]
        if missing or done.returncode == 0:
            print(f"{self.folder}: status {done.returncode}, not said: "
                  f"{missing}")
        return len(missing) + (done.returncode == 0)

    # What it wrote

    def last(self):
        return of.times(self.folder)[-1]

    def final(self, *names):
        """Fields of the parcels at the last time, in the order in which they
        were given: one array, or a list of several."""
        fields = of.cloud_by_id(self.folder, self.last(), CLOUD, *names)
        values = [fields[name] for name in names]
        return values[0] if len(values) == 1 else values

    def history(self, name):
        """A field at all times that were written: times, then one array a
        time in the order in which the parcels were given."""
        times = [t for t in of.times(self.folder) if float(t) > 0]
        return np.array(times, float), np.array([
            of.cloud_by_id(self.folder, t, CLOUD, name)[name] for t in times
        ])

    def table(self):
        """The table parcels.dat by the names of its columns."""
        return of.columns(
            self.folder / "postProcessing" / CLOUD / "0/parcels.dat")

    def indicators(self):
        """The table errorIndicators by the names of its columns."""
        return of.columns(
            self.folder / "postProcessing/errorIndicators/0" / f"{CLOUD}.dat")

    def by_height(self, name):
        """Mean of a field in each layer of cells, at the last time."""
        values = of.field(self.folder, self.last(), name)
        layers = values.reshape(*self.cells[::-1], -1)
        return layers.mean(axis=(0, 2)).squeeze()

    # Probes

    def probe(self, name, *points):
        """Write a field at these points in each step."""
        self.append("system/controlDict", f"""
functions
{{
    taps
    {{
        type            probes;
        libs            (sampling);
        fields          ({name});
        probeLocations  {foam(points)};
    }}
}}
""")

    def probed(self, name):
        """Times, and values at the points of probe, one column a point."""
        rows = of.table(self.folder / "postProcessing/taps/0" / name)
        return rows[:, 0], rows[:, 1:]

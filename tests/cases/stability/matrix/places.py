# ------------------------------------------------------------------------------
# cghsFoam: coarse-grained hard-sphere fluidised beds for OpenFOAM
# Licence: GPL-3.0-or-later, see the file LICENSE
#
# Description
#     Where parcels are, come in and cannot leave:
#
#     - on: on each point, and in the middle of each edge and face of cells of
#       cubes and of tetrahedra, those of the walls too. In a fluid that feels
#       them; those within fly straight on, none is lost, all of the volume
#       counts.
#     - wall: hard spheres whose centres are on a wall, an edge, a corner of the
#       box are put inside.
#     - bounce: parcels without contacts come back from walls, as fast, and a
#       plane of symmetry does as if their image was there.
#     - full: solids are fed into a bed that is full: what finds no room is
#       owed, and nothing is squeezed.
#     - blocked: what comes in cannot leave: a liquid is refused, with the
#       patch's name; the pressure of a gas rises as it must; a screen in the
#       outlet holds the bed that is blown against it.
#     - empty: no parcel, in a gas and in a liquid.
# ------------------------------------------------------------------------------
"""Places of the stability matrix."""

import itertools

import numpy as np

from cghsCase import Case, ideal_gas, lattice
import cghsTest as of
import meshes
from matrix import masses, refused, result, solve


def on(kind):
    """All places of a lattice of half cells: points, and middles of edges,
    faces and cells. Tetrahedra go along diagonals of the cubes."""
    name, n, side, v = f"on.{kind}", 3, 0.3, np.array([0.1, 0.07, -0.03])
    d, dt, steps = 1e-3, 0.01, 20
    mesh = dict(cells=(n, n, n)) if kind == "cubes" else dict(mesh=False)
    case = Case(name, x1=side, y1=side, z1=side, g=(0, 0, 0),
                coupling="twoWay", dragModel="none", contactModel="none",
                diameter=d, density=1e3, deltaT=dt, endTime=steps*dt, **mesh)
    if kind == "tetrahedra":
        meshes.pieces(case, (side,)*3, (n, n, n), meshes.TETS, shift=0)
    half = np.array(list(itertools.product(range(2*n + 1), repeat=3)))
    x = half*side/(2*n)
    case.parcels(x, U=v, d=d, rho=1e3)
    solve(name, case)
    X, U = case.final("position", "U")
    result(f"{name}.lost", abs(len(X) - len(x)), 0)
    result(f"{name}.outside", max(-X.min(), X.max() - side, 0), 1e-9)
    # Those that meet no wall; the fluid that they push aside moves them a bit
    end = x + v*steps*dt
    free = ((end > 0) & (end < side) & (x > 0) & (x < side)).all(axis=1)
    result(f"{name}.straight", abs(X - end)[free].max()/side, 1e-5)
    result(f"{name}.speed", abs(abs(U)/abs(v) - 1).max(), 1e-3)
    if kind == "cubes":
        alpha = of.field(name, case.last(), "alpha")
        volume = (1 - alpha).mean()*side**3
        result(f"{name}.volume", abs(volume/masses(case, "0").sum()*1e3 - 1),
               1e-9)


def wall():
    """At all 26 places of the box's walls, at rest, and on their way out."""
    d, side = 0.02, 0.3
    x = np.array([p for p in itertools.product((0, 0.5, 1), repeat=3)
                  if p != (0.5, 0.5, 0.5)])*side
    for speed in (0, 1):
        name = f"wall.v{speed}"
        case = Case(name, x1=side, y1=side, z1=side, cells=(3, 3, 3), e=1,
                    mu=0.1, g=(0, 0, 0), diameter=d, deltaT=1e-3, endTime=0.1)
        U = speed*(x - side/2)/(side/2)
        case.parcels(x, U=U, omega=(0, 0, 0), d=d)
        solve(name, case)
        X, V = case.final("position", "U")
        result(f"{name}.lost", abs(len(X) - len(x)), 0)
        beyond = d/2 - np.minimum(X, side - X).min()
        result(f"{name}.inside", max(beyond, 0)/d, 0.02)
        result(f"{name}.speed", max((V**2).sum(axis=1).max()
                                    - (U**2).sum(axis=1).max(), 0), 1e-12)


def bounce():
    for kind, deltaT in ("wall", 0.01), ("symmetryPlane", 0.01), ("wall", 9.5):
        name = f"bounce.{kind}.{deltaT:g}"
        end = max(1.5, deltaT)
        case = Case(name, cells=(4, 4, 4), typeX=kind, g=(0, 0, 0),
                    contactModel="none", deltaT=deltaT, maxDeltaT=deltaT,
                    endTime=end, writeInterval=end)
        x, U = np.array([[0.8, 0.3, 0.5], [0.5, 0.5, 0.5]]), \
            np.array([[0.5, 0.1, 0], [0.9, 0.7, -0.8]])
        case.parcels(x, U=U)
        solve(name, case)
        far = (x + end*U) % 2
        exact = np.where(far > 1, 2 - far, far)
        X, V = case.final("position", "U")
        result(f"{name}.place", abs(X - exact).max(), 1e-5)
        result(f"{name}.speed", abs(abs(V) - abs(U)).max(), 1e-12)


def full():
    """Air, a bed of 0.6 up to the top, and parcels to be fed in there."""
    d, side, rho, rate = 1e-3, 0.01, 2500.0, 5e-3
    n = int(0.6*side**3/(np.pi/6*d**3))
    case = Case("full", overlay="throughFlow", x1=side, y1=side, z1=side,
                cells=(4, 4, 4), typeY="patch", top="rebound", U=(0, 0.1, 0),
                coupling="twoWay", dragModel="Gidaspow", diameter=d, e=0.5,
                mu=0.1, density=rho, deltaT=2e-4, endTime=0.1)
    case.fill(fillNumber=n)
    case.append("constant/parcelsProperties", "feeding { inlet { shortage"
                " makeUp; feedPlace patch; patchCoeffs { patch yMax; speed 0.1;"
                f" }} massFlowRate {rate}; }} }}")
    solve("full", case)
    table = case.table()
    M = n*rho*np.pi/6*d**3
    result("full.balance", abs(table["mass"] - M - table["fedMass"]).max()/M,
           1e-12)
    result("full.owed", int(table["fedMass"][-1] > 0.5*rate*0.1), 0)
    result("full.overlap", table["maxOverlap"][-50:].max(), 0.03)
    result("full.outside", max(-case.final("position").min(), 0), 0)


def blocked():
    U = 0.1
    closed = dict(overlay="throughFlow", cells=(2, 4, 2), typeY="patch",
                  U=(0, U, 0), coupling="twoWay", contactModel="none",
                  deltaT=0.01, endTime=1, writeInterval=0.1)

    def shut(case):
        case.patches("U", yMax="type fixedValue; value uniform (0 0 0);")
        case.patches("p", yMax="type fixedFluxPressure;")
        case.parcels(lattice(2, 2, 2), d=1e-3)

    case = Case("blocked.liquid", rho=1000, nu=1e-6, **closed)
    shut(case)
    refused("blocked.liquid", case, "outflow")

    gas = ideal_gas(1.2, 1.8e-5)
    case = Case("blocked.gas", dragModel="WenYu", pTolerance=1e-12,
                **{**closed, **gas, "g": (0, 0, 0)})
    shut(case)
    solve("blocked.gas", case)
    p = of.field("blocked.gas", case.last(), "p")
    # By volume at the inlet, whose density rises with it: exponentially, with
    # the first order of the step
    result("blocked.gas.pressure", abs(p.mean()/gas["p"]/np.exp(U) - 1), 1e-3)
    result("blocked.gas.even", np.ptp(p)/gas["p"], 1e-3)

    d, side = 1e-3, 0.01
    case = Case("blocked.screen", overlay="throughFlow", x1=side, y1=2*side,
                z1=side, cells=(4, 8, 4), typeY="patch", top="rebound",
                U=(0, 3.0, 0), coupling="twoWay", dragModel="Gidaspow",
                diameter=d, density=250, e=0.5, mu=0.1, deltaT=1e-4,
                endTime=0.2)
    case.fill(fillNumber=300)
    solve("blocked.screen", case)
    table = case.table()
    result("blocked.screen.lost", abs(table["nParcels"] - 300).max(), 0)
    x = case.final("position")
    result("blocked.screen.beyond", max(x[:, 1].max() - 2*side, 0), 0)
    # All of them pressed to the screen, at 0.55 solids or more
    deep = 300*np.pi/6*d**3/side**2/0.55
    result("blocked.screen.centre", (2*side - x[:, 1].mean())/deep, 0.6)


def empty():
    for fluid in ("incompressible", "gas"):
        name = f"empty.{fluid}"
        case = Case(name, cells=(3, 3, 3), coupling="twoWay", fluid=fluid,
                    p=1e5 if fluid == "gas" else 0, deltaT=1e-3, endTime=0.01)
        case.parcels([])
        solve(name, case)
        result(f"{name}.voidage", abs(of.field(name, case.last(), "alpha")
                                      - 1).max(), 0)


def main():
    on("cubes")
    on("tetrahedra")
    wall()
    bounce()
    full()
    blocked()
    empty()


if __name__ == "__main__":
    main()

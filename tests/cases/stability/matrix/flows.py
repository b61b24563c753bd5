# ------------------------------------------------------------------------------
# cghsFoam: coarse-grained hard-sphere fluidised beds for OpenFOAM
# Licence: GPL-3.0-or-later, see the file LICENSE
#
# Description
#     Parcels and fluid that feel each other, at the ends of what can be given:
#
#     - drag: the fluid streams through parcels at rest, alike in all cells of a
#       box of periods, with steps of 1e-6 to 1e6 drag times, W of 1 to 1e9 and
#       densities of 1e-3 to 1e5 of the fluid's: slip and momentum against the
#       two equations, by hand.
#     - let go: light spheres in liquid with the mass that goes along, dense
#       ones in gas: g (rho_p - rho)/(rho_p + C rho).
#     - terminal: 20 times as large as its neighbour, the velocity of each.
#     - supersonic: a parcel enters gas at rest at 3000 m/s: it slows down as
#       the drag law says.
#     - dense: air through a bed of 0.7 solids, Ergun's pressure drop.
#     - wide: parcels of 3 cells; alone in the box, too.
#     - meshes: as much dust as fluid, by mass, flies about in fluid at rest, in
#       a closed box of all kinds of cells, with steps of up to 1e6 drag times:
#       the energy of both never rises, and the volume is all there.
# ------------------------------------------------------------------------------
"""Suspensions of the stability matrix."""

import numpy as np

from cghsCase import CLOUD, Case, ideal_gas, lattice
import cghsTest as of
import dragLaws
import meshes
from matrix import masses, momentum, result, solve

NU = 1.5e-5


def both(case, time):
    """Momentum of the fluid in the whole box [kg m/s], and of the parcels."""
    n = np.prod(case.cells)
    alpha, U = (of.field(case.folder, time, f) for f in ("alpha", "U"))
    U = np.broadcast_to(U, (n, 3))
    alpha = np.broadcast_to(alpha, n)
    fluid = case.volume/n*case.rho*(alpha[:, None]*U).sum(axis=0)
    return fluid, momentum(case, time)


PERIODIC = {f"type{axis}": "cyclic" for axis in "XYZ"}


def drag(share, ratio, W=1e9):
    """Steps of so many drag times. A parcel in each cell, which has as much
    mass as the fluid there, but a fifth of the volume at most."""
    name = f"drag.{ratio:g}.W{W:g}.dt{share:g}"
    d, slip, n, steps, rho = 1e-7, 1e-6, 4, 10, 1.2
    density, load = ratio*rho, min(1, 0.2*ratio)
    e = 1 - load/ratio
    side = n*np.cbrt(W*np.pi/6*d**3*ratio/load)
    K = dragLaws.rate("WenYu", slip, d, rho, rho*NU, density)
    dt = share/K
    case = Case(name, x1=side, y1=side, z1=side, cells=(n, n, n),
                g=(0, 0, 0), **PERIODIC, coupling="twoWay", rho=rho, nu=NU,
                U=(0, slip, 0), mappingModel="centroid", diameter=d,
                density=density, parcelWeight=W, contactModel="none",
                deltaT=dt, endTime=steps*dt, writeInterval=dt,
                pTolerance=1e-15)
    case.rho, case.volume = rho, side**3
    # A smoother needs as many sweeps as the step is longer than viscosity takes
    case.append("system/fvSolution", "solvers { U { solver PBiCGStab;"
                " preconditioner DILU; tolerance 1e-15; } }")
    case.parcels(lattice(n, n, n)*side, d=d, rho=density, W=W)
    solve(name, case)

    start = e*rho*case.volume*slip
    times = [t for t in of.times(case.folder) if float(t) > 0]
    sums = np.array([sum(both(case, t))[1] for t in times])
    result(f"{name}.momentum", abs(sums/start - 1).max(), 1e-9)
    fluid, dust = both(case, times[-1])
    found = 1 - fluid[1]/(e*rho*case.volume)/slip \
        + dust[1]/masses(case, "0").sum()/slip
    exact = -np.expm1(-steps*share*e**-2.65*(1 + load/e))
    # What is gone of the slip
    result(f"{name}.slip", abs(found/exact - 1), 1e-4)


def let_go(ratio, dt, C):
    """From rest, without drag."""
    name = f"letGo.{ratio:g}.dt{dt:g}"
    n, g = 10, 9.81
    fluid = dict(rho=1000, nu=1e-6) if C else dict(rho=0.1, nu=1e-4)
    case = Case(name, y1=400, cells=(1, 4, 1), coupling="oneWay",
                contactModel="none", dragModel="none", deltaT=dt,
                endTime=n*dt, writeInterval=dt, **fluid)
    if C:
        case.append("constant/parcelsProperties", "subModels { forces"
                    f" (addedMass); addedMassCoeffs {{ C {C};"
                    " crowding none; } }")
    case.parcels([[0.5, 200, 0.5]], rho=ratio*fluid["rho"])
    solve(name, case)
    v = case.history("U")[1][:, 0, 1]
    exact = g*(1 - ratio)/(ratio + C)*dt*np.arange(1, n + 1)
    result(f"{name}.speed", abs(v/exact - 1).max(), 1e-9)


def terminal():
    """Next to each other in air, 50 um and 1 mm."""
    rho, rho_p, dt = 1.2, 2500.0, 0.05
    d = np.array([5e-5, 1e-3])
    case = Case("terminal", x1=0.1, y1=1000, z1=0.1, cells=(1, 100, 1),
                coupling="twoWay", dragModel="WenYu", contactModel="none",
                rho=rho, nu=NU, deltaT=dt, endTime=10)
    case.parcels([[0.05, 900, 0.05], [0.06, 900, 0.05]], d=d, rho=rho_p)
    solve("sizes.terminal", case)
    v = -case.final("U")[:, 1]
    exact = [dragLaws.terminal_velocity("WenYu", x, rho, rho*NU, rho_p)
             for x in d]
    result("sizes.terminal.speed", abs(v/exact - 1).max(), 1e-3)


def supersonic():
    """Into air at rest. By small steps of dv/dt = -K v, to first order."""
    d, rho_p, v0, n, dt = 1e-3, 2500.0, 3000.0, 100, 2e-5
    gas = ideal_gas(1.2, 1.2*NU)
    case = Case("supersonic", x1=10, y1=0.5, z1=0.5, cells=(20, 1, 1),
                g=(0, 0, 0), coupling="twoWay", dragModel="WenYu", deltaT=dt,
                endTime=n*dt, writeInterval=20*dt, contactModel="none",
                diameter=d, density=rho_p, **gas)
    case.parcels([[0.25, 0.25, 0.25]], U=(v0, 0, 0), d=d, rho=rho_p)
    solve("supersonic", case)
    t, v = case.history("U")
    v = v[:, 0, 0]
    exact, small = [v0], 20
    for _ in range(n*small):
        K = dragLaws.rate("WenYu", exact[-1], d, 1.2, 1.2*NU, rho_p)
        exact.append(exact[-1]/(1 + K*dt/small))
    exact = np.array(exact)[np.round(t/dt*small).astype(int)]
    print(f"supersonic: {v[-1]:.1f} m/s, by hand {exact[-1]:.1f}")
    result("supersonic.speed", abs(v/exact - 1).max(), 2e-3)
    result("supersonic.gains", max(np.diff(np.append(v0, v)).max(), 0), 0)


def dense(solids=0.7):
    """In a lattice of unequal places, so heavy that nothing moves it."""
    d, n, U, rho = 1e-3, (4, 12, 4), 0.5, 1.2
    cell = d*np.cbrt(2*np.pi/6/solids)
    size = np.array(n)*cell
    case = Case("dense", overlay="throughFlow", x1=size[0], y1=size[1],
                z1=size[2], cells=n, typeX="cyclic", typeY="patch",
                typeZ="cyclic", top="escape", coupling="twoWay",
                dragModel="Gidaspow", mappingModel="centroid", rho=rho, nu=NU,
                U=(0, U, 0), g=(0, 0, 0), contactModel="none", diameter=d,
                density=1e9, deltaT=2e-5, endTime=4e-3, minVoidage=0.25,
                pTolerance=1e-9)
    x = np.concatenate([lattice(*n) + np.array(s)/n for s in (
        (-0.25, -0.25, -0.25), (0.25, 0.25, 0.25))])
    case.parcels(x*size, d=d, rho=1e9)
    solve("dense", case)
    e = of.field("dense", case.last(), "alpha")
    result("dense.voidage", abs(e/(1 - solids) - 1).max(), 1e-9)
    p = rho*case.by_height("p")
    e = 1 - solids
    exact = dragLaws.ergun(e, U/e, d, rho, rho*NU)*U/e**2
    result("dense.pressure",
           abs((p[2] - p[-3])/((n[1] - 5)*cell)/exact - 1), 1e-3)
    result("dense.fastest", abs(of.field("dense", case.last(), "U")).max()
           / (U/e) - 1, 1e-3)


def centroid(share, warns):
    """Parcels of that share of a cell, in water, by centroid."""
    d = 0.02*share
    name = f"wide.centroid.{share:g}"
    case = Case(name, x1=0.16, y1=0.32, z1=0.16, cells=(8, 16, 8),
                overlay="throughFlow", typeY="patch", top="escape",
                coupling="twoWay", rho=1000, nu=1e-6, diameter=d,
                density=2500, mappingModel="centroid", dragModel="Gidaspow",
                U=(0, 0.05, 0), deltaT=2e-3, endTime=4e-3)
    case.fill(fillNumber=50)
    solve(name, case)
    log = (case.folder/"log.cghsFoam").read_text()
    result(f"{name}.warned", abs(log.count("blow to the fluid") - warns), 0)


def alone():
    """One parcel of 3 cells rises in water in a closed box: it ends at the lid,
    and the water at rest."""
    d = 3e-3
    case = Case("wide.one", x1=0.012, y1=0.012, z1=0.012, cells=(12, 12, 12),
                coupling="twoWay", rho=1000, nu=1e-6, dragModel="Gidaspow",
                e=0.5, diameter=d, density=500, deltaT=4e-3, endTime=0.4,
                minVoidage=0.2)
    case.append("constant/parcelsProperties", "subModels { forces"
                " (addedMass); addedMassCoeffs { C 0.5; crowding none; } }")
    case.parcels([[0.0061, 0.004, 0.0062]], d=d, rho=500)
    solve("wide.one", case)
    x, v = case.final("position", "U")
    result("wide.one.place", abs(x[0, 1]/(0.012 - d/2) - 1), 0.01)
    result("wide.one.speed", abs(v).max(), 0.01)
    alpha = of.field("wide.one", case.last(), "alpha")
    result("wide.one.volume",
           abs((1 - alpha).mean()*0.012**3/(np.pi/6*d**3) - 1), 1e-9)


# ---- Meshes

SIDE = 0.04
CUBE = (SIDE, SIDE, SIDE)
MESHES = {
    "slender": (dict(x1=1, y1=0.01, z1=0.01, cells=(4, 4, 4)), None),
    "skewed": (dict(mesh=False), lambda case: meshes.pieces(
        case, CUBE, (4, 4, 4), meshes.HEXES, shift=0.25)),
    "tetrahedra": (dict(mesh=False), lambda case: meshes.pieces(
        case, CUBE, (3, 3, 3), meshes.TETS)),
    "polyhedra": (dict(mesh=False),
                  lambda case: meshes.polyhedra(case, CUBE, (3, 3, 3))),
    "flat": (dict(cells=(6, 6, 1), typeZ="empty"), None),
}


def dusty(mesh, mapping, share, ratio, W=None, **parameters):
    """As much dust as fluid by mass flies about in fluid at rest, in a closed
    box; steps of so many drag times."""
    name = f"mesh.{mesh}.{mapping}.{ratio:g}.dt{share:g}"
    more, change = MESHES[mesh]
    d, rho, n, v = 1e-5, 1.2, 200, 0.1
    size = np.array([more.get(f"{a}1", SIDE) for a in "xyz"])
    density = ratio*rho
    if W:
        d = np.cbrt(np.prod(size)/ratio/(n*np.pi/6*W))
    else:
        W = np.prod(size)/ratio/(n*np.pi/6*d**3)
    name += f".W{W:.1g}"
    dt = min(share/dragLaws.rate("WenYu", v, d, rho, rho*NU, density), 0.02)
    case = Case(name, **{**dict(
        x1=SIDE, y1=SIDE, z1=SIDE, g=(0, 0, 0), coupling="twoWay",
        dragModel="WenYu", contactModel="none", mappingModel=mapping,
        rho=rho, nu=NU, wallU="noSlip", diameter=d, density=density,
        parcelWeight=W, deltaT=dt, endTime=20*dt, writeInterval=2*dt,
        pTolerance=1e-12), **more, **parameters})
    if change:
        change(case)
    rng = np.random.default_rng(6)
    x, U = rng.uniform(0.1, 0.9, (n, 3))*size, rng.normal(size=(n, 3))*v
    if mesh == "flat":
        x[:, 2], U[:, 2] = SIDE/2, 0
    case.parcels(x, U=U, omega=0*U, d=d, rho=density, W=W)
    solve(name, case)
    case.run("postProcess", "-func", "writeCellVolumes", "-time", case.last())
    V = of.field(case.folder, case.last(), "V")

    def held(time):
        m = masses(case, time)
        v = of.cloud_by_id(case.folder, time, CLOUD, "U")["U"]
        fluid = 0
        if float(time) > 0:
            alpha, u = (of.field(case.folder, time, f) for f in ("alpha", "U"))
            fluid = 0.5*rho*(V*alpha*(u**2).sum(axis=1)).sum()
        return fluid + 0.5*(m*(v**2).sum(axis=1)).sum()

    E = np.array([held(t) for t in of.times(case.folder)])
    result(f"{name}.energy", max(np.diff(E).max()/E[0], 0), 1e-9)
    alpha, u = (of.field(case.folder, case.last(), f) for f in ("alpha", "U"))
    result(f"{name}.volume", abs((V*(1 - alpha)).sum()
                                 / (n*W*np.pi/6*d**3) - 1), 1e-9)
    result(f"{name}.lost", abs(len(case.final("d")) - n), 0)
    return E


def main():
    for ratio in (1e-3, 1e3, 1e5):
        for share in (1e-6, 1e6):
            drag(share, ratio)
    drag(1e-6, 1e3, W=1)
    let_go(1e-3, 1e-3, 0.5)
    let_go(1e5, 0.1, 0)
    terminal()
    supersonic()
    dense()
    centroid(0.75, 1)
    centroid(0.3, 0)
    alone()
    for mesh in MESHES:
        dusty(mesh, "diffusion", 1e6, 1e3)
    dusty("tetrahedra", "centroid", 1e6, 1e5)
    dusty("polyhedra", "centroid", 1, 1e3)
    dusty("flat", "diffusion", 1, 1e3, 1e9, contactModel="hardSphere", e=0,
          mu=10)


if __name__ == "__main__":
    main()

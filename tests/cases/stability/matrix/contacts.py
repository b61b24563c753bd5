# ------------------------------------------------------------------------------
# cghsFoam: coarse-grained hard-sphere fluidised beds for OpenFOAM
# Licence: GPL-3.0-or-later, see the file LICENSE
#
# Description
#     Contacts at the ends of what can be given, without a fluid:
#
#     - ends: e and e_t of 0 and 1, mu of 0 and 10: oblique impacts of spinning
#       parcels, W of 1 and 1e9, sizes 20:1, densities 1000:1, of each pair and
#       with a wall, against the law of impact. Momentum and angular momentum to
#       round-off, energy does not rise.
#     - crowd: so do a dense crowd's, sizes 3:1, in all of its steps.
#     - press: a bed under 1000 g comes to rest, in steps in which what rests
#       falls by 0.005 of a diameter. Where it falls by a half, that is said; no
#       parcel leaves the box.
#     - sizes: 20:1, the large ones dropped on a layer of the small.
#     - same: parcels at the same point part, without momentum; hard ones
#       without a speed, soft ones with no more than their springs had.
#     - rest: a bed at rest stays so, step after step.
# ------------------------------------------------------------------------------
"""Contacts of the stability matrix."""

import itertools

import numpy as np

from cghsCase import Case, lattice
import cghsTest as of
from matrix import energy, masses, momentum, result, solve, spins

ENDS = list(itertools.product((0, 1), (0, 1), (0, 10)))     # e, e_t, mu


def struck(x, v, w, r, m, e, et, mu):
    """Velocities and spins of two after their impact; of a wall r = 0 and m is
    infinite."""
    n = x[1] - x[0]
    n /= np.linalg.norm(n)
    share = 1/(1/m[0] + 1/m[1])
    at = v[1] - v[0] - np.cross(r[0]*w[0] + r[1]*w[1], n)
    vn = at @ n
    vt = at - vn*n
    slip = np.linalg.norm(vt)
    Jt = -min(2/7*share*(1 + et)*slip, mu*share*(1 + e)*abs(vn))*vt/slip
    P = -share*(1 + e)*vn*n + Jt
    spin = np.cross(n, Jt)
    # r/I, nothing for the wall
    lever = [2.5/(k*q) if q else 0 for k, q in zip(m, r)]
    return (np.array([v[0] - P/m[0], v[1] + P/m[1]]),
            np.array([w[0] - lever[0]*spin, w[1] - lever[1]*spin]))


def ends(e, et, mu, W):
    """Pairs that touch, in a row, and one at a wall."""
    name = f"ends.e{e}.et{et}.mu{mu}.W{W:g}"
    k = np.cbrt(W)
    rng = np.random.default_rng(4)
    # Wide and heavy of each pair over 0.01 and 1000
    wide = np.array([[1, 1], [1, 20], [1, 1], [20, 1]])
    heavy = np.array([[1, 1], [1, 1], [1, 1e3], [1e-3, 1]])
    r = 0.005*wide
    n = rng.normal(size=(len(r), 3))
    n /= np.linalg.norm(n, axis=1)[:, None]
    middle = lattice(len(r), 1, 1)*[4, 1, 1]
    near = 1 - 1e-9
    x = np.stack([middle - near*r[:, :1]*n, middle + near*r[:, 1:]*n], axis=1)
    # Towards each other, and along each other and turning
    v = rng.normal(size=x.shape)
    v -= (v*n[:, None]).sum(axis=2)[..., None]*n[:, None]
    v += np.array([1, -1])[:, None]*n[:, None]
    w = rng.normal(size=x.shape)/r[..., None]
    m = 4/3*np.pi*r**3*1000*heavy

    wall = np.array([[0.3, near*0.005, 0.1], [0.3, 0, 0.1]])
    fall, turn = np.array([0.7, -1, 0.3]), np.array([80.0, -50, 120])
    dt = 1e-10

    every = x.reshape(-1, 3), v.reshape(-1, 3), w.reshape(-1, 3)
    X, V, w0 = (np.vstack([a, b])
                for a, b in zip(every, (wall[:1], fall, turn)))
    d = np.append(2*r.ravel(), 0.01)/k
    rho = np.append(1000*heavy.ravel(), 1000)
    case = Case(name, x1=4, cells=(4, 1, 1), g=(0, 0, 0), e=e, et=et, mu=mu,
                deltaT=dt, endTime=dt)
    case.parcels(X, U=V, omega=w0, d=d, rho=rho, W=W)
    solve(name, case)

    pairs = [struck(*a, e, et, mu) for a in zip(x, v, w, r, m)]
    one = struck(wall, [fall, 0*fall], [turn, 0*turn], (0.005, 0),
                 (1, 1e300), e, et, mu)
    exact = [np.vstack([*(p[i] for p in pairs), one[i][:1]]) for i in (0, 1)]
    U, omega = case.final("U"), spins(case, case.last())
    radius = d[:, None]*k/2
    result(f"{name}.law", max(abs(U - exact[0]).max(),
                              (radius*abs(omega - exact[1])).max()), 1e-7)

    # Of the pairs
    last = slice(0, -1)
    M = masses(case, case.last())
    scale = (M[:, None]*abs(V)).sum()
    result(f"{name}.momentum",
           abs((M[:, None]*(U - V))[last].sum(axis=0)).max()/scale, 1e-14)
    spin = np.cross(X, U - V) + 0.4*radius**2*(omega - w0)
    result(f"{name}.angular",
           abs((M[:, None]*spin)[last].sum(axis=0)).max()/scale, 1e-9)
    before, after = energy(case, "0"), energy(case, case.last())
    gain = after/before - 1
    kept = e == 1 and (mu == 0 or et == 1)
    result(f"{name}.energy", abs(gain) if kept else max(gain, 0), 1e-12)


def crowd(e, et, mu, W=1, **parameters):
    """At 0.45 solids, nothing around it."""
    name = f"crowd.e{e}.et{et}.mu{mu}.W{W:g}"
    name += "".join(f".{k}" for k in parameters)
    side, steps, dt = 0.1, 100, 2e-4
    rng = np.random.default_rng(5)
    flat = parameters.get("typeZ") == "empty"
    points = lattice(8, 8, 1 if flat else 8)
    wide = np.where(np.arange(len(points)) % 2, 1, 0.33)
    d = side/8*np.cbrt(0.45*6/np.pi)*wide
    rest = dict(x1=side, y1=side, z1=side, cells=(4, 4, 1 if flat else 4),
                typeX="cyclic", typeY="cyclic", typeZ="cyclic", g=(0, 0, 0),
                e=e, et=et, mu=mu, deltaT=dt, endTime=steps*dt,
                writeInterval=dt)
    case = Case(name, **{**rest, **parameters})
    v, w = rng.normal(size=(2, len(points), 3))
    if flat:
        v[:, 2] = w[:, :2] = 0
    case.parcels(points*side, U=v, omega=w/d[:, None], d=d/np.cbrt(W), W=W)
    solve(name, case)
    times = of.times(case.folder)
    P = np.array([momentum(case, t) for t in times])
    scale = masses(case, "0").sum()
    result(f"{name}.momentum", abs(P - P[0]).max()/scale, 1e-13)
    E = np.array([energy(case, t) for t in times])
    result(f"{name}.energy", max(np.diff(E).max()/E[0], 0), 1e-12)
    gone = len(case.final("d")) - len(points)
    result(f"{name}.lost", abs(gone), 0)


def bed(name, n, side, **parameters):
    case = Case(name, x1=side, y1=2*side, z1=side, cells=(4, 8, 4), **{
        **dict(e=0.5, et=0.3, mu=0.3, diameter=1e-3), **parameters})
    case.fill(fillNumber=n)
    return case


def press(e, mu, share, steps):
    """Of 1 mm, under 1000 g; in a step a parcel at rest falls by that share."""
    name = f"press.e{e}.mu{mu}.{share:g}"
    g, d, n, side = 9810.0, 1e-3, 500, 0.008
    dt = np.sqrt(share*d/g)
    case = bed(name, n, side, g=(0, -g, 0), e=e, mu=mu, deltaT=dt,
               endTime=steps*dt, maxDisplacement=0.1)
    solve(name, case)
    warned = (case.folder/"log.cghsFoam").read_text().count("Gravity alone")
    result(f"{name}.warned", abs(warned - (share > 0.1)), 0)
    result(f"{name}.lost", abs(case.table()["nParcels"] - n).max(), 0)
    x = case.final("position")
    beyond = max(-x.min(), (x - [side, 2*side, side]).max(), 0)
    result(f"{name}.outside", beyond, 0)
    if share > 0.1:
        return
    table, last = case.table(), slice(-100, None)
    m = n*np.pi/6*d**3*2500
    speed = np.sqrt(2*table["kineticEnergy"][last].mean()/m)
    result(f"{name}.speed", speed/(g*dt), 1)
    result(f"{name}.overlap", table["maxOverlap"][last].max(), 0.05)
    result(f"{name}.creep", np.ptp(table["centreY"][last])/d, 0.05)


def sizes():
    """Two of 20 mm fall on 600 of 1 mm that lie in a box."""
    side, small, large, dt = 0.05, 1e-3, 0.02, 1e-4
    points = lattice(25, 1, 24)*[side, small, side]
    x = np.vstack([points, [[0.013, 0.02, 0.013], [0.037, 0.025, 0.036]]])
    d = np.append(np.full(len(points), small), [large, large])
    case = Case("sizes", x1=side, y1=side, z1=side, cells=(5, 5, 5), e=0.5,
                et=0.5, mu=0.1, deltaT=dt, endTime=0.6, diameter=small)
    case.parcels(x, omega=(0, 0, 0), d=d)
    solve("sizes", case)
    table, last = case.table(), slice(-200, None)
    fall = (masses(case, "0")*9.81*x[:, 1]).sum()
    result("sizes.energy", table["kineticEnergy"].max()/fall, 1)
    result("sizes.rest", table["kineticEnergy"][last].mean()/fall, 1e-4)
    result("sizes.lost", abs(table["nParcels"] - len(x)).max(), 0)
    x, d = case.final("position", "d")
    out = d/2 - np.minimum(x, side - x).min(axis=1)
    result("sizes.throughWalls", max(0, out.max())/small, 0.05)


def same(model):
    """Two, and five, at one point, that move alike in a box of periods."""
    name, side = f"same.{model}", 0.1
    d, dt, v = 0.01, 1e-4, np.array([0.1, 0.2, -0.1])
    case = Case(name, x1=side, y1=side, z1=side, cells=(4, 4, 4), g=(0, 0, 0),
                typeX="cyclic", typeY="cyclic", typeZ="cyclic",
                contactModel=model, mu=0.1, e=0.5, et=0.3, deltaT=dt,
                endTime=0.1, springConstant=1e2)
    x = 2*[(0.02, 0.05, 0.05)] + 5*[(0.06, 0.03, 0.07)]
    case.parcels(x, U=v, omega=(0, 0, 0), d=d)
    solve(name, case)
    x, U = case.final("position", "U")
    m = np.pi/6*d**3*2500
    result(f"{name}.momentum", abs((U - v).mean(axis=0)).max()/0.1, 1e-12)
    gap = x[:, None] - x
    gap = np.linalg.norm(gap - side*np.round(gap/side), axis=2)
    np.fill_diagonal(gap, side)
    if model == "none":
        result(f"{name}.straight", abs(U - v).max(), 1e-14)
        return
    # Soft ones are on their way, and may meet again
    result(f"{name}.apart", max(1 - gap.min()/d, 0),
           0.02 if model == "hardSphere" else 0.5)
    # Springs of eleven pairs, hard spheres nothing
    gained = 0.5*m*((U - v)**2).sum()
    stored = 11*0.5*1e2*d**2 if model == "softSphere" else 1e-12
    result(f"{name}.energy", gained/stored, 1)


def rest(end, deltaT=1e-3, **parameters):
    """A bed of 200 left alone in steps of 1e-4 s."""
    d, n = 1e-3, 200
    case = bed("rest", n, 0.006, deltaT=deltaT, maxDeltaT=1e-4, endTime=end,
               **parameters)
    solve("rest", case)
    table = case.table()
    later = table["time"] > min(0.2*end, 1)
    m = n*np.pi/6*d**3*2500
    fall = m*9.81*table["centreY"][0]
    energy = table["kineticEnergy"] + table["rotationalEnergy"]
    result("rest.creep", np.ptp(table["centreY"][later])/d, 0.01)
    result("rest.energy", energy[later].max()/fall, 1e-4)
    result("rest.overlap", table["maxOverlap"][later].max(), 0.02)
    result("rest.lost", abs(table["nParcels"] - n).max(), 0)


def main():
    for e, et, mu in ENDS:
        ends(e, et, mu, 1e9)
    ends(0, 1, 10, 1)
    for e, et, mu in ENDS:
        if mu or et:                # smooth ones do not ask for e_t
            crowd(e, et, mu)
    crowd(0, 0, 10, 1e9, typeZ="empty")
    press(0, 0, 0.005, 1500)
    press(0.9, 0.1, 0.005, 1500)
    press(0.9, 0.1, 0.5, 200)
    sizes()
    for model in ("hardSphere", "softSphere", "none"):
        same(model)
    rest(2)


if __name__ == "__main__":
    main()

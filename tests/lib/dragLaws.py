# ------------------------------------------------------------------------------
# cghsFoam: coarse-grained hard-sphere fluidised beds for OpenFOAM
# Licence: GPL-3.0-or-later, see the file LICENSE
#
# Description
#     Drag laws, written down once more and independently of src/closures, as
#     the chapter and the papers have them: the exchange coefficient
#     beta [kg/m^3/s] of a suspension of voidage e and slip speed u. The force
#     on a particle is V beta/(1 - e) (u_fluid - v).
# ------------------------------------------------------------------------------
"""Reference drag laws for tests."""

import numpy as np


def single_sphere(Re):
    """Schiller and Naumann's drag coefficient."""
    return np.where(Re < 1000, 24/Re*(1 + 0.15*Re**0.687), 0.44)


def wen_yu(e, u, d, rho, mu):
    Re = e*rho*u*d/mu
    return 0.75*single_sphere(Re)*rho*e*(1 - e)*u/d*e**-2.65


def ergun(e, u, d, rho, mu):
    return 150*(1 - e)**2*mu/(e*d**2) + 1.75*rho*(1 - e)*u/d


def gidaspow(e, u, d, rho, mu):
    return np.where(e <= 0.8, ergun(e, u, d, rho, mu),
                    wen_yu(e, u, d, rho, mu))


def syamlal_obrien(e, u, d, rho, mu):
    Re = e*rho*u*d/mu
    A = e**4.14
    B = np.where(e <= 0.85, 0.8*e**1.28, e**2.65)
    vr = 0.5*(A - 0.06*Re
              + np.sqrt((0.06*Re)**2 + 0.12*Re*(2*B - A) + A**2))
    Cd = (0.63 + 4.8/np.sqrt(Re/vr))**2
    return 0.75*Cd*rho*e*(1 - e)*u/(vr**2*d)


LAWS = {"WenYu": wen_yu, "Gidaspow": gidaspow, "SyamlalOBrien": syamlal_obrien}


def rate(law, u, d, rho, mu, rho_p, e=1 - 1e-9):
    """Rate [1/s] at which a particle takes up the slip: drag/(mass u)."""
    return LAWS[law](e, u, d, rho, mu)/((1 - e)*rho_p)


def terminal_velocity(law, d, rho, mu, rho_p, g=9.81):
    """The speed at which drag holds weight less buoyancy, by bisection."""
    low, high = 0.0, 1e3
    for _ in range(200):
        u = 0.5*(low + high)
        holds = u*rate(law, u, d, rho, mu, rho_p) > g*abs(1 - rho/rho_p)
        low, high = (low, u) if holds else (u, high)
    return u

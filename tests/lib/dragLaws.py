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

from roots import root


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


def syamlal_obrien(e, u, d, rho, mu, C1=2.65, C2=0.8, voidage_in_re=True):
    Re = (e if voidage_in_re else 1)*rho*u*d/mu
    A = e**4.14
    B = np.where(e <= 0.85, C2*e**1.28, e**C1)
    vr = 0.5*(A - 0.06*Re
              + np.sqrt((0.06*Re)**2 + 0.12*Re*(2*B - A) + A**2))
    Cd = (0.63 + 4.8/np.sqrt(Re/vr))**2
    return 0.75*Cd*rho*e*(1 - e)*u/(vr**2*d)


def bvk(e, u, d, rho, mu):
    """Beetstra, van der Hoef and Kuipers 2007: drag over Stokes'."""
    phi = 1 - e
    Re = e*rho*u*d/mu
    F = 10*phi/e**2 + e**2*(1 + 1.5*phi**0.5) + 0.413*Re/(24*e**2)*(
        1/e + 3*phi*e + 8.4*Re**-0.343)/(
        1 + 10**(3*phi)*Re**(-(1 + 4*phi)/2))
    return 18*mu*e*phi*F/d**2


def hill_koch_ladd(e, u, d, rho, mu):
    """Benyahia, Syamlal and O'Brien 2006, Table 1; one voidage at a time."""
    phi = 1 - e
    R = rho*e*u*d/(2*mu)
    w = np.exp(-10*(0.4 - phi)/phi)
    packed = 10*phi/(1 - phi)**3
    F0 = F2 = packed
    if phi < 0.4:
        top = 1 + 3*np.sqrt(phi/2) + (135/64)*phi*np.log(phi)
        F0 = w*packed + (1 - w)*(top + 17.14*phi)/(
            1 + 0.681*phi - 8.48*phi**2 + 8.16*phi**3)
        F2 = w*packed + (1 - w)*(top + 17.89*phi)/(
            1 + 0.681*phi - 11.03*phi**2 + 15.41*phi**3)
    F1 = (np.sqrt(2/phi)/40 if phi <= 0.1
          else 0.11 + 0.00051*np.exp(11.6*phi))
    F3 = (0.9351*phi + 0.03667 if phi < 0.0953
          else 0.0673 + 0.212*phi + 0.0232*(1 - phi)**-5)

    fast = F2 + F3*R
    if phi <= 0.01:
        F = 1 + 3*R/8 if R <= (F2 - 1)/(3/8 - F3) else fast
    else:
        root = np.sqrt(F3**2 - 4*F1*(F0 - F2))
        F = F0 + F1*R**2 if R <= (F3 + root)/(2*F1) else fast
    return 18*mu*e**2*phi*F/d**2


def emms(e, u, d, rho, mu):
    """Eq 14, third branch mended, never above Wen and Yu."""
    if e <= 0.4924:
        H = 0.1443 + 1.6864/(1 + (e/0.4064)**20.4805)
    elif e <= 0.9505:
        H = (-0.0999 + 0.9586*e)**1.8008
    else:
        H = (1649.4591 - 1648.5453*e)**-0.08597
    return wen_yu(e, u, d, rho, mu)*min(H, 1)


def gao(e, u, d, rho, mu, effective=248e-6, in_d=False, throughout=False):
    """Eqs 15-17; in_d: the effective diameter divides, as in Re; throughout: it
    is that of what is beyond 0.933, too."""
    if e <= 0.8:
        return ergun(e, u, d, rho, mu)
    if e <= 0.933:
        Cd = single_sphere(e*rho*u*effective/mu)
        length = effective if in_d else d
        return 5/72*e*(1 - e)*rho*u/(length*(1 - e)**0.293)*Cd
    swarm = e**-2.65 if e <= 0.99 else 1
    d = effective if throughout else d
    return 0.75*e*(1 - e)*rho*u/d*single_sphere(e*rho*u*d/mu)*swarm


def igci(e, u, d, rho, mu, size=0.01, settling=0.22, g=9.81):
    """Igci, Pannala, Benyahia and Sundaresan 2012, away from walls."""
    phi = 1 - e
    if phi < 0.0012:
        h = 2.7*phi**0.234
    elif phi < 0.014:
        h = -0.019/phi**0.455 + 0.963
    elif phi < 0.25:
        h = 0.868*np.exp(-0.38*phi) - 0.176*np.exp(-119.2*phi)
    elif phi < 0.455:
        h = -4.59e-5*np.exp(19.75*phi) + 0.852*np.exp(-0.268*phi)
    elif phi <= 0.59:
        h = (phi - 0.59)*(-1501*phi**3 + 2203*phi**2 - 1054*phi + 162)
    else:
        h = 0
    if phi < 0.18:
        h *= phi**0.24*(1.48 + np.exp(-18*phi))
    filtered = (g*size/settling**2)**1.6
    return wen_yu(e, u, d, rho, mu)*(1 - h*filtered/(filtered + 0.4))


LAWS = {"WenYu": wen_yu, "Gidaspow": gidaspow, "SyamlalOBrien": syamlal_obrien,
        "BVK": bvk, "HillKochLadd": hill_koch_ladd, "EMMS": emms, "Gao": gao,
        "Igci": igci}


def rate(law, u, d, rho, mu, rho_p, e=1 - 2**-50):
    """Rate [1/s] at which a particle takes up the slip: drag/(mass u). law is
    a name or a function."""
    beta = LAWS.get(law, law)
    return beta(e, u, d, rho, mu)/((1 - e)*rho_p)


def carrying_velocity(law, d, rho, mu, rho_p, e=1 - 2**-50, g=9.81):
    """The superficial velocity in which a suspension of voidage e rests: the
    drag of the slip U/e holds the weight less the buoyancy in the
    suspension."""
    def excess(U):
        return U/e*rate(law, U/e, d, rho, mu, rho_p, e) \
            - e*g*abs(1 - rho/rho_p)

    return root(excess, 1e-30, 1e3)


def terminal_velocity(law, d, rho, mu, rho_p, g=9.81):
    """The speed at which a single particle falls."""
    return carrying_velocity(law, d, rho, mu, rho_p, g=g)

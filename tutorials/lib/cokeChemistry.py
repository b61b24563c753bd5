# ------------------------------------------------------------------------------
# cghsFoam: coarse-grained hard-sphere fluidised beds for OpenFOAM
# Licence: GPL-3.0-or-later, see the file LICENSE
#
# Description
#     What burns in a tutorial, from its own dictionaries: molar masses and
#     enthalpies of its gas and solids, rates of its reactions.
#     And the steady limits of a bed of catalyst whose coke burns: solids that
#     are well mixed and all as hot as the gas, which flows through them as a
#     plug or is well mixed, too.
#
#         chemistry = Chemistry(case)
#         chemistry.M["CO2"], chemistry.enthalpy("CO2", T)
#         bed = CokeBed(chemistry, feed, inventory, p, volume, flows)
#         bed.limit(plug=True)
# ------------------------------------------------------------------------------
"""Coke that burns: its data, and its steady limits."""

import re
from pathlib import Path

from tutorial import np, of, stop

R = 8.31446261815324

# [kg/kmol], as OpenFOAM has them
ATOMS = dict(C=12.01115, H=1.00797, O=15.9994, N=14.0067)


def dictionary(case, name):
    """The text of a file of constant, without comments."""
    return re.sub(r"//.*", "", (Path(case) / "constant" / name).read_text())


def block(text, name):
    """What is in the braces after a name."""
    start = re.search(rf"(?m)^\s*{name}\s*\{{", text)
    if not start:
        stop(f"there is no dictionary {name}")
    depth, end = 1, start.end()
    while depth:
        depth += {"{": 1, "}": -1}.get(text[end], 0)
        end += 1
    return text[start.end():end - 1]


def value(text, name):
    """A number, or none."""
    match = re.search(rf"\b{name}\s+({of.NUMBER})\s*;", text)
    return float(match[1]) if match else None


def expanded(text, whole):
    """With the entries of the dictionaries that it takes in by $:name."""
    return text + "".join(
        block(whole, other) for other in re.findall(r"\$:(\w+);", text))


class Chemistry:
    """M [kg/mol] by names; the names of the gas. Thermodynamics are hConst or,
    of the gas, janaf."""

    def __init__(self, case):
        self.reactions = dictionary(case, "reactions")
        gas = dictionary(case, "thermophysicalProperties")
        self.gas = re.search(r"\bspecies\s*\(([^)]*)\)", gas)[1].split()
        solids = block(self.reactions, "solids")

        # Of janaf two sets; else one. See enthalpy
        self.M, self.coefficients, self.common = {}, {}, {}
        self._known = {}    # A and Ta of reactions
        for name in self.gas:
            self._read(name, expanded(block(gas, name), gas))
        for name in re.findall(r"(\w+)\s*\{(?:[^{}]*\{[^{}]*\})+[^{}]*\}",
                               solids):
            self._read(name, block(solids, name))

    def _read(self, name, text):
        elements = re.search(r"elements\s*\{([^}]*)\}", text)
        self.M[name] = 1e-3 * (
            sum(ATOMS[atom] * float(n) for atom, n in
                re.findall(r"(\w+)\s+([\d.]+)\s*;", elements[1]))
            if elements else value(text, "molWeight"))
        if value(text, "Cp") is not None:
            self.common[name] = np.inf
            self.coefficients[name] = [
                [value(text, "Hf"), value(text, "Cp")]]
            return
        if "lowCpCoeffs" not in text:
            return      # At a temperature that is given
        self.common[name] = value(text, "Tcommon")
        self.coefficients[name] = [
            self._janaf(text, entry, self.M[name])
            for entry in ("lowCpCoeffs", "highCpCoeffs")]

    @staticmethod
    def _janaf(text, entry, M):
        """Coefficients of the enthalpy [J/kg] over powers of T."""
        a = [float(x) for x in
             re.search(rf"{entry}\s*\(([^)]*)\)", text)[1].split()]
        return [R / M * x for x in (a[5], *(a[i] / (i + 1) for i in range(5)))]

    def enthalpy(self, name, T):
        """With that of formation [J/kg]."""
        high = int(T > self.common[name])
        return np.polynomial.polynomial.polyval(
            T, self.coefficients[name][high])

    def heat_capacity(self, name, T):
        """[J/kg/K]."""
        high = int(T > self.common[name])
        return np.polynomial.polynomial.polyval(
            T, np.polynomial.polynomial.polyder(
                self.coefficients[name][high]))

    def rate_constant(self, reaction, T):
        """In the units of its entry A, by Arrhenius."""
        if reaction not in self._known:
            text = expanded(block(self.reactions, reaction), self.reactions)
            Ta = value(text, "Ta")
            Ta = value(text, "Ea") / R if Ta is None else Ta
            self._known[reaction] = value(text, "A"), Ta
        A, Ta = self._known[reaction]
        return A * np.exp(-Ta / T)


def share_of_CO(T):
    """In what leaves the carbon, as cokeCombustion has it (intrinsic)."""
    return 1 / (1 + 5.28e-3 * np.exp(34860 / (R * T)))


class CokeBed:
    """A bed with reactions toCO2, toH2O and afterburn. feed: flow of solids
    [kg/s], its T and mass fractions; flows: the same of each gas that comes in;
    inventory [kg], p [Pa], volume of the gas in the bed [m3]."""

    SLICES = 400

    def __init__(self, chemistry, feed, inventory, p, volume, flows):
        self.chemistry = chemistry
        self.feed, self.T_feed, self.Y_feed = feed
        self.inventory, self.p, self.volume = inventory, p, volume
        self.flows = flows
        self.gas_in = np.array([
            sum(flow * Y.get(s, 0) / chemistry.M[s] for flow, _, Y in flows)
            for s in chemistry.gas])

    def _rates(self, T):
        """1/bar/s of C and H; share of CO that leaves the carbon; of CO's
        fire."""
        k = self.chemistry.rate_constant
        return k("toCO2", T), k("toH2O", T), share_of_CO(T), k("afterburn", T)

    def _burning(self, n, C, H, T, rates):
        """Of the whole bed, if gas of these flows [mol/s] were everywhere in
        it: what they gain, carbon and hydrogen that burn [mol/s]."""
        k_C, k_H, share, k_CO = rates
        M = self.chemistry.M
        x = dict(zip(self.chemistry.gas, np.maximum(n, 0) / n.sum()))
        bar = x["O2"] * self.p / 1e5
        carbon = k_C * bar * self.inventory * C / M["C"]
        hydrogen = k_H * bar * self.inventory * H / M["H"]
        fire = (k_CO * self.volume * (self.p / (R * T))**2 * x["CO"]
                * np.sqrt(x["O2"] * x["H2O"]))
        gain = dict(
            O2=-carbon * (1 - 0.5 * share) - 0.25 * hydrogen - 0.5 * fire,
            CO2=carbon * (1 - share) + fire, CO=carbon * share - fire,
            H2O=0.5 * hydrogen)
        return (np.array([gain.get(s, 0) for s in self.chemistry.gas]),
                carbon, hydrogen)

    def through(self, C, H, T, plug):
        """Gas that flows out, and what burns [mol/s]."""
        rates = self._rates(T)
        n = self.gas_in
        if plug:
            carbon = hydrogen = 0
            for _ in range(self.SLICES):
                middle = n + 0.5 * self._burning(
                    n, C, H, T, rates)[0] / self.SLICES
                gain, c, h = self._burning(middle, C, H, T, rates)
                n = n + gain / self.SLICES
                carbon += c / self.SLICES
                hydrogen += h / self.SLICES
            return n, carbon, hydrogen

        # Mixed: by Newton's method, in steps that keep all above zero
        def missing(flows):
            return (self.gas_in
                    + self._burning(flows, C, H, T, rates)[0] - flows)

        n = 0.5 * n
        for _ in range(2000):
            f = missing(n)
            J = np.empty((n.size, n.size))
            for k in range(n.size):
                m = n.copy()
                m[k] += 1e-6 * max(n[k], 1e-3)
                J[:, k] = (missing(m) - f) / (m[k] - n[k])
            step = np.linalg.solve(J, -f)
            shrinks = np.max(-step / np.maximum(n, 1e-9))
            n = np.maximum(n + min(1, 0.5 / max(shrinks, 1e-9)) * step, 1e-9)
            if np.abs(step).max() < 1e-9:
                break
        return (n, *self._burning(n, C, H, T, rates)[1:])

    def _misfits(self, unknown, plug):
        """Of C, H and T, over what they are."""
        C, H, T = unknown
        chemistry = self.chemistry
        n, carbon, hydrogen = self.through(C, H, T, plug)
        lost = (carbon * chemistry.M["C"], hydrogen * chemistry.M["H"])
        solids = self.feed - sum(lost)

        def heat(flow, T, Y):
            return flow * sum(
                y * chemistry.enthalpy(s, T) for s, y in Y.items())

        heat_in = heat(self.feed, self.T_feed, self.Y_feed) + sum(
            heat(*flow) for flow in self.flows)
        heat_out = heat(solids, T, dict(C=C, H=H, catalyst=1 - C - H)) + sum(
            v * chemistry.M[s] * chemistry.enthalpy(s, T)
            for s, v in zip(chemistry.gas, n))
        fed = [self.feed * self.Y_feed[s] for s in ("C", "H")]
        return np.array([
            1 - (solids * C + lost[0]) / fed[0],
            1 - (solids * H + lost[1]) / fed[1],
            (heat_in - heat_out)
            / (self.feed * chemistry.heat_capacity("catalyst", T) * 300)])

    def limit(self, plug, guess=(0.0043, 0.0001, 910.0)):
        """C and H of the solids, T [K], and mass fractions of the gas that
        leaves."""
        x = np.array(guess)
        for _ in range(100):
            f = self._misfits(x, plug)
            J = np.empty((3, 3))
            for k in range(3):
                y = x.copy()
                y[k] *= 1 + 1e-5
                J[:, k] = (self._misfits(y, plug) - f) / (1e-5 * x[k])
            step = np.linalg.solve(J, -f)
            x = x + min(1, 0.2 / np.abs(step / x).max()) * step
            if np.abs(step / x).max() < 1e-8:
                break
        else:
            stop("the steady limit has not been found")
        n = self.through(*x, plug)[0]
        mass = np.array([self.chemistry.M[s] for s in self.chemistry.gas]) * n
        return dict(C=x[0], H=x[1], T=x[2],
                    **dict(zip(self.chemistry.gas, mass / mass.sum())))

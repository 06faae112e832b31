"""Two equal aluminium plates meet: a strong shock behind an elastic precursor."""

import methods
import shock
import two_waves
from catalogue import case
from two_waves import FIGURES, ORDERS, judge, order_gates

TITLE = "Symmetric impact of aluminium"
PROBLEM = two_waves.Problem(shock.ALUMINIUM, 400.0, 50e-3)
TARGETS = {**two_waves.TARGETS, "overshoot": 0.04}

ABOUT = r"""
Two equal plates of aluminium meet with 400 m/s each, in uniaxial strain; half of it is run, with a mirror plane
(*symmetry*). Constants of Wilkins' flying plate: :math:`\rho_0` = 2785, C = 5328 m/s, S = 1.338, :math:`\Gamma` = 2,
:math:`\mu` = 27.6 GPa, Y = 300 MPa. The plate is 50 mm thick and has n cells; it is looked at after 2.5 and 5 us.

Exact, as in :doc:`piston`: HEL 635.885 MPa with 6490.46 m/s, shock to 6636.147 MPa with 5908.78 m/s. The mirror plane
replaces the contact wall, and the shock is thirty times stronger: viscosity has something to do here. The first columns
show what is called wall heating: the heat of the start of the shock, which no later motion takes away.
"""


def cases(level):
    sizes = (100, 200) if level == "test" else (200, 400, 800)
    return [case("impact", method, n, weight=0.8 * (n / 200) ** 2 * (1 if method.frame == "lagrangian" else 3))
            for method in methods.METHODS if not cannot(method) for n in sizes]


def cannot(method):
    if method.stock == "sph":
        return "its materials are fluids: no strength"
    if method.stock:
        return "no Mie-Gruneisen solid with strength: *EOS_SHOCK* of MACHDYN goes without energy"
    return ""


def measure(case):
    return PROBLEM.measure(case)


def gates(case):
    found = two_waves.gates(case, PROBLEM, 2.5e-6)
    if "plateau" in found:
        found["overshoot"] = TARGETS["overshoot"]
    return found


def draw(results, file):
    PROBLEM.draw(results, file, 1e-3, "mm")

"""A copper bar runs against a rigid wall: elastic precursor and plastic shock."""

import methods
import shock
import two_waves
from catalogue import case
from two_waves import FIGURES, ORDERS, TARGETS, judge, order_gates

TITLE = "Elastic-plastic piston"
PROBLEM = two_waves.Problem(shock.COPPER, 20.0, 1.0)

ABOUT = r"""
A copper bar in uniaxial strain runs with 20 m/s against a rigid wall (*contact*), which is a piston for the bar: the
problem of Udaykumar and co-workers, used since by Maire and others; constants as in the Piston test of the Spheral code:
:math:`\rho_0` = 8930, C = 3940 m/s, S = 1.49, :math:`\Gamma` = 2, :math:`\mu` = 45 GPa, Y = 90 MPa. The bar is 1 m long and
has n cells; the state is looked at after 75 and 150 us, before anything has reached its far end.

Exact: an elastic jump to the yield point, which for a stress rate is :math:`\rho_y = \rho_0 \exp(Y/2\mu)`, with the
Hugoniot elastic limit (HEL) of 199.03 MPa and a speed of 4722.18 m/s, and a plastic jump with
:math:`S_{xx} = -\frac{2}{3} Y` to 741.592 MPa, with 3976.96 m/s, each with the conservation laws of mass, momentum and energy
(*shock.py*). Speeds are those in material at rest, between the two times, at half the height of each front. HEL: mean
over the middle half between the fronts; plateau: from 20 to 80 % of the way to the shock; L1: integral of the
difference over that of the exact stress.
"""


def cases(level):
    sizes = (100, 200) if level == "test" else (200, 400, 800)
    return [case("piston", method, n, weight=0.8 * (n / 200) ** 2 * (1 if method.frame == "lagrangian" else 3))
            for method in methods.METHODS if not cannot(method) for n in sizes]


def cannot(method):
    if method.stock == "sph":
        return "its materials are fluids: no strength"
    if method.stock:
        return "no wall of its own and no Mie-Gruneisen solid with strength: *EOS_SHOCK* of MACHDYN goes without energy"
    return ""


def measure(case):
    return PROBLEM.measure(case)


def gates(case):
    return two_waves.gates(case, PROBLEM, 75e-6)


def draw(results, file):
    PROBLEM.draw(results, file, 1.0, "m")

"""A copper bar runs against a rigid wall: elastic precursor and plastic shock."""

import shock
import stock
import two_waves
from catalogue import usual_cases
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
difference over that of the exact stress; its order is shown for the shock alone too (from half of its way to half-way to the
precursor). Order 0.9 is out of reach here: both fronts are so weak that they hardly steepen, and a linear front that a
method of order p spreads converges with p/(p + 1): 2/3 without a viscosity, 1/2 with it.

The columns at a *contact* wall do not have the stress of the plateau: forces of the corrected form are in equilibrium
with 3/2 and 3/4 of it in the first two columns (h = 1 spacing, half cells on the face: their sums M are 1/2 and 3/4 of
that inside). The force on the wall is right, and a *symmetry* plane (:doc:`impact`) has no such columns.
"""


def cases(level):
    return usual_cases("piston", level, (100, 200), (200, 400, 800), 0.3, cannot)


def cannot(method):
    return stock.plane_shock(method)


def measure(case):
    return PROBLEM.measure(case)


def gates(case):
    return two_waves.gates(case, PROBLEM, 75e-6)


def misses(case):
    if case.n < two_waves.FINEST or case.method.key in ("L-monaghan05", "L-balsara1"):
        return {}
    return {"hel": two_waves.FOOT if case.method.whole else two_waves.EXCESS}


def draw(results, file):
    PROBLEM.draw(results, file, 1.0, "m")

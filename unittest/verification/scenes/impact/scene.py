"""Two equal aluminium plates meet: a strong shock behind an elastic precursor."""

import shock
import stock
import two_waves
from catalogue import usual_cases
from two_waves import FIGURES, ORDERS, judge, order_gates

TITLE = "Symmetric impact of aluminium"
PROBLEM = two_waves.Problem(shock.ALUMINIUM, 400.0, 50e-3)
TARGETS = {**two_waves.TARGETS, "overshoot": 0.04}

ABOUT = r"""
Two equal plates of aluminium meet with 400 m/s each, in uniaxial strain; half of it is run, with a mirror plane
(*symmetry*). Constants of Wilkins' flying plate: :math:`\rho_0` = 2785, C = 5328 m/s, S = 1.338, :math:`\Gamma` = 2,
:math:`\mu` = 27.6 GPa, Y = 300 MPa. The plate is 50 mm thick and has n cells; it is looked at after 2.5 and 5 us.

Exact, as in :doc:`piston`: HEL 635.885 MPa with 6490.46 m/s, shock to 6636.147 MPa with 5908.78 m/s. The mirror plane
replaces the contact wall, and the shock is nine times stronger: viscosity has something to do here.

A method that overshoots is wrong behind the shock too, at any resolution: what overshoots unloads again, elastically, and
takes its share of the deviator along. The stress of the plateau misses that share of :math:`\frac{2}{3} Y`, and the
shock is slower in proportion, and the L1 error stops to fall (column *its deviator*; without strength, in :doc:`noh`, the mean state is right however it rings).
"""


def cases(level):
    return usual_cases("impact", level, (100, 200), (200, 400, 800), 0.3, cannot)


def cannot(method):
    return stock.plane_shock(method)


def measure(case):
    return PROBLEM.measure(case)


def gates(case):
    found = two_waves.gates(case, PROBLEM, 2.5e-6)
    if "plateau" in found or (case.method.kind == "front" and case.n >= 200):
        found["overshoot"] = TARGETS["overshoot"]
    return found


RINGING = ("correct", "safe", "none", "limited05", "limited2", "limited3")    # the plateau lacks a part of the deviator at any n


def misses(case):
    kind, found = case.method.kind, {}
    if case.method.gradient == "plain" or case.n < 400:
        return found
    if kind in RINGING and not (kind == "limited3" and case.n < two_waves.FINEST):
        found["plastic"] = two_waves.UNLOADED
        if case.method.frame == "eulerian" and kind in ("correct", "safe", "none"):
            found["elastic"] = two_waves.EXCESS
    if case.n >= two_waves.FINEST:
        if kind in RINGING:
            found.update(hel=two_waves.EXCESS, plateau=two_waves.UNLOADED)
        if kind in RINGING and kind != "limited3":
            found["overshoot"] = TOO_LITTLE
        if kind in ("monaghan05", "front"):
            found["plateau"] = two_waves.UNLOADED
        if kind in ("monaghan1", "balsara1", "front"):
            found["hel"] = two_waves.FOOT
    return found


TOO_LITTLE = "too little viscosity for this shock"


def draw(results, file):
    PROBLEM.draw(results, file, 1e-3, "mm")

"""Planar Noh problem for a Mie-Grueneisen fluid."""

import methods
import plane_shock
import profiles
import shock
import stock
from catalogue import Figure, overview, usual_cases
from histories import drift
from plane_shock import RUNS_AHEAD
from running import columns

TITLE = "Planar Noh problem, Mie-Gruneisen"
SOLID, U = shock.IRON_FLUID, 200.0
_, BEHIND = shock.piston(SOLID, U)

ABOUT = r"""
Two streams of iron without strength meet with 200 m/s each; half of it is run, with a mirror plane. n cells are 50 mm;
it is looked at after 5 and 10 us. Exact: everything that the shock has passed is at rest, with
:math:`e = \frac{1}{2} u^2` = 20000 J/kg, :math:`\rho` = 8267.66, P = 6.215645 GPa; the shock runs with 3959.01 m/s in
material at rest (Rankine-Hugoniot for the cubic Hugoniot curve, *shock.py*; the planar case of the problem of
W. F. Noh, J. Comput. Phys. 72, 78 (1987), for this equation of state).

The package refuses a shear modulus of 0; with 1 Pa the deviator stays below 1e-9 of the pressure.
The first columns show wall heating: too much energy and too little density, at the right pressure. Nothing but viscosity
makes heat here, which is the hardest of all tests for a method that keeps little of it: there is no plastic work to
damp the ringing behind the shock.
"""

FIGURES = [
    Figure("speed", "speed of the shock", "{:+.2%}"),
    Figure("plateau", "pressure behind it", "{:+.2%}"),
    Figure("rho", "density behind it", "{:+.2%}"),
    Figure("overshoot", "overshoot of the pressure", "{:.1%}"),
    Figure("ripple", "ripple of the pressure (rms)", "{:.2%}"),
    Figure("heating", "wall heating: e of the first column", "{:+.0%}"),
    Figure("l1", "L1 error of the pressure", "{:.2%}", order=True),
    Figure("l1_rho", "L1 error of density jump", "{:.2%}", order=True),
    Figure("energy", "drift of the total energy", "{:.0e}"),
]
TARGETS = {"speed": 0.005, "plateau": 0.003, "energy": 1e-5}
ORDERS = {"l1": 0.9}


def cases(level):
    found = usual_cases("noh", level, (100, 200), (200, 400, 800), 0.3, cannot)
    for each in found:
        each.may_fail = RINGS_APART if each.name == "L-none-800" else ""
    return found


RINGS_APART = "without viscosity the ringing grows until particles fly apart"


def cannot(method):
    return stock.plane_shock(method, fluid=True)


def measure(case):
    (t1, p1), (t2, p2) = profiles.over_time(case.dump)[1:3]
    x, pressure = p2["x"], p2["p"]
    place = (BEHIND.speed - U) * t2
    run = profiles.front(x, pressure, 0.5 * BEHIND.stress) - profiles.front(p1["x"], p1["p"], 0.5 * BEHIND.stress)
    rise = [rho - SOLID.rho0 for rho in p2["rho"]]
    data = columns(case.csv)
    return {
        "speed": (run / (t2 - t1) + U) / BEHIND.speed - 1,
        "plateau": profiles.mean(x, pressure, 0.2 * place, 0.8 * place) / BEHIND.stress - 1,
        "rho": profiles.mean(x, p2["rho"], 0.2 * place, 0.8 * place) / BEHIND.rho - 1,
        "overshoot": max(p for at, p in zip(x, pressure) if at > 0.5 * place) / BEHIND.stress - 1,
        "ripple": profiles.deviation(x, pressure, 0.2 * place, 0.8 * place) / BEHIND.stress,
        "heating": p2["e"][0] / BEHIND.e - 1,
        "l1": profiles.l1(x, pressure, lambda at: BEHIND.stress if at < place else 0.0, 0.0, 1.1 * place),
        "l1_rho": profiles.l1(x, rise, lambda at: BEHIND.rho - SOLID.rho0 if at < place else 0.0, 0.0, 1.1 * place),
        "energy": drift(data["total_J"]),
    }


FINEST = 800    # cells at which the targets are to be met


def gates(case):
    """Ringing leaves the mean density alone, as long as there is any viscosity. The rest on coarse lattices only where
    nothing rings."""
    found = {"energy": 1e-12}
    if case.method.kind != "none":
        found["rho"] = 0.003
    if case.n >= FINEST or (case.method.gradient == "corrected" and plane_shock.calm(case.method)):
        found.update(speed=TARGETS["speed"], plateau=TARGETS["plateau"])
    return found


def misses(case):
    if case.n < FINEST or not case.method.little:
        return {}
    return {"speed": RUNS_AHEAD, "plateau": RUNS_AHEAD} if case.method.kind == "none" else {"speed": RUNS_AHEAD}


def order_gates(cases):
    return plane_shock.order_gates(cases, 0.75)


def draw(results, file):
    import pictures
    figure, (pressure, heat, errors) = pictures.axes(3, width=3.7)
    for r, colour in pictures.finest_lagrangian(results):
        t, last = profiles.over_time(r.case.dump)[-1]
        pressure.plot([1e3 * x for x in last["x"]], [p / 1e9 for p in last["p"]], lw=1, color=colour)
        near = [(1e3 * x, e / BEHIND.e) for x, e in zip(last["x"], last["e"]) if x < 2e-3]
        heat.plot(*zip(*near), lw=1, marker=".", ms=3, color=colour)
    place = 1e3 * (BEHIND.speed - U) * t
    pressure.plot([0, place, place, 1.2 * place], [BEHIND.stress / 1e9] * 2 + [0, 0], "k", lw=0.8, zorder=0)
    pressure.set(xlabel="distance from the plane (mm)", ylabel="pressure (GPa)", xlim=(0.9 * place, 1.04 * place),
                 title=pictures.title(results) + "; black: exact")
    heat.set(xlabel="distance from the plane (mm)", ylabel="energy / exact", title="wall heating")
    pictures.error_axes(figure, errors, results, "l1", "L1 error of the pressure")
    pictures.save(figure, file.parent, file.stem)


def judge(results):
    found = overview(results, "l1")
    last, orders = found.last, found.orders
    calm = [r for r in last if r.figures["overshoot"] < 0.04]
    return (f"The mean density behind the shock is right within {max(abs(r.figures['rho']) for r in last):.2%} for "
            f"all methods; *correct* overshoots by {found.default['overshoot']:.0%}, {len(calm)} of {len(last)} methods by "
            f"less than 4 %. The L1 error falls with order {orders[methods.DEFAULT]:.2f} for *correct* and "
            f"{orders['L-monaghan1']:.2f} for *monaghan 1 1*; {found.reach(ORDERS['l1'])} {ORDERS['l1']:g}.")

"""Shock tube for a Mie-Grueneisen fluid: rarefaction, contact, shock."""

import functools

import methods
import plane_shock
import profiles
import shock
import stock
from catalogue import Figure, overview, usual_cases
from histories import drift
from plane_shock import RUNS_AHEAD
from running import columns

TITLE = "Shock tube, Mie-Gruneisen"
SOLID, E_LEFT = shock.IRON_FLUID, 707714.084
HALF = 0.5    # length of either side, m


@functools.lru_cache(maxsize=1)
def tube():
    return shock.tube(SOLID, E_LEFT)


ABOUT = r"""
Iron without strength at rest in a tube of 1 m: heat makes 10 GPa on the left, on the right there is neither heat nor
pressure; the density is 7850 kg/m3 on both sides. n cells along the tube; it is looked at after 50 and 100 us, before
anything has reached the mirror planes at its ends.

Exact (*shock.py*: jump conditions on the right, isentrope on the left, integrated by Runge-Kutta, joined at equal pressure
and velocity): P* = 4.950243 GPa, u* = 162.0607 m/s, densities 7542.02 and 8191.15 on the two sides of the contact, shock
with 3891.16 m/s, rarefaction from -4065.33 to -3870.43 m/s. The isentrope of this equation of state has a kink where
the density passes its value at rest and tension begins; here it lies in tension altogether.

The package refuses a shear modulus of 0; with 1 Pa the deviator stays below 1e-9 of the pressure. At the contact
density and energy jump while pressure and velocity do not: what the pressure does there is an error of the method.
"""

FIGURES = [
    Figure("star", "pressure between the waves", "{:+.2%}"),
    Figure("ustar", "velocity between the waves", "{:+.2%}"),
    Figure("speed", "speed of the shock", "{:+.2%}"),
    Figure("overshoot", "overshoot of the pressure", "{:.1%}"),
    Figure("blip", "pressure at the contact, largest error", "{:.1%}"),
    Figure("l1", "L1 error of the pressure", "{:.2%}", order=True),
    Figure("l1_u", "L1 error of the velocity", "{:.2%}", order=True),
    Figure("l1_rho", "L1 error of density - 7850", "{:.2%}", order=True),
    Figure("energy", "drift of the total energy", "{:.0e}"),
]
TARGETS = {"star": 0.003, "speed": 0.005, "energy": 1e-5}
ORDERS = {"l1": 0.9}


def cases(level):
    return usual_cases("shocktube", level, (100, 200), (200, 400, 800), 0.3, cannot)


def cannot(method):
    return stock.plane_shock(method, fluid=True)


def seen(case):
    """(time, profile with the interface at x = 0) of the snapshots after the first."""
    found = profiles.over_time(case.dump)[1:]
    for _, each in found:
        each["x"] = [x - HALF / case.n for x in each["x"]]    # in.shocktube: half a cell to the right
    return found


def distances(profile, t):
    """Relative L1 errors of pressure, velocity and density."""
    exact, x, reach = tube(), profile["x"], 0.45
    at = lambda name: lambda place: getattr(shock.tube_at(exact, place / t), name)
    rho = at("rho")
    rise = lambda place: rho(place) - SOLID.rho0
    return (profiles.l1(x, profile["p"], at("stress"), -reach, reach),
            profiles.l1(x, profile["vx"], at("u"), -reach, reach),
            profiles.l1(x, [r - SOLID.rho0 for r in profile["rho"]], rise, -reach, reach))


def measure(case):
    (t1, p1), (t2, p2) = seen(case)[:2]
    exact, x, pressure = tube(), p2["x"], p2["p"]
    star, contact = exact.star_right, exact.star_left.u * t2
    tail, front = exact.fan[-1][0] * t2, star.speed * t2
    run = profiles.front(x, pressure, 0.5 * star.stress) - profiles.front(p1["x"], p1["p"], 0.5 * star.stress)
    low, high = 0.8 * tail, 0.8 * front
    near = [p for at, p in zip(x, pressure) if abs(at - contact) < 0.05 * front]
    l1, l1_u, l1_rho = distances(p2, t2)
    data = columns(case.csv)
    return {
        "star": profiles.mean(x, pressure, low, high) / star.stress - 1,
        "ustar": profiles.mean(x, p2["vx"], low, high) / star.u - 1,
        "speed": run / (t2 - t1) / star.speed - 1,
        "overshoot": max(p for at, p in zip(x, pressure) if at > 0.5 * front) / star.stress - 1,
        "blip": max(abs(p / star.stress - 1) for p in near),
        "l1": l1, "l1_u": l1_u, "l1_rho": l1_rho,
        "energy": drift(data["total_J"]),
    }


FINEST = 800    # cells at which the targets are to be met


def gates(case):
    """On coarse lattices, with stiffness right: the shock within one spacing after 50 us, and with a viscosity the pressure
    between the waves within twice the target."""
    found = {"energy": 1e-12}
    if case.n >= FINEST:
        found.update(speed=TARGETS["speed"], star=TARGETS["star"])
    elif case.method.gradient == "corrected":
        found["speed"] = 2 * HALF / case.n / (tube().star_right.speed * 50e-6)
        if case.method.whole and case.n >= 200:
            found["star"] = 2 * TARGETS["star"]
    return found


def misses(case):
    if case.method.gradient == "corrected" and case.n >= FINEST and case.method.little:
        return {"speed": RUNS_AHEAD}
    return {"speed": RUNS_AHEAD} if case.name == "L-none-400" else {}


def order_gates(cases):
    """The rarefaction and the contact keep the order of a smeared front below that of a shock."""
    return plane_shock.order_gates(cases, 0.6)


def draw(results, file):
    import pictures
    figure, (pressure, density, errors) = pictures.axes(3, width=3.7)
    for r, colour in pictures.finest_lagrangian(results):
        t, last = seen(r.case)[-1]
        pressure.plot(last["x"], [p / 1e9 for p in last["p"]], lw=1, color=colour)
        density.plot(last["x"], last["rho"], lw=1, color=colour)
    places = [-0.5 + k / 4000 for k in range(4001)]
    states = [shock.tube_at(tube(), x / t) for x in places]
    pressure.plot(places, [s.stress / 1e9 for s in states], "k", lw=0.8, zorder=0)
    density.plot(places, [s.rho for s in states], "k", lw=0.8, zorder=0)
    pressure.set(xlabel="x (m)", ylabel="pressure (GPa)", title=pictures.title(results) + "; black: exact")
    density.set(xlabel="x (m)", ylabel="density (kg/m$^3$)")
    pictures.error_axes(figure, errors, results, "l1", "L1 error of the pressure")
    pictures.save(figure, file.parent, file.stem)


def judge(results):
    found = overview(results, "l1")
    default = found.default
    least = min(found.last, key=lambda r: r.figures["l1"])
    return (f"*correct* has the pressure between the waves within {abs(default['star']):.2%}, overshoots behind the shock by "
            f"{default['overshoot']:.0%}, and its L1 error of {default['l1']:.2%} falls with order "
            f"{found.orders[methods.DEFAULT]:.2f}; the smallest has *{least.case.method.title}* ({least.case.method.group}) "
            f"with {least.figures['l1']:.2%}. {found.reach(ORDERS['l1'])} order {ORDERS['l1']:g}. The largest "
            f"error of the pressure at the contact is {default['blip']:.1%} with *correct*, "
            f"{found.figures['L-monaghan1']['blip']:.1%} with *monaghan 1 1*.")

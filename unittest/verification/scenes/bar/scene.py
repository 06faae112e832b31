"""An elastic bar runs against a rigid wall and leaves it: contact time, restitution, energy lost."""

import stock
from catalogue import Figure, overview, usual_cases
from histories import drift
from running import columns

TITLE = "Elastic bar on a rigid wall"

ABOUT = r"""
A bar of iron (elastic, uniaxial strain; n cells along it) runs with 1 m/s against a rigid wall (*contact*). Exact, in
the linear limit: a wave with the stress :math:`\rho c_L v` runs to the free end, comes back as a release, and after
:math:`2 L / c_L` the bar leaves the wall with the velocity it came with and without any stress: restitution 1, no
kinetic energy lost; half-way the kinetic energy is zero. (Any textbook on stress waves, for instance K. F. Graff, Wave
Motion in Elastic Solids, 1975, chapter 2; here with the stiffness of uniaxial strain.)

What a *contact* wall takes at once, the kinetic energy of the half cells that hit it, is 1/(2 n) of the whole, and is
counted as wall work. Contact time: until the force of the wall falls below half of :math:`\rho c_L v` for the last
time; restitution: momentum at :math:`3 L / c_L` over that before.
"""

FIGURES = [
    Figure("contact", "contact time", "{:+.2%}", order=True),
    Figure("restitution", "restitution - 1", "{:+.2%}", order=True),
    Figure("lost", "kinetic energy lost", "{:.2%}", order=True),
    Figure("wall", "of it by the wall", "{:.2%}"),
    Figure("viscous", "of it viscous heat", "{:.2%}"),
    Figure("rest", "least kinetic energy", "{:.2%}"),
    Figure("force", "force of the wall, mean", "{:+.2%}"),
    Figure("energy", "drift of the total energy", "{:.0e}"),
]
TARGETS = {"contact": 0.01, "restitution": 0.01, "lost": 0.01, "energy": 1e-5}


def cases(level):
    return usual_cases("bar", level, (50, 100), (100, 200, 400), 0.3, cannot)


def cannot(method):
    return {"": "", "tlsph": stock.NO_PERIODIC, "ulsph": stock.NO_WALL, "sph": stock.NO_SOLID}[method.stock]


def measure(case):
    data = columns(case.csv)
    t, force = data["passages"], data["force"]
    last = max(k for k in range(len(t) - 1) if force[k] >= 0.5)
    leaves = t[last] + (t[last + 1] - t[last]) * (force[last] - 0.5) / (force[last] - force[last + 1])
    steady = [f for x, f in zip(t, force) if 0.5 < x < 1.5]
    return {"contact": 0.5 * leaves - 1, "restitution": data["momentum"][-1] - 1, "lost": 1 - data["kinetic"][-1],
            "wall": data["wall"][-1], "viscous": data["viscous"][-1], "rest": min(data["kinetic"]),
            "force": sum(steady) / len(steady) - 1, "energy": drift(data["total"])}


FINEST = 400    # cells at which the targets are to be met


def gates(case):
    """What the wall takes is known exactly, the steady force too where the stiffness is right."""
    found = {"energy": 1e-12, "wall": 0.5 / case.n * (1 + 1e-6)}
    if case.method.gradient == "corrected":
        found["force"] = 1e-3
    if case.n >= FINEST:
        found.update({name: TARGETS[name] for name in ("contact", "restitution", "lost")})
    return found


def misses(case):
    """A viscosity of first order takes what the wave loses at its two fronts."""
    if case.name == "E-front-50":
        return {"force": "stress comes up to its value slowly behind the front, a third as far off with n = 100"}
    if case.n < FINEST or case.method.little:
        return {}
    heat = "viscous heat of the front"
    return {"lost": heat} if "limited" in case.method.key else {"lost": heat, "restitution": heat}


def order_gates(cases):
    """A linear front that a method of order p spreads converges with p/(p + 1): 1/2 with a viscosity, 2/3 without."""
    return {"lost": 0.45} if cases[0].method.gradient == "corrected" else {}


def draw(results, file):
    import pictures
    figure, (force, lost, left) = pictures.axes(3, width=3.7)
    for r, colour in pictures.finest_lagrangian(results, "csv"):
        data = columns(r.case.csv)
        force.plot(data["passages"], data["force"], lw=1, color=colour)
        left.plot(data["passages"], data["kinetic"], lw=1, color=colour)
    force.plot([0, 2, 2, 3], [1, 1, 0, 0], "k", lw=0.8, zorder=0)
    left.plot([0, 1, 2, 3], [1, 0, 1, 1], "k", lw=0.8, zorder=0)
    force.set(xlabel="time (passages)", ylabel="force of the wall / exact", ylim=(-0.1, 1.6),
              title=pictures.title(results) + "; black: exact")
    left.set(xlabel="time (passages)", ylabel="kinetic energy / initial")
    pictures.error_axes(figure, lost, results, "lost", "kinetic energy lost", 1e-5)
    pictures.slope(lost, 1, 100, 4e-3)
    pictures.save(figure, file.parent, file.stem)


def judge(results):
    found = overview(results)
    last, default, standard = found.last, found.default, found.figures["L-monaghan1"]
    within = sum(abs(r.figures["contact"]) <= TARGETS["contact"] for r in last)
    return (f"At the finest resolution *correct* loses {default['lost']:.2%} of the kinetic energy, of it "
            f"{default['wall']:.2%} at the wall, and *monaghan 1 1* {standard['lost']:.2%}; {within} of {len(last)} "
            f"methods have the contact time within {TARGETS['contact']:.0%}.")

"""A standing longitudinal elastic wave: frequency, energy lost, order of convergence."""

import math

import bodies
import lattice
import methods
import stock
from catalogue import Figure, case, finest, overview, usual_cases
from histories import crossings, drift, slope
from running import columns, snapshots

TITLE = "Standing elastic wave"
PERIODS_OF_SHOT = 1.125     # see in.wave
SMALL, LARGE = 1e-6, 1e-3   # strains
PASSAGES = 20               # half periods after which the energy is looked at

ABOUT = r"""
A longitudinal wave stands in a periodic strip of iron (plane strain, elastic, :math:`K = \rho C^2` = 101.7 GPa,
:math:`\mu` = 80 GPa); n particles are one wavelength. The strain is 1e-6, so that nothing but the discretization
is seen. Continuum: :math:`\omega = c_L k` with :math:`c_L^2 = (K + \frac{4}{3} \mu)/\rho`, no loss, and
:math:`v = A \sin(k x) \cos(\omega t)`.

Plane waves are exact eigenmodes of particles on a lattice. With plain gradients (SR 18 and 19, at zero stress) a
wave along a row has

.. math::

   \frac{\omega}{c_L k} = s(k), \qquad s(k) = - \frac{1}{k} \sum_j V \, \frac{\partial W}{\partial x}(x_j) \sin(k x_j) ,

once from the strain rate and once from the force (for one dimension: Monaghan, Annu. Rev. Astron. Astrophys. 30, 543
(1992), and the literature on SPH dispersion since). Gradient correction divides both by
:math:`M = -\sum_j V \, x_j \, \partial W / \partial x = s(0)`, in the Eulerian and in the Lagrangian frame alike, hence

.. math::

   \frac{\omega}{c_L k} = \frac{s(k)}{s(0)} ,

which goes to 1 for long waves while the plain form keeps the error :math:`s(0) - 1` (+1.1 % for h = 1.3 spacings) at
any resolution. The frequency of the leapfrog in time, :math:`\sin(\frac{1}{2} \omega' \Delta t) = \frac{1}{2} \omega
\Delta t`, is part of the comparison.

The styles that come with LAMMPS run on the same lattice with a range of 3 spacings: *smd/ulsph* with gradient correction and
Q1 = 1, as in the Taylor rod of the examples; *sph/taitwater*, which is a fluid, with c = :math:`c_L` and :math:`\alpha` = 1.
They brake particles that move apart as well, or do not tell a wave from a shock.

*large* rows have a strain of 1e-3 instead, about where metals yield. Balsara's switch is
:math:`|\nabla \cdot v| / (|\nabla \cdot v| + |\nabla \times v| + 10^{-4} c/h)`: with a strain of 1e-6 the last term, which is
there to divide by something, is the largest, and the viscosity is off. It is no property of waves that *balsara* sees, and
its row without *large* does not count.

The profile is compared after a period and an eighth, since an error of phase would not show at a maximum.
"""

FIGURES = [
    Figure("lattice", "frequency against the lattice", "{:+.1e}"),
    Figure("frequency", "frequency against c_L k", "{:+.1e}", order=True),
    Figure("lost", "kinetic energy lost in 20 half periods", "{:.2e}"),
    Figure("profile", "L2 error of the velocity, t = 9/8 T", "{:.2e}", order=True),
    Figure("energy", "drift of the total energy", "{:.0e}"),
]
TARGETS = {"lattice": 1e-3, "lost": 1e-3, "energy": 1e-5}
ORDERS = {"profile": 1.5}


def cases(level):
    found = usual_cases("wave", level, (25, 50), (50, 100, 200), 0.5, cannot)
    if level == "report":
        found += [case("wave", methods.BY_KEY[key], n, 0.5 * (n / 50) ** 2, "-large", strain=LARGE)
                  for key in ("L-balsara1", "L-front", "L-correct") for n in (50, 100)]
    return found


def cannot(method):
    return stock.NO_PERIODIC if method.stock == "tlsph" else ""


# ---- figures ------------------------------------------------------------------------------------------------

def last_peak(t, y):
    """Height of the maximum around PASSAGES half periods, by a parabola through the three highest lines."""
    inside = [k for k in range(len(t) - 1) if t[k] > PASSAGES / 2 - 0.25]
    k = max(inside, key=lambda k: y[k])
    a, b, c = y[k - 1], y[k], y[k + 1]
    return b - (c - a) ** 2 / (8 * (a - 2 * b + c)) if a - 2 * b + c else b


def expected(case, step):
    """omega over c_L k on this lattice; step: of time, in periods of the exact wave."""
    k = 2 * math.pi / case.n
    exact = lattice.frequency(k, float(case.variables["h"]), case.method.gradient == "corrected")
    return lattice.leapfrog(exact * 2 * math.pi * step) / (2 * math.pi * step)


def profile_error(case):
    """L2 error of the velocity over that of the wave at its largest."""
    _, shot = snapshots(case.dump)[-1]
    now = math.cos(2 * math.pi * PERIODS_OF_SHOT)
    amplitude = case.variables.get("strain", SMALL) * 5152.4879    # in.wave: strain times c_L
    errors = [v / amplitude - now * math.sin(2 * math.pi * x) for v, x in zip(shot["vx"], shot["x"])]
    return math.sqrt(2 * sum(e * e for e in errors) / len(errors))


def measure(case):
    data = columns(case.csv)
    t, kinetic = data["periods"], data["kinetic_J"]
    omega = 0.5 / slope(crossings(t, data["amplitude"]))
    lattice_known = not case.method.stock    # the kernels of the others are not in lattice.py
    return {"lattice": omega / expected(case, t[2] - t[1]) - 1 if lattice_known else math.nan, "frequency": omega - 1,
            "lost": 1 - last_peak(t, kinetic) / kinetic[0], "profile": profile_error(case),
            "energy": drift(data["total_J"])}


# ---- judging ------------------------------------------------------------------------------------------------

FAITHFUL = ("none", "correct", "safe", "limited05", "limited2", "limited3")    # what they take from a wave vanishes with refinement


def faithful(method):
    return method.kind in FAITHFUL and not method.stock


def gates(case):
    if case.method.stock:
        return {}
    if "strain" in case.variables:
        return {"energy": 1e-12}
    strict = faithful(case.method) and case.n >= 50
    return {"lattice": 1e-5 if strict else 1e-3, "energy": 1e-12}


def order_gates(cases):
    """Smooth waves: second order; the corrected viscosity is a hyperviscosity, its loss falls with the third power."""
    method, gates = cases[0].method, {}
    if "strain" in cases[0].variables:
        return gates
    if faithful(method):
        gates["profile"] = 1.5
    if method.kind in ("correct", "safe"):
        gates["lost"] = 2.7
    return gates


def order_misses(cases):
    return {"profile": PLAIN} if cases[0].method.gradient == "plain" else {}


PLAIN = "plain gradients have an error of stiffness that does not depend on n"


def draw(results, file):
    import pictures
    figure, (left, right) = pictures.axes(2)
    large = [r for r in results if not r.failed and r.case.series == "L-balsara1-large"]
    results = bodies.main_series(results)
    for axes, name in ((left, "profile"), (right, "lost")):
        axes.loglog([r.case.n for r in large], [r.figures[name] for r in large], ":s", ms=4, color=pictures.COLOURS["balsara1"],
                    label="Lagrangian: balsara 1 1, large")
        pictures.convergence(axes, results, name, 1e-6)
    pictures.slope(left, 2, 50, 8e-3)
    right.axhline(TARGETS["lost"], color="k", lw=0.7)
    left.set(xlabel="particles a wavelength", ylabel="L2 error of the velocity at t = 9/8 T")
    right.set(xlabel="particles a wavelength", ylabel="kinetic energy lost in 20 half periods", title="black: aim")
    pictures.legend(figure, left)
    pictures.save(figure, file.parent, file.stem)


def judge(results):
    large = {r.case.method.key: r.figures["lost"] for r in finest(results) if "strain" in r.case.variables}
    found = overview(bodies.main_series(results))
    last, by_key = found.last, found.figures
    off = max(abs(r.figures["lattice"]) for r in last if not r.case.method.stock)
    kept = [key for key, got in by_key.items() if max(got["lost"], large.get(key, 0.0)) <= TARGETS["lost"]]
    first, standard = found.default, by_key["L-monaghan1"]
    plain = max(abs(r.figures["frequency"]) for r in last if r.case.method.gradient == "plain")
    return (f"At the finest resolution in every method of this package waves travel at the speed of their lattice, within {off:.0e}; plain "
            f"gradients leave {100 * plain:.1f} % against the continuum at any n. In 20 half periods *correct* loses "
            f"{100 * first['lost']:.4f} % of the kinetic energy and *monaghan 1 1* {100 * standard['lost']:.0f} %; "
            f"{len(kept)} of {len(last)} methods stay below {100 * TARGETS['lost']:g} %. With a strain of 1e-3 and n = 100 *balsara 1 1* loses "
            f"{100 * large['L-balsara1']:.0f} %, *front* {100 * large['L-front']:.2f} % and *correct* {100 * large['L-correct']:.2f} %.")

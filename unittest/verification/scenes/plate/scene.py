"""An oscillating plate, clamped by its end face or bonded in a channel: period and energy lost."""

import bodies
import methods
from catalogue import Figure, case, order, series
from running import columns, snapshots

TITLE = "Oscillating plate"
PERIOD = {"fixed": 0.2552, "channel": 0.2625}    # s
THIN = {"h": 0.8}                                # as doc/pair_sph_solid.rst recommends for thin bodies in bending

ABOUT = r"""
The plate of J. P. Gray, J. J. Monaghan and R. P. Swift (Comput. Methods Appl. Mech. Engrg. 190, 6641 (2001)): 0.2 m x 0.02 m, E = 2
MPa, :math:`\nu` = 0.3975, :math:`\rho` = 1000 kg/m\ :sup:`3`, plane strain, starts with the velocity of the first mode of a clamped
beam, at the tip a hundredth of the speed of sound :math:`\sqrt{K/\rho}`.

The usual comparison is with the thin plate, 0.2540 s. That is not the solution of this problem. Two-dimensional elasticity
(eigenvalues with biquadratic elements) has 0.2552 s when all displacements at x = 0 are held (*fixed*), and 0.2625 s when the plate
goes on into a channel of a quarter of its length and is bonded to the walls (*channel*). At this amplitude finite elements have
0.25553 s: it plays no part. Nothing is lost in truth.

n spacings are the depth, particles on the faces; the Lagrangian frame has h = 0.8 spacings, as recommended for thin bodies. The
input is that of *examples/elastic*. The period is the time of the second passage of the tip through its first position.
"""

FIGURES = [
    Figure("period", "period", "{:+.2e}", order=True),
    Figure("lost", "energy lost in a period", "{:.1e}", order=True),
    Figure("tip", "largest displacement of the tip (mm)", "{:.1f}"),
    Figure("total", "drift of the total energy", "{:.0e}"),
]
TARGETS = {"period": 0.01, "lost": 0.005, "total": 1e-9}


def cases(level):
    default = methods.BY_KEY[methods.DEFAULT]
    found = [plate(method, n) for method in methods.METHODS if not cannot(method) for n in sizes(method, level)]
    return found + [plate(default, n, "channel") for n in ((4,) if level == "test" else (5, 10, 14))]


def plate(method, n, clamp="fixed"):
    thin = THIN if method.frame == "lagrangian" else {}
    clamped = {"clamp": clamp, "suffix": "" if clamp == "fixed" else f"-{clamp}"} if not method.stock else {}
    return case("plate", method, n, weight=cost(method) * (n / 10) ** 3, **clamped, **thin)


def sizes(method, level):
    if level == "test":
        return (4,) if method.key in (methods.DEFAULT, "L-none", "L-monaghan1", "E-correct") else ()
    if method.key == methods.DEFAULT:
        return 5, 10, 20
    return (5, 10) if method.key in ("L-none", "L-monaghan1") else (5,)    # 20 s and more at n = 10


def cost(method):
    return 80.0 if method.stock else 30.0 if method.frame == "eulerian" else 10.0


def cannot(method):
    return "its pair styles are for fluids: no shear stress" if method.stock == "sph" else ""


# ---- figures ------------------------------------------------------------------------------------------------

def measure(case):
    data = columns(case.csv)
    exact, total = PERIOD[case.variables.get("clamp", "fixed")], data["total_J"]
    y = [tip - data["tip_mm"][0] for tip in data["tip_mm"]]
    times = bodies.crossings(data["t_s"], y)
    found = {"tip": max(map(abs, y)), "total": max(abs(e / total[0] - 1) for e in total)}
    if len(times) > 1:
        found["period"] = times[1] / exact - 1
    if "elastic_J" in data:
        left = (data["kinetic_J"][-1] + data["elastic_J"][-1]) / data["kinetic_J"][0]
        found["lost"] = (1 - left) / (data["t_s"][-1] / exact)
    return found


# ---- judging ------------------------------------------------------------------------------------------------

def gates(case):
    if case.method.stock:
        return {"total": 0.01}
    found = {"total": 1e-10, "period": 0.02 if case.n < 10 else 0.005}
    if case.method.key == methods.DEFAULT:
        found["lost"] = 0.02 if case.n < 10 else 0.005
    return found


def misses(case):
    return {"period": "the kernel of the Eulerian frame smooths strain through the depth"} if case.method.frame == "eulerian" else {}


def draw(results, file):
    import pictures
    figure, (left, right) = pictures.axes(2)
    for each in (r for r in bodies.main_series(results) if r.case.n == 5):
        data, method = columns(each.case.csv), each.case.method
        left.plot(data["t_s"], [y - data["tip_mm"][0] for y in data["tip_mm"]], label=pictures.label(method), **pictures.look(method))
    for k in (1, 2):
        left.axvline(k * PERIOD["fixed"] / 2, color="k", lw=0.7)
    left.set(xlabel="time (s)", ylabel="tip (mm)", title="fixed, n = 5; black: exact zero crossings")
    for name, mark in ((methods.DEFAULT, "o"), (methods.DEFAULT + "-channel", "s")):
        group = series(results)[name]
        right.loglog([r.case.n for r in group], [abs(r.figures["period"]) for r in group], "C3", marker=mark, ms=4,
                     label=f"{group[0].case.variables['clamp']}, period")
        right.loglog([r.case.n for r in group], [r.figures["lost"] for r in group], "C0", marker=mark, ms=4,
                     label=f"{group[0].case.variables['clamp']}, energy lost in a period")
    right.set_xticks([5, 10, 14, 20], ["5", "10", "14", "20"])
    right.minorticks_off()
    right.set(xlabel="spacings through the depth", ylabel="relative error", title="correct, Lagrangian frame")
    right.legend(fontsize=7)
    pictures.legend(figure, left)
    pictures.save(figure, file.parent, file.stem)


def judge(results):
    runs = series(results)
    fixed, channel = runs[methods.DEFAULT], runs[methods.DEFAULT + "-channel"]

    def periods(group):
        return ", ".join(f"{100 * r.figures['period']:+.2f} % (n = {r.case.n})" for r in group)

    eulerian = [r.figures["period"] for r in results if not r.failed and r.case.method.key.startswith("E-") and "period" in r.figures]
    return (f"With *correct* the period is off by {periods(fixed)} with a fixed face, by {periods(channel)} in the channel. "
            f"{100 * fixed[-1].figures['lost']:.2f} % of the energy is lost in a period with n = {fixed[-1].case.n}, less with order "
            f"{order(fixed, 'lost'):.1f}. " +
            (f"In the Eulerian frame with n = 5 the plate is too soft, by {100 * min(eulerian):.0f} to {100 * max(eulerian):.0f} % in the "
             "period where there is one." if eulerian else "In the Eulerian frame there is no period to speak of."))

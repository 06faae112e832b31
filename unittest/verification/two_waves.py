"""Elastic precursor and plastic shock behind a wall: what the scenes piston and impact measure, judge and draw.

The body moves with -u against the plane x = 0, so that everything is seen from the wall."""

import methods
import plane_shock
import profiles
import shock
from catalogue import Figure, overview
from histories import drift
from running import columns

FIGURES = [
    Figure("hel", "Hugoniot elastic limit", "{:+.2%}"),
    Figure("elastic", "speed of the precursor", "{:+.2%}"),
    Figure("plastic", "speed of the shock", "{:+.2%}"),
    Figure("plateau", "stress of the plateau", "{:+.2%}"),
    Figure("deviator", "its deviator", "{:+.0%}"),
    Figure("heat", "its energy", "{:+.2%}"),
    Figure("overshoot", "overshoot of the stress", "{:.1%}"),
    Figure("ripple", "ripple of the plateau (rms)", "{:.2%}"),
    Figure("face", "stress of the column at the wall", "{:+.0%}"),
    Figure("l1", "L1 error of the stress", "{:.2%}", order=True),
    Figure("l1_shock", "L1 error, shock alone", "{:.2%}", order=True),
    Figure("energy", "drift of the total energy", "{:.0e}"),
]
TARGETS = {"hel": 0.005, "elastic": 0.005, "plastic": 0.005, "plateau": 0.003, "energy": 1e-5}
ORDERS = {"l1": 0.9, "l1_shock": 0.9}


class Problem:
    """A solid that runs into the wall with a velocity; length: of the body, all that counts is before its far end."""

    def __init__(self, solid, u, length):
        self.solid, self.u, self.length = solid, u, length
        self.first, self.second = shock.piston(solid, u)

    def fronts(self, t):
        """Places of the shock and of the precursor."""
        return (self.second.speed - self.u) * t, (self.first.speed - self.u) * t

    def stress(self, t):
        """The exact profile, positive in compression."""
        shock_at, precursor_at = self.fronts(t)
        return lambda x: self.second.stress if x < shock_at else self.first.stress if x < precursor_at else 0.0

    def seen(self, case):
        """(time, x, stress, profile) of the snapshots after the first."""
        for t, found in profiles.over_time(case.dump)[1:]:
            yield t, found["x"], [-s for s in found["sxx"]], found

    def measure(self, case):
        (t1, x1, s1, _), (t2, x2, s2, last) = list(self.seen(case))[:2]
        a, b = self.fronts(t2)

        def speed(level):
            return (profiles.front(x2, s2, level) - profiles.front(x1, s1, level)) / (t2 - t1) + self.u

        quarter = 0.25 * (b - a)
        middle = 0.5 * (self.first.stress + self.second.stress)
        data = columns(case.csv)
        return {
            "hel": profiles.mean(x2, s2, a + quarter, b - quarter) / self.first.stress - 1,
            "elastic": speed(0.5 * self.first.stress) / self.first.speed - 1,
            "plastic": speed(middle) / self.second.speed - 1,
            "plateau": profiles.mean(x2, s2, 0.2 * a, 0.8 * a) / self.second.stress - 1,
            "deviator": profiles.mean(x2, [s - p for s, p in zip(s2, last["p"])], 0.2 * a, 0.8 * a) /
                        (2 * self.solid.Y / 3) - 1,
            "heat": profiles.mean(x2, last["e"], 0.2 * a, 0.8 * a) / self.second.e - 1,
            "overshoot": max(s for x, s in zip(x2, s2) if x > 0.5 * a) / self.second.stress - 1,
            "ripple": profiles.deviation(x2, s2, 0.2 * a, 0.8 * a) / self.second.stress,
            "face": s2[0] / self.second.stress - 1,
            "l1_shock": profiles.l1(x2, s2, self.stress(t2), 0.5 * a, 0.5 * (a + b)),
            "l1": profiles.l1(x2, s2, self.stress(t2), 0.0, 1.1 * b),
            "energy": drift(data["total_J"]),
        }

    # ---- the page -------------------------------------------------------------------------------------------

    def draw(self, results, file, unit_x, name_x):
        """Profiles of the viscosities in the default frame at the finest resolution, and the L1 error of all."""
        import pictures
        figure, (whole, near, errors) = pictures.axes(3, width=3.7)
        top = self.second.stress / 1e9
        for r, colour in pictures.finest_lagrangian(results):
            t, x, stress, _ = list(self.seen(r.case))[-1]
            top = max(top, (1 + r.figures["overshoot"]) * self.second.stress / 1e9)
            for axes in (whole, near):
                axes.plot([v / unit_x for v in x], [s / 1e9 for s in stress], lw=1, color=colour)
        a, b = self.fronts(t)
        steps = [0, a, a, b, b, 1.15 * b]
        levels = [self.second.stress] * 2 + [self.first.stress] * 2 + [0, 0]
        for axes in (whole, near):
            axes.plot([s / unit_x for s in steps], [v / 1e9 for v in levels], "k", lw=0.8, zorder=0)
            axes.set(xlabel=f"distance from the wall ({name_x})", ylabel="stress (GPa)")
        near.set(xlim=(0.9 * a / unit_x, 1.06 * a / unit_x), ylim=(0.8 * self.second.stress / 1e9, 1.02 * top), title="the shock")
        whole.set(title=pictures.title(results) + "; black: exact")
        pictures.error_axes(figure, errors, results, "l1", "L1 error of the stress")
        pictures.save(figure, file.parent, file.stem)


# ---- judging ------------------------------------------------------------------------------------------------

FINEST = 800    # cells at which the targets are to be met


# causes of known misses
EXCESS = ("the precursor overshoots on the lattice; what exceeds the yield stress flows, goes on with the slower plastic "
          "speed, and the excess behind the front decays slowly with refinement")
FOOT = "the foot of the smeared shock reaches into the plateau of the precursor"
UNLOADED = ("what overshoots unloads again, elastically, and takes its share of the deviator along: plateau and shock "
            "speed stay short of the exact ones at any resolution")


def gates(case, problem, interval):
    """At the finest resolution the targets. On coarser lattices, and with stiffness right: each front within one spacing
    after the interval of time, and where nothing overshoots the plateau as it has to be."""
    found = {"energy": 1e-12}
    if case.n >= FINEST:
        found.update(TARGETS, energy=1e-12)
    elif case.method.gradient == "corrected" and case.n >= 200:
        spacing = problem.length / case.n
        found["elastic"] = spacing / (problem.first.speed * interval)
        found["plastic"] = spacing / (problem.second.speed * interval)
        if plane_shock.calm(case.method):
            found["plateau"] = TARGETS["plateau"]
    return found


def order_gates(cases):
    """A linear front that a method of order p spreads converges with p/(p + 1) in L1: 1/2 with a viscosity."""
    return plane_shock.order_gates(cases, 0.45)


def judge(results):
    found = overview(results, "l1")
    last, default = found.last, found.default
    missed = [f.text for f in FIGURES if f.name in TARGETS and not abs(default[f.name]) <= TARGETS[f.name]]
    least = min(last, key=lambda r: r.figures["l1"])
    calm = min(last, key=lambda r: r.figures["overshoot"])
    return (f"*correct* in the Lagrangian frame {'misses: ' + ', '.join(missed) if missed else 'meets all targets'}; its "
            f"stress overshoots by {default['overshoot']:.1%}, its L1 error of {default['l1']:.2%} at n = "
            f"{max(r.case.n for r in last)} falls with order {found.orders[methods.DEFAULT]:.2f}. The smallest L1 error has "
            f"*{least.case.method.title}* ({least.case.method.group}) with {least.figures['l1']:.2%}, the least overshoot "
            f"*{calm.case.method.title}* ({calm.case.method.group}) with {calm.figures['overshoot']:.1%}; "
            f"{found.reach(ORDERS['l1'])} order {ORDERS['l1']:g}.")

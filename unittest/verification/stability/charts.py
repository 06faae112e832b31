"""The charts, as data: which run stands in which cell. Add a line here, and runs, pictures and page follow."""

import pathlib
from dataclasses import dataclass, field

HERE = pathlib.Path(__file__).resolve().parent
ROOT = HERE.parents[2]
TAYLOR, ELASTIC = ROOT / "examples/taylor", ROOT / "examples/elastic"
OUTPUT = HERE / "output"


@dataclass
class Run:
    chart: str
    panel: str
    row: str
    column: str
    scene: str                  # rod, strip, square, turning, growth: how it is judged
    folder: pathlib.Path        # where it runs
    script: str
    variables: dict = field(default_factory=dict)
    weight: float = 1.0         # expected run time, s
    output: pathlib.Path = OUTPUT

    def __post_init__(self):
        self.name = "_".join((self.chart, self.panel, self.row, self.column)).replace(" ", "-").replace("/", "-").replace(",", "")
        self.variables = {**self.variables, "out": self.output}


@dataclass
class Form:
    title: str
    frame: str
    gradient: str
    h: float                    # in spacings, as recommended


FORMS = {
    "lagrangian": Form("frame lagrangian", "lagrangian", "corrected", 1.0),
    "eulerian": Form("frame eulerian, gradient corrected", "eulerian", "corrected", 1.5),
    "plain": Form("frame eulerian, gradient plain", "eulerian", "plain", 1.5),
}
METHODS = {                     # row of a chart: viscosity
    "none": "none",
    "monaghan 0.2": "monaghan 0.2 0.2",
    "monaghan 0.5": "monaghan 0.5 0.5",
    "monaghan 1": "monaghan 1 1",
    "correct": "correct",
    "weights safe": "correct weights safe",
    "limited 0.5": "limited 0.5 0.5",
    "balsara 1": "balsara 1 1",
    "front": "front",
}
PAIRS = {                       # viscosities with coefficients a1, a2
    "monaghan": "monaghan {} {}",
    "correct": "correct alpha {} {}",
    "weights safe": "correct weights safe alpha {} {}",
    "limited": "limited {} {}",
    "balsara": "balsara {} {}",
    "front": "front alpha {} {}",
}

COEFFICIENTS = (0.0, 0.25, 0.5, 1.0, 1.5, 2.0, 2.5)
SMOOTHING = {"lagrangian": (0.8, 0.9, 1.0, 1.1, 1.2, 1.3, 1.4, 1.5),
             "eulerian": (1.0, 1.1, 1.2, 1.3, 1.4, 1.5, 1.6, 1.7, 1.8, 1.9, 2.0)}
COURANT = (0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0.7, 0.8, 0.9, 1.0, 1.2, 1.5, 2.0, 3.0)
SPEEDS = (50, 100, 150, 200, 300, 400, 500, 600, 800, 1000)
RATES = (10, 30, 100, 300, 1000, 3000)
JITTERS = (0.0, 0.05, 0.1, 0.15, 0.25)
LOADS = (-1000, -300, -100, 0, 100, 300, 1000)


def rod(chart, panel, row, column, form, viscosity, weight=0.6, **more):
    """The Taylor rod at half the resolution: 11 x 34 particles."""
    form = FORMS[form]
    cfl, tend = float(more.get("cfl", 0.3)), float(more.get("tend", 50e-6))
    variables = {"frame": form.frame, "gradient": form.gradient, "h": form.h, "viscosity": viscosity, "refine": 0.5,
                 "half": 0.1, "cfl": cfl, "steps": round(9000 * 0.3 / cfl * tend / 50e-6), **more}
    return Run(chart, panel, row, str(column), "rod", TAYLOR, "in.taylor", variables, weight * 0.3 / cfl)


def methods(quick):
    return {key: METHODS[key] for key in ("none", "correct")} if quick else METHODS


def thin(values, quick):
    """A coarse grid: first and last."""
    return [values[0], values[-1]] if quick else values


def coefficients(quick):
    for form in FORMS:
        for key, words in PAIRS.items():
            for a2 in thin(COEFFICIENTS, quick):
                for a1 in thin(COEFFICIENTS, quick):
                    yield rod("coefficients", f"{form} {key}", str(a2), a1, form, words.format(a1, a2))


def by_method(chart, values, quick, **fixed):
    """One panel a form, one row a viscosity; values(form) gives column and variables."""
    for form in FORMS:
        for key, viscosity in methods(quick).items():
            for column, variables in values(form):
                yield rod(chart, form, key, column, form, viscosity, **{**fixed, **variables})


def smoothing(quick):
    def values(form):
        frame = FORMS[form].frame
        return [(h, {"h": h}) for h in thin(SMOOTHING[frame], quick)]
    yield from by_method("smoothing", values, quick)


def courant(quick):
    yield from by_method("courant", lambda form: [(cfl, {"cfl": cfl}) for cfl in thin(COURANT, quick)], quick)


def speed(quick):
    yield from by_method("speed", lambda form: [(v, {"speed": f"{v}.0"}) for v in thin(SPEEDS, quick)], quick,
                         tend="80e-6", weight=1.2)


def strip(chart, panel, row, column, form, viscosity, rate=100.0, h=1.3, options="", **more):
    """The strip of examples/elastic, 24 x 6 particles, pulled by 10 %."""
    form = FORMS[form]
    words = f"gradient {form.gradient} {options}".strip()
    variables = {"frame": form.frame, "h": h, "viscosity": viscosity, "options": words, "rows": 6, "stretch": 0.1,
                 "rate": rate, "cfl": 0.3, "every": max(1, round(300 / rate)), "steps": round(1e6 / rate), **more}
    return Run(chart, panel, row, str(column), "strip", ELASTIC, "in.strip", variables, 0.2 + 20 / rate)


def tension(quick):
    panels = (("lagrangian", "lagrangian", ""), ("eulerian", "eulerian", ""), ("plain", "plain", ""),
              ("eulerian, artificial", "eulerian", "tensile artificial 0.3 4"))
    for panel, form, options in panels:
        for key, viscosity in methods(quick).items():
            for rate in ((100,) if quick else RATES):
                yield strip("tension", panel, key, rate, form, viscosity, float(rate), options=options)


def grow(panel, row, column, tension, h, mode=1, gradient="corrected", viscosity="none", options=""):
    return Run("growth", panel, row, str(column), "growth", HERE, "in.tension",
               {"tension": tension, "h": h, "mode": mode, "gradient": gradient, "viscosity": viscosity, "options": options,
                "tend": 1000.0 if panel != "artificial" else 400.0}, 0.5)


def growth(quick):
    tensions = (1e-2,) if quick else (5e-4, 1e-3, 2e-3, 5e-3, 1e-2, 2e-2, 5e-2)
    for h in ((1.3,) if quick else (1.2, 1.3, 1.4, 1.5)):
        for T in tensions:
            yield grow("tension", str(h), T, T, h)
    for gradient in ("corrected", "plain"):
        for h in ((1.3,) if quick else (1.0, 1.1, 1.2, 1.3, 1.4, 1.5, 1.6, 1.7, 1.8, 2.0)):
            for mode in (1, 2, 3):
                yield grow("smoothing", f"{gradient} {mode}", h, 0.02, h, mode, gradient)
    for key in METHODS:
        for h in ((1.3,) if quick else (1.2, 1.3, 1.4)):
            yield grow("viscosity", key, h, 0.02, h, viscosity=METHODS[key])
    for h in ((1.3,) if quick else (1.0, 1.1, 1.2, 1.3, 1.4, 1.5, 1.6, 1.7, 1.8, 2.0)):
        for mode in (1, 2, 3):
            yield grow("artificial", str(mode), h, 0.02, h, mode, options="tensile artificial 0.3 4")


def square(chart, panel, row, column, form, viscosity, h, **more):
    """The free square of examples/elastic, 10 x 10 particles, a quarter of a turn."""
    form = FORMS[form]
    variables = {"frame": form.frame, "h": h, "viscosity": viscosity, "options": f"gradient {form.gradient}", "rows": 10,
                 "speed": 25.0, "turns": 0.25, "prestress": 0, "cfl": 0.3, "every": 50, "steps": 40000, **more}
    return Run(chart, panel, row, str(column), "square", ELASTIC, "in.square", variables, 1.0)


def jitter(quick):
    columns = (0.0, 0.25) if quick else JITTERS
    for key, viscosity in methods(quick).items():
        for value in columns:
            for form in FORMS:
                h = 1.3 if form == "lagrangian" else 1.5
                yield rod("jitter", f"rod {form}", key, value, form, viscosity, h=h, jitter=value)
                yield strip("jitter", f"strip {form}", key, value, form, viscosity, h=1.3, jitter=value)
                yield square("jitter", f"square {form}", key, value, form, viscosity, h, jitter=value)


def turning(quick):
    for form, settings in FORMS.items():
        for key, viscosity in methods(quick).items():
            for load in thin(LOADS, quick):
                variables = {"frame": settings.frame, "h": settings.h, "viscosity": viscosity, "cfl": 0.3,
                             "options": f"gradient {settings.gradient}", "load": f"{load}e6", "steps": 60000}
                yield Run("turning", form, key, str(load), "turning", HERE, "in.turning", variables, 1.0)


CHARTS = {"coefficients": coefficients, "smoothing": smoothing, "courant": courant, "speed": speed, "tension": tension,
          "growth": growth, "jitter": jitter, "turning": turning}

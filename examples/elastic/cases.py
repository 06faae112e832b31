"""The runs of this example, as data: add a line here and run, tables and pictures follow."""

from dataclasses import dataclass, field


@dataclass
class Case:
    name: str                   # of the files in output/
    scene: str                  # plate, strip, ring or square: script and table
    title: str                  # viscosity, in the table
    frame: str
    h: float                    # in spacings
    jitter: float               # in spacings
    variables: dict = field(default_factory=dict)
    gated: bool = False         # must meet the figures in measure.py
    may_fail: bool = False      # a run that shows how a body breaks
    quick: bool = False         # part of the short version
    weight: float = 1.0         # expected run time, relative

    @property
    def script(self):
        return f"in.{self.scene}"


VISCOSITIES = {"none": ("none", "none"), "0.5": ("(0.5, 0.5)", "monaghan 0.5 0.5"), "correct": ("correct", "correct")}


def case(scene, key="correct", frame="lagrangian", h=1.0, jitter=0.0, suffix="", weight=1.0, **more):
    title, viscosity = VISCOSITIES[key]
    flags = {name: more.pop(name) for name in ("gated", "may_fail", "quick") if name in more}
    name = f"{scene}-{frame}-h{h}-{key}" + (f"-jitter{jitter}" if jitter else "") + suffix
    variables = {"frame": frame, "viscosity": viscosity, "h": h, "jitter": jitter,
                 "cfl": 0.3 if frame == "eulerian" else 0.6, **more}
    neighbours = {0.8: 1.0, 1.0: 1.3, 1.3: 2.0}[h] * (3.0 if frame == "eulerian" else 1.0)
    return Case(name, scene, title, frame, h, jitter, variables, weight=weight * neighbours, **flags)


def plate(rows, clamp, **more):
    return case("plate", suffix=f"-{clamp}-{rows}", rows=rows, clamp=clamp, weight=6.0 * (rows / 10) ** 3, **more)


EULERIAN = {"frame": "eulerian", "h": 1.3, "may_fail": True}
JITTERS = (0.10, 0.25)

CASES = [
    plate(10, "channel", h=0.8, gated=True, quick=True),
    plate(10, "channel", h=1.0),
    plate(10, "channel", h=1.3),
    plate(10, "fixed", h=0.8, gated=True),
    plate(10, "fixed", h=1.0),
    plate(10, "fixed", h=1.3),
    plate(20, "channel", h=0.8, gated=True),
    plate(20, "channel", h=1.0),
    plate(20, "fixed", h=0.8, gated=True),
    plate(10, "channel", h=0.8, key="none"),
    plate(10, "channel", h=0.8, key="0.5"),
    *(plate(10, "channel", h=1.3, jitter=jitter) for jitter in JITTERS),
    plate(10, "channel", **EULERIAN),
    plate(10, "channel", key="0.5", **EULERIAN),

    case("strip", h=0.8, gated=True),
    case("strip", h=1.0, gated=True, quick=True),
    case("strip", h=1.3, gated=True),
    *(case("strip", h=1.3, jitter=jitter, may_fail=True) for jitter in JITTERS),    # see README: the lattice creeps
    case("strip", **EULERIAN),
    case("strip", key="0.5", **EULERIAN),

    case("ring", h=1.0, gated=True, weight=8.0),
    case("ring", h=1.0, key="0.5", gated=True, weight=8.0),
    *(case("ring", h=1.3, jitter=jitter, gated=True, weight=8.0) for jitter in JITTERS),
    case("ring", weight=8.0, **EULERIAN),
    case("ring", key="0.5", weight=8.0, **EULERIAN),

    case("square", h=1.0, gated=True, weight=15.0),
    *(case("square", h=1.3, jitter=jitter, weight=15.0) for jitter in JITTERS),
    case("square", weight=15.0, **EULERIAN),
    case("square", h=1.0, gated=True, suffix="-slow", rows=8, speed=0.1, prestress=0, every=20000, weight=100.0),
]
BY_NAME = {case.name: case for case in CASES}

"""The runs of this example, as data: add a line here and run, table and pictures follow."""

from dataclasses import dataclass, field


@dataclass
class Case:
    name: str                   # of the files in output/
    title: str                  # viscosity, in the table and the pictures
    frame: str
    refine: int
    h: float                    # in spacings
    tend: float                 # ms
    variables: dict = field(default_factory=dict)
    script: str = "in.parkes"
    gated: bool = False         # must agree with the finite elements
    may_fail: bool = False      # a run that shows how a body breaks
    levels: tuple = (1, 2)      # of the runs it is part of: 0 short, 1 ordinary, 2 long
    weight: float = 1.0         # expected run time, relative


LATTICES = {1: "201 x 5", 2: "401 x 9", 4: "801 x 17"}
VISCOSITIES = {                 # name of the files, title, viscosity
    "none": ("none", "none"),
    "0.1": ("(0.1, 0.1)", "monaghan 0.1 0.1"),
    "0.5": ("(0.5, 0.5)", "monaghan 0.5 0.5"),
    "correct": ("correct", "correct"),
}


def name_of(key, frame="lagrangian", refine=1, h=0.8, suffix=""):
    return f"{frame}-{refine}x-h{h}-{key}{suffix}"


def beam(key, frame="lagrangian", refine=1, h=0.8, tend=25.0, suffix="", levels=(1, 2), gated=False, may_fail=False, **more):
    title, viscosity = VISCOSITIES[key]
    variables = {"frame": frame, "viscosity": viscosity, "h": h, "refine": refine, "tend": f"{tend:g}e-3",
                 "cfl": 0.3 if frame == "eulerian" else 0.6, "every": 100 * refine, **more}
    neighbours = {0.8: 1.0, 1.0: 1.2, 1.3: 1.6}[h] * (1.5 if frame == "eulerian" else 1.0)
    return Case(name_of(key, frame, refine, h, suffix), title, frame, refine, h, tend, variables, gated=gated,
                may_fail=may_fail, levels=levels, weight=neighbours * refine ** 3 * tend / 25.0)


CASES = [
    beam("correct", tend=3.0, suffix="-3ms", levels=(0,), gated=True),
    *(beam(key, gated=key == "correct") for key in VISCOSITIES),
    beam("correct", h=1.0),
    *(beam(key, h=1.0, tend=3.0) for key in VISCOSITIES if key != "correct"),
    beam("correct", h=1.3),
    beam("correct", suffix="-C4797", C=4797),
    # the Eulerian frame: where the block shears off, it does so early
    beam("none", "eulerian", h=1.3, tend=3.0, may_fail=True),
    beam("0.1", "eulerian", h=1.3, tend=3.0, may_fail=True),
    beam("0.5", "eulerian", h=1.3, tend=5.0, may_fail=True),
    beam("correct", "eulerian", h=1.3, tend=5.0, may_fail=True),
    beam("correct", "eulerian", refine=2, h=1.3, tend=3.0, may_fail=True),
    # finer lattices
    beam("correct", refine=2, tend=3.0, suffix="-3ms", levels=(1,), gated=True),
    *(beam(key, refine=2, tend=3.0, suffix="-3ms") for key in VISCOSITIES if key != "correct"),
    beam("correct", refine=2, levels=(2,), gated=True),
    beam("correct", refine=2, h=1.0, tend=3.0, levels=(1,)),
    *(beam(key, refine=2, h=1.0, tend=3.0, levels=(1,)) for key in VISCOSITIES if key != "correct"),
    *(beam(key, refine=4, tend=3.0, levels=(2,)) for key in VISCOSITIES),
]
BY_NAME = {case.name: case for case in CASES}

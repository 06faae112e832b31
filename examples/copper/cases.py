"""The runs of this example, as data: add a line here and run, table and pictures follow."""

from dataclasses import dataclass, field


@dataclass
class Case:
    name: str                   # of the files in output/
    title: str                  # viscosity, in the table
    frame: str
    radius: int                 # particles in the radius
    h: float                    # in spacings
    wall: str
    quarter: bool
    variables: dict = field(default_factory=dict)
    script: str = "in.copper"
    gated: bool = False         # must agree with the finite elements
    may_fail: bool = False      # a run that shows how a body breaks
    level: int = 1              # 0: also in the short version; 2: in the long version only
    weight: float = 1.0         # expected run time, relative


VISCOSITIES = {"none": "none", "0.5": "monaghan 0.5 0.5", "correct": "correct"}
TITLES = {"none": "none", "0.5": "(0.5, 0.5)", "correct": "correct"}


def bar(radius, key="correct", frame="lagrangian", h=1.0, wall="symmetry", quarter=False, **more):
    name = f"{frame}-r{radius}-h{h}-{wall}-{key}" + ("-quarter" if quarter else "")
    variables = {"frame": frame, "viscosity": VISCOSITIES[key], "h": h, "radius": radius, "wall": wall,
                 "quarter": "yes" if quarter else "no", "cfl": 0.3 if frame == "eulerian" else 0.6}
    if frame == "eulerian":
        variables["options"] = "tensile none"
    weight = (radius / 9) ** 4 * (0.3 if quarter else 1.0) * {1.0: 1.0, 1.3: 2.0}[h] * (2.0 if frame == "eulerian" else 1.0)
    return Case(name, TITLES[key], frame, radius, h, wall, quarter, variables, weight=weight, **more)


CASES = [
    bar(6, level=0),
    bar(6, quarter=True, level=0),
    bar(9, gated=True),
    bar(9, quarter=True),
    bar(9, key="none", quarter=True),
    bar(9, key="0.5", quarter=True),
    bar(9, h=1.3, quarter=True),
    bar(9, wall="contact", quarter=True),
    bar(9, frame="eulerian", h=1.3, quarter=True, may_fail=True),
    bar(12, quarter=True, level=2),
]
BY_NAME = {case.name: case for case in CASES}

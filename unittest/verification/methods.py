"""The methods that every verification scene is run with, as data: add a line here and all tables get a row.

A method of this package is a set of variables for the input in.<scene>. One of the styles that come with LAMMPS has
an input of its own, in.<scene>.<package>; a scene says in cannot(method) why it has none."""

from dataclasses import dataclass, field


@dataclass(frozen=True)
class Method:
    key: str                # in file names and data
    title: str              # in tables
    group: str              # rows of a group stand together
    stock: str = ""         # a style that comes with LAMMPS: ulsph, tlsph, sph
    package: str = ""       # of that style: ending of its input
    variables: dict = field(default_factory=dict, compare=False)
    gradient: str = ""      # corrected or plain
    frame: str = ""

    @property
    def kind(self):
        """Which viscosity: the key without the letter of the frame."""
        return self.key.split("-")[-1]

    @property
    def whole(self):
        """Is the viscosity whole in a shock?"""
        return self.kind.startswith(("monaghan", "balsara", "front"))

    @property
    def little(self):
        """Does it take next to nothing from a smooth flow, and little from a shock?"""
        return self.kind in ("correct", "safe", "none", "limited05")

    def script(self, scene):
        return f"in.{scene}.{self.package}" if self.package else f"in.{scene}"


H = {"lagrangian": 1.0, "eulerian": 1.3}      # smoothing length in spacings, as doc/pair_sph_solid.rst recommends for waves
CFL = {"lagrangian": 0.6, "eulerian": 0.3}    # the same for all scenes, and no more than auto takes (doc/fix_sph_solid_dt.rst)


def ours(key, viscosity, frame="lagrangian", gradient="corrected", title=None, **variables):
    group = "Lagrangian frame" if frame == "lagrangian" else f"Eulerian frame, {gradient} gradients"
    initial = {"lagrangian": "L", "eulerian": "E" if gradient == "corrected" else "P"}[frame]
    settings = {"frame": frame, "viscosity": viscosity, "gradient": gradient, "h": H[frame], "cfl": CFL[frame]}
    return Method(f"{initial}-{key}", title or viscosity, group, "", "", {**settings, **variables}, gradient, frame)


METHODS = [
    ours("correct", "correct"),
    ours("none", "none"),
    ours("monaghan05", "monaghan 0.5 0.5"),
    ours("monaghan1", "monaghan 1 1"),
    ours("limited05", "limited 0.5 0.5"),
    ours("limited2", "limited 2 2"),
    ours("limited3", "limited 3 3"),
    ours("balsara1", "balsara 1 1"),
    ours("safe", "correct weights safe"),
    ours("front", "front"),
    ours("correct", "correct", "eulerian"),
    ours("none", "none", "eulerian"),
    ours("monaghan05", "monaghan 0.5 0.5", "eulerian"),
    ours("monaghan1", "monaghan 1 1", "eulerian"),
    ours("limited2", "limited 2 2", "eulerian"),
    ours("safe", "correct weights safe", "eulerian"),
    ours("front", "front", "eulerian"),
    ours("correct", "correct", "eulerian", "plain"),
    ours("monaghan1", "monaghan 1 1", "eulerian", "plain"),
    Method("ulsph", "smd/ulsph (MACHDYN)", "styles that come with LAMMPS", "ulsph", "smd", {"style": "ulsph"}),
    Method("tlsph", "smd/tlsph (MACHDYN)", "styles that come with LAMMPS", "tlsph", "smd", {"style": "tlsph"}),
    Method("sph", "sph/* (SPH)", "styles that come with LAMMPS", "sph", "sph"),
]
BY_KEY = {method.key: method for method in METHODS}
DEFAULT = "L-correct"    # what a user gets who sets nothing

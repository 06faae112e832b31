"""What is measured, as data: add a line here, and runs and tables follow."""

from dataclasses import dataclass, field

H = {"lagrangian": 1.0, "eulerian": 1.3}    # in spacings, as doc/pair_sph_solid.rst recommends


@dataclass(frozen=True)
class Variant:
    key: str
    title: str
    h: float                # half of the kernel's range, in spacings
    script: str = "in.block"
    variables: dict = field(default_factory=dict, compare=False)
    main: bool = False      # measured at 10^5 particles too
    large: bool = False     # and at 10^6 and more
    shared: bool = False    # with two ranks and two threads too
    ranks: int = 1
    threads: int = 1

    def on(self, ranks, threads):
        suffix = f"-{ranks}r{threads}t"
        return Variant(self.key + suffix, f"{self.title}, {ranks} rank{'s' * (ranks > 1)}, {threads} thread{'s' * (threads > 1)}",
                       self.h, self.script, self.variables, self.main, ranks=ranks, threads=threads)


def ours(key, frame, viscosity="correct", title=None, h=None, main=False, large=False, shared=False, **variables):
    h = h or H[frame]
    return Variant(key, title or f"{frame}, {viscosity}", h, "in.block",
                   {"frame": frame, "viscosity": viscosity, "h": h, **variables}, main, large, shared)


def stock(key, title, style, h, main=False, **variables):
    return Variant(key, title, h, "in.block.smd", {"style": style, "h": h, **variables}, main)


VARIANTS = [
    ours("L-correct", "lagrangian", main=True, large=True, shared=True),
    ours("L-correct-mixed", "lagrangian", title="lagrangian, correct, precision mixed", main=True, large=True, shared=True, options="precision mixed"),
    ours("L-none", "lagrangian", "none"),
    ours("L-monaghan", "lagrangian", "monaghan 1 1"),
    ours("L-monaghan-mixed", "lagrangian", title="lagrangian, monaghan 1 1, precision mixed", viscosity="monaghan 1 1", options="precision mixed"),
    ours("L-limited", "lagrangian", "limited 1 1"),
    ours("L-correct-h1.3", "lagrangian", title="lagrangian, correct, h 1.3", h=1.3),
    ours("E-correct", "eulerian", main=True, large=True, shared=True),
    ours("E-correct-mixed", "eulerian", title="eulerian, correct, precision mixed", main=True, large=True, shared=True, options="precision mixed"),
    ours("E-none", "eulerian", "none"),
    ours("E-monaghan", "eulerian", "monaghan 1 1"),
    ours("E-monaghan-mixed", "eulerian", title="eulerian, monaghan 1 1, precision mixed", viscosity="monaghan 1 1", options="precision mixed"),
    ours("E-correct-plain", "eulerian", title="eulerian, correct, plain", gradient="plain"),
    ours("E-monaghan-plain", "eulerian", "monaghan 1 1", title="eulerian, monaghan 1 1, plain", gradient="plain"),
    stock("ulsph-h1.3", "smd/ulsph", "ulsph", 1.3, main=True),
    stock("ulsph-h1.0", "smd/ulsph", "ulsph", 1.0),
    stock("ulsph-corrected", "smd/ulsph, gradient correction", "ulsph", 1.3, correction="*GRADIENT_CORRECTION"),
    stock("tlsph-h1.3", "smd/tlsph", "tlsph", 1.3, main=True),
    stock("tlsph-h1.0", "smd/tlsph", "tlsph", 1.0),
]
BY_KEY = {variant.key: variant for variant in VARIANTS}

# What each feature costs, in instructions: (title, variant of VARIANTS or variables over those of a base).
# The first of each frame is what the others are compared with.
BARE = {"lagrangian": {"options": "hourglass 0"}, "eulerian": {}}


def features(frame):
    """(key, title, variables): everything off, then one thing on at a time, then the default with everything."""
    base = {"frame": frame, "viscosity": "none", "h": H[frame], **BARE[frame]}
    first = "no viscosity, no hourglass damping" if frame == "lagrangian" else "no viscosity, corrected gradients"
    yield "bare", first, base
    if frame == "lagrangian":
        yield "hourglass", "hourglass damping", {**base, "options": "hourglass 0.03"}
    else:
        yield "plain", "plain gradients", {**base, "gradient": "plain"}
        yield "tensile", "artificial stress", {**base, "options": "tensile artificial 0.3 4"}
    yield "monaghan", "viscosity monaghan 1 1", {**base, "viscosity": "monaghan 1 1"}
    yield "correct", "viscosity correct", {**base, "viscosity": "correct"}
    if frame == "lagrangian":
        yield "limited", "viscosity limited 1 1", {**base, "viscosity": "limited 1 1"}
    yield "energy", "energy ledger every 10 steps", {**base, "energy": "yes"}
    yield "wall", "contact wall that the body lies on", {**base, "wall": "yes"}
    yield "adapt", "time step looked at every 10 steps", {**base, "adapt": "yes"}
    full = {"frame": frame, "viscosity": "correct", "h": H[frame]}
    yield "default", "viscosity correct, all else at its default", full
    yield "cold", "the same without energy equation (energy no)", {**full, "options": "energy no",
                                                                   "material": "eos mie-gruneisen 3600 1.8 0"}
    yield "mixed", "viscosity correct, all else at its default, precision mixed", {**full, "options": "precision mixed"}
    yield "default-monaghan", "viscosity monaghan 1 1, all else at its default", {**full, "viscosity": "monaghan 1 1"}


@dataclass(frozen=True)
class Block:
    dim: int
    n: int          # particles along an edge
    steps: int
    level: int      # 0: --quick too, 1: ordinary, 2: --large only

    @property
    def count(self):
        return self.n ** self.dim


# so many steps that ours run for 0.1 s and need new neighbor lists (in runs of 12 steps one style had 228 to 835 ns), and that the
# last one, which has a virial, does not show
BLOCKS = [Block(2, 100, 150, 0), Block(3, 22, 50, 0), Block(2, 316, 100, 1), Block(3, 46, 50, 1),
          Block(2, 1000, 40, 2), Block(3, 100, 20, 2), Block(2, 2000, 20, 2), Block(3, 159, 12, 2)]
COUNTED = [Block(2, 30, 20, 0), Block(3, 9, 10, 0)]    # for instructions


def measured_on(block, large):
    """The variants for a block, those that are compared with each other next to each other in time."""
    if block.level == 0:
        return VARIANTS
    if block.level == 2:
        return [v for v in VARIANTS if v.large] if large else []
    return [each for v in VARIANTS if v.main for each in [v] + [v.on(*way) for way in ((2, 1), (1, 2)) if v.shared]]

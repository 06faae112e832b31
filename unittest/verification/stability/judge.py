"""How a run ended, by numbers. Energies of the rod in units of its initial kinetic energy, distances in initial spacings."""

import math
import pathlib
import re
import sys

sys.dont_write_bytecode = True
HERE = pathlib.Path(__file__).resolve().parent
sys.path[:0] = [str(HERE), str(HERE.parents[2] / "examples"), str(HERE.parents[2] / "examples/elastic")]

import growth
import running
from charts import TAYLOR
from histories import closest, drift, largest
from measure import tension    # of examples/elastic

# verdicts, in the order in which they are looked for; the colours and words of the legend are in plot.py
REFUSED, DISTORTED, UNPHYSICAL, LEFT, STOPPED, SLOW, ENERGY, TORN, CLUMPED, OFF, SURVIVED = (
    "refused", "distorted", "unphysical", "left", "stopped", "slow", "energy", "torn", "clumped", "off", "survived")

MESSAGES = (("beyond what this frame can follow", DISTORTED), ("is not physical", UNPHYSICAL), ("time step limit", UNPHYSICAL),
            ("pair_style sph/solid:", REFUSED), ("Lost atoms", LEFT))

ENERGY_ERROR = 1e-3     # of the total energy
CLOSEST = 0.1           # two particles of a rod; the finite elements compress the cells of its foot to 0.15
PAIRED = 0.5            # two particles of a body in tension or in free rotation, where nothing is compressed
FOOT, LENGTH = 0.10, 0.05    # of the rod, against finite elements
ROD_LENGTH, ROD_WIDTH = 25.4, 7.6
WILKINS = 0.05          # length of a rod at rest against Wilkins and Guinan, over the initial length
                        # (both less what random displacements have taken from the distance at first)
SPREAD = 0.2            # of the stress in the strip, over its mean
STRESS = 0.2            # mean stress of the strip against the exact one
SPIN = 0.01             # angular momentum
TURN = 0.05             # kinetic energy of a free rotation
RATE = 0.1              # growth rate, against the fastest of the modes that have a formula
LOADED = 0.15           # stress in the middle of the disc, against the exact one


def files(run):
    return [run.output / f"{run.name}.{kind}" for kind in ("csv", "dump", "log")]


def log_of(run):
    path = files(run)[2]
    return path.read_text() if path.exists() else ""


def stop(message):
    return next((verdict for words, verdict in MESSAGES if words in message), STOPPED)


def left_by_jitter(run):
    """Share of a spacing that two particles still have between them when each was moved towards the other."""
    return 1 - 2 * float(run.variables.get("jitter", 0.0))


def data_of(run):
    try:
        data = running.columns(files(run)[0])
    except (OSError, ValueError, IndexError):
        return {}
    return data if data and all(data.values()) else {}


def least_distance(run, spacing):
    """Over all snapshots; nan where there is none."""
    try:
        shots = running.snapshots(files(run)[1])
    except (OSError, ValueError, StopIteration):
        return math.nan
    return min((closest(shot, spacing) for _, shot in shots), default=math.nan)


def wilkins_guinan(speed):
    """Length of a rigid-plastic rod at rest over its first length, plane strain: M. L. Wilkins and M. W. Guinan, J. Appl.
    Phys. 44 (1973) 1200, with 2/sqrt(3) Y for the yield stress."""
    return (1 - 0.12) * math.exp(-7850 * speed ** 2 * math.sqrt(3) / (4 * 600e6)) + 0.12


def finite_elements():
    data = running.columns(TAYLOR / "reference/taylor_contact_history.csv")
    times = [t * 1e6 for t in data["t_s"]]
    return [running.at(50, times, data[key]) for key in ("L_axis_mm", "foot_width_mm")]


def rod(run, data):
    speed, tend = float(run.variables.get("speed", 200)), float(run.variables.get("tend", 50e-6)) * 1e6
    length, foot = data["length_mm"][-1], data["foot_mm"][-1]
    end = {"reached": data["t_us"][-1] / tend, "energy": largest(map(abs, data["energy_error"])),
           "closest": least_distance(run, math.sqrt(7.6 / 10 * 25.4 / 33) * 1e-3)}
    if speed == 200:
        fe_length, fe_foot = finite_elements()
        end["number"] = foot / fe_foot - 1
        end["off"] = not abs(foot / fe_foot - 1) <= FOOT or not abs(length / fe_length - 1) <= LENGTH
    else:
        end["number"] = length / ROD_LENGTH
        end["off"] = not data["ke"][-1] >= 0.02 and not abs(length / ROD_LENGTH - wilkins_guinan(speed)) <= WILKINS
    if run.chart == "speed":
        end["number"] = length / ROD_LENGTH
    end["clumped"] = not end["closest"] >= CLOSEST * left_by_jitter(run)
    return end


def strip(run, data):
    """Number: the elongation at which the stress ceases to be uniform."""
    least = least_distance(run, 10e-3 / run.variables["rows"])
    ends = (data["elongation"], data["sxx_Pa"], data["sxx_min_Pa"], data["sxx_max_Pa"])
    uneven = [e for e, mean, low, high in zip(*ends) if e > 0.002 and not high - low <= SPREAD * abs(mean)]
    exact = tension(data["elongation"][-1])
    return {"reached": data["elongation"][-1] / run.variables["stretch"], "closest": least,
            "clumped": not least >= PAIRED * left_by_jitter(run), "number": uneven[0] if uneven else math.nan,
            "off": bool(uneven) or not abs(data["sxx_Pa"][-1] / exact - 1) <= STRESS}


def square(run, data):
    """Number: change of the kinetic energy."""
    least = least_distance(run, 20e-3 / run.variables["rows"])
    return {"reached": data["turns"][-1] / run.variables["turns"], "closest": least,
            "clumped": not least >= PAIRED * left_by_jitter(run), "energy": drift(data["total_J"]),
            "number": data["kinetic_J"][-1] / data["kinetic_J"][0] - 1,
            "off": not drift(data["kinetic_J"]) <= TURN or not drift(data["Lz"]) <= SPIN}


def turning(run, data):
    """Number: stress in the middle against the exact one, mean over the second half of the run."""
    half = len(data["t_s"]) // 2
    exact = data["exact_Pa"][-1]
    wrong = sum(data["stress_Pa"][half:]) / len(data["stress_Pa"][half:]) / exact - 1
    least = least_distance(run, 2 * 3.8e-3 / int(run.variables.get("across", 12)))
    return {"reached": data["turns"][-1] / float(run.variables.get("turns", 0.5)), "closest": least,
            "clumped": not least >= PAIRED, "number": wrong,
            "off": not abs(wrong) <= LOADED or not drift(data["Lz"]) <= SPIN}


def growing(run, data):
    """Number: growth rate, c0/dx; exact: the formula's, of this mode, and of the fastest one of the three."""
    v = run.variables
    eps = 0.3 if v["options"] else 0.0
    exact = [growth.rate(v["tension"], v["h"], mode, v["gradient"], v["viscosity"], eps) for mode in growth.MODES]
    fastest, found = max(e for e in exact if e == e), growth.fitted(data)
    mine = exact[v["mode"] - 1]
    return {"number": found, "exact": mine, "fastest": fastest, "reached": 1.0,
            "off": not min(abs(found - mine), abs(found - fastest)) <= RATE * fastest}


SCENES = {"rod": rod, "strip": strip, "square": square, "turning": turning, "growth": growing}


def used_up(run):
    """All steps used, several times those of an ordinary run, before the end of the time."""
    done = re.findall(r"Loop time of .* for (\d+) steps", log_of(run))
    return "steps" in run.variables and bool(done) and int(done[-1]) >= run.variables["steps"]


def left_the_box(run):
    """Particles lost after the last line of thermo output, which is where LAMMPS looks for them. Runs are on one rank."""
    log = log_of(run)
    created, own = re.findall(r"Created (\d+) atoms", log), re.findall(r"Nlocal: +(\d+) ave", log)
    return bool(created) and bool(own) and int(own[-1]) < int(created[0])


def verdict_of(run, end, message):
    if message:
        return stop(message)
    if left_the_box(run):
        return LEFT
    if used_up(run):
        return SLOW
    if not end.get("energy", 0.0) <= ENERGY_ERROR:
        return ENERGY
    if "has lost all its neighbors" in log_of(run):
        return TORN
    if end.get("clumped"):
        return CLUMPED
    return OFF if end["off"] else SURVIVED


FIELDS = ("chart", "panel", "row", "column", "verdict", "number", "reached", "energy", "closest", "exact", "fastest", "message")


def judge(run, message):
    """A line of the chart's CSV; the files of the run are removed."""
    data = data_of(run)
    end = SCENES[run.scene](run, data) if data else {}
    line = {"chart": run.chart, "panel": run.panel, "row": run.row, "column": run.column,
            "verdict": verdict_of(run, end, message), "message": (message or "")[:160]}
    for name in ("number", "reached", "energy", "closest", "exact", "fastest"):
        line[name] = f"{end[name]:.5g}" if name in end else ""
    for path in files(run):
        path.unlink(missing_ok=True)
    return line

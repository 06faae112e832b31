"""The catalogue of verification scenes: what a scene consists of, running it, keeping its figures, judging them.

A scene is a folder scenes/<name> with in.<name> and scene.py, which has

  TITLE, ABOUT                 a line; rst text with the problem and its exact reference and source
  FIGURES                      list of Figure
  cases(level)                 list of Case; level "test" takes seconds altogether, "report" is everything
  measure(case)                {figure: number}, from case.csv and case.dump. Needs nothing but Python
  gates(case)                  {figure: limit}: the test fails where |number| > limit or is not finite
  draw(results, file)          the picture of the page, with matplotlib
  judge(results)               one honest sentence, from the numbers

and, where it needs them,

  TARGETS = {figure: limit}    what is aimed at, for every method at the finest n: marks in the table, row in the index
  ORDERS = {figure: least}     the same for the observed order of convergence
  order_gates(series)          {figure: least}: the test fails where the observed order of these cases is less
  misses(case)                 {figure: cause}: gates known to be missed. The test fails if such a one is met: then
                               the entry is out of date, unless the cause is a Chance
  order_misses(series)         {figure: cause}: the same for order_gates
  cannot(method)               why a method cannot run here, or ""
  HEADLINE                     key of the method for the index (default: that of a user who sets nothing)

Output of the report is in scenes/<name>/output, that of the test in scenes/<name>/output/test."""

import csv
import importlib.util
import math
import pathlib
import sys
from dataclasses import dataclass, field

HERE = pathlib.Path(__file__).resolve().parent
SCENES = HERE / "scenes"
ROOT = HERE.parents[1]
sys.path[:0] = [str(HERE), str(ROOT / "examples")]

import methods
import running
from histories import slope


@dataclass(frozen=True)
class Figure:
    name: str
    text: str               # head of its column
    format: str = "{:.2e}"
    order: bool = False     # an error whose order of convergence over n is asked for


@dataclass
class Case:
    name: str               # of the files: output/<name>.csv and so on
    method: methods.Method
    n: int                  # resolution
    variables: dict = field(default_factory=dict)
    script: str = ""
    weight: float = 1.0     # seconds it is expected to run
    may_fail: str = ""      # why the run may stop early: the documented failure of a method
    series: str = ""        # cases of one series differ in n only; default: one series a method
    output: pathlib.Path = pathlib.Path("output")    # set by the catalogue

    @property
    def csv(self):
        return self.output / f"{self.name}.csv"

    @property
    def dump(self):
        return self.output / f"{self.name}.dump"


@dataclass
class Result:
    case: Case
    figures: dict           # empty if the run failed
    failed: str = ""        # last message of a run that did not come to its end


def case(scene, method, n, weight=1.0, suffix="", **variables):
    """The usual case: the method's settings, and n."""
    return Case(f"{method.key}{suffix}-{n}", method, n, {**method.variables, "n": n, **variables},
                method.script(scene), weight, series=method.key + suffix)


def usual_cases(scene, level, test, report, seconds, cannot):
    """The usual cases: all methods that can run, at the sizes of the level. The Eulerian frame, whose steps are shorter and
    cost three times as much, stops a size earlier in the report, with one more at the coarse end.
    seconds: what a run at the first size of the report takes in the Lagrangian frame; it grows with n squared."""
    found = []
    for method in methods.METHODS:
        slow = method.frame == "eulerian"
        sizes = test if level == "test" else (report[0] // 2, *report[:-1]) if slow else report
        if not cannot(method):
            found += [case(scene, method, n, seconds * (n / report[0]) ** 2 * (5 if slow else 1)) for n in sizes]
    return found


# ---- scenes -------------------------------------------------------------------------------------------------

def names():
    return sorted(path.parent.name for path in SCENES.glob("*/scene.py"))


def load(name):
    """The module scenes/<name>/scene.py."""
    path = SCENES / name / "scene.py"
    if not path.exists():
        sys.exit(f"There is no scene \"{name}\". Scenes: {', '.join(names())}")
    spec = importlib.util.spec_from_file_location(f"scene_{name}", path)
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


def cases_of(scene, name, level):
    """The cases, with their output folder."""
    cases = scene.cases(level)
    for each in cases:
        each.output = folder(name, level)
    return cases


def folder(name, level):
    return SCENES / name / "output" / ("test" if level == "test" else "")


def optional(scene, name, default, *arguments):
    """scene.name(*arguments), or the default where the scene has no such function."""
    return getattr(scene, name)(*arguments) if hasattr(scene, name) else default


# ---- running ------------------------------------------------------------------------------------------------

def run(name, level, lmp):
    """Runs all cases of a scene; a Result for each."""
    scene, here = load(name), SCENES / name
    cases, output = cases_of(scene, name, level), folder(name, level)
    output.mkdir(parents=True, exist_ok=True)
    running.empty(output)
    failed = running.simulate_all(here, lmp, cases, output.relative_to(here)) if cases else {}
    return [result(scene, each, failed.get(each.name, "")) for each in cases]


def result(scene, case, failed):
    return Result(case, {} if failed else scene.measure(case), failed)


# ---- keeping ------------------------------------------------------------------------------------------------

def keep(results, scene, path):
    """All figures as CSV, so that pages can be written again without the runs."""
    path.parent.mkdir(parents=True, exist_ok=True)
    columns = [figure.name for figure in scene.FIGURES]
    with open(path, "w", newline="") as file:
        writer = csv.writer(file, lineterminator="\n")
        writer.writerow(["case", "method", "n", *columns, "failed"])
        for each in results:
            numbers = [f"{each.figures[name]:.8g}" if name in each.figures else "" for name in columns]
            writer.writerow([each.case.name, each.case.method.key, each.case.n, *numbers, each.failed])


def kept(scene, name, path):
    """The results that keep() wrote, for the cases that the scene still has."""
    with open(path, newline="") as file:
        rows = {row["case"]: row for row in csv.DictReader(file)}
    results = []
    for each in cases_of(scene, name, "report"):
        row = rows.get(each.name)
        if row:
            figures = {f.name: float(row[f.name]) for f in scene.FIGURES if row.get(f.name)}
            results.append(Result(each, figures, row["failed"]))
    return results


# ---- judging ------------------------------------------------------------------------------------------------

def series(results):
    """{series: its results that ran, coarse to fine}"""
    found = {}
    for each in sorted(results, key=lambda r: r.case.n):
        if not each.failed:
            found.setdefault(each.case.series or each.case.method.key, []).append(each)
    return found


def finest(results):
    """The finest result of each series."""
    return [group[-1] for group in series(results).values()]


def order(results, figure):
    """Observed order of convergence: least squares of log error over log n; nan with fewer than two or a nan."""
    points = [(math.log(r.case.n), math.log(abs(r.figures[figure]))) for r in results
              if r.figures.get(figure)]
    if len(points) < 2:
        return math.nan
    sizes, errors = zip(*points)
    return -slope(errors, sizes)


@dataclass
class Overview:
    """What judge() has its sentence from, where a method has one series."""
    last: list        # the finest result of each method
    figures: dict     # {key of the method: its figures there}
    orders: dict      # {key of the method: observed order of the error}

    @property
    def default(self):
        return self.figures[methods.DEFAULT]

    def reach(self, least):
        """How many methods have this order."""
        return f"{sum(value >= least for value in self.orders.values())} of {len(self.orders)} methods reach"


def overview(results, error=""):
    """error: the figure whose order is asked for."""
    last = finest(results)
    return Overview(last, {r.case.method.key: r.figures for r in last},
                    {key: order(group, error) for key, group in series(results).items()} if error else {})


class Chance(str):
    """A cause of a failure or a miss that grows out of rounding: another machine may see it or not."""


def complaints(scene, results):
    """What the test has against these results: a list of sentences, and the number of gates that were looked at."""
    found, looked = [], 0
    for each in results:
        if each.failed:
            if not each.case.may_fail:
                found.append(f"{each.case.name} did not run: {each.failed}")
            continue
        if each.case.may_fail and not isinstance(each.case.may_fail, Chance):
            found.append(f"{each.case.name} ran, though it is listed as failing: {each.case.may_fail}")
        known = optional(scene, "misses", {}, each.case)
        for figure, limit in scene.gates(each.case).items():
            looked += 1
            value = each.figures.get(figure, math.nan)
            found += verdict(f"{each.case.name}: {figure} = {value:.6g}, limit {limit:g}", abs(value) <= limit,
                             known.get(figure))
    more, orders = order_complaints(scene, results)
    return found + more, looked + orders


def order_complaints(scene, results):
    found, looked = [], 0
    for name, group in series(results).items():
        cases = [r.case for r in group]
        known = optional(scene, "order_misses", {}, cases)
        for figure, least in optional(scene, "order_gates", {}, cases).items():
            looked += 1
            value = order(group, figure)
            found += verdict(f"{name}: order of {figure} = {value:.3f}, at least {least:g}", value >= least,
                             known.get(figure))
    return found, looked


def verdict(text, met, cause):
    """The complaint about one gate, if there is one; cause: why it is known to be missed."""
    if isinstance(cause, Chance):
        return []
    if cause is None:
        return [] if met else [text]
    return [f"{text}: met, though listed as missed ({cause})"] if met else []

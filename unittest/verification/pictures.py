"""What the pictures of all scenes share: a colour for each viscosity, a line for each frame, a legend beside."""

from matplotlib.ticker import LogFormatterSciNotation, NullLocator

import methods
from catalogue import series
from drawing import plt, save

COLOURS = {"correct": "C3", "none": "0.5", "monaghan05": "C0", "monaghan1": "C9", "limited05": "C2", "limited2": "C8", "limited3": "C1",
           "balsara1": "navy", "safe": "maroon", "front": "magenta",
           "ulsph": "C4", "tlsph": "C5", "sph": "C6"}
LINES = {"Lagrangian frame": "-", "Eulerian frame, corrected gradients": "--", "Eulerian frame, plain gradients": ":"}
LETTERS = {"Lagrangian frame": "Lagrangian", "Eulerian frame, corrected gradients": "Eulerian",
           "Eulerian frame, plain gradients": "Eulerian, plain"}


def look(method):
    """Keywords of a line for this method; methods that are new get a colour of their own."""
    key = method.kind
    return {"color": COLOURS.get(key, f"C{sum(map(ord, key)) % 10}"), "linestyle": LINES.get(method.group, "-."),
            "linewidth": 1.2}


def label(method):
    return f"{LETTERS[method.group]}: {method.title}" if method.group in LETTERS else method.title


def axes(count, width=4.4, height=3.6):
    """A figure with so many axes, and room on the right for legend()."""
    figure, grid = plt.subplots(1, count + 1, figsize=(width * count + 2.4, height), layout="constrained",
                                gridspec_kw={"width_ratios": [width] * count + [2.4]})
    grid[-1].axis("off")
    return figure, grid[:-1]


def legend(figure, source):
    """All lines of the axes source, in the room on the right."""
    rank = {label(method): k for k, method in enumerate(methods.METHODS)}
    entries = sorted(zip(*source.get_legend_handles_labels()), key=lambda entry: rank.get(entry[1], len(rank)))
    handles, labels = zip(*entries)
    figure.axes[-1].legend(handles, labels, loc="center left", fontsize=7, borderaxespad=0)


def convergence(axes, results, name, floor=0.0):
    """Error against n for all series."""
    for _, group in series(results).items():
        method = group[0].case.method
        axes.loglog([r.case.n for r in group], [max(abs(r.figures[name]), floor) for r in group], marker="o", ms=3,
                    label=label(method), **look(method))
    sizes = sorted({r.case.n for r in results})
    axes.set_xticks(sizes, [str(n) for n in sizes])
    axes.xaxis.set_minor_locator(NullLocator())
    axes.yaxis.set_minor_formatter(LogFormatterSciNotation(minor_thresholds=(1, 0.4)))
    axes.tick_params(axis="y", which="minor", labelsize=7)


def finest_lagrangian(results, output="dump"):
    """(result, colour) of what came to its end in the Lagrangian frame at the finest n; output: what has to be there."""
    size = max(r.case.n for r in results)
    for each in results:
        case = each.case
        if not each.failed and case.n == size and case.method.frame == "lagrangian" and getattr(case, output).exists():
            yield each, look(case.method)["color"]


def title(results):
    """Of the axes with finest_lagrangian()."""
    return f"Lagrangian frame, n = {max(r.case.n for r in results)}"


def error_axes(figure, axes, results, name, text, floor=0.0):
    """The last axes of a figure: error against n of all methods, and what their lines mean."""
    convergence(axes, results, name, floor)
    axes.set(xlabel="n", ylabel=text)
    legend(figure, axes)


def slope(axes, order, n, value):
    """A thin line of the given order through (n, value), over a factor of four."""
    ends = [n, 4 * n]
    axes.plot(ends, [value * (m / n) ** -order for m in ends], "k", lw=0.7)
    axes.annotate(f"order {order}", (ends[1], value * 4.0 ** -order), fontsize=7, ha="right", va="top")

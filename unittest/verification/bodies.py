"""What the scenes with two-dimensional bodies share: pieces of a body, colours and errors in pictures.

Measuring needs nothing but Python."""

from histories import close_pairs


def pieces(shot, reach):
    """Sizes of what hangs together, largest first: particles joined by distances below reach."""
    root = list(range(len(shot["x"])))

    def find(k):
        while root[k] != k:
            root[k] = root[root[k]]
            k = root[k]
        return k

    for i, j, _ in close_pairs(shot["x"], shot["y"], reach):
        root[find(i)] = find(j)
    sizes = {}
    for k in range(len(root)):
        sizes[find(k)] = sizes.get(find(k), 0) + 1
    return sorted(sizes.values(), reverse=True)


def colour_bar(figure, axes):
    """Beside the axes, for what was drawn there first; an inset, so that the legend of pictures.py keeps its room."""
    figure.colorbar(axes.collections[0], cax=axes.inset_axes([1.02, 0.1, 0.04, 0.8]))


def main_series(results):
    """Those that ran with nothing but the settings of their method."""
    return [r for r in results if not r.failed and r.case.series == r.case.method.key]


def errors(axes, results, name, floor=0.0, line=None, more=()):
    """Convergence of the main series, and of the series in more, named by their ending; line: (order, n, error)."""
    import pictures
    from catalogue import series
    if line:
        pictures.slope(axes, *line)
    for (name_of, group), mark in zip(((k, g) for k, g in series(results).items() if k in more), "sv^"):
        axes.loglog([r.case.n for r in group], [max(abs(r.figures[name]), floor) for r in group], "k:", marker=mark, ms=4, lw=1,
                    label=f"Lagrangian: {group[0].case.method.title}, {name_of.split('-')[-1]}")
    pictures.convergence(axes, main_series(results), name, floor)

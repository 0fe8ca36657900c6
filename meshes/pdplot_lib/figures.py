"""Maps, profiles and comparisons of runs."""
from pathlib import Path

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt  # noqa: E402
import numpy as np  # noqa: E402

from .components import component_of, default_component, title_of  # noqa: E402
from .raster import Raster, window_of  # noqa: E402
from .results import PlotError, read_history, vector_columns  # noqa: E402
from .units import plain, scaled, time_text, with_unit  # noqa: E402

# Perceptually uniform; dark is little, so that cracks and saturation stand out.
_MAPS = {"Damage": "inferno", "Concentration": "viridis", "Coverage": "viridis", "Temperature": "magma"}
plt.rcParams.update({"font.size": 9, "figure.dpi": 110, "savefig.bbox": "tight", "axes.titlesize": 9,
                     "image.interpolation": "nearest"})


def save_curves(figure, path, axes):
    """With a grid and a legend in each of the axes; tells where it is."""
    for axis in axes:
        axis.grid(alpha=0.3)
        axis.legend(fontsize=8)
    figure.savefig(path, dpi=150)
    print(path)


class View:
    """How a field is shown. component: x, y, z, of tensors xx, xy ..., von-mises, principal1 ... (None: the magnitude
    of a vector, what people look at of a tensor); scale: of the deformation, 0 for none; crack: Damage above which
    points count as cracked, or None; slice: (axis, position) of a solid."""

    def __init__(self, field, component=None, scale=0.0, crack=None, slice=None, limits=None, map=None, unit=None,
                 factor=1.0):
        self.field, self.component, self.scale, self.crack, self.slice = field, component, scale, crack, slice
        self.limits, self.map, self.unit, self.factor = limits, map, unit, factor
        self.path, self.measured = None, None  # label of a Crack_Tip; a path [n, 2] in m from elsewhere
        self.window = None  # (lowest corner, highest corner) shown, where pictures must agree in it

    def values(self, results, step):
        values = results.field(self.field, step) * self.factor
        return values if values.ndim == 1 else component_of(self.field, values, self._component(values.shape[1]))

    def paths(self, results, step):
        """Over maps: the way of a tip up to the step, and a path from elsewhere; [n, 3] in m, and how to draw it."""
        if self.path is not None:
            history = read_history(results.path)
            columns = vector_columns(history, self.path)
            tips = np.stack([history[column] for column in columns], axis=1)
            yield tips[history["step"] <= step], {"color": "deepskyblue", "linewidth": 1.0}
        if self.measured is not None:
            places = np.column_stack([self.measured, np.zeros(len(self.measured))])
            yield places, {"color": "white", "marker": ".", "markersize": 3, "linestyle": "none"}

    def name(self, results):
        width = results.width(self.field)
        return title_of(self.field, width, self._component(width))

    def units(self, results):
        return results.unit(self.field) if self.unit is None else self.unit

    def _component(self, width):
        return self.component or default_component(self.field, width)


def auto_scale(results, steps):
    """Factor that makes the largest displacement (but for a hundredth of the points, which may fly off) a twentieth of
    the size of the body."""
    largest = max(np.quantile(np.abs(results.field("Displacement", step)).max(axis=1), 0.99) for step in steps)
    size = np.ptp(results.x, axis=0).max()
    return 0.05 * size / largest if largest > 0 else 0.0


class Plane:
    """What of a body is shown: all points of a plane scene; of a solid those near a plane through it, which colour its
    places as they colour all of the solid, each place by the nearest. points: their indices; axes: the two shown."""

    def __init__(self, results, view):
        self.results, self.view = results, view
        if results.dimension < 3:
            self.points, self.axes, self.height = np.arange(len(results.x)), (0, 1), None
            return
        axis, position = slice_of(results, view)
        along = results.x[:, axis]
        if not along.min() - 0.5 * results.spacing() <= position <= along.max() + 0.5 * results.spacing():
            raise PlotError(f"no points at {'xyz'[axis]} = {position:g} m (the body spans {along.min():g} .. "
                            f"{along.max():g} m)")
        self.points = np.flatnonzero(np.abs(along - position) <= (1.05 + results.reach()) * results.spacings())
        self.axes = tuple(i for i in range(3) if i != axis)
        self.height = along[self.points] - position

    def places(self, step=None):
        """[n, 2 or 3] of the points: at a step displaced as the view says; and the height above the plane."""
        x = self.results.x[self.points][:, self.axes]
        if self.view.scale and step is not None:
            x = x + self.view.scale * self.results.field("Displacement", step)[self.points][:, self.axes]
        return x if self.height is None else np.column_stack([x, self.height])

    def raster(self, step):
        raster = Raster(self.places(step), self.results.spacings()[self.points], window=self.view.window,
                        reach=self.results.reach())
        if raster.is_empty():
            raise PlotError(f"no points at {'xyz'[3 - sum(self.axes)]} = {slice_of(self.results, self.view)[1]:g} m")
        return raster


def slice_of(results, view):
    """(axis, position) of the slice of a solid: through the middle of its thinnest direction."""
    if view.slice:
        return view.slice
    extent = np.ptp(results.x, axis=0)
    axis = int(np.flatnonzero(extent <= 1.001 * extent.min())[-1])  # z before y before x
    return axis, (results.x[:, axis].max() + results.x[:, axis].min()) / 2


def map_panels(panels, view, columns=None):
    """Figure with one map for each (results, step, title), one colour bar for all."""
    panels = list(panels)
    if panels[0][0].dimension == 1:
        return line_panels(panels, view)
    limits = view.limits or common_limits(panels, view)
    factor, unit = scaled(max(abs(limits[0]), abs(limits[1])), view.units(panels[0][0]))
    if view.scale and view.window is None and len({id(results) for results, _, _ in panels}) == 1:
        view.window = common_window(panels, view)
    shape = _aspect(panels[0][0], view)
    columns = columns or _columns(len(panels), shape)
    rows = -(-len(panels) // columns)
    width = {1: 7.2, 2: 4.6}.get(columns, 3.4)
    figure, axes = plt.subplots(rows, columns, figsize=(width * columns + 0.9, (width * shape + 0.55) * rows),
                                squeeze=False, constrained_layout=True)
    for axis in axes.ravel()[len(panels):]:
        axis.axis("off")
    for index, (axis, (results, step, title)) in enumerate(zip(axes.ravel(), panels)):
        image = draw_map(axis, results, step, view, [limit * factor for limit in limits], factor)
        axis.set_title(title)
        # Panels of one body share its axes: only the outer ones are labelled.
        if index % columns:
            axis.set_ylabel("")
        if index + columns < len(panels):
            axis.set_xlabel("")
    bar = figure.colorbar(image, ax=axes, shrink=0.9 if rows == 1 else min(0.85, 2.5 / rows), pad=0.02, aspect=25,
                          fraction=0.05 if columns > 1 else 0.08)
    bar.set_label(with_unit(view.name(panels[0][0]), unit))
    return figure


def _columns(n_panels, shape):
    """As many as make the whole picture about as wide as a screen is."""
    if n_panels == 1:
        return 1
    return int(np.clip(np.rint(np.sqrt(1.3 * n_panels * shape)), 2, max(2, min(n_panels, 5))))


def draw_map(axis, results, step, view, limits, factor):
    plane = Plane(results, view)
    chosen, (first, second) = plane.points, plane.axes
    raster = plane.raster(step)
    length, unit = scaled(np.abs(raster.extent).max(), "m")
    extent = [value * length for value in raster.extent]
    values = view.values(results, step)[chosen] * factor
    map = plt.get_cmap(view.map or _MAPS.get(view.field, "viridis"))
    if view.field == "Damage" and not view.values(results, step).any():  # grey: black would be all there is to see
        map, limits = map.with_extremes(under="0.8"), (max(limits[0], 1e-9 * limits[1]), limits[1])
    image = axis.imshow(raster.image(values), origin="lower", extent=extent, vmin=limits[0], vmax=limits[1], cmap=map)
    if view.crack is not None:
        cracked = raster.image((results.field("Damage", step)[chosen] > view.crack).astype(float)).filled(0)
        if cracked.any() and not cracked.all():
            axis.contour(raster.columns * length, raster.rows * length, cracked, [0.5], colors="white",
                         linewidths=0.7)
    for places, style in view.paths(results, step):
        axis.plot(places[:, first] * length, places[:, second] * length, scalex=False, scaley=False, **style)
    axis.set_xlabel(f"{'xyz'[first]} ({unit})")
    axis.set_ylabel(f"{'xyz'[second]} ({unit})")
    return image


def common_window(panels, view):
    """(lowest corner, highest corner) of all panels, so that displaced bodies are seen to move."""
    lows, highs = [], []
    for results, step, _ in panels:
        low, high = window_of(Plane(results, view).places(step), results.spacing())
        lows.append(low)
        highs.append(high)
    return np.min(lows, axis=0), np.max(highs, axis=0)


def line_panels(panels, view):
    figure, axis = plt.subplots(figsize=(6.4, 4), constrained_layout=True)
    for results, step, title in panels:
        order = np.argsort(results.x[:, 0])
        axis.plot(results.x[order, 0], view.values(results, step)[order], label=title)
    axis.set_xlabel("x (m)")
    axis.set_ylabel(with_unit(view.name(panels[0][0]), view.units(panels[0][0])))
    axis.legend()
    axis.grid(alpha=0.3)
    return figure


def common_limits(panels, view):
    if view.field in ("Damage", "Coverage"):
        return 0.0, 1.0
    lows, highs = zip(*[(values.min(), values.max())
                        for values in (view.values(results, step) for results, step, _ in panels)])
    low, high = min(lows), max(highs)
    return (low, high) if high > low else (low - 0.5 * (abs(low) or 1), high + 0.5 * (abs(high) or 1))


def comparison(first, second, steps, view):
    """Two runs, each at its step, and their difference where the points are the same."""
    runs = list(zip((first, second), run_labels([first, second]), steps))
    panels = [(run, step, f"{label}, {step_title(run, step, view)}") for run, label, step in runs]
    if len(first.x) != len(second.x) or not np.allclose(first.x, second.x, rtol=0, atol=1e-9 * np.ptp(first.x)) \
            or first.dimension == 1:
        return map_panels(panels, view, columns=2)
    limits = view.limits or common_limits(panels, view)
    factor, unit = scaled(max(abs(limits[0]), abs(limits[1])), view.units(first))
    plane = Plane(first, view)
    chosen, one = plane.points, plane.axes[0]
    difference = ((view.values(second, steps[1]) - view.values(first, steps[0])) * factor)[chosen]
    shape = _aspect(first, view)
    figure, axes = plt.subplots(1, 3, figsize=(14.5, 4.2 * shape + 1.2), constrained_layout=True)
    for axis, (results, step, title) in zip(axes, panels):
        image = draw_map(axis, results, step, view, [limit * factor for limit in limits], factor)
        axis.set_title(title)
    bar = {"location": "bottom", "shrink": 0.7, "aspect": 35, "pad": 0.03}
    figure.colorbar(image, ax=axes[:2], **bar).set_label(with_unit(view.name(first), unit))
    raster = plane.raster(steps[0])
    largest = np.abs(difference).max()
    length, length_unit = scaled(np.abs(raster.extent).max(), "m")
    image = axes[2].imshow(raster.image(difference), origin="lower", cmap="coolwarm", vmin=-(largest or 1.0),
                           vmax=largest or 1.0, extent=[value * length for value in raster.extent])
    axes[2].set_title(f"{runs[1][1]} - {runs[0][1]}" + (f", at most {largest:.3g}" if largest else ": no difference"))
    axes[2].set_xlabel(f"{'xyz'[one]} ({length_unit})")
    figure.colorbar(image, ax=axes[2], **bar).set_label(with_unit("difference", unit))
    return figure


def run_labels(runs):
    """Names that tell the runs apart: with their folders where the files are called alike."""
    if len({run.label for run in runs}) == len(runs):
        return [run.label for run in runs]
    return [str(Path(run.path.resolve().parent.name) / run.label) for run in runs]


def step_title(results, step, view=None):
    """Step, time, and what of the body is shown how."""
    text = f"step {step}, t = {time_text(results.time(step), results.time(results.steps[-1]))}"
    if view is not None and results.dimension == 3:
        axis, position = slice_of(results, view)
        length, unit = scaled(abs(position) or np.ptp(results.x[:, axis]), "m")
        text += f", {'xyz'[axis]} = {position * length:.4g} {unit}"
    if view is not None and view.scale:
        text += f", displaced {plain(view.scale)} ×"
    if view is not None:
        values = view.values(results, step)
        if values.min() == values.max():
            text += f", {values[0] if values[0] else 0:.3g} everywhere"
    return text


def _aspect(results, view):
    low, high = window_of(Plane(results, view).places(), results.spacing())
    width, height = high - low
    return float(np.clip(height / width, 0.15, 2.0))

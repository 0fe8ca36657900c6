"""Maps, profiles, histories, comparisons and animations."""
import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt  # noqa: E402
import numpy as np  # noqa: E402

from .raster import Raster  # noqa: E402
from .results import PlotError  # noqa: E402
from .units import scaled, time_text, unit_of, with_unit  # noqa: E402

# Perceptually uniform; dark is little, so that cracks and saturation stand out.
_MAPS = {"Damage": "inferno", "Concentration": "viridis", "Coverage": "viridis", "Temperature": "magma"}
plt.rcParams.update({"font.size": 9, "figure.dpi": 110, "savefig.bbox": "tight", "axes.titlesize": 9,
                     "image.interpolation": "nearest"})


class View:
    """How a field is shown. component: None, 0, 1, 2 (None: magnitude of a vector); scale: of the deformation, 0 for
    none; crack: Damage above which points count as cracked, or None; slice: (axis, position) of a solid."""

    def __init__(self, field, component=None, scale=0.0, crack=None, slice=None, limits=None, map=None, unit=None,
                 factor=1.0):
        self.field, self.component, self.scale, self.crack, self.slice = field, component, scale, crack, slice
        self.limits, self.map, self.unit, self.factor = limits, map, unit, factor

    def values(self, results, step):
        values = results.field(self.field, step) * self.factor
        if values.ndim == 1:
            return values
        if self.component is not None:
            if self.component >= values.shape[1]:
                raise PlotError(f"{self.field} has {values.shape[1]} components, not {self.component + 1}")
            return values[:, self.component]
        return np.linalg.norm(values, axis=1)

    def name(self, results):
        width = results.field(self.field, results.steps[-1]).ndim
        if width == 1:
            return self.field
        return f"{self.field} " + ("magnitude" if self.component is None else "xyz"[self.component])

    def units(self):
        return unit_of(self.field) if self.unit is None else self.unit


def auto_scale(results, steps):
    """Factor that makes the largest displacement a twentieth of the size of the body."""
    largest = max(np.abs(results.field("Displacement", step)).max() for step in steps)
    size = np.ptp(results.x, axis=0).max()
    return 0.05 * size / largest if largest > 0 else 0.0


def plane_of(results, view):
    """(indices of the points shown, their two axes): all points of a plane scene, a slice of a solid."""
    if results.dimension < 3:
        return np.arange(len(results.x)), (0, 1)
    extent = np.ptp(results.x, axis=0)
    axis, position = view.slice or (int(extent.argmin()), None)
    along = results.x[:, axis]
    if position is None:
        position = (along.max() + along.min()) / 2
    chosen = np.flatnonzero(np.abs(along - position) <= 0.51 * results.spacing())
    if not len(chosen):
        raise PlotError(f"no points within half a spacing of {'xyz'[axis]} = {position:g} m "
                        f"(the body spans {along.min():g} .. {along.max():g} m)")
    return chosen, tuple(i for i in range(3) if i != axis)


def map_panels(panels, view, columns=None):
    """Figure with one map for each (results, step, title), one colour bar for all."""
    panels = list(panels)
    if panels[0][0].dimension == 1:
        return line_panels(panels, view)
    limits = view.limits or common_limits(panels, view)
    factor, unit = scaled(max(abs(limits[0]), abs(limits[1])), view.units())
    columns = columns or (1 if len(panels) == 1 else 2)
    rows = -(-len(panels) // columns)
    shape = _aspect(panels[0][0], view)
    width = 7.2 if columns == 1 else 4.6
    figure, axes = plt.subplots(rows, columns, figsize=(width * columns + 0.9, (width * shape + 0.55) * rows),
                                squeeze=False, constrained_layout=True)
    for axis in axes.ravel()[len(panels):]:
        axis.axis("off")
    for axis, (results, step, title) in zip(axes.ravel(), panels):
        image = draw_map(axis, results, step, view, [limit * factor for limit in limits], factor)
        axis.set_title(title)
    bar = figure.colorbar(image, ax=axes, shrink=0.85 if rows * columns > 1 else 0.9, pad=0.02)
    bar.set_label(with_unit(view.name(panels[0][0]), unit))
    return figure


def draw_map(axis, results, step, view, limits, factor):
    chosen, (first, second) = plane_of(results, view)
    x = results.x[chosen][:, [first, second]]
    if view.scale:
        x = x + view.scale * results.field("Displacement", step)[chosen][:, [first, second]]
    raster = Raster(x, 0.9 * results.spacing())
    length, unit = scaled(np.abs(raster.extent).max(), "m")
    extent = [value * length for value in raster.extent]
    values = view.values(results, step)[chosen] * factor
    image = axis.imshow(raster.image(values), origin="lower", extent=extent, vmin=limits[0], vmax=limits[1],
                        cmap=view.map or _MAPS.get(view.field, "viridis"))
    if view.crack is not None:
        cracked = raster.image((results.field("Damage", step)[chosen] > view.crack).astype(float)).filled(0)
        if cracked.any() and not cracked.all():
            axis.contour(raster.columns * length, raster.rows * length, cracked, [0.5], colors="white",
                         linewidths=0.7)
    axis.set_xlabel(f"{'xyz'[first]} ({unit})")
    axis.set_ylabel(f"{'xyz'[second]} ({unit})")
    return image


def line_panels(panels, view):
    figure, axis = plt.subplots(figsize=(6.4, 4), constrained_layout=True)
    for results, step, title in panels:
        order = np.argsort(results.x[:, 0])
        axis.plot(results.x[order, 0], view.values(results, step)[order], label=title)
    axis.set_xlabel("x (m)")
    axis.set_ylabel(with_unit(view.name(panels[0][0]), view.units()))
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


def comparison(first, second, step, view):
    """Two runs and their difference on the same points."""
    panels = [(first, step, f"{first.label}, step {step}"), (second, step, f"{second.label}, step {step}")]
    if len(first.x) != len(second.x) or not np.allclose(first.x, second.x, rtol=0, atol=1e-9 * np.ptp(first.x)):
        return map_panels(panels, view)
    limits = view.limits or common_limits(panels, view)
    factor, unit = scaled(max(abs(limits[0]), abs(limits[1])), view.units())
    difference = (view.values(second, step) - view.values(first, step)) * factor
    shape = _aspect(first, view)
    figure, axes = plt.subplots(1, 3, figsize=(14.5, 4.2 * shape + 0.9), constrained_layout=True)
    for axis, (results, _, title) in zip(axes, panels):
        image = draw_map(axis, results, step, view, [limit * factor for limit in limits], factor)
        axis.set_title(title)
    figure.colorbar(image, ax=axes[:2], shrink=0.8).set_label(with_unit(view.name(first), unit))
    chosen, (one, two) = plane_of(first, view)
    raster = Raster(first.x[chosen][:, [one, two]], 0.9 * first.spacing())
    largest = np.abs(difference[chosen]).max() or 1.0
    length, length_unit = scaled(np.abs(raster.extent).max(), "m")
    image = axes[2].imshow(raster.image(difference[chosen]), origin="lower", cmap="coolwarm", vmin=-largest,
                           vmax=largest, extent=[value * length for value in raster.extent])
    axes[2].set_title("second - first")
    axes[2].set_xlabel(f"{'xyz'[one]} ({length_unit})")
    figure.colorbar(image, ax=axes[2], shrink=0.8).set_label(with_unit("difference", unit))
    return figure


def history_panels(runs, columns=None, against=None):
    """Histories of several runs: a panel for each column. runs: [(label, {column: values})]."""
    first = runs[0][1]
    against = against or ("time" if "time" in first else "step")
    for name in (columns or []) + [against]:
        if name not in first:
            raise PlotError(f"no column {name} in the history (there are: {', '.join(first)})")
    columns = columns or [name for name in first if name not in ("step", "time", against)]
    if not columns:
        raise PlotError("the history has no columns; name computes for the whole body under Output Variables")
    across = 1 if len(columns) == 1 else 2
    rows = -(-len(columns) // across)
    figure, axes = plt.subplots(rows, across, figsize=(5.4 * across, 3.2 * rows), squeeze=False,
                                constrained_layout=True)
    for axis in axes.ravel()[len(columns):]:
        axis.axis("off")
    for axis, column in zip(axes.ravel(), columns):
        for label, history in runs:
            if column in history:
                axis.plot(history[against], history[column], label=label, linewidth=1.2)
        axis.set_xlabel("time (s)" if against == "time" else against)
        axis.set_ylabel(column.replace("_", " "))
        axis.grid(alpha=0.3)
        if len(runs) > 1:
            axis.legend()
    return figure


def animation(results, view, file_name, steps, frames_per_second):
    """GIF of all steps, with limits that do not change."""
    from io import BytesIO

    from PIL import Image
    view.limits = view.limits or common_limits([(results, step, "") for step in steps], view)
    frames = []
    for step in steps:
        figure = map_panels([(results, step, step_title(results, step))], view)
        buffer = BytesIO()
        figure.savefig(buffer, format="png", dpi=90, bbox_inches=None)
        plt.close(figure)
        frames.append(Image.open(buffer).convert("RGB").convert("P", palette=Image.Palette.ADAPTIVE, colors=128))
    frames[0].save(file_name, save_all=True, append_images=frames[1:], duration=int(1000 / frames_per_second), loop=0)


def step_title(results, step):
    return f"step {step}, t = {time_text(results.time(step))}"


def _aspect(results, view):
    chosen, (first, second) = plane_of(results, view)
    extent = np.ptp(results.x[chosen], axis=0)
    return float(np.clip(extent[second] / max(extent[first], 1e-300), 0.15, 2.0))

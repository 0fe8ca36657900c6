"""The command line of pdplot."""
import argparse
import math
import sys
from pathlib import Path

from .components import component_of
from .pictures import save
from .results import PlotError, Results, history_units, read_history, read_path

_EPILOG = """sample runs
  pdplot                                       the newest results here: Damage (or the first field) at the last step
  pdplot plate.h5 --field Concentration --step 1300,1800,2600,3000 -o hydrogen.png
  pdplot plate --field Displacement --component y --deformed auto
  pdplot plate --step all --animate crack.gif --crack 0.36
  pdplot plate --path Crack_Tip --measured test.txt      the way of the crack over the measured one
  pdplot plate other --field Damage            two runs and their difference
  pdplot plate other --history Crack_Length,Top_ReactionY
  pdplot specimen --growth                     da/dN over the range of K, and the exponent of the line through it
  pdplot solid --field Damage --slice z=0.002
"""
# What a viewer wants to see first.
_FAVOURITES = ["Damage", "Concentration", "Temperature", "Displacement"]


def main(arguments=None):
    options = _parser().parse_args(arguments)
    try:
        for file in _draw(options):
            print(file)
    except PlotError as error:
        print(f"pdplot: {error}", file=sys.stderr)
        return 2
    return 0


def _parser():
    parser = argparse.ArgumentParser(prog="pdplot", description="Pictures of the results of pdrun.", epilog=_EPILOG,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("results", nargs="*", help="results: NAME.h5, NAME or a folder; default: the newest here")
    parser.add_argument("--field", help="field to show; default: Damage, Concentration ... or the first there is")
    parser.add_argument("--component", help="x, y, z of a vector (default: its magnitude); of a tensor xx, xy ... zz, "
                        "von-mises, principal1 (largest), principal2, principal3 (default: von-mises of stresses, "
                        "principal1 of strains)")
    parser.add_argument("--step", default="last", metavar="last|all|N,N...", help="one or several, side by side")
    parser.add_argument("--deformed", nargs="?", const="auto", metavar="SCALE",
                        help="show points displaced, SCALE times (default: to a twentieth of the size)")
    parser.add_argument("--crack", nargs="?", const=0.36, type=float, metavar="DAMAGE",
                        help="outline what has more damage than this (default 0.36)")
    parser.add_argument("--path", metavar="TIP", help="draw the way of a Crack_Tip of the run, by its Output Label")
    parser.add_argument("--measured", metavar="FILE",
                        help="dots of a path from elsewhere: x y or x,y in m, a place a row")
    parser.add_argument("--slice", metavar="AXIS=POSITION", help="of a solid; default: through its thinnest middle")
    parser.add_argument("--range", nargs=2, type=float, metavar=("LOW", "HIGH"), help="of the colours")
    parser.add_argument("--map", help="matplotlib's colour map")
    parser.add_argument("--unit", help="unit of the field, for the label")
    parser.add_argument("--factor", type=float, default=1.0, help="multiplies the field")
    parser.add_argument("--animate", metavar="FILE.gif|mp4", help="all chosen steps as an animation")
    parser.add_argument("--speed", type=float, default=5.0, help="frames a second of the animation")
    parser.add_argument("--history", nargs="?", const="", metavar="COLUMN,COLUMN...",
                        help="curves of NAME.csv over time, all columns or those named")
    parser.add_argument("--growth", nargs="?", const="Crack_Length", metavar="LENGTH",
                        help="growth of a crack in a cycle, by the Output Label of its Crack_Length (default: "
                        "Crack_Length), on axes of logarithms over the range of K")
    parser.add_argument("--against", metavar="COLUMN", help="what the history is drawn over (default: time), or the "
                        "growth (default: Stress_Intensity_Range)")
    parser.add_argument("-o", "--output", help="picture to write (.png, .pdf, .svg)")
    return parser


def _draw(options):
    from . import figures
    if options.history is not None:
        return [_draw_history(options)]
    if options.growth is not None:
        return [_draw_growth(options)]
    runs = [Results(name) for name in options.results or [None]]
    view = _view(options, runs[0], figures)
    steps = [_steps(options.step, run) for run in runs]
    if options.deformed:
        view.scale = figures.auto_scale(runs[0], steps[0]) if options.deformed == "auto" else _number(options.deformed)
    if options.animate:
        from .animation import animation
        if len(runs) > 1:
            raise PlotError("--animate shows one run; name one")
        animation(runs[0], view, options.animate, steps[0] if len(steps[0]) > 1 else runs[0].steps, options.speed)
        return [options.animate]
    if len(runs) == 2 and len(steps[0]) == 1:
        figure = figures.comparison(*runs, [steps[0][0], steps[1][0]], view)
    else:
        labels = [f"{label}, " for label in figures.run_labels(runs)] if len(runs) > 1 else [""]
        panels = [(run, step, label + figures.step_title(run, step, view))
                  for run, label, chosen in zip(runs, labels, steps) for step in chosen]
        figure = figures.map_panels(panels, view)
    return [_write(figure, options, str(runs[0].path.with_name(f"{runs[0].label}_{view.field}.png")))]


def _draw_history(options):
    from .history import history_panels
    histories, units = _histories(options)
    columns = [column.strip() for column in options.history.split(",") if column.strip()]
    figure = history_panels(histories, columns, options.against, units)
    return _write(figure, options, f"{Path(histories[0][0]).name}_history.png")


def _draw_growth(options):
    from .growth import growth_panel
    histories, units = _histories(options)
    figure = growth_panel(histories, options.growth, options.against or "Stress_Intensity_Range", units)
    return _write(figure, options, f"{Path(histories[0][0]).name}_growth.png")


def _histories(options):
    """[(label, {column: values})] of the runs, and the units of the first."""
    names = options.results or [None]
    histories = [(_label(name), read_history(name or ".")) for name in names]
    if len({label for label, _ in histories}) < len(histories):
        histories = [(str(name), history) for name, (_, history) in zip(names, histories)]
    return histories, history_units(names[0] or ".", histories[0][1])


def _label(name):
    """Of results by the name that a user gave, in which points may stand."""
    path = Path(str(name or "."))
    return (path.stem if path.suffix in (".h5", ".csv", ".xdmf") else path.name) or "run"


def _write(figure, options, default):
    """`default`: its name where the user gives none."""
    output = options.output or default
    save(figure, output, "pdplot", is_named=bool(options.output))
    return output


def _view(options, results, figures):
    fields = results.fields()
    field = options.field or _most_telling(results, fields)
    if field is None:
        raise PlotError(f"{results.path}: no fields in the last step")
    field = next((name for name in fields if name.lower() == field.lower()), field)
    component = options.component and options.component.lower()
    values = results.field(field, results.steps[-1])
    if component and values.ndim == 1:
        raise PlotError(f"--component {component}: {field} is one number a point, not a vector")
    if component:
        component_of(field, values[:1], component)
    if options.slice and results.dimension < 3:
        raise PlotError(f"--slice {options.slice}: {results.path} is no solid; all its points are shown")
    if options.range and not options.range[0] < options.range[1]:
        raise PlotError(f"--range {options.range[0]:g} {options.range[1]:g}: expected the lower end first")
    if options.map and options.map not in figures.plt.colormaps():
        raise PlotError(f"--map {options.map}: no such map; even in lightness are viridis, cividis, inferno, "
                        "magma, plasma")
    if (options.path or options.measured) and (options.deformed or results.dimension == 1):
        raise PlotError("--path and --measured: paths are those of undeformed plane or solid bodies; leave out "
                        "--deformed")
    view = figures.View(field, component, crack=options.crack, slice=_slice(options.slice), limits=options.range,
                        map=options.map, unit=options.unit, factor=options.factor)
    view.path, view.measured = options.path, read_path(options.measured) if options.measured else None
    return view


def _most_telling(results, fields):
    """The first favourite that is not the same everywhere; failing that, the first there is."""
    there = [name for name in _FAVOURITES if name in fields] + [name for name in fields if name not in _FAVOURITES]
    return next((name for name in there if results.varies(name)), there[0] if there else None)


def _steps(text, results):
    if text == "last":
        return [results.steps[-1]]
    if text == "all":
        return results.steps
    try:
        return [int(word) for word in text.split(",")]
    except ValueError:
        raise PlotError(f"--step {text}: expected last, all or numbers such as 100,200") from None


def _slice(text):
    if text is None:
        return None
    axis, equals, position = text.partition("=")
    if axis not in ("x", "y", "z") or not equals:
        raise PlotError(f"--slice {text}: expected for example z=0.002")
    return "xyz".index(axis), _number(position)


def _number(text):
    try:
        number = float(text)
    except ValueError:
        raise PlotError(f"`{text}` is not a number") from None
    if not math.isfinite(number):
        raise PlotError(f"`{text}` is not a finite number")
    return number

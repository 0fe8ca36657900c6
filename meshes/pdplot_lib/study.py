"""Error against wall time and against bond-updates, of the runs of a study."""
import argparse
import csv
import sys
from pathlib import Path

from .results import PlotError

_MARKERS = "os^vDP*X<>"


def read_table(path):
    """{label: [(error, seconds, bond-updates, overrides), ...]} of NAME.study.csv, without runs that failed."""
    series = {}
    try:
        with open(path, newline="") as file:
            for row in csv.DictReader(file):
                points = series.setdefault(row["label"], [])
                if row["error"] and float(row["error"]) > 0.0:
                    points.append((float(row["error"]), float(row["seconds"]), float(row["bond_updates"]),
                                   row["overrides"]))
    except (OSError, KeyError, ValueError, TypeError) as error:
        raise PlotError(f"{path}: cannot be read as the table of a study ({error})") from error
    if not any(series.values()):
        raise PlotError(f"{path}: no run with an error above zero: nothing to draw on logarithmic axes")
    return {label: points for label, points in series.items() if points}


def draw(series, error, reference, output):
    from .figures import plt  # sets the style
    figure, panels = plt.subplots(1, 2, figsize=(10, 4.4), sharey=True, constrained_layout=True)
    for (label, points), marker in zip(series.items(), _MARKERS * (1 + len(series) // len(_MARKERS))):
        for panel, column in zip(panels, (1, 2)):
            panel.loglog([point[column] for point in points], [point[0] for point in points], marker=marker,
                         markersize=5, linewidth=1.2, label=label)
    panels[0].set_xlabel("wall time (s)")
    panels[1].set_xlabel("directed bond-updates")
    panels[0].set_ylabel(f"error {error}".strip())
    for panel in panels:
        panel.grid(alpha=0.3, which="both")
    panels[1].legend(fontsize=8)
    if reference:
        figure.suptitle(f"reference: {reference}", fontsize=9)
    figure.savefig(output, dpi=150)


def main(arguments=None):
    parser = argparse.ArgumentParser(prog="pdstudy", description="Log-log picture of the table of a study.",
                                     epilog="sample run: pdstudy hydrogen_diffusion.study.csv -o study.png")
    parser.add_argument("table", help="NAME.study.csv, which pdrun --study writes")
    parser.add_argument("--reference", default="", help="what the errors are taken against, for the title")
    parser.add_argument("--error", default="", help="name of the error norm, for the axis")
    parser.add_argument("-o", "--output", help="picture to write (.png, .pdf, .svg); default: NAME.study.png")
    options = parser.parse_args(arguments)
    try:
        draw(read_table(options.table), options.error, options.reference,
             options.output or str(Path(options.table).with_suffix(".png")))
    except PlotError as error:
        print(f"pdstudy: {error}", file=sys.stderr)
        return 2
    return 0

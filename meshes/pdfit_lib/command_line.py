"""The command line of pdfit."""
import argparse
import sys

from pdplot_lib.results import PlotError

from .problem import FitError, Problem


def _fit(problem):
    """Whether it converged."""
    # Late, since SciPy takes a while.
    from .intervals import Judgement
    from .least_squares import Fit
    from .report import Iterations, coarse_history, draw, summary_of, write_residuals, write_results
    from .runs import Runs
    runs = Runs(problem)
    table = Iterations(problem, runs)
    fitted = Fit(problem, runs, table.add).run()
    judgement = Judgement(problem, fitted)
    histories = runs.histories([problem.unscaled(fitted.scaled)])[0]
    models = [series.model(histories) for series in problem.series]
    write_residuals(problem, models)
    write_results(problem, runs, fitted, judgement, models)
    for warning in filter(None, (coarse_history(series, histories) for series in problem.series)):
        print(f"warning: {warning}", file=sys.stderr, flush=True)
    for judged in judgement.values:
        problem.print(judged.text())
    for series, model in zip(problem.series, models):
        unit = ("standard deviations" if series.has_deviations else
                "(logarithms)" if series.is_logarithmic else series.unit)
        for what, numbers in zip(("fitted", "not fitted"), summary_of(series, model)):
            if numbers:
                problem.print(f"{series.label}, points {what}: off by {numbers[0]:.3g} (rms), {numbers[1]:.3g} at most "
                              f"{unit}".rstrip())
    problem.print(f"table: {problem.base}.fit.csv, residuals: {problem.base}.fit.residuals.csv")
    try:
        draw(problem, judgement, models, histories)
        problem.print(f"picture: {problem.base}.fit.png")
    except PlotError as error:
        problem.print(f"no picture: {error}")
    return fitted.is_converged


def main(arguments=None):
    parser = argparse.ArgumentParser(
        prog="pdfit", description="Adjusts values of decks until histories of runs agree with measured series. "
        "`pdrun --fit fit.yaml` checks the fit and starts this program.",
        epilog="sample run: pdfit results/wire.fit.problem.json   repeats the fit that pdrun has written there; runs "
        "that are there are not repeated")
    parser.add_argument("problem", help="NAME.fit.problem.json, which pdrun --fit writes")
    try:
        problem = Problem(parser.parse_args(arguments).problem)
        if _fit(problem):
            return 0
        print(f"pdfit: the fit has not converged in {problem.max_iterations} steps; {problem.base}.fit.json has the "
              "values so far. With a larger Maximum Iterations it goes on: runs that are there are not repeated",
              file=sys.stderr)
        return 3
    except (OSError, ValueError, KeyError) as error:
        print(f"pdfit: {error}", file=sys.stderr)
        return 2
    except FitError as error:
        print(f"pdfit: {error}", file=sys.stderr)
        return 3

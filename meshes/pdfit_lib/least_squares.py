"""Nonlinear least squares by SciPy's trust region within bounds, with differences whose runs go on side by side."""
import sys

import numpy as np
from scipy.optimize import least_squares

from .problem import FitError


class Fitted:
    """Where a fit has ended: scaled values, residuals and their derivatives there, which values are at a bound."""

    def __init__(self, solution, jacobian):
        self.scaled, self.residuals, self.jacobian = solution.x, solution.fun, jacobian
        self.active, self.message, self.is_converged = solution.active_mask, solution.message, solution.status > 0


class Fit:
    def __init__(self, problem, runs, on_iteration):
        """on_iteration(values, sum of squares): called at the start and after each step that was taken."""
        self.problem, self.runs, self.on_iteration = problem, runs, on_iteration
        self.lowest = np.array([value.bounds[0] for value in problem.values])
        self.highest = np.array([value.bounds[1] for value in problem.values])
        self._last = None  # scaled values and derivatives
        self._told = set()

    def run(self):
        start = np.array([value.scaled(value.start) for value in self.problem.values])
        # Rounding of logarithms must not put a start on a bound beyond it.
        start = np.clip(start, self.lowest, self.highest)
        residuals = self._residuals([start])[0]
        if not np.all(np.isfinite(residuals)):
            raise FitError("with the values of Start " + self._reason(start))
        self._look_for_influence(self._derivatives(start, residuals))
        # Its evaluations are that of the start and one a step.
        solution = least_squares(lambda u: self._residuals([u])[0], start, jac=self._jacobian, x_scale="jac",
                                 bounds=(self.lowest, self.highest), method="trf", ftol=self.problem.tolerance,
                                 xtol=self.problem.tolerance, gtol=1e-10, max_nfev=1 + self.problem.max_iterations)
        return Fitted(solution, self._derivatives(solution.x, solution.fun))

    def _residuals(self, sets):
        """Of the fitted points, for each set of scaled values; infinite where runs failed or ended too soon, which is
        told."""
        results = []
        for scaled, histories in zip(sets, self.runs.histories([self.problem.unscaled(u) for u in sets])):
            if histories is None:
                results.append(np.full(sum(series.is_fitted.sum() for series in self.problem.series), np.inf))
                continue
            parts = [series.residuals(series.model(histories))[series.is_fitted] for series in self.problem.series]
            residuals = np.concatenate(parts)
            results.append(np.where(np.isfinite(residuals), residuals, np.inf))
            if not np.all(np.isfinite(residuals)):
                self._tell(scaled)
        return results

    def _reason(self, scaled):
        """Why there are no residuals with these values."""
        values = self.problem.unscaled(scaled)
        said = self.runs.why(values)
        if said:
            return f"a run failed: {said}"
        histories = self.runs.histories([values])[0]
        for series in self.problem.series:
            obstacle = series.obstacle(series.model(histories))
            if obstacle:
                row, why = obstacle
                return f"{series.places[row]} (run {self.runs.name(series.runs[row], values)}): {why}"
        return ""

    def _tell(self, scaled):
        """Once; at the start the error does."""
        text = f"a trial failed with {self.problem.text(self.problem.unscaled(scaled))}:\n  {self._reason(scaled)}"
        if self._last is not None and text not in self._told:
            self._told.add(text)
            print(text, file=sys.stderr, flush=True)

    def _jacobian(self, scaled):
        residuals = self._residuals([scaled])[0]
        self.on_iteration(self.problem.unscaled(scaled), float(residuals @ residuals))
        return self._derivatives(scaled, residuals)

    def _derivatives(self, scaled, residuals):
        """By differences, forward where there is room, of all values at once."""
        if self._last is not None and np.array_equal(self._last[0], scaled):
            return self._last[1]
        steps = np.array([value.step(self.problem.difference_step) for value in self.problem.values])
        room = np.maximum(self.highest - scaled, scaled - self.lowest)
        steps = np.minimum(steps, room)
        signs = np.where(scaled + steps <= self.highest, 1.0, -1.0)
        there = self._residuals([self._moved(scaled, i, signs[i] * steps[i]) for i in range(len(scaled))])
        columns = [(moved - residuals) / (sign * step) for moved, sign, step in zip(there, signs, steps)]
        others = [i for i in range(len(scaled)) if self._needs_other_side(scaled, i, -signs[i] * steps[i], columns[i])]
        back = self._residuals([self._moved(scaled, i, -signs[i] * steps[i]) for i in others])
        for i, moved in zip(others, back):
            other = (residuals - moved) / (signs[i] * steps[i])
            known = [column for column in (columns[i], other) if np.all(np.isfinite(column))]
            if known:
                columns[i] = np.mean(known, axis=0)
        for i, column in enumerate(columns):
            if not np.all(np.isfinite(column)):
                raise FitError(f"beside {self.problem.values[i].name} = "
                               f"{self.problem.values[i].text(self.problem.unscaled(scaled)[i])} no run comes to its "
                               "end by which a derivative could be found; narrow its bounds, or take a smaller "
                               "Difference Step. " + self._reason(self._moved(scaled, i, signs[i] * steps[i])))
        self._last = (scaled.copy(), np.stack(columns, axis=1))
        return self._last[1]

    def _needs_other_side(self, scaled, i, step, column):
        has_room = self.lowest[i] <= scaled[i] + step <= self.highest[i]
        return has_room and (self.problem.is_central or not np.all(np.isfinite(column)))

    @staticmethod
    def _moved(scaled, i, step):
        moved = scaled.copy()
        moved[i] += step
        return moved

    def _look_for_influence(self, jacobian):
        influence = np.linalg.norm(jacobian, axis=0)
        for value, size in zip(self.problem.values, influence):
            if size <= 1e-9 * influence.max() or size == 0.0:
                raise FitError(f"{value.name} has no influence on any fitted point at its Start; leave it out of "
                               "Values, compare another history, or take a larger Difference Step")

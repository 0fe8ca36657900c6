"""What a fit says of its values: intervals of 95 % confidence from the derivatives, and where they are worth little."""
import numpy as np
from scipy.stats import norm, t

_SIGNIFICANT = 1e-6  # singular values below this share of the largest are none


class Judged:
    """A value with what is known of it. interval: None where the points do not tell one."""

    def __init__(self, value, number, interval, note):
        self.value, self.number, self.interval, self.note = value, number, interval, note

    def text(self):
        text = f"{self.value.name} = {self.value.text(self.number)}"
        if self.interval is not None:
            text += f"  (95 %: {self.interval[0]:.4g} to {self.interval[1]:.4g})"
        return text + (f"  {self.note}" if self.note else "")


class Judgement:
    """values: [Judged]; sum_of_squares; degrees: of freedom; correlation [n, n], not numbers where there is
    none."""

    def __init__(self, problem, fitted):
        self.sum_of_squares = float(fitted.residuals @ fitted.residuals)
        n_values = len(problem.values)
        is_free = fitted.active == 0
        self.degrees = len(fitted.residuals) - int(is_free.sum())
        covariance, is_determined = _covariance(fitted.jacobian[:, is_free])
        self.correlation = np.full((n_values, n_values), np.nan)
        free = np.flatnonzero(is_free)
        deviation = np.sqrt(np.diag(covariance))
        with np.errstate(invalid="ignore", divide="ignore"):
            self.correlation[np.ix_(free, free)] = covariance / np.outer(deviation, deviation)
        factor = self._factor(problem.has_deviations)
        half = np.full(n_values, np.nan)
        half[free] = np.where(is_determined, factor * deviation, np.inf)
        self.values = [self._judged(problem, fitted, i, half[i]) for i in range(n_values)]

    def _factor(self, has_deviations):
        """Half of an interval in standard deviations as the derivatives have them. Deviations that are given count,
        unless the points scatter more than they say; without them the scatter tells."""
        if self.degrees <= 0:
            return norm.ppf(0.975) if has_deviations else np.inf
        variance = self.sum_of_squares / self.degrees
        if has_deviations and variance <= 1.0:
            return norm.ppf(0.975)
        return t.ppf(0.975, self.degrees) * np.sqrt(variance)

    def _judged(self, problem, fitted, i, half):
        value, scaled = problem.values[i], fitted.scaled[i]
        number = value.unscaled(scaled)
        if fitted.active[i] != 0:
            bound = "Lowest" if fitted.active[i] < 0 else "Highest"
            return Judged(value, number, None, f"at its bound {bound}: the points ask for a value beyond it")
        if not np.isfinite(half):
            why = ("as many values as points" if self.degrees <= 0 else
                   "the points do not tell it from the other values, or not at all")
            return Judged(value, number, None, f"not determined: {why}")
        interval = sorted((value.unscaled(scaled - half), value.unscaled(scaled + half)))
        notes = []
        if half > (np.log(10.0) if value.is_logarithmic else max(abs(scaled), 1e-300)):
            notes.append("hardly determined: the interval is wider than the value")
        for j, other in enumerate(problem.values):
            if j != i and abs(self.correlation[i, j]) > 0.95:
                notes.append(f"goes with {other.name} (correlation {self.correlation[i, j]:.3f})")
        return Judged(value, number, interval, "; ".join(notes))


def _covariance(jacobian):
    """Inverse of the normal matrix, and which values it is worth something for."""
    if jacobian.shape[1] == 0:
        return np.zeros((0, 0)), np.zeros(0, dtype=bool)
    size = np.linalg.norm(jacobian, axis=0)
    size[size == 0.0] = 1.0
    _, singular, rows = np.linalg.svd(jacobian / size, full_matrices=False)
    significant = singular > _SIGNIFICANT * singular[0]
    scaled = rows[significant].T / singular[significant]
    lost = np.sqrt((rows[~significant] ** 2).sum(axis=0))
    return (scaled @ scaled.T) / np.outer(size, size), lost < 1e-3

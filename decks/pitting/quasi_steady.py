"""A pit under a cover with one slit, in the plane, as an ordinary differential equation; shares nothing with the library.

The pit spreads evenly from the slit (width w, through a cover of thickness L): at depth d its wall has the length
w + pi d and encloses w d + pi d^2/2. Electrolyte in it is steady: the ions F that leave, mol/(m s), need the difference

    C_wall = F/D (L/w + ln(pi e R/(2 w))/pi),    R = d + w/4,

of concentration; the first term is that of the slit, the second of a half plane that a channel opens into, from the
conformal map z = w/pi (sqrt(q^2 - 1) - arccos(1/q)), R the conformal radius of the wall. The current sets the speed until
C_wall = C_sat; then salt covers the wall and F, from C_sat, does.
"""
import numpy as np

FARADAY = 96485.33212


class CoveredPit:
    """SI units; concentrations mol/m3."""

    def __init__(self, width=10e-6, thickness=4e-6, diffusivity=860e-12, solid=142900.0, saturation=4600.0, current=5.1e3,
                 charge=2.19):
        self.width, self.thickness, self.diffusivity = width, thickness, diffusivity
        self.solid, self.saturation, self.speed = solid, saturation, current / (charge * FARADAY * solid)

    def resistance(self, depth):
        """Of electrolyte in slit and pit: C_wall = F resistance/D."""
        radius = depth + 0.25 * self.width
        return self.thickness / self.width + np.log(0.5 * np.pi * np.e * radius / self.width) / np.pi

    def wall(self, depth):
        return self.width + np.pi * depth

    def most_ions(self, depth):
        """F under salt, mol/(m s)."""
        return self.diffusivity * self.saturation / self.resistance(depth)

    def rate(self, depth):
        """m/s; the ions that stay in the electrolyte are those of C_sat less half the way to a line's source."""
        ions = self.most_ions(depth)
        kept = self.saturation - ions / (2 * np.pi * self.diffusivity)
        bare = self.speed * self.wall(depth) * (self.solid - self.saturation)
        return np.where(ions >= bare, self.speed, np.minimum(self.speed, ions / (self.wall(depth) * (self.solid - kept))))

    def transition(self):
        """Depth at which salt appears."""
        low, high = 0.0, 1.0
        for _ in range(80):
            middle = 0.5 * (low + high)
            isBare = self.most_ions(middle) > self.speed * self.wall(middle) * (self.solid - self.saturation)
            low, high = (middle, high) if isBare else (low, middle)
        return low

    def depths(self, times, farthest=1e-3):
        """At `times`: t(d) by the trapezoidal rule, inverted."""
        grid = np.linspace(0.0, farthest, 20001)
        slowness = 1.0 / self.rate(grid)
        elapsed = np.concatenate([[0.0], np.cumsum(0.5 * (slowness[1:] + slowness[:-1]) * np.diff(grid))])
        return np.interp(times, elapsed, grid)


def exponents(times, depths):
    """d ln depth/d ln t between neighbours, and the times in the middle."""
    return np.sqrt(times[1:] * times[:-1]), np.diff(np.log(depths)) / np.diff(np.log(times))

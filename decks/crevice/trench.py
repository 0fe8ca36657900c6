#!/usr/bin/python3
"""The trench of the crevice in two dimensions, by finite volumes on a grid that follows the wall; shares nothing with
the library.

Where the trench is deep, C differs across it and its walls slant, which gap_averaged.py knows nothing of. Here it is
C(x, eta), eta = y/h(x, t) from 0 on the line of symmetry to 1 on the wall, where h = h0 + s. With the wall's
concentration w,

    d(h C)/dt + ... = div(D grad C)    of cells that grow with h; the wall adds C_solid ds/dt,
    (C_solid - w) ds/dt = D (dC/dy - dh/dx dC/dx)    at the wall,
    ds/dt <= v(w) sqrt(1 + (dh/dx)^2),    w <= C_sat,    one of the two an equality at each x:

bare metal recedes at v along its normal. The first hours, in which the site runs to the mouth and eats 1 um off the
walls, are those of the gap-averaged model; its state at 6 h is the start, and the part next to the mouth the domain.

Sample runs:
  trench.py                                 72 h in half a minute: depths and places
  trench.py --columns 640 --longest 100     finer
"""
import argparse
from dataclasses import dataclass

import numpy as np
import scipy.sparse as sparse
from gap_averaged import HOUR, Crevice, simulate, slow_from
from scipy.sparse.linalg import splu


@dataclass
class Trench:
    """Times in s; rows of `depth` are snapshots at `times`, columns those of the grid; concentration [snapshots,
    columns, layers + 1], the last entry of a column that of the wall."""

    crevice: Crevice
    x: np.ndarray
    eta: np.ndarray
    times: np.ndarray
    depth: np.ndarray
    concentration: np.ndarray
    site: np.ndarray  # where saturation begins
    steps: int = 0
    massError: float = 0.0  # largest at a snapshot, of the metal dissolved

    def deepest(self, k=-1):
        """Largest depth, its place, and how far to either side, mouth and closed end, it is half as deep."""
        depth, x = self.depth[k], self.x
        top = int(np.argmax(depth))
        half = 0.5 * depth[top]
        return depth[top], x[top], x[top] - np.interp(half, depth[:top + 1], x[:top + 1]), \
            np.interp(-half, -depth[top:], x[top:]) - x[top]

    def stop(self, drift=0.01):
        return slow_from(self.times, self.site, drift * self.crevice.length, window=4 * HOUR)


def derivative(n, width):
    """Of n values in a row at their places: central, one-sided at the ends."""
    matrix = sparse.diags([np.full(n - 1, -0.5 / width), np.full(n - 1, 0.5 / width)], [-1, 1]).tolil()
    matrix[0, :2] = matrix[n - 1, n - 2:] = [-1.0 / width, 1.0 / width]
    return matrix.tocsr()


class MappedGrid:
    """`columns` along x over `length`, `layers` across; values of a column: those of its cells, then that of the wall."""

    def __init__(self, crevice, length, columns, layers):
        self.crevice, self.columns, self.layers, self.dx = crevice, columns, layers, length / columns
        self.x = (np.arange(columns) + 0.5) * self.dx
        self.halfGap = 0.5 * (crevice.mouthGap + (crevice.endGap - crevice.mouthGap) * self.x / crevice.length)
        self.lines = np.arange(layers + 1) / layers
        self.eta = (np.arange(layers) + 0.5) / layers
        across = self.of_column(layers)
        alongLines = derivative(columns, self.dx)
        one = sparse.identity(columns)
        faces = sparse.diags([-np.ones(columns), np.ones(columns)], [-1, 0], shape=(columns + 1, columns)).tolil()
        faces[0, 0], faces[columns, columns - 1] = 2.0, 0.0  # C = 0 half a cell from the mouth's cells; closed end
        mean = (0.5 * abs(sparse.diags([np.ones(columns), np.ones(columns)], [-1, 0],
                                       shape=(columns + 1, columns)))).tolil()
        mean[0, 0] = mean[columns, columns - 1] = 0.0  # C = 0 all over the mouth
        cells = sparse.eye(layers, layers + 1)
        self.valueOnLines = sparse.kron(one, across["value"]).tocsr()
        self.slopeOnLines = sparse.kron(one, across["slope"]).tocsr()
        self.alongLines = sparse.kron(alongLines, across["value"]).tocsr()
        self.alongFaces = sparse.kron(faces / self.dx, cells).tocsr()
        self.acrossFaces = sparse.kron(mean, across["inCells"]).tocsr()
        # Gain of cells, and for the walls (the last row of a column) minus the flux that comes from the wall's line.
        up = sparse.eye(layers + 1, layers + 1, 1).tolil()
        low = sparse.eye(layers + 1, layers + 1).tolil()
        up[layers - 1] = low[layers] = 0.0
        up[layers, layers] = -1.0
        self.gainByLines = sparse.kron(one, (up - low)).tocsr()
        gainByFaces = sparse.diags([-np.ones(columns), np.ones(columns)], [0, 1], shape=(columns, columns + 1))
        self.gainByFaces = sparse.kron(gainByFaces, sparse.eye(layers + 1, layers)).tocsr()
        # What a line that moves with the wall takes up of the cells' content, per length and ds/dt.
        moving = sparse.diags(np.append(self.lines[:-1], 0.0)) @ across["value"]
        self.swept = sparse.kron(one, sparse.csr_matrix(self.shifted(moving) - moving)).tocsr()

    @staticmethod
    def of_column(layers):
        """Values and eta derivatives on the lines, and derivatives in the cells, by the values of a column."""
        value, slope = np.zeros((layers + 1, layers + 1)), np.zeros((layers + 1, layers + 1))
        value[0, 0] = value[layers, layers] = 1.0
        for line in range(1, layers):
            value[line, line - 1:line + 1] = 0.5
            slope[line, line - 1:line + 1] = -layers, layers
        slope[layers, layers - 1:] = -2.0 * layers, 2.0 * layers
        return {"value": sparse.csr_matrix(value), "slope": sparse.csr_matrix(slope),
                "inCells": sparse.csr_matrix(layers * np.diff(value, axis=0))}

    @staticmethod
    def shifted(matrix):
        """Rows of the line above; the wall's line is moved by the metal, and has none."""
        dense = np.zeros(matrix.shape)
        dense[:-1] = matrix.toarray()[1:]
        dense[-2] = 0.0
        return sparse.csr_matrix(dense)

    def diffusion(self, h):
        """Matrix of the cells' gain by diffusion, mol/(m s); rows of the wall: minus what it gives, mol/(m2 s)."""
        d, layers = self.crevice.diffusivity, self.layers
        slope = np.gradient(h, self.dx)
        eta, slopes, gaps = np.tile(self.lines, self.columns), np.repeat(slope, layers + 1), np.repeat(h, layers + 1)
        onLines = sparse.diags(d * (1.0 + (eta * slopes) ** 2) / gaps) @ self.slopeOnLines \
            - sparse.diags(d * eta * slopes) @ self.alongLines
        between = np.concatenate([h[:1] - 0.5 * self.dx * slope[0], 0.5 * (h[1:] + h[:-1]), h[-1:]])
        tilt = np.concatenate([slope[:1], np.diff(h) / self.dx, slope[-1:]])
        tilts = np.repeat(tilt, layers) * np.tile(self.eta, self.columns + 1)
        onFaces = d / layers * (sparse.diags(np.repeat(between, layers)) @ self.alongFaces
                                - sparse.diags(tilts) @ self.acrossFaces)
        widths = np.tile(np.append(np.full(layers, self.dx), 1.0), self.columns)
        return sparse.diags(widths) @ self.gainByLines @ onLines + self.gainByFaces @ onFaces


class Walls:
    """ds/dt and w on the kinked graph by u, as in gap_averaged.py."""

    def __init__(self, crevice):
        self.crevice, self.fullSpeed = crevice, crevice.speed(crevice.saturation)[0]

    def on_graph(self, u, stretch):
        saturation, isBare = self.crevice.saturation, u <= 0.0
        wall = saturation + np.minimum(u, 0.0)
        speed, slope = self.crevice.speed(wall)
        rate = np.where(isBare, speed, self.fullSpeed * (1.0 - u / saturation))
        return wall, stretch * rate, isBare * 1.0, stretch * np.where(isBare, slope, -self.fullSpeed / saturation)


@dataclass
class State:
    values: np.ndarray  # [columns, layers + 1]
    depth: np.ndarray
    u: np.ndarray
    rate: np.ndarray
    outflow: float = 0.0


class Stepper:
    """Backward Euler; the geometry of the diffusion is that of the step's start."""

    tolerance, maximumIterations = 1e-10, 30

    def __init__(self, grid):
        self.grid, self.walls = grid, Walls(grid.crevice)
        self.isWall = np.tile(np.append(np.zeros(grid.layers, bool), True), grid.columns)
        self.ofCells = np.tile(np.append(np.full(grid.layers, grid.dx / grid.layers), 0.0), grid.columns)
        self.column = np.repeat(np.arange(grid.columns), grid.layers + 1)
        metal = np.zeros(grid.layers + 1)
        metal[-2] = grid.crevice.solid * grid.dx
        self.metal = np.tile(metal, grid.columns)

    def stretch(self, depth):
        """Length of wall per length along x, by the deeper neighbour: what is deep spreads to the sides."""
        rise = np.diff(depth) / self.grid.dx
        return np.sqrt(1.0 + np.maximum(0.0, np.maximum(np.append(rise, 0.0), np.append(0.0, -rise))) ** 2)

    def step(self, old, length):
        """None where Newton's method fails."""
        grid, solid, saturation = self.grid, self.grid.crevice.solid, self.grid.crevice.saturation
        h = grid.halfGap + old.depth
        diffusion, stretch = grid.diffusion(h), self.stretch(old.depth)
        volume = self.ofCells * h[self.column]
        content = volume * old.values.ravel()
        values, u = old.values.ravel().copy(), old.u
        for _ in range(self.maximumIterations):
            wall, rate, wallByU, rateByU = self.walls.on_graph(u, stretch)
            values[self.isWall] = wall
            rates, grown = rate[self.column], volume + length * self.ofCells * rate[self.column]
            swept, gain = grid.swept @ values, diffusion @ values
            residual = grown * values - content - length * (gain + rates * (grid.dx * swept + self.metal))
            # Of the wall: what diffuses away from it is what the metal gives less what stays in its place.
            scale = length * solid * self.walls.fullSpeed / saturation  # of the size of the cells' entries
            residual[self.isWall] = (gain[self.isWall] + (solid - wall) * rate) * scale
            byRate = length * (self.ofCells * values - grid.dx * swept - self.metal)
            byU = sparse.csr_matrix(((byRate * rateByU[self.column])[~self.isWall],
                                     (np.flatnonzero(~self.isWall), self.column[~self.isWall])),
                                    shape=(len(values), grid.columns))
            jacobian = sparse.diags(grown) - length * (diffusion + grid.dx * sparse.diags(rates) @ grid.swept)
            jacobian = sparse.diags(np.where(self.isWall, 0.0, 1.0)) @ jacobian \
                + sparse.diags(np.where(self.isWall, scale, 0.0)) @ diffusion
            chain = np.ones(len(values))
            chain[self.isWall] = wallByU
            direct = np.zeros(len(values))
            direct[self.isWall] = scale * ((solid - wall) * rateByU - wallByU * rate)
            spread = sparse.csr_matrix((np.ones(grid.columns), (np.arange(grid.columns), np.flatnonzero(self.isWall))),
                                       shape=(grid.columns, len(values)))
            byUnknowns = jacobian @ sparse.diags(chain) + sparse.diags(direct) + byU @ spread
            change = splu(byUnknowns.tocsc()).solve(-residual)
            values = np.where(self.isWall, values, values + change)
            wanted = np.maximum(u + change[self.isWall], -saturation)
            crosses = (u > 0.0) != (wanted > 0.0)
            wanted[crosses] = np.where(u[crosses] > 0.0, -1e-14, 1e-14) * saturation
            largest = max(np.max(np.abs(wanted - u)), np.max(np.abs(change[~self.isWall])))
            u = wanted
            if largest < self.tolerance * saturation and not np.any(crosses):
                return self.finished(old, values, u, stretch, length, diffusion)
        return None

    def finished(self, old, values, u, stretch, length, diffusion):
        wall, rate, _, _ = self.walls.on_graph(u, stretch)
        values[self.isWall] = wall
        # What diffusion takes from all cells together leaves by the mouth.
        lost = -np.sum((diffusion @ values)[~self.isWall])
        return State(values.reshape(self.grid.columns, -1), old.depth + length * rate, u, rate,
                     old.outflow + length * lost)

    def mass(self, state):
        return np.sum(self.ofCells * (self.grid.halfGap + state.depth)[self.column] * state.values.ravel())

    def active_site(self, state):
        """Where saturation begins, coming from the mouth: in a cell that is bare over the part that its rate tells."""
        first = int(np.argmax(state.u > 0.0))
        bare = state.rate[first] / (self.walls.fullSpeed * self.stretch(state.depth)[first])
        return self.grid.x[first] + self.grid.dx * (np.clip(bare, 0.0, 1.0) - 0.5)


def carve(crevice=Crevice(), hours=72, columns=320, layers=6, longest=300.0, length=4e-3, start=6):
    """The trench at all whole hours from `start` to `hours`, in steps of `longest` s after a short run-up. RuntimeError
    where a step has no solution."""
    before = simulate(crevice, start * HOUR, snapshots=1)
    stepper = Stepper(MappedGrid(crevice, length, columns, layers))
    grid, saturation = stepper.grid, crevice.saturation
    mean = np.interp(grid.x, np.append(0.0, before.x), np.append(0.0, before.concentration[-1]))
    isFull = mean > saturation * (1.0 - 1e-9)
    state = State(np.repeat(mean[:, None], layers + 1, axis=1), np.interp(grid.x, before.x, before.depth[-1]),
                  np.where(isFull, saturation, mean - saturation), np.zeros(columns))
    known = stepper.mass(state) - crevice.solid * np.sum(state.depth) * grid.dx
    times = HOUR * np.arange(start, hours + 1)
    result = Trench(crevice, grid.x, grid.eta, times, np.zeros((len(times), columns)),
                    np.zeros((len(times), columns, layers + 1)), np.zeros(len(times)))
    now, proposed = times[0], 1.0
    for k, end in enumerate(times):
        while now < end - 1e-6:
            taken = min(proposed, end - now)
            new = stepper.step(state, taken)
            if new is None:
                proposed = 0.25 * taken
                if proposed < 1e-3:
                    raise RuntimeError(f"no solution of a step of {taken:g} s at {now:g} s")
                continue
            state, now, result.steps = new, now + taken, result.steps + 1
            proposed = min(longest, 1.5 * proposed)
        result.depth[k], result.concentration[k], result.site[k] = state.depth, state.values, stepper.active_site(state)
        metal = crevice.solid * np.sum(state.depth) * grid.dx
        result.massError = max(result.massError, abs(stepper.mass(state) + state.outflow - known - metal) / metal)
    return result


def main():
    parser = argparse.ArgumentParser(description="The trench of crevice corrosion of alloy 625, in two dimensions.")
    parser.add_argument("--factor", type=float, default=Crevice().factor, help="on the printed rates")
    parser.add_argument("--hours", type=int, default=72)
    parser.add_argument("--columns", type=int, default=320)
    parser.add_argument("--layers", type=int, default=6)
    parser.add_argument("--longest", type=float, default=300.0, help="step, s")
    given = parser.parse_args()
    result = carve(Crevice(factor=given.factor), given.hours, given.columns, given.layers, given.longest)
    for k, t in enumerate(result.times):
        if t / HOUR in (10, 15, 20, 30, 40, 50, 60) or k + 1 == len(result.times):
            depth, place, towardsMouth, towardsEnd = result.deepest(k)
            print(f"{t / HOUR:g} h: {depth * 1e6:.1f} um deep at {place * 1e3:.3f} mm, half as deep "
                  f"{towardsMouth * 1e6:.0f} um nearer to the mouth and {towardsEnd * 1e6:.0f} um nearer to the closed "
                  f"end; saturated from {result.site[k] * 1e3:.3f} mm on")
    for drift in (0.01, 0.005):
        t, x = result.stop(drift)
        print(f"active site drifts less than {100 * drift:g} % of L in 10 h from {t / HOUR:.3g} h on, "
              f"then at {x * 1e3:.4g} mm")
    print(f"{result.steps} steps; mass kept to {result.massError:.1e} of the metal dissolved")


if __name__ == "__main__":
    main()

"""The linear loop many steps at a time.

Between its limits loop and plant are one linear system. K steps of it are one matrix: from the state at the start
of a block and the trajectory points in it to every column of the block. The states at the starts of the blocks
follow by the same trick, 16 blocks at a time, and again 16 times 16. So a minute at 4 kHz is a handful of matrix
products. Every block is checked against the limits; from the first that breaks one the plain steps take over until
the loop is calm again. Positions inside a block are relative to the point at which it begins, so nothing is lost
far from zero.
"""

from __future__ import annotations

from functools import lru_cache
from math import inf, lcm
from typing import TYPE_CHECKING

import numpy as np

from motionlang.controller.servo.discrete import discretise
from motionlang.controller.servo.linear import Probe, kept_places
from motionlang.controller.servo.steps import MEMORY, empty_columns, stepper

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from motionlang.controller.servo.loop import Loop
    from motionlang.controller.servo.plant import Drive, Motor
    from motionlang.controller.servo.steps import State

    Array = NDArray[np.float64]

BLOCK = 48
"""Steps in a block, as nearly as the cycles allow."""
LONGEST = 256
GROUP = 16
CHUNK = 2048
FIRST_CHUNK = 512
"""Blocks that are tried at once, at most and to begin with."""
_CAUTIOUS = 256
WORTHWHILE = 4
"""Blocks below which plain steps are quicker."""
_CALM = 1
_PATIENCE = 128


@lru_cache(maxsize=32)
def lift(loop: Loop, plant: Motor | Drive, columns: tuple[str, ...], integrating: bool) -> Lifted | None:
    """The block form of a loop and a plant; None where they are not linear or their periods do not meet."""
    unit = lcm(loop.ratio, loop.derivative_every if loop.derivative else 1)
    if not (loop.is_linear and plant.is_linear) or unit > LONGEST:
        return None
    return Lifted(loop, plant, columns, integrating, unit * max(1, round(BLOCK / unit)))


class Lifted:
    """One loop and one plant, `steps` samples to a block."""

    def __init__(
        self, loop: Loop, plant: Motor | Drive, columns: tuple[str, ...], integrating: bool, steps: int
    ) -> None:
        self.steps, self.cycles = steps, steps // loop.ratio
        self.columns = columns
        self.stepper = stepper(loop, plant, columns, integrating)
        self.ratio, self.has_feed = loop.ratio, loop.has_feed_forward
        names = discretise(plant, loop.period).names
        self.size = len(names) + len(MEMORY)
        self.kept = kept_places(loop, names)
        self.shifting = np.array([i in (0, len(names) + MEMORY.index("last_position")) for i in self.kept])
        self.checks = _checks(loop)
        wanted = tuple(dict.fromkeys((*columns, *self.checks)))
        # A loop that grows beyond all numbers within one block breaks its limits: its blocks are never used.
        with np.errstate(over="ignore", invalid="ignore"):
            self._lift(Probe(loop, plant, wanted, integrating, self.kept, self.size), wanted, loop)
        # No column of a block is larger than the sizes of its start and inputs times these: a cheap first check.
        self.bounds = {name: np.abs(self.outputs[name]).max(axis=1) for name in self.checks}

    # -- making the matrices

    def _lift(self, probe: Probe, wanted: tuple[str, ...], loop: Loop) -> None:
        nz, nc = len(self.kept), self.cycles
        width = nz + nc * (2 if self.has_feed else 1) + 1
        z = np.eye(nz, width)
        rows: dict[str, list[Array]] = {name: [] for name in wanted}
        every = loop.derivative_every if loop.derivative else 1
        for k in range(self.steps):
            given = np.vstack([z, *self._inputs(k, nz, width)])
            step, outputs = probe.held if k % every else probe.sampled
            for name, row in zip(wanted, outputs, strict=True):
                rows[name].append(row @ given)
            z = step @ given
        z[self.shifting] -= np.eye(width)[nz + nc - 1]
        self.outputs = {name: np.ascontiguousarray(np.array(each).T) for name, each in rows.items()}
        self.forced = np.ascontiguousarray(z[:, nz:].T)
        self.levels = [_Level(z[:, :nz].copy())]
        self.width = width

    def _inputs(self, k: int, nz: int, width: int) -> tuple[Array, Array, Array]:
        """Demand, feed-forward and 1 at step k of a block, over (state, points, feed-forward, 1)."""
        cycle, part = divmod(k, self.ratio)
        unit = np.eye(width)
        demand = unit[nz + cycle] * (part / self.ratio)
        if cycle:
            demand = demand + unit[nz + cycle - 1] * (1.0 - part / self.ratio)
        feed = unit[nz + self.cycles + cycle] if self.has_feed else np.zeros(width)
        return demand, feed, unit[-1]

    # -- running

    def run(self, points: Array, feed: Array, state: State, out: list[Array]) -> State:
        """Run whole blocks: `points` holds one more value than there are cycles, `out` a slice for each column."""
        total, done = (len(points) - 1) // self.cycles, 0
        chunk, patience = FIRST_CHUNK, _CALM
        while done < total:
            count = min(chunk, total - done)
            good, state = self._try(points, feed, state, out, done, count)
            done += good
            if good == count:
                chunk, patience = min(CHUNK, chunk * 4), max(_CALM, patience // 2)
                continue
            chunk = _CAUTIOUS
            done, state = self._plain(points, feed, state, out, done, total, patience)
            patience = min(_PATIENCE, patience * 2) if good < WORTHWHILE else _CALM
        return state

    def _try(
        self, points: Array, feed: Array, state: State, out: list[Array], first: int, count: int
    ) -> tuple[int, State]:
        """Run `count` blocks as if there were no limits; the number that were right, and the state after them."""
        nz, nc, a = len(self.kept), self.cycles, first * self.cycles
        bases = points[a : a + count * nc + 1 : nc]
        x = np.empty((count, self.width))
        np.subtract(
            points[a + 1 : a + count * nc + 1].reshape(count, nc), bases[:-1, None], out=x[:, nz : nz + nc]
        )
        if self.has_feed:
            x[:, nz + nc : -1] = feed[a : a + count * nc].reshape(count, nc)
        x[:, -1] = 1.0
        start = np.array([state[i] for i in self.kept])
        start[self.shifting] -= bases[0]
        with np.errstate(all="ignore"):
            x[:, :nz], last = self._chain(x[:, nz:] @ self.forced, start, 0)
            good = self._write(x, bases, out, first * self.steps)
        after = last if good == count else x[good, :nz]
        if not np.isfinite(after).all():
            # The powers of a loop that runs away overflow; step by step its output has an end.
            return 0, state
        full = list(state)
        for i, value, moves in zip(self.kept, after.tolist(), self.shifting.tolist(), strict=True):
            full[i] = value + float(bases[good]) if moves else value
        return good, tuple(full)

    def _write(self, x: Array, bases: Array, out: list[Array], begin: int) -> int:
        """Fill the columns from the blocks' starts and inputs; the number of blocks before one breaks a limit."""
        whole = slice(begin, begin + len(x) * self.steps)
        views = {name: out[i][whole].reshape(len(x), self.steps) for i, name in enumerate(self.columns)}
        good, done = self._inside(x, views)
        for name, view in views.items():
            if name not in done:
                np.matmul(x[:good], self.outputs[name], out=view[:good])
            if name == "position":
                view[:good] += bases[:good, None]
        return good

    def _inside(self, x: Array, views: dict[str, Array]) -> tuple[int, set[str]]:
        """How many blocks, from the first, stay inside the limits, and which columns are filled by having looked."""
        good, size, done = len(x), np.abs(x), set()
        for name, limit in self.checks.items():
            if (size @ self.bounds[name]).max() <= limit:
                continue
            made = np.matmul(x, self.outputs[name], out=views.get(name))
            done.add(name)
            if not (made.max() <= limit and made.min() >= -limit):
                within = (made <= limit) & (made >= -limit)
                good = min(good, int(within.argmin()) // self.steps)
        return good, done

    def _plain(
        self, points: Array, feed: Array, state: State, out: list[Array], done: int, total: int, calm: int
    ) -> tuple[int, State]:
        """Plain steps for `calm` blocks from block `done` on."""
        until = min(total, done + calm)
        cycles = slice(done * self.cycles, until * self.cycles)
        demand = interpolated(points[cycles.start : cycles.stop + 1], self.ratio)
        steady = np.repeat(feed[cycles], self.ratio)
        made = empty_columns(self.columns)
        state = self.stepper(demand.tolist(), steady.tolist(), state, made)
        for column, values in zip(out, made, strict=True):
            column[done * self.steps : until * self.steps] = values
        return until, state

    def _chain(self, g: Array, z: Array, level: int) -> tuple[Array, Array]:
        """States at the starts of all blocks, and after the last, of z' = z F + g."""
        if level == len(self.levels):
            self.levels.append(_Level(self.levels[-1].grouped))
        own, n, nz = self.levels[level], len(g), len(z)
        if n == 1:
            return z[None, :], own.step @ z + g[0]
        groups = -(-n // GROUP)
        if n < groups * GROUP:
            g = np.concatenate((g, np.zeros((groups * GROUP - n, nz))))
        inside = g.reshape(groups, nz * GROUP) @ own.driven
        starts, last = self._chain(inside[:, -nz:], z, level + 1)
        inside += starts @ own.free
        states = inside[:, :-nz].reshape(groups * GROUP, nz)
        return states[:n], last if n == groups * GROUP else states[n]


class _Level:
    """GROUP steps of z' = F z + g as one: `free` from the first state, `driven` from the inputs, to all states."""

    def __init__(self, f: Array) -> None:
        nz = len(f)
        powers = [np.eye(nz)]
        with np.errstate(all="ignore"):
            for _ in range(GROUP):
                powers.append(f @ powers[-1])
        self.step, self.grouped = f, powers[GROUP]
        self.free = np.hstack([power.T for power in powers])
        self.driven = np.zeros((nz * GROUP, nz * (GROUP + 1)))
        for m in range(GROUP + 1):
            for j in range(m):
                self.driven[j * nz : (j + 1) * nz, m * nz : (m + 1) * nz] = powers[m - 1 - j].T


def interpolated(points: Array, ratio: int) -> Array:
    """The demand at the servo rate between trajectory points, the last point left out."""
    if ratio == 1:
        return points[:-1]
    made = np.multiply.outer(np.diff(points), np.arange(ratio) / ratio)
    made += points[:-1, None]
    flat: Array = made.reshape(-1)
    return flat


def _checks(loop: Loop) -> dict[str, float]:
    """Columns that must stay inside a limit for the loop to be linear."""
    checks = {"output": loop.output_limit} if loop.output_limit < inf else {}
    if loop.has_integral and loop.integral_limit < inf:
        checks["integral"] = loop.integral_limit
    return checks

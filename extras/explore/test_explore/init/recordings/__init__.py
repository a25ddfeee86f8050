"""Recordings of machines, as a logger at the terminals makes them, from runs in a world that is known."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from motionlang.kernel import Run, Source, dialect_of, read_machine, run
from motionlang.views.lanes import ChannelLane, lanes

FOLDER = Path(__file__).parent
PROGRAMS = ("stamp.mnt", "saw.mccl")


def world_of(program: Path) -> dict[str, object]:
    """Return the machine file that is right for a program."""
    return read_machine(Source.read(str(program.with_suffix(".world.toml"))))


def machine_run(program: Path, world: dict[str, object] | None = None) -> Run:
    """Return the run of a program in its world."""
    language = dialect_of(program.name)
    assert language is not None
    source = Source.read(str(program))
    return run(source, dialect=language.name, machine=world_of(program) if world is None else world)


@dataclass
class Logger:
    """A data logger: a row every `step` s, `jitter` as a share of it, and what else may be wrong.

    `before` seconds of rest come before power-up (or are missing, if negative), the clock counts 1 + `drift` seconds
    for one, positions have `noise` in user units.
    """

    step: float
    jitter: float = 0.0
    noise: float = 0.0
    before: float = 0.0
    drift: float = 0.0
    end: float = float("inf")
    seed: int = 1

    def table(self, result: Run) -> dict[str, NDArray[np.float64]]:
        """Return the columns of a recording of a run."""
        chance = np.random.default_rng(self.seed)
        times = np.arange(-self.before, min(result.time, self.end), self.step)
        times = times + self.step * self.jitter * chance.uniform(-0.5, 0.5, len(times))
        columns = {"time_s": 100.0 + (1.0 + self.drift) * times}
        inside = np.maximum(times, 0.0)
        for axis in result.trace.axes:
            exact = result.trace.at(axis, "position", inside)
            columns[f"axis{axis}_position_uu"] = exact + self.noise * chance.standard_normal(len(times))
        for lane in self._lanes(result):
            at = np.searchsorted(lane.times, inside, "right") - 1
            columns[lane.name] = np.array(lane.values)[at]
            if lane.group == "outputs":
                columns[lane.name] = np.where(times < 0.0, 0.0, columns[lane.name])
        return columns

    def _lanes(self, result: Run) -> list[ChannelLane]:
        found = {each.name: each for each in lanes(result.controller)}
        program = result.program or result.dialect.program(result.source)
        for _, use in program.structure.inputs():
            found.setdefault(f"in{use.number}", ChannelLane("inputs", int(use.number), [0.0], [0.0]))
        return list(found.values())


def csv_of(columns: dict[str, NDArray[np.float64]]) -> str:
    """Return columns as the text of a CSV file."""
    rows = zip(*(values.tolist() for values in columns.values()), strict=True)
    return "\n".join(
        [
            ",".join(columns),
            *(",".join(f"{each:.6g}" if k else f"{each:.6f}" for k, each in enumerate(row)) for row in rows),
            "",
        ]
    )

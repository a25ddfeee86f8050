"""Sweeps: one program in many variants, each a complete run.

The variants run on the processors of this machine or on a cluster.
"""

from __future__ import annotations

import os
from collections.abc import Collection, Iterable, Iterator, Mapping, Sequence
from concurrent.futures import Executor
from dataclasses import dataclass
from typing import Any

from motionlang.commands.quantities import ResultValue, quantity
from motionlang.commands.sweep.job import Problem, Result, SweepJob, worker_of
from motionlang.commands.sweep.pool import Hand
from motionlang.commands.sweep.space import Space, Value, space_of
from motionlang.kernel import Dialect, ProgramError, Source, check_setting, dialect_for, settings_next_to
from motionlang.kernel.failures import allowed
from motionlang.kernel.lang import is_key_of_entries
from motionlang.kernel.rows import RowTable, transposed
from motionlang.processes.parallel import cores

KEEP = ("time",)


@dataclass(eq=False, slots=True)
class Row:
    """One variant: number, `values`, and results `kept`, by name.

    `problem` is its first error, or the first event that is not allowed, or None. `row["time"]` and
    `row["accel"]` look up a result or a varied value.
    """

    index: int
    values: dict[str, Value]
    kept: dict[str, ResultValue]
    problem: Problem | None

    def __getitem__(self, name: str) -> object:
        return self.kept[name] if name in self.kept else self.values[name]

    def __repr__(self) -> str:
        problem_text = f", problem={self.problem['message']!r}" if self.problem else ""
        return f"Row({self.index}, {self.values}, {self.kept}{problem_text})"

    @property
    def ok(self) -> bool:
        """True if the run was good, as `Run.ok`."""
        return self.problem is None


class Rows(RowTable):
    """The rows of a sweep: an iterator by arrival, and a table by number.

    The table has the rows that have not been iterated over yet.
    """

    __slots__ = ("_names", "_rows")

    def __init__(self, rows: Iterator[Row], names: Sequence[str]) -> None:
        self._rows, self._names = rows, ("index", *names, "problem")

    def __iter__(self) -> Iterator[Row]:
        return self._rows

    def __next__(self) -> Row:
        return next(self._rows)

    def columns(self) -> dict[str, list[Any]]:
        """Run all variants and return the columns of their table.

        The columns are the number, the varied values, the results, and the error message.
        """
        rows = sorted(self._rows, key=lambda row: row.index)
        return transposed(
            [
                {"index": row.index, **row.values, **row.kept}
                | {"problem": row.problem["message"] if row.problem else None}
                for row in rows
            ],
            self._names,
        )

    def __repr__(self) -> str:
        return f"<Rows of a sweep: {', '.join(self._names)}>"


class Sweep:
    """A program and its variants, checked before any run; `results` runs them.

    `space` has the variants, `job` the data that they share.
    """

    def __init__(
        self,
        program: str | os.PathLike[str] | Source,
        grid: Space | Mapping[str, object] | Iterable[Mapping[str, Value]],
        *,
        keep: Sequence[str] = KEEP,
        dialect: str | Dialect | None = None,
        machine: Mapping[str, object] | None = None,
        overrides: Mapping[str, float | str] | None = None,
        worlds: Mapping[str, Mapping[str, Mapping[str, object]]] | None = None,
        until: float | None = None,
        certify: bool = False,
        allow: Iterable[str] = (),
    ) -> None:
        """Take the arguments of `sweep`.

        Raises ValueError for an unknown name or key, OSError if the program cannot be read, ProgramError if
        it, or its machine file, is invalid.
        """
        self.space = space_of(grid)
        source = program if isinstance(program, Source) else Source.read(program)
        language = dialect_for(source, dialect)
        settings = settings_next_to(program) if machine is None else dict(machine)
        for name in keep:
            quantity(name)
        self.job = SweepJob(
            source,
            language.name,
            self.space.names,
            keep,
            settings,
            overrides or {},
            worlds or {},
            until,
            certify,
            allowed(allow),
        )
        if len(self.space):
            self._check()

    def _check(self) -> None:
        """Report the mistakes of every variant once, before any run."""
        values = self.space[0]
        for name, value in zip(self.space.names, values, strict=True):
            is_setting = "." in name and not is_key_of_entries(name)
            problem = check_setting(name, value) if is_setting else None
            if problem is not None:
                raise ValueError("; ".join(problem))
        settings, given = self.job.of(values)
        worker = worker_of(self.job)
        worker.program(settings).require()
        try:
            worker.compiled(settings, given)
        except ProgramError as error:
            if not any(each.line for each in error.diagnostics):
                raise ValueError(
                    "; ".join(f"{each.message}; {each.hint}" for each in error.diagnostics)
                ) from None

    def __len__(self) -> int:
        return len(self.space)

    def results(
        self, executor: Executor | None = None, jobs: int | None = None, done: Collection[int] = ()
    ) -> Iterator[Result]:
        """Yield the rows as plain tuples, in order of arrival, except variants in `done`."""
        left = len(self.space) - len(done)
        variants = ((n, self.space[n]) for n in range(len(self.space)) if n not in done)
        return Hand(self.job, variants, left, executor, jobs or cores()).rows()

    def row(self, result: Result) -> Row:
        """Return a result as a row with names."""
        index, kept, problem = result
        values = dict(zip(self.space.names, self.space[index], strict=True))
        return Row(index, values, dict(zip(self.job.keep, kept, strict=True)), problem)


def sweep(
    program: str | os.PathLike[str] | Source,
    grid: Space | Mapping[str, object] | Iterable[Mapping[str, Value]],
    *,
    keep: Sequence[str] = KEEP,
    executor: Executor | None = None,
    jobs: int | None = None,
    dialect: str | Dialect | None = None,
    machine: Mapping[str, object] | None = None,
    overrides: Mapping[str, float | str] | None = None,
    until: float | None = None,
    certify: bool = False,
    allow: Iterable[str] = (),
) -> Rows:
    """Run a program in many variants and return an iterator over their rows.

    Rows come in order of arrival. The rows are also a table: `sweep(…).to_polars()`. Times are seconds,
    lengths user units (uu).

    `grid` has the values by name: names of the program and, with a dot, keys of the machine file. The values
    are lists, or texts such as "500:5000:10"; every combination is a variant. A list of points, `[{"accel":
    500.0}, …]`, is one variant per point. `keep` names the results of a run to keep, see docs/sweep.md.
    `executor` is any `concurrent.futures.Executor`, such as Dask's; without one, `jobs` processes of this
    machine are used. The other arguments are the same as in `run`; with `certify` a variant that exceeds a
    limit of the machine is an error. `allow` has the events that a good run may have, as `--allow`.

    A variant that did not run well is a row with its `problem`. Errors that affect all variants are raised before the
    first one runs, as in `Sweep`.
    """
    made = Sweep(
        program,
        grid,
        keep=keep,
        dialect=dialect,
        machine=machine,
        overrides=overrides,
        until=until,
        certify=certify,
        allow=allow,
    )
    names = (*made.space.names, *made.job.keep)
    return Rows(map(made.row, made.results(executor, jobs)), names)

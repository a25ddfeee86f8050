"""The report of a sweep: table, best variant, Pareto front, failures."""

from __future__ import annotations

import re
import sys
from collections.abc import Iterator, Sequence
from math import inf
from typing import TYPE_CHECKING, Any

from motionlang.commands import sweep as sweeps
from motionlang.commands.quantities import CYCLE, no_cycle_notes, unit_of
from motionlang.commands.sweep.expression import QuantityExpression, pareto
from motionlang.commands.sweep.job import Problem, Result, worker_of
from motionlang.commands.sweep.table import Row, cell, sweep_table
from motionlang.kernel import end_of
from motionlang.views.table import Document, Table
from motionlang.views.terminal import styled, table_width, wants_colour

if TYPE_CHECKING:
    from motionlang.commands.sweep.command import SweepCommand
    from motionlang.commands.sweep.variants import Variants

    # The values and results of each variant without an error, by its number and their name.
    Good = dict[int, Row]

# Variants that are named for each error, or because they are equal.
MAX_NAMED = 3
# Values are equal within this share of them.
EQUAL = 1e-9
_FIGURES = re.compile(r"\d[\d.e+-]*")


class SweepReport:
    """The report of a sweep; `keep` names the results that it needs.

    These are the requested results and those used in expressions. `names` are the varied names.
    """

    def __init__(self, variants: Variants, names: Sequence[str]) -> None:
        self.names, self._variants, self._costs = tuple(names), variants, variants.pareto or []
        expressions = (variants.minimise, variants.maximise, variants.where, *self._costs)
        needed = [name for each in expressions if each is not None for name in each.names]
        self.keep = tuple(dict.fromkeys((*variants.keep, *(name for name in needed if name not in names))))

    def table(self, sweep: sweeps.Sweep, rows: dict[int, Result]) -> Table:
        """Return the table of all rows, in the order of the variants."""
        return sweep_table(self._units, [self._row(sweep, *rows[index]) for index in sorted(rows)])

    @property
    def _units(self) -> dict[str, str]:
        """The varied names and the results with their units."""
        return {**dict.fromkeys(self.names, ""), **{name: unit_of(name) for name in self.keep}}

    def _row(self, sweep: sweeps.Sweep, index: int, results: Sequence[Any], problem: Problem | None) -> Row:
        values = zip((*self.names, *self.keep), (*sweep.space[index], *results), strict=True)
        return {"variant": index, **dict(values), "problem": None if problem is None else problem["message"]}

    def report(self, command: SweepCommand, sweep: sweeps.Sweep, rows: dict[int, Result]) -> int:
        """Print the requested output; 1 if a variant failed."""
        bad = {index: result[2] for index, result in sorted(rows.items()) if result[2] is not None}
        good: Good = {n: self._row(sweep, *rows[n]) for n in sorted(rows) if n not in bad}
        best, front = self._best(good), self._front(good)
        text = self._text(command.rows, good, best, front) if command.format == "text" and rows else ""
        command.show(Document([self.table(sweep, rows)]), text)
        sys.stdout.flush()
        self._note_limit(sweep, good)
        self._note_cycles(sweep, good)
        self._note_without_value(good)
        if bad:
            self._report_failures(sweep, bad, len(rows))
        return int(bool(bad))

    def _note_limit(self, sweep: sweeps.Sweep, good: Good) -> None:
        """Say that every variant ran to the time limit, so that its time compares nothing."""
        limit = sweep.job.until if sweep.job.until is not None else end_of(sweep.job.settings)
        has_cycle = any(CYCLE.fullmatch(name) for name in self.keep)
        if not has_cycle and len(good) > 1 and all(values.get("time") == limit for values in good.values()):
            sys.stderr.write(
                f"note: every variant ran to the time limit of {limit:.10g} s; compare the cycle: --keep cycle\n"
            )

    def _note_cycles(self, sweep: sweeps.Sweep, good: Good) -> None:
        """Name the cycle of the first variant, if no variant has one of those that are kept."""
        lacking = {name: None for name in self.keep if all(values[name] is None for values in good.values())}
        if good and any(CYCLE.fullmatch(name) for name in lacking):
            found = worker_of(sweep.job).run(sweep.space[next(iter(good))])
            for note in no_cycle_notes(found, lacking):
                sys.stderr.write(f"note: {note}\n")

    def _note_without_value(self, good: Good) -> None:
        """Name the variants that do not count since an expression has no value there."""
        for each in filter(None, (self._variants.where, self._variants.wanted, *self._costs)):
            is_where = each is self._variants.where
            lacking = [row for row in good.values() if (each(row) if is_where else each.number(row)) is None]
            if lacking:
                named = self._named([[row[name] for name in self.names] for row in lacking])
                sys.stderr.write(f"note: {each.text} has no value with {named}\n")

    def _cost(self, wanted: QuantityExpression, values: dict[str, Any]) -> float | None:
        """Return the value to minimise, None if it is not a number."""
        cost = wanted.number(values)
        return -cost if cost is not None and self._variants.maximise is not None else cost

    def _best(self, good: Good) -> list[int]:
        """Return the numbers of the best variants, which are equal to rounding."""
        wanted = self._variants.wanted
        if wanted is None:
            return []
        costs = {index: self._cost(wanted, good[index]) for index in self._where(good)}
        least = min((cost for cost in costs.values() if cost is not None), default=0.0)
        most = least + EQUAL * abs(least)
        return [index for index, cost in costs.items() if cost is not None and cost <= most]

    def _where(self, good: Good) -> list[int]:
        where = self._variants.where
        return [index for index, values in good.items() if where is None or where(values)]

    def _front(self, good: Good) -> list[int]:
        if not self._costs:
            return []
        costs, numbers = [], []
        for index in self._where(good):
            cost = [each.number(good[index]) for each in self._costs]
            if None not in cost:
                costs.append(tuple(c for c in cost if c is not None))
                numbers.append(index)
        return [numbers[n] for n in pareto(costs)]

    # ---------------------------------------------------------------------------------------------- the table

    def _text(self, most: int, good: Good, best: list[int], front: list[int]) -> str:
        colour = wants_colour(sys.stdout)
        shown = front if self._costs else self._where(good)
        what = f"{len(front)} of {len(good)} variants on the Pareto front" if self._costs else ""
        if not self._costs and self._variants.where is not None and len(shown) < len(good):
            what = f"{len(shown)} of {len(good)} variants with {self._variants.where.text}"
        most = most or len(shown)
        wanted = self._variants.wanted
        if wanted is not None and not self._costs and len(shown) > most:

            def rank(index: int) -> tuple[float, int]:
                cost = self._cost(wanted, good[index])
                return (inf if cost is None else cost), index

            shown = sorted(shown, key=rank)
        lines = [styled(what, "bold", colour), ""] if what else []
        if shown:
            table = sweep_table(self._units, [good[n] for n in shown[:most]], frozenset(best))
            lines += table.lines(table_width(sys.stdout), colour=colour)
        if len(shown) > most:
            lines.append(f"and {len(shown) - most} more; --rows 0 shows all, --rows-to FILE writes all")
        if self._variants.wanted is not None:
            lines += ["", *self._best_lines(good, best, self._variants.wanted)]
        return "\n".join(lines) + "\n"

    def _best_lines(self, good: Good, best: list[int], wanted: QuantityExpression) -> Iterator[str]:
        if not best:
            where = self._variants.where
            yield f"no variant has {where.text}" if where is not None else f"no variant has a {wanted.text}"
            return
        first, *equal = ([good[n][name] for name in self.names] for n in best)
        which = "largest" if self._variants.maximise is not None else "smallest"
        value = cell(wanted.number(good[best[0]]))
        yield f"best: {self._named([first])}; {wanted.text} is {which} there, {value}"
        if equal:
            yield f"equally good: {self._named(equal)}"

    def _named(self, points: Sequence[Sequence[object]]) -> str:
        """Return the varied values of some variants, the first ones if there are many."""
        named = [
            ", ".join(f"{n} = {cell(v)}" for n, v in zip(self.names, point, strict=True))
            for point in points[:MAX_NAMED]
        ]
        more = [f"and {len(points) - MAX_NAMED} more"] if len(points) > MAX_NAMED else []
        return "; ".join([*named, *more])

    # --------------------------------------------------------------------------------------- failed variants

    def _report_failures(self, sweep: sweeps.Sweep, bad: dict[int, Problem], count: int) -> None:
        """Report failed variants separately, grouped by error."""
        groups: dict[str, tuple[str, list[int]]] = {}
        for index, problem in bad.items():
            location = f" (line {problem['line']})" if problem["line"] else ""
            message = f"{problem['code']}: {problem['message']}{location}"
            # Errors that differ only in figures are grouped.
            groups.setdefault(_FIGURES.sub("", message), (message, []))[1].append(index)
        sys.stderr.write(f"{len(bad)} of {count} variants failed\n")
        for message, indices in groups.values():
            sys.stderr.write(f"  {message}\n    with {self._named([sweep.space[n] for n in indices])}\n")

"""The facts about a file in MCCL: those of any program; a macro is followed where it is called."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass

from motionlang.commands.check.axis_state import AT_POWER_UP, ENDLESS, IDLE, TARGETS, AxisFacts
from motionlang.commands.check.reach import LOWER, UPPER
from motionlang.commands.check.rule_facts import Facts, Part
from motionlang.commands.check.silence import has_host
from motionlang.kernel import Keyword
from motionlang.kernel.lang import CALL, ENTER, Use
from motionlang.kernel.lang import AxisKey as Key
from motionlang.kernel.mccl import Command, MacroFile
from motionlang.kernel.mccl.resolve.errors import axis_count, model_of

# The bits of LN and LF for the high and the low software limit.
HIGH, LOW = 4, 8


@dataclass(eq=False)
class Background:
    """The foreground, a background task, or a macro that nothing in the file calls."""

    kind: str
    name: str
    at: int
    calls: Sequence[Part] = ()
    parameters: Sequence[Part] = ()


class MacroFacts(Facts):
    """The facts about a file in MCCL without errors."""

    names_all = True
    # A file may be sent to a board whose axes have moved before, and other lines may follow it.
    at_power_up = AT_POWER_UP._replace(target=None, span=None)
    outlasts_text = True
    at_limit = "the axis stops there with an error if LN enables its limits"

    def __init__(self, program: MacroFile) -> None:
        self.lines = program.whole
        self.model = model_of(program.source, program.settings)
        self.axis_count = axis_count(program.settings)
        self.has_host = has_host(program.source, program.language)
        structure, graph = program.structure, program.structure.graph
        main, *macros = structure.units
        started = {name for each in structure.statements.values() for name in each.starts}
        entries: dict[Part, list[int]] = {Background("main", main.name, 0): [main.entry]}
        followed = graph.reached_within(main.entry)
        for macro in macros:
            if macro.title in started:
                part = Background("task", macro.title, graph.points[macro.entry].at)
                entries[part] = [macro.entry]
                followed |= graph.reached_within(macro.entry)
        for macro in macros:
            if macro.entry not in followed:
                part = Background("sub", macro.title, graph.points[macro.entry].at)
                entries[part] = [macro.entry]
        points = {part: sorted(graph.reached_within(*begin)) for part, begin in entries.items()}
        super().__init__(structure, program.settings, entries, points, {})
        on = self.given("enable")
        moved = {key for act in self.written_by(lambda row: row.role in ("start", "run")) for key in act.axes}
        self.never_on = frozenset() if None in on else frozenset(moved - on - {None})
        self.polling = set().union(*graph.cycles)

    @property
    def commands(self) -> Iterator[tuple[Command, int]]:
        """The commands of all lines, each with its offset."""
        for line in self.lines:
            yield from zip(line.commands, line.offsets, strict=True)

    def text(self, act: Use) -> str:
        """Return the command of a use in source form."""
        return self.structure.statements[act.at].text

    def resolved(self, part: Part, found: dict[int, list[Use]]) -> dict[int, list[Use]]:
        points = self.graph.points
        unknown = {points[p].at for p in self.points[part] if self._calls_unknown(p)}
        for p, uses in found.items():
            if points[p].at in unknown:  # it may be any macro of the board
                found[p] = [*uses, Use("act", uses[0].row, points[p].at, (None,))]
        return found

    def _calls_unknown(self, p: int) -> bool:
        """True if a macro is called that no line of the file defines."""
        point = self.graph.points[p]
        goes_on = point.next == (self.graph.ranges[point.key[0]][-1],)
        return point.calls < 0 and (point.kind == CALL or (point.kind == ENTER and goes_on))

    def may_fail(self, act: Use, axis: AxisFacts) -> tuple[bool, bool]:
        if axis.off and act.role in ("run", "start"):
            return True, True
        if act.role == "run":
            return axis.mode != ENDLESS or (axis.motion != IDLE and not axis.jogs), axis.mode == TARGETS
        if act.role != "start":
            return False, False
        never = axis.mode == TARGETS and axis.jogs and self.needs_rest(axis.shape)
        return axis.mode != TARGETS or never, never

    def disturbs(self, row: Keyword) -> bool:
        return any(map(row.does, ("switch", "follows", "hands-over", "datum")))

    def needs_rest(self, shape: str) -> bool:
        return shape in ("PS", "PP")

    def limited(self, act: Use, number: int, sides: frozenset[str]) -> frozenset[str]:
        if act.row is None or act.row.function not in ("limits_on", "limits_off"):
            return sides
        bits = int(act.number(0) or 0) or HIGH | LOW
        meant = frozenset(side for side, bit in ((UPPER, HIGH), (LOWER, LOW)) if bits & bit)
        return sides | meant if act.row.function == "limits_on" else sides - meant

    def limits_in_force(self, key: Key, axis: AxisFacts) -> frozenset[str]:
        """Return the sides that LN has enabled, without those whose limit is in an old unit, or set elsewhere."""
        return frozenset(side for side in axis.limited if f"{side} limit" in axis.set)

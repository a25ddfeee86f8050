"""The facts that all rules of a check share: what a program does with its axes, and which parts run at one time.

A part is what runs or is called by itself: the program, a task, an event handler, a sub, a macro. Its points are those
of the graph of the steps (`kernel/lang/step_graph.py`); each statement counts at one of them, a condition at its test.
"""

from __future__ import annotations

from collections.abc import Callable, Collection, Iterator, Mapping, Sequence
from dataclasses import replace
from functools import cached_property
from typing import Protocol

from motionlang.commands.check.axis_state import AT_POWER_UP, AllAxes, AxisFacts, Follower
from motionlang.commands.check.reach import LOWER, UPPER
from motionlang.kernel import Keyword
from motionlang.kernel.lang import ENDLESS, STOP, TEST, UNTIL, Statement, Structure, Use
from motionlang.kernel.lang import AxisKey as Key

# Roles of keywords that load the move buffer, and so wait while it is full.
LOADS = frozenset(("move", "entry", "course", "path"))


class NamedParameter(Protocol):
    """A parameter of a part."""

    @property
    def name(self) -> str: ...


class Part(Protocol):
    """A part of a program: its `kind` is "main", "task", "event" or "sub"; `calls` are the parts that it calls."""

    @property
    def kind(self) -> str: ...
    @property
    def name(self) -> str: ...
    @property
    def at(self) -> int: ...
    @property
    def calls(self) -> Collection[Part]: ...
    @property
    def parameters(self) -> Sequence[NamedParameter]: ...


class Facts:
    """The facts about a program.

    `entries` has the points at which each part begins, the one of its text first; `points` all its points in the order
    of the text, `names` the parts by the names under which they are called.
    """

    # True if a use without an axis means all axes, False if it may mean any.
    names_all = False
    # The state of each axis when the program begins, and those axes that nothing ever switches on.
    at_power_up = AT_POWER_UP
    never_on: frozenset[Key] = frozenset()
    # True if the controller goes on with what a program has set when that has ended.
    outlasts_text = False
    # True if a software limit is in force, at 0, once the program has set the other one.
    one_limit_arms_both = False
    # What happens at a limit.
    at_limit = "the axis stops there with an error"

    def __init__(
        self,
        structure: Structure,
        settings: Mapping[str, object],
        entries: Mapping[Part, Sequence[int]],
        points: Mapping[Part, Sequence[int]],
        names: Mapping[str, Part],
    ) -> None:
        self.structure, self.settings = structure, settings
        self.graph = structure.graph
        self.entries, self.points, self._names = entries, points, names
        self.parts = list(points)
        # The statement that is carried out at a point, and what it does with keywords.
        self.statement_at: dict[int, Statement] = {}
        self.acts: dict[int, list[Use]] = {}
        # The acts of each part, and those of all parts by keyword.
        self.acts_of: dict[Part, list[Use]] = {}
        self.used: dict[Keyword, list[Use]] = {}
        # The points at which a statement reads again and again, as a wait for a condition does.
        self.polling: set[int] = set()
        self._touched: dict[frozenset[str], dict[Part, set[Key]]] = {}
        # The tasks and handlers that use each axis, by roles.
        self._users: dict[frozenset[str], dict[Key, set[Part]]] = {}
        self.roots = self._roots()
        for part in self.parts:
            found = self._carried_out(part)
            self.statement_at |= found
            self.acts |= self.resolved(part, {p: found[p].uses for p in sorted(found)})
            self.acts_of[part] = [act for p in sorted(found) for act in self.acts[p]]
        for act in (act for p in sorted(self.acts) for act in self.acts[p]):
            if act.row is not None:
                self.used.setdefault(act.row, []).append(act)

    @cached_property
    def axes(self) -> Follower:
        """The state of the axes before each statement."""
        return Follower(self)

    # ---------------------------------------------------------------------------------------------- the flow

    def statements_of(self, part: Part) -> Iterator[tuple[int, Statement]]:
        """Yield the points at which a part carries out a statement, with the statement."""
        return ((p, self.statement_at[p]) for p in self.points[part] if p in self.statement_at)

    def reached(self, part: Part) -> set[int]:
        """Return the points that the beginnings of a part lead to, without those in the parts that it calls."""
        return self.graph.reached_within(*self.entries[part])

    def endless(self) -> Iterator[set[int]]:
        """Yield each cycle that a part reaches and never leaves, as the set of its points."""
        reached = set().union(*map(self.reached, self.parts))
        for cycle in self.graph.cycles:
            if cycle <= reached and all(after in cycle for p in cycle for after in self.graph.within[p]):
                yield cycle

    def is_test(self, p: int) -> bool:
        """True if a condition is tested at a point."""
        return self.graph.points[p].role in (TEST, UNTIL, ENDLESS)

    def leaves(self, p: int) -> bool:
        """True if a part is left at a point, by a return, an Exit or the end of its text."""
        return not self.graph.within[p] and self.graph.points[p].role != STOP

    def _carried_out(self, part: Part) -> dict[int, Statement]:
        """Return the statement that is carried out at each point: a condition at its test, others at their first."""
        places: dict[tuple[str, int], int] = {}
        for p in self.points[part]:
            point = self.graph.points[p]
            key = point.key[0], point.at
            if self.is_test(p):
                places[key] = p
            else:
                places.setdefault(key, p)
        statements = self.structure.statements
        return {p: statements[at] for (_, at), p in places.items() if at in statements}

    # ------------------------------------------------------------------------------------------ who calls whom

    def called(self, part: Part) -> list[Part]:
        """Return the part and all that it calls, directly or indirectly, each once."""
        found: dict[Part, None] = {}
        stack = [part]
        while stack:
            each = stack.pop()
            if each not in found:
                found[each] = None
                stack.extend(sorted(each.calls, key=lambda part: part.at, reverse=True))
        return list(found)

    def _roots(self) -> dict[Part, set[Part]]:
        """Map each part to the parent task, tasks and handlers that run it.

        Label handlers belong to the parent task.
        """
        found: dict[Part, set[Part]] = {part: set() for part in self.parts}
        for root in self.parts:
            if root.kind != "sub":
                for part in self.called(root):
                    found[part].add(root)
        return found

    def callee(self, call: Use) -> Part:
        """Return the part that a call enters."""
        return self._names[call.callee]

    # ---------------------------------------------------------------------------------------------- the acts

    def resolved(self, part: Part, found: dict[int, list[Use]]) -> dict[int, list[Use]]:
        """Return the uses of a part, with "any axis" for its parameters if it names more than one axis.

        A parameter may be the same axis as another one that the part names.
        """
        keys = {key for uses in found.values() for use in uses for key in use.axes}
        if len(keys) == 1:
            return found
        return {p: [_without_parameters(use) for use in uses] for p, uses in found.items()}

    def driven_inputs(self) -> set[int] | None:
        """Return the digital inputs that the machine file drives; None without one: then every input may change."""
        if all(key.startswith(("controller.", "run.")) for key in self.settings):
            return None
        found: set[int] = {entry["channel"] for entry in self.settings.get("input", ())}  # type: ignore[attr-defined]
        return found | {value for key, value in self.settings.items() if key.endswith("_input")}  # type: ignore[misc]

    def may_fail(self, act: Use, axis: AxisFacts) -> tuple[bool, bool]:
        """Return if an act may be rejected in the state of its axis (its line ends there), and if it certainly is."""
        return False, False

    def disturbs(self, row: Keyword) -> bool:
        """True if nothing is known of an axis after a keyword without a role was written for it."""
        return row.kind in ("command", "move") or row.does("switch")

    def needs_rest(self, shape: str) -> bool:
        """True if a move with a shape, by its keyword, can only start at rest."""
        return False

    def limited(self, act: Use, number: int, sides: frozenset[str]) -> frozenset[str]:
        """Return the sides on which a software limit is set after a use, of those on which one was."""
        side = next((each for each in (UPPER, LOWER) if act.row is not None and act.row.does(each)), None)
        return sides | {side} if side is not None and act.number(number) else sides

    def limits_in_force(self, key: Key, axis: AxisFacts) -> frozenset[str]:
        """Return the sides on which the software limit of an axis acts if it is set, without those in an old unit."""
        return frozenset(
            each for each in (UPPER, LOWER) if axis.scaled is None or f"{each} limit" in axis.set
        )

    def passes_switches(self, key: Key) -> bool:
        """True if the axis may go on at a limit switch."""
        return False

    def refined(self, p: int, truth: bool, state: AllAxes) -> AllAxes:
        """Return the state of the axes after the condition that is tested, or waited for, at a point was `truth`."""
        return state

    def written_by(self, wanted: Callable[[Keyword], object]) -> Iterator[Use]:
        """Yield the uses, other than reads, of the keywords that are `wanted`."""
        for row, acts in self.used.items():
            if wanted(row):
                yield from (act for act in acts if act.role != "read")

    def given(self, *effects: str) -> set[Key]:
        """Return the axes of all keywords with one of these effects, except in reads."""
        acts = self.written_by(lambda row: any(map(row.does, effects)))
        return {key for act in acts for key in act.axes}

    def named(self, word: str) -> set[Key]:
        """Return the axes for which the program writes or executes a keyword."""
        return {key for act in self.written_by(lambda row: row.name == word) for key in act.axes}

    def word(self, function: str) -> str:
        """Return the keyword with this function that the program uses, "" if it uses none."""
        return next((row.name for row in self.used if row.function == function), "")

    def constants(self, word: str) -> dict[Key, list[float] | None]:
        """Map each axis to the constants that a keyword assigns to it.

        An axis maps to None if one of the values is unknown.
        """
        return self.values(lambda row: row.name == word)

    def values(self, wanted: Callable[[Keyword], object]) -> dict[Key, list[float] | None]:
        """Map each axis to the constants that the keywords that are `wanted` assign to it, as `constants` does."""
        found: dict[Key, list[float] | None] = {}
        for act in self.written_by(wanted):
            for number, key in enumerate(act.axes):
                value = act.number(number)
                known = found.setdefault(key, [])
                if value is None:
                    found[key] = None
                elif known is not None:
                    known.append(value)
        return found

    def touched(self, part: Part, roles: frozenset[str]) -> set[Key]:
        """Return the axes that a part and those that it calls use in one of these roles.

        The axes are those of the caller: parameters of callees are replaced by their arguments.
        """
        known = self._touched.get(roles)
        if known is None:
            known = self._touched[roles] = self._all_touched(roles)
        return known[part]

    def touched_elsewhere(self, part: Part, roles: frozenset[str]) -> set[Key]:
        """Return the axes that tasks and handlers other than those of a part use in one of these roles."""
        users = self._users.get(roles)
        if users is None:
            users = self._users[roles] = {}
            for root in self.parts:
                for key in self.touched(root, roles) if root.kind != "sub" else ():
                    users.setdefault(key, set()).add(root)
        return {key for key, roots in users.items() if not roots <= self.roots[part]}

    def _all_touched(self, roles: frozenset[str]) -> dict[Part, set[Key]]:
        """Return the axes that each part uses in these roles.

        They are computed to a fixed point, because subs may be recursive.
        """
        found: dict[Part, set[Key]] = {}
        calls: dict[Part, list[tuple[Part, Use]]] = {}
        for part, acts in self.acts_of.items():
            found[part] = {key for act in acts if act.role in roles for key in act.axes}
            for act in acts:
                if act.callee:
                    calls.setdefault(self.callee(act), []).append((part, act))
        grown = list(calls)
        while grown:
            callee = grown.pop()
            for caller, act in calls.get(callee, ()):
                more = {self.outer(act, key) for key in found[callee]} - found[caller]
                if more:
                    found[caller] |= more
                    grown.append(caller)
        return found

    def outer(self, call: Use, key: Key) -> Key:
        """Return the caller's axis that corresponds to an axis of the called part."""
        if not isinstance(key, str):
            return key
        parameters = (each.name for each in self.callee(call).parameters)
        found = zip(call.arguments, parameters, strict=False)
        return next((axis for axis, name in found if name == key), None)


def spelt(key: Key) -> str:
    """Return an axis as shown in messages: its number, or the parameter that holds it."""
    return "?" if key is None else str(key)


def _without_parameters(use: Use) -> Use:
    axes = tuple(None if isinstance(key, str) else key for key in use.axes)
    return use if axes == use.axes else replace(use, axes=axes)

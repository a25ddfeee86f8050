"""The checks that analyse one function at a time, and their dependencies."""

from __future__ import annotations

from collections.abc import Hashable, Iterable, Mapping
from typing import TYPE_CHECKING

from motionlang.commands.check.mint.axis_state import CHANGES, Follower
from motionlang.commands.check.mint.brackets import check_brackets
from motionlang.commands.check.mint.buffer import GO, Buffers
from motionlang.commands.check.mint.conditions import Conditions
from motionlang.commands.check.mint.iterations import check_iterations
from motionlang.commands.check.mint.motion import Motion, Reach
from motionlang.commands.check.mint.reachability import Reachability
from motionlang.commands.check.mint.settings import TOUCHES, Settings
from motionlang.kernel.mint.resolve.recall import Recall
from motionlang.kernel.mint.resolve.symbols import Function, Symbol
from motionlang.kernel.mint.syntax.nodes import Module

if TYPE_CHECKING:
    from motionlang.commands.check.mint.axis_state import After, Axis
    from motionlang.commands.check.mint.effects import Facts, Key
    from motionlang.commands.check.mint.findings import Findings


class FunctionChecks:
    """The checks of each function; `recall` has the results of an earlier check."""

    def __init__(
        self,
        facts: Facts,
        settings: Mapping[str, object],
        module: Module,
        findings: Findings,
        recall: Recall | None,
    ) -> None:
        self._facts, self._settings, self._module = facts, settings, module
        self._findings, self._recall = findings, recall
        add = findings.add
        reach = self._reach = Reach(facts, settings)
        follower = self._follower = Follower(
            facts, lambda key, axis: bool(reach.beyond(key, axis)), self._recalled
        )
        self._motion = Motion(follower, reach, add)
        self._buffers = Buffers(facts, follower, add)
        self._unused = Settings(facts, follower, add)
        self._reachability = Reachability(facts, follower, settings, add)
        self._conditions = Conditions(facts, follower, module, settings, add)
        self._keys: dict[Function, Hashable] = {}
        self._program = self._program_facts() if recall is not None else None
        self._seen: dict[Symbol, Hashable] = {}

    def check(self) -> None:
        """Report the problems of all functions."""
        for function in self._facts.functions:
            self._follower.analyse(function)
            if self._recall is None:
                self._check(function)
                continue
            key = self._keys[function]
            known = self._recall.find(key)
            if known is not None:
                self._recall.repeat(known, function, self._findings.add)
                continue
            self._recall.recorder.begin()
            self._check(function)
            left = self._portable(function)
            if left is None:
                self._recall.recorder.depends()
            self._recall.store(key, function, left)

    def _check(self, function: Function) -> None:
        self._motion.check(function)
        self._buffers.check(function)
        self._unused.check(function)
        self._reachability.check(function)
        self._conditions.check(function)
        check_iterations(self._facts, function, self._findings.add)
        check_brackets(self._facts, function, self._module.source, self._findings.add)

    # --------------------------------------------------------------------------------- what a result depends on

    def _recalled(self, function: Function) -> After | None:
        """Return the facts about axes after a function, if an earlier check found them.

        The functions that it calls must have been analysed.
        """
        if self._recall is None:
            return None
        facts, calls = self._facts, sorted(function.calls, key=lambda each: each.at)
        key = self._keys[function] = self._recall.key(
            "lint",
            function,
            self._program,
            _names(facts.roots[function]),
            tuple(map(self._of_symbol, self._recall.symbols.get(function, ()))),
            tuple(map(self._of_callee, calls)),
        )
        found = self._recall.find(key)
        return None if found is None else self._after(function, found[1])

    def _program_facts(self) -> Hashable:
        """Return the facts about the whole program that the checks use."""
        facts, follower, reach, buffers = self._facts, self._follower, self._reach, self._buffers
        roots = [each for each in facts.functions if each.kind != "sub"]
        return (
            repr(self._settings),
            facts.default_axes,
            bool(facts.hosted),
            *map(_axes, (follower.apart, follower.stopped, follower.led, reach.unlimited, reach.wrapped)),
            *map(_constants, (reach.forward, reach.reverse, buffers.sizes)),
            *map(_axes, (buffers.triggered, self._conditions.limited)),
            tuple(
                (each.qualified_name, _axes(buffers.started[each]), _axes(facts.touched(each, TOUCHES)))
                for each in roots
            ),
        )

    def _of_symbol(self, symbol: Symbol) -> Hashable:
        """Return the functions that write a variable, and their tasks and handlers."""
        known = self._seen.get(symbol)
        if known is None:
            facts = self._facts
            writers = facts.writers.get(symbol)
            roots = set() if writers is None else set().union(*(facts.roots[each] for each in writers))
            known = self._seen[symbol] = (
                None if writers is None else _names(writers),
                _names(roots),
                _names(facts.roots[symbol.home]),
                symbol in facts.hosted,
            )
        return known

    def _of_callee(self, callee: Function) -> Hashable:
        """Return the effects of a call of a sub on axes."""
        touched = (_axes(self._facts.touched(callee, roles)) for roles in (CHANGES, GO))
        left = self._portable(callee) if callee in self._follower.after else ()
        # An object is equal to no other, so a caller of this sub is not recalled.
        return callee.qualified_name, *touched, object() if left is None else repr(left)

    # ------------------------------------------------------------------------------------- facts of another check

    def _portable(self, function: Function) -> tuple[tuple[Hashable, Hashable], ...] | None:
        """Return the facts after a function in a form that other programs can use.

        Numbers replace the symbols and offsets of this program. Returns None if an offset of another function is among
        them. There are no facts about a function that is still being analysed.
        """
        assert self._recall is not None
        number = self._recall.own(function).number
        found = []
        for key, axis in self._follower.after[function].items():
            index = function.parameters.index(key) if isinstance(key, Symbol) else None
            loaded = None if axis.loaded is None else number(axis.loaded)
            scaled = None if not axis.scaled else number(axis.scaled)
            if (loaded is None) is not (axis.loaded is None) or (scaled is None) is not (not axis.scaled):
                return None
            found.append(
                (
                    (index, None if index is not None else key),
                    axis._replace(loaded=loaded, scaled=scaled or 0),
                )
            )
        return tuple(sorted(found, key=lambda each: repr(each[0])))

    def _after(self, function: Function, found: Iterable[tuple[tuple[int | None, Key], Axis]]) -> After:
        """Convert stored facts back: insert the symbols and offsets of this program."""
        assert self._recall is not None
        at = self._recall.own(function).at
        return {
            key if index is None else function.parameters[index]: axis._replace(
                loaded=None if axis.loaded is None else at(axis.loaded),
                scaled=at(axis.scaled) if axis.scaled else 0,
            )
            for (index, key), axis in found
        }


def _names(functions: Iterable[Function]) -> tuple[str, ...]:
    return tuple(sorted(each.qualified_name for each in functions))


def _axis(key: Key) -> Hashable:
    """Return an axis as a plain value; for a parameter this includes its sub's name."""
    return (key.home.qualified_name, key.name.lower()) if isinstance(key, Symbol) else key


def _axes(keys: Iterable[Key]) -> Hashable:
    return frozenset(map(_axis, keys))


def _constants(given: Mapping[Key, list[float] | None]) -> Hashable:
    return frozenset((_axis(key), repr(values)) for key, values in given.items())

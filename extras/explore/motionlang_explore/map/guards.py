"""The conditions around the statements of a program, from its text.

Each point of the graph has guards: the sides of branches that decide whether the program comes there. They are carried
forward once, in the order of the flow; where both sides of a branch meet, what guards the branch guards. A call guards
what it calls, a handler what it does.
"""

from __future__ import annotations

from collections import defaultdict

from motionlang.kernel.lang import Statement, Structure

# So many guards of a point are followed.
MAX_GUARDS = 12
# A branch and its side, or ~ the entry of a handler.
Guard = tuple[int, bool]


class Guards:
    """The guards of the points of a program."""

    def __init__(self, structure: Structure) -> None:
        self._structure = structure
        started = {each for statement in structure.statements.values() for each in statement.starts}
        # What begins by itself: the program, tasks, handlers, and macros that are started as tasks.
        self._roots = {
            unit.entry: unit
            for unit in structure.units
            if unit.kind in ("program", "task", "event") or unit.title in started
        }
        self._loops = {structure.points[p].at for p in structure.graph.closing}
        self._guards: dict[int, tuple[Guard, ...]] = {}
        self._find()
        # The first point of each statement.
        self._first: dict[int, int] = {}
        for p in sorted(self._guards):
            self._first.setdefault(structure.points[p].at, p)

    def of(self, at: int) -> list[tuple[str, int]]:
        """Return the conditions, or the handler, of a statement, each with its line; none if it always comes."""
        return [self._words(*guard) for guard in self._guards[self._first[at]]]

    def _words(self, q: int, side: bool) -> tuple[str, int]:
        if q < 0:
            return self._roots[~q].title, self._roots[~q].line
        statement = self._structure.statements[self._structure.points[q].at]
        text = statement.condition
        if not side:  # the condition of an Until has been turned around already
            is_until = statement.form.startswith("Until ") and text.startswith("not (")
            text = text[5:-1] if is_until else f"not ({text})" if " " in text else f"not {text}"
        return f"`{text}`", statement.line

    def knows(self, at: int) -> bool:
        """True if the program can come to the statement at an offset."""
        return at in self._first

    def waits(self, at: int) -> bool:
        """True if a statement waits for its condition, or ends a loop by it."""
        statement = self._structure.statements[at]
        return bool(statement.condition) and (bool(statement.waits) or at in self._loops)

    def _find(self) -> None:
        points = self._structure.points
        order, came = self._ordered(), defaultdict[int, dict[Guard, None]](dict)
        place = {p: k for k, p in enumerate(order)}
        for p in order:
            root = self._roots.get(p)
            begins = ((~p, True),) if root is not None and root.kind == "event" else ()
            self._guards[p] = self._joined(came[p]) if root is None else begins
            point, statement = points[p], self._statement(p)
            # A wait that goes on by itself, as for the end of a move, decides nothing.
            waits = statement is not None and not statement.condition and bool(statement.waits)
            for k, after in enumerate(point.next):
                if place[after] > place[p]:
                    decides = point.branches and not waits
                    came[after] |= dict.fromkeys([(p, k == 0)] if decides else self._guards[p])
            if place.get(point.calls, -1) > place[p]:
                came[point.calls] |= dict.fromkeys(self._guards[p])

    def _ordered(self) -> list[int]:
        """Return the points that the program reaches, each before those that follow it but for loops."""
        points, finished, seen = self._structure.points, list[int](), set[int]()
        for entry in reversed(self._roots):
            stack = [(entry, False)]
            while stack:
                p, is_done = stack.pop()
                if is_done:
                    finished.append(p)
                elif p not in seen and p >= 0:
                    seen.add(p)
                    stack.append((p, True))
                    stack += ((after, False) for after in (*points[p].next, points[p].calls))
        return finished[::-1]

    def _joined(self, came: dict[Guard, None]) -> tuple[Guard, ...]:
        """Return guards without the branches of which each side comes here; behind others, a loop decides nothing."""
        found, seen, stack = dict[Guard, None](), set[Guard](), list(came)
        while stack:
            q, side = stack.pop(0)
            if (q, side) in seen:
                continue
            seen.add((q, side))
            if (q, not side) in found:
                del found[q, not side]
                stack += self._guards[q]
            elif (found or stack) and q >= 0 and self._structure.points[q].at in self._loops:
                stack += self._guards[q]
            elif len(found) < MAX_GUARDS:
                found[q, side] = None
        return tuple(found)

    def _statement(self, p: int) -> Statement | None:
        return self._structure.statements.get(self._structure.points[p].at)

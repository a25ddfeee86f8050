"""Breakpoints as clients set them: lines, motion, filters, data."""

from __future__ import annotations

import os
from collections.abc import Callable
from urllib.parse import urlsplit
from urllib.request import url2pathname

from motionlang.ide.dap.arguments import Arguments
from motionlang.ide.debug import moments
from motionlang.ide.debug.breakpoints import Breakpoint, Watched
from motionlang.ide.debug.debugger import Debugger
from motionlang.ide.debug.expressions import WrongExpression
from motionlang.ide.debug.moments import Search

Body = dict[str, object]


class Breaking:
    """The breakpoints of a session.

    `first_line` is the number with which the client starts counting lines.
    """

    def __init__(self, debugger: Debugger, path: str, first_line: int) -> None:
        self._debugger, self._path, self._line = debugger, path, 1 - first_line
        self._searches: dict[str, list[Search]] = {}

    def _is_program(self, given: Arguments) -> bool:
        path = given.object("source").text("path", "")
        return bool(path) and _real(path) == _real(self._path)

    def lines(self, given: Arguments) -> list[Body]:
        """Replace the line breakpoints."""
        wanted, is_program = given.objects("breakpoints"), self._is_program(given)
        if not is_program:
            return [_unverified("this file is not the program that is debugged") for _ in wanted]
        made: list[Breakpoint] = []
        answers: list[Body] = []
        for each in wanted:
            line = self._debugger.line_for(each.number("line") + self._line)
            if line is None:
                answers.append(_unverified("there is no statement here or below"))
                continue
            message = each.text("logMessage", "")
            condition, hits = each.text("condition", ""), each.text("hitCondition", "")
            try:
                offsets = self._debugger.offsets_at(line)
                made.append(Breakpoint(offsets, condition, hits, message or None))
            except WrongExpression as error:
                answers.append(_unverified(str(error)))
            else:
                answer: Body = {"verified": True, "line": line - self._line}
                if hits:
                    answer["message"] = "iterations of a polling loop that are skipped do not count"
                answers.append(answer)
        self._debugger.set_breakpoints(made)
        return answers

    def motion(self, given: Arguments) -> list[Body]:
        """Replace the motion breakpoints."""
        axes = self._debugger.axes
        return self._searched("motion", given, "breakpoints", "name", lambda text: moments.search(text, axes))

    def filters(self, given: Arguments) -> list[Body]:
        """Replace the filters: errors, faults, limits, clamps."""
        found: list[Search] = []
        answers: list[Body] = []
        errors = False
        for name in given.texts("filters"):
            if name not in moments.FILTERS:
                answers.append(_unverified(f"there is no filter {name[:40]!r}"))
                continue
            kinds = moments.FILTERS[name][1]
            errors = errors or name == "error"
            found.append(moments.filtered(kinds) if kinds else moments.complaints)
            answers.append({"verified": True})
        self._debugger.stops_at_errors = errors
        self._use("filters", found)
        return answers

    def data(self, given: Arguments) -> list[Body]:
        """Replace the data breakpoints: variables by path, channels by name."""
        watched: list[Watched] = []

        def of(data: str) -> Search | None:
            what, _, rest = data.partition(" ")
            if what in ("input", "output") and rest.isdecimal():
                return moments.channel(what, int(rest), "changes", "change")
            if what != "variable" or not rest:
                raise WrongExpression("this cannot be watched")
            watched.append(Watched(tuple(rest.split("/"))))
            return None

        answers = self._searched("data", given, "breakpoints", "dataId", of)
        self._debugger.watched = watched
        return answers

    def _searched(
        self, kind: str, given: Arguments, list_of: str, name: str, make: Callable[[str], Search | None]
    ) -> list[Body]:
        found: list[Search] = []
        answers: list[Body] = []
        for each in given.objects(list_of):
            try:
                search = make(each.text(name))
            except WrongExpression as error:
                answers.append(_unverified(str(error)))
                continue
            if search is not None:
                found.append(search)
            answers.append({"verified": True})
        self._use(kind, found)
        return answers

    def _use(self, kind: str, searches: list[Search]) -> None:
        self._searches[kind] = searches
        self._debugger.searches = [each for found in self._searches.values() for each in found]

    def targets(self, given: Arguments) -> list[Body]:
        """Return the targets of `goto` at a line: its next and its previous execution.

        The number of the forward target is twice the line number, and that of the backward target is one more.
        """
        line = self._debugger.line_for(given.number("line") + self._line)
        if line is None or not self._is_program(given):
            return []
        words = ("the next time that line {} begins", "back to the last time that line {} began")
        return [
            {"id": 2 * line + number, "label": text.format(line), "line": line - self._line}
            for number, text in enumerate(words)
        ]

    def locations(self, given: Arguments) -> list[Body]:
        """Return the lines with statements in a range."""
        first = given.number("line") + self._line
        last = given.number("endLine", first - self._line) + self._line
        if not self._is_program(given):
            return []
        return [{"line": line - self._line} for line in self._debugger.lines if first <= line <= last]


def _real(path: str) -> str:
    """Return the path of a file without links, as a text to compare; `path` may be a URI."""
    try:
        if path.lower().startswith("file:"):
            path = url2pathname(urlsplit(path).path)
        return os.path.normcase(os.path.realpath(path))
    except ValueError:  # a NUL, or brackets that are no host
        return path


def _unverified(text: str) -> dict[str, object]:
    return {"verified": False, "message": text}

"""The debugger at the prompt: a program that is stopped between two statements.

It has its own machine: lines typed at the prompt do not affect it.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Sequence
from typing import TYPE_CHECKING

from motionlang.ide.debug import moments
from motionlang.ide.debug.breakpoints import Breakpoint
from motionlang.ide.debug.debugger import Debugger, NotStopped, Stop
from motionlang.ide.debug.destinations import destination
from motionlang.ide.debug.expressions import assignment, parse
from motionlang.ide.debug.moments import Search
from motionlang.ide.debug.values import shown
from motionlang.kernel import (
    Diagnostic,
    Machine,
    ProgramError,
    Source,
    Variable,
    dialect_for,
    settings_next_to,
)
from motionlang.kernel.files import reason
from motionlang.views.diagnostics import render
from motionlang.views.formatting import significant

if TYPE_CHECKING:
    from motionlang.repl.session import Session

_LINE = re.compile(r"(\d{1,7})(?:\s+if\s+(.+))?", re.IGNORECASE)


class Debugging:
    """A program in the debugger of a prompt, and its breakpoints as typed."""

    def __init__(self, session: Session, path: str) -> None:
        self._session, self.path = session, path
        self._broken: dict[str, Breakpoint | Search] = {}
        source = Source.read(path)
        self.debugger = Debugger(
            source, dialect_for(source, session.dialect), settings_next_to(path),
            show=session.write, ask=self._ask, interrupted=self._interrupted,
        )  # fmt: skip
        self._filters = [
            moments.filtered(kinds) if kinds else moments.complaints for _, kinds in moments.FILTERS.values()
        ]
        self.debugger.stops_at_errors = True
        self.use()

    # Methods, because the prompt replaces both functions of the session.
    def _ask(self, begun: str) -> str | None:
        return self._session.ask(begun)

    def _interrupted(self) -> bool:
        return self._session.interrupted()

    def use(self) -> None:
        """Pass the breakpoints to the debugger; limits, faults and errors always stop it."""
        broken = self._broken.values()
        self.debugger.set_breakpoints([each for each in broken if isinstance(each, Breakpoint)])
        searches = [each for each in broken if not isinstance(each, Breakpoint)]
        self.debugger.searches = [*searches, *self._filters]

    def add(self, text: str) -> None:
        """Add a breakpoint: `LINE`, `LINE if CONDITION`, or a motion breakpoint.

        Raises ValueError if it is invalid.
        """
        match = _LINE.fullmatch(text)
        if text.lower().endswith(" if"):
            raise ValueError(f"{text} has no condition; {text} n > 3")
        if match is None:
            self._broken[text] = moments.search(text, self.debugger.axes)
        else:
            line = self.debugger.line_for(int(match[1]))
            if line is None:
                raise ValueError(f"there is no statement in line {match[1]} or below")
            self._broken[text] = Breakpoint(self.debugger.offsets_at(line), match[2] or "")
        self.use()

    @property
    def stopped(self) -> tuple[Machine, float] | None:
        """The machine and the time of the stop; None if the program has ended."""
        if self.debugger.stop is None:
            return None
        state = self.debugger.state()
        return state.machine, state.time

    def remove_all(self) -> None:
        self._broken.clear()
        self.use()

    @property
    def broken(self) -> list[str]:
        """The breakpoints as typed."""
        return list(self._broken)

    def line(self, stop: Stop | None) -> str:
        """Return one line about a stop, or about the end."""
        if stop is None:
            run = self.debugger.run
            if run is None:
                return "the program has not begun\n"
            remarks = "".join(render(each, self.debugger.source) for each in run.diagnostics)
            return f"{remarks}{run.status} after {significant(run.time, 9)} s\n"
        source = self.debugger.source.line(stop.line).strip()
        why = f"-- {stop.text}\n" if stop.text else ""
        return f"{why}{significant(stop.time, 9)} s  line {stop.line}: {source}\n"


def _with(session: Session, work: Callable[[Debugging], str]) -> None:
    """Call `work` with the program in the debugger, and show its result or the error."""
    debugging = session.debugging
    try:
        if debugging is None:
            raise NotStopped
        session.write(work(debugging))
    except NotStopped:
        _wrong(session, "no program is stopped in the debugger", ".debug FILE begins one")
    except ValueError as error:
        message, _, hint = str(error).partition("; ")
        _wrong(session, message, hint)


def _wrong(session: Session, message: str, hint: str = "") -> None:
    session.trouble([Diagnostic("values", message, hint=hint)])


def debug(session: Session, path: str) -> None:
    """`.debug FILE`: begin, or run a changed text of the program to the same time."""
    before = session.debugging

    try:
        if before is not None and path in ("", before.path):
            path = before.path
            source = Source.read(path)
            _with(session, lambda debugging: _again(session, debugging, source))
            return
        if not path:
            raise NotStopped
        session.debugging = Debugging(session, path)
        if before is not None:
            before.debugger.abandon()
        _with(session, lambda debugging: debugging.line(debugging.debugger.start()))
    except NotStopped:
        _wrong(session, "no program is in the debugger", ".debug FILE begins one")
    except OSError as error:
        session.trouble([Diagnostic("file", f"{path} cannot be read: {reason(error)}")])
    except ProgramError as error:
        session.trouble(error.diagnostics, Source.read(path))


def change(session: Session, text: str) -> None:
    """`.change N TEXT`: replace line N, and run the new text to the same time."""
    number, _, line = text.partition(" ")

    def work(debugging: Debugging) -> str:
        source = debugging.debugger.source
        lines = source.text.split("\n")
        if not number.isdecimal() or not 1 <= int(number) <= len(lines):
            raise ValueError(f".change takes a line from 1 to {len(lines)} and its new text")
        lines[int(number) - 1] = line
        return _again(session, debugging, Source(source.name, "\n".join(lines)))

    _with(session, work)


def _again(session: Session, debugging: Debugging, source: Source) -> str:
    """Run another text to the same time; breakpoints stay at their lines.

    The errors of the text are shown, and the program stays as it was.
    """
    try:
        stop = debugging.debugger.restart(source)
    except ProgramError as error:
        session.trouble(error.diagnostics, source)
        return ""
    typed = debugging.broken
    debugging.remove_all()
    for each in typed:
        debugging.add(each)
    return debugging.line(stop)


def break_(session: Session, text: str) -> None:
    """`.break`: add a breakpoint, list them, or remove them all."""

    def work(debugging: Debugging) -> str:
        if text.lower() == "off":
            debugging.remove_all()
        elif text:
            debugging.add(text)
        return "".join(f"{each}\n" for each in debugging.broken) or "no breakpoints\n"

    _with(session, work)


def moving(move: Callable[[Debugger, str], Stop | None]) -> Callable[[Session, str], None]:
    """Return the command that moves the debugger, such as `.step` or `.back`, and shows where it stops."""
    return lambda session, text: _with(
        session, lambda debugging: debugging.line(move(debugging.debugger, text))
    )


step = moving(lambda debugger, _: debugger.step_in())
over = moving(lambda debugger, _: debugger.next())
back = moving(lambda debugger, _: debugger.step_back())
go = moving(lambda debugger, _: debugger.go_on())
reverse = moving(lambda debugger, _: debugger.reverse())
goto = moving(lambda debugger, text: destination(debugger, text)())


def changed(session: Session, text: str) -> None:
    """`.changed X`: go back to the last change of a variable, axis or channel."""

    def work(debugging: Debugging) -> str:
        debugger = debugging.debugger
        path = debugger.state().path_of(text)
        stop = debugger.last_change(path)
        return f"{stop.text}\n" if stop is not None and stop.reason == "goto" else debugging.line(stop)

    _with(session, work)


def vars_(session: Session, text: str) -> None:
    """`.vars`: show the state at the stop or one value, or assign a variable.

    Without a program in the debugger, show what the lines of the session have assigned.
    """

    def work(debugging: Debugging) -> str:
        given = assignment(text)
        debugger = debugging.debugger
        state = debugger.state()
        if given is not None:
            name, value = given
            return f"{name} = {shown(debugger.assign(state.path_of(name), parse(value)(state)).value)}\n"
        if text:
            found = state.evaluate(text)
            return f"{text} = {shown(getattr(found, 'value', found))}\n"
        return _everything(debugger)

    if session.debugging is None and not text:
        session.write(_lines(_listed(session.runner.interactive.variables())))
    else:
        _with(session, work)


def _everything(debugger: Debugger) -> str:
    """Return variables, axes and channels, and what other tasks wait for."""
    state = debugger.state()
    stop = debugger.stop
    lines = []
    for task in state.tasks():
        if stop is not None and task.name == stop.task:
            for frame in state.frames(task.task)[:1]:
                lines += _listed(frame.variables)
        elif task.why:
            lines.append(f"task {task.name} {task.why}")
    lines += _listed(state.module())
    for axis in state.axes():
        if _has_moved(axis):
            lines += _axis(axis)
    lines += _listed([*state.inputs(), *state.outputs()])
    return _lines(lines)


def _lines(lines: Sequence[str]) -> str:
    return "".join(f"{line}\n" for line in lines) or "no variables\n"


def _listed(variables: Sequence[Variable]) -> list[str]:
    return [f"{each.name} = {shown(each.value)}" for each in variables]


def _has_moved(axis: Variable) -> bool:
    values = {each.name: each.value for each in axis.value}  # type: ignore[attr-defined]
    return bool(values["position"] or values["velocity"] or values["target"] or values["faults"] != "none")


def _axis(axis: Variable) -> list[str]:
    """Return the line of an axis at the stop, and a second line for an earlier moment."""
    now: list[str] = []
    earlier: dict[str, list[str]] = {}
    for each in axis.value:  # type: ignore[attr-defined]
        name, _, moment = each.name.partition(" at ")
        if each.value in (None, "none", []):
            continue
        if isinstance(each.value, list):
            text = f"{len(each.value)} in the buffer"
        elif name == "state":
            text = each.value
        else:
            text = f"{name} {each.value if isinstance(each.value, str) else shown(each.value)}"
        (earlier.setdefault(moment, []) if moment else now).append(text)
    found = [f"{axis.name}: {', '.join(now)}"]
    return found + [f"{axis.name} at {moment}: {', '.join(texts)}" for moment, texts in earlier.items()]

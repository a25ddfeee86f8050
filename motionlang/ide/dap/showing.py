"""The state at a stop in the protocol: threads, frames, scopes, variables.

References to frames and variables are valid until the program continues, and none is used twice, because a client may
still request one of an earlier stop and takes equal numbers for the same object. A reference stores the path of its
object, which is looked up on request.
"""

from __future__ import annotations

import os
import re
from collections.abc import Sequence

from motionlang.ide.dap.arguments import Arguments, RequestRefused
from motionlang.ide.debug.debugger import Debugger
from motionlang.ide.debug.expressions import WrongExpression, assignment, parse
from motionlang.ide.debug.scopes import LOCAL, MACHINE, MODULE, Waiting
from motionlang.ide.debug.values import shown
from motionlang.kernel import Variable, entries
from motionlang.kernel.lang import Frame
from motionlang.kernel.tools import count_of

Body = dict[str, object]
Path = tuple[str, ...]

AXES, INPUTS, OUTPUTS, VALUE = "axes", "inputs", "outputs", "value"
# More references than a client can show.
MAX_REFERENCES = 1_000_000
# More completions than a client shows.
MAX_COMPLETIONS = 200
_FIXED = "the program and the machine set this; only variables and inputs can be changed"
# The word before the cursor, or a command.
_WORD = re.compile(r"(?:^\.\w*|@?\w+)$")


class Showing:
    """The threads, frames and variables that a client has seen at a stop."""

    def __init__(self, debugger: Debugger, path: str, first_line: int, first_column: int) -> None:
        self._debugger, self._path = debugger, path
        self._line, self._column = 1 - first_line, 1 - first_column
        self._threads: dict[str, int] = {}
        self._frames: list[tuple[str, int]] = []
        self._references: list[tuple[Path, int | None, Variable | None]] = []
        # The last numbers of frames and of references at earlier stops.
        self._old_frames = self._old_references = 0
        self._known: list[Body] = [{"id": 1, "name": "program"}]

    def forget(self) -> None:
        """Invalidate all references, because the program continues."""
        self._old_frames += len(self._frames)
        self._old_references += len(self._references)
        self._frames.clear()
        self._references.clear()

    def number(self, task: str) -> int:
        """Return the number of a task's thread."""
        return self._threads.setdefault(task, len(self._threads) + 1)

    # ----------------------------------------------------------------------------------------------- threads

    def threads(self, stopped: bool) -> list[Body]:
        """Return the tasks and handlers; while the program runs, those of the last stop."""
        if stopped:
            found = [_thread(self.number(each.name), each) for each in self._debugger.state().tasks()]
            self._known = found or [{"id": 1, "name": "program, ended"}]
        return self._known

    def stack(self, given: Arguments) -> Body:
        """Return the frames of a thread."""
        number = given.number("threadId")
        state = self._debugger.state()
        name = next((each for each, known in self._threads.items() if known == number), None)
        task = next((each for each in state.tasks() if each.name == name), None)
        if task is None:
            if number == 1 and self._debugger.run is not None:
                return self._end()
            raise RequestRefused(f"there is no thread {number}")
        frames = state.frames(task.task)
        found = [self._frame(task.name, depth, frame) for depth, frame in enumerate(frames)]
        first, levels = given.number("startFrame", 0), given.number("levels", 0)
        first = max(first, 0)
        return {
            "stackFrames": found[first : first + levels if levels > 0 else None],
            "totalFrames": len(found),
        }

    def _end(self) -> Body:
        """Return a frame after the last statement, for a program that has ended."""
        self._frames.append(("", 0))
        lines = self._debugger.lines
        frame = {
            "id": self._old_frames + len(self._frames), "name": "end of the program", "source": self._source(),
            "line": (lines[-1] if lines else 1) - self._line, "column": 1 - self._column,
        }  # fmt: skip
        return {"stackFrames": [frame], "totalFrames": 1}

    def _frame(self, task: str, depth: int, frame: Frame) -> Body:
        self._frames.append((task, depth))
        line, column, length = self._debugger.location_of(frame.offset)
        return {
            "id": self._old_frames + len(self._frames), "name": frame.name, "source": self._source(),
            "line": line - self._line, "column": column - self._column,
            "endLine": line - self._line, "endColumn": column + length - self._column,
        }  # fmt: skip

    def _source(self) -> Body:
        return {"name": os.path.basename(self._path), "path": self._path}

    # ------------------------------------------------------------------------------------------------ scopes

    def scopes(self, given: Arguments) -> list[Body]:
        """Return the scopes of a frame: local variables, program variables, the machine."""
        number = given.number("frameId") - self._old_frames
        if not 1 <= number <= len(self._frames):
            raise RequestRefused(f"there is no frame {number + self._old_frames} at this stop")
        task, depth = self._frames[number - 1]
        found = []
        if task and self._local(number - 1):
            found.append(_scope("Local", self._refer((f"{LOCAL}{depth}",), number - 1), "locals"))
        name = "Variables" if self._debugger.language.name == "mint" else "Registers"
        found.append(_scope(name, self._refer((MODULE,))))
        for title, path in (("Axes", AXES), ("Inputs", INPUTS), ("Outputs", OUTPUTS)):
            found.append(_scope(title, self._refer((path,))))
        return found

    def _local(self, index: int) -> Sequence[Variable]:
        name, depth = self._frames[index]
        state = self._debugger.state()
        task = next((each for each in state.tasks() if each.name == name), None)
        frames = state.frames(task.task) if task is not None else ()
        return frames[depth].variables if depth < len(frames) else ()

    def _refer(self, path: Path, frame: int | None = None, variable: Variable | None = None) -> int:
        if len(self._references) >= MAX_REFERENCES:
            return 0
        self._references.append((path, frame, variable))
        return self._old_references + len(self._references)

    def _referred(self, given: Arguments) -> tuple[Path, int | None, list[Variable]]:
        number = given.number("variablesReference") - self._old_references
        if not 1 <= number <= len(self._references):
            raise RequestRefused(
                f"there is no variablesReference {number + self._old_references} at this stop"
            )
        path, frame, variable = self._references[number - 1]
        state = self._debugger.state()
        if variable is not None and isinstance(variable.value, list):
            found: Sequence[Variable] = variable.value
            if frame is None and path[0] == MODULE:
                fresh = state.find(path)
                found = fresh.value if fresh is not None and isinstance(fresh.value, list) else found
        elif frame is not None:
            found = self._local(frame)
        elif path[0] == MODULE:
            found = state.module()
        else:
            read = {AXES: state.axes, INPUTS: state.inputs, OUTPUTS: state.outputs}
            found = read[path[0]]()
        return path, frame, list(found)

    def variables(self, given: Arguments) -> list[Body]:
        """Return the variables of a scope, or the elements of a variable."""
        path, frame, found = self._referred(given)
        first, count = max(given.number("start", 0), 0), given.number("count", 0)
        section = found[first : first + count if count > 0 else None]
        return [self._variable((*path, each.name), frame, each) for each in section]

    def _variable(self, path: Path, frame: int | None, variable: Variable) -> Body:
        body: Body = {"name": variable.name, **self._value(path, frame, variable)}
        if path[0] == MODULE or path[0].startswith(LOCAL):
            body["evaluateName"] = variable.name
        return body

    def _value(self, path: Path, frame: int | None, variable: Variable) -> Body:
        value = variable.value
        unit = f" {variable.type}" if variable.type in ("uu", "uu/s") and value is not None else ""
        if isinstance(value, list):
            text = count_of(len(value), "element")
            if path[0] == AXES and len(path) == 2:
                text = ", ".join(f"{each.name} {_plain(each.value)}" for each in value[:2])
            return {
                "value": text,
                "type": variable.type,
                "variablesReference": self._refer(path, frame, variable),
            }
        text = _plain(value) if path[0] == AXES else shown(value)
        return {"value": text + unit, "type": variable.type, "variablesReference": 0}

    # ----------------------------------------------------------------------------------------------- changes

    def set_variable(self, given: Arguments) -> Body:
        """Change the value of a variable or an input."""
        path, frame, found = self._referred(given)
        name, text = given.text("name"), given.text("value")
        if path[0] == INPUTS:
            return self._set_input(name, text)
        if path[0] in (AXES, OUTPUTS):
            raise RequestRefused(_FIXED)
        if not any(each.name == name for each in found):
            raise RequestRefused(f"there is no variable {name[:60]} here")
        if frame is not None and not self._is_current(frame):
            raise RequestRefused("only variables of the task that is stopped can be changed")
        return self._assign((*path, name), text)

    def _is_current(self, frame: int) -> bool:
        stop = self._debugger.stop
        return stop is not None and self._frames[frame][0] == stop.task

    def _set_input(self, name: str, text: str) -> Body:
        what, _, number = name.rpartition(" ")
        if not number.isdecimal() or what not in ("input", "analogue input"):
            raise RequestRefused(f"{name[:60]} is no input")
        entry = f"{number}={text.strip()}"
        made = entries({}, inputs=entry) if what == "input" else entries({}, analog=entry)
        self._debugger.enter(made)
        return {"value": text.strip(), "variablesReference": 0}

    def _assign(self, path: Path, text: str) -> Body:
        value = parse(text)(self._debugger.state())
        found = self._debugger.assign(path, value)
        return self._value(path, None, found)

    def path_of(self, name: str) -> Path:
        """Return the path of a variable, an axis or a channel, by its name.

        Raises WrongExpression if there is none.
        """
        return self._debugger.state().path_of(name)

    def set_expression(self, given: Arguments) -> Body:
        """Change the value of a variable or an input, given by its name."""
        return self._set(given.text("expression"), given.text("value"))

    def _set(self, name: str, text: str) -> Body:
        path = self.path_of(name)
        if path[0] != MACHINE:
            return self._assign(path, text)
        if "input" not in path[1]:
            raise RequestRefused(_FIXED)
        return self._set_input(path[1], text)

    def carry_out(self, line: str) -> Body:
        """Carry out a line of the console: an assignment, or an expression whose value is returned."""
        given = assignment(line)
        if given is None:
            return self.evaluate(line)
        body = self._set(*given)
        return {"result": body.pop("value"), **body}

    def evaluate(self, text: str) -> Body:
        """Return the value of an expression."""
        found = self._debugger.state().evaluate(text)
        if isinstance(found, Variable):
            path = self.path_of(text)
            body = self._value(path, None, found)
            return {"result": body["value"], **{key: each for key, each in body.items() if key != "value"}}
        return {"result": shown(found), "variablesReference": 0}

    def completions(self, given: Arguments, commands: Sequence[str]) -> list[Body]:
        """Return the names that complete the word before the cursor of the console."""
        column = given.number("column") + self._column - 1
        text = given.text("text").encode("utf-16-le")[: 2 * max(column, 0)].decode("utf-16-le", "ignore")
        word = _WORD.search(text)
        begun = "" if word is None else word[0]
        if text.startswith("."):
            names: Sequence[str] = commands if begun == text else self._debugger.state().names()
        else:
            names = self._debugger.state().names()
        start = column - len(begun) + 1 - self._column
        return [
            {"label": name, "start": start, "length": len(begun)}
            for name in names
            if name.lower().startswith(begun.lower())
        ][:MAX_COMPLETIONS]

    def data_of(self, given: Arguments) -> Body:
        """Return the identifier of a variable or a channel for a data breakpoint."""
        name = given.text("name")
        path: Path = ()
        if given.number("variablesReference", 0):
            path = (*self._referred(given)[0], name)
        else:
            try:
                path = self.path_of(name)
            except WrongExpression:
                path = ()
        if len(path) == 2 and path[0] == AXES:
            path = self.path_of(name)
        if path and path[0] == MACHINE:
            return {
                "dataId": f"variable {'/'.join(path)}",
                "description": f"{name} changes",
                "accessTypes": ["write"],
            }
        if path and path[0] in (INPUTS, OUTPUTS) and not name.startswith("analogue"):
            return {"dataId": name, "description": f"{name} changes", "accessTypes": ["write"]}
        if not path or not (path[0] == MODULE or path[0].startswith(LOCAL)):
            return {"dataId": None, "description": f"{name[:60]} cannot be watched; use a motion breakpoint"}
        return {
            "dataId": f"variable {'/'.join(path)}",
            "description": f"{name} changes",
            "accessTypes": ["write"],
        }


def _thread(number: int, task: Waiting) -> Body:
    what = "handler " if task.is_handler else ""
    return {"id": number, "name": f"{what}{task.name}" + (f" ({task.why})" if task.why else "")}


def _scope(name: str, reference: int, hint: str = "") -> Body:
    body: Body = {"name": name, "variablesReference": reference, "expensive": False}
    return body | ({"presentationHint": hint} if hint else {})


def _plain(value: object) -> str:
    """Return a value as text, without quotes."""
    return value if isinstance(value, str) else shown(value)

"""Writer of docs/contributing/one-statement.md, which follows one statement through every stage."""

from __future__ import annotations

import sys
from collections.abc import Callable
from pathlib import Path
from types import FrameType
from typing import Any

import motionlang
from motionlang.commands.check.listing import render_steps
from motionlang.kernel.execution import run
from motionlang.kernel.lang.machine.machine import Machine
from motionlang.kernel.lang.scheduler import Scheduler
from motionlang.kernel.lang.step_list import listed_units
from motionlang.kernel.lang.steps import Steps
from motionlang.kernel.mint import DIALECT
from motionlang.kernel.mint.syntax.node import Node
from motionlang.kernel.mint.syntax.parser import parse
from motionlang.kernel.mint.syntax.tokens import tokens
from motionlang.kernel.source import Source
from tests.recorder import Recorder

PAGE = Path(__file__).parents[1] / "docs" / "contributing" / "one-statement.md"
STATEMENT = "MOVER(0) = 2 * 12.5"
PROGRAM = (
    f"SCALE(0) = 10\nSPEED(0) = 100\nACCEL(0) = 500\nDECEL(0) = 500\n{STATEMENT}\nGO(0)\nPAUSE IDLE(0)\n"
)
LINE = 5
PACKAGE = Path(motionlang.__file__).parent
# The files whose functions check a keyword and make its steps.
MAKERS = (
    "kernel/mint/steps/keywords.py",
    "kernel/mint/steps/words.py",
    "kernel/mint/steps/unit.py",
    "kernel/mint/runtime/binding.py",
    "kernel/mint/keywords/",
    "kernel/mint/check/access.py",
    "kernel/lang/keyword.py",
)
# The operation of the controller that the statement calls.
LOADS = "load_by"
# What only listens to the controller.
LISTENER = "motion_listener.py"
# Programs, each with the statement whose files the page lists; it runs for the second time, as the first time it may
# create objects.
WAYS = (
    ("a.mnt", "SPEED(0) = 50\nSPEED(0) = 100\n", "SPEED(0) = 100"),
    ("a.mnt", "MOVER(0) = 1 : GO(0)\nPAUSE IDLE(0)\nMOVER(0) = 1\nGO(0)\nPAUSE IDLE(0)\n", "GO(0)"),
    ("a.mnt", "JOG(0) = 5\nx = POS(0)\nWAIT(5)\ny = POS(0)\nCANCEL(0)\n", "y = POS(0)"),
    ("a.mcl", "1MN,1MR5,1WS\n1MR40000\n1WS\n", "1MR40000"),
)
TEXT = """\
# One statement through every stage

This page follows `{statement}`, line {line} of the program below, from its text to the log of the run. It is generated
by `python -m tools.derived`, and a test compares it, so what you see is what the code does.

```mint
{program}```

## Tokens

Lark splits the text by the terminals of the grammar (`kernel/mint/syntax/tokens.py`): kind, text and offset in the
statement.

```text
{tokens}
```

## Tree

The parser builds nodes of `kernel/mint/syntax/nodes.py`. The base class is `kernel/mint/syntax/node.py`.

```text
{tree}
```

## Steps

`kernel/mint/resolve/` finds what each name refers to. A class of node has one function in `kernel/mint/steps/`, which
is called twice. First it checks the node (`kernel/mint/steps/check.py`) and reports its mistakes. These functions check
the keyword: `_checked_index` its axis, `_check_value` its value by the range of the row (`Keyword.refusal`).

```text
{check}
```

If there is no mistake, it turns the node into steps (`kernel/lang/steps.py`), a list that `motionlang check FILE
--steps` prints. What a step does is a function of the variables of the call. Loading a move is a `try`: while the move
buffer of the axis is full, the step waits and is done again. It pays for the statement when it is done.

```text
{code}
```

The makers of a step nest like this. `bound` returns the operation of the keyword on axis 0. The row of MOVER has a
maker, `load_move(True)`, whose function `made` makes it. `_load` makes the function of the step around it,
`loaded`, and `add` names this function after the keyword: a stack says `MOVER`.

A setting such as `SPEED(0) = 100` takes a shorter way: `_store` adds a step whose function is made by `action`
(`kernel/mint/steps/words.py`), and `_write_setting` (`kernel/mint/runtime/binding.py`) binds it to the setting of
`kernel/controller/settings.py` that its row names.

```text
{makers}
```

## Operations of the controller

At run time `kernel/lang/step_task.py` does one step after another. A debugger that stops in the controller shows this
stack, and a profile the same names: `MOVER` is the function of the step, `load` the operation of its row.

```text
{stack}
```

The operation checks the value and calls the controller (`kernel/controller/operations.py`) in counts and seconds: 25
user units are 250 counts.

```text
{operations}
```

## Log

`GO` starts the move: a planner makes a profile, and the log stores the move (`kernel/log/records.py`). From rest to
rest at 100 uu/s with 500 uu/s², 25 uu take 25 / 100 + 100 / 500 = 0.45 s.

```text
{log}
```

## Four statements, file by file

These are the files that the functions of a statement enter while it runs, in the order in which they first do. The loop
over the steps (`kernel/lang/step_task.py`) and the scheduler are not among them, and neither is what happens once, when
the steps are written.

{ways}
"""


def written() -> str:
    """Return the page."""
    source = Source("stages.mnt", PROGRAM)
    return TEXT.format(
        statement=STATEMENT,
        line=LINE,
        program=PROGRAM,
        tokens="\n".join(f"{kind:<10} {text:<6} {at}" for kind, text, at in tokens(STATEMENT)),
        tree="\n".join(_tree(parse(Source("a.mnt", f"{STATEMENT}\n")))),
        code=_code(source),
        **_functions(source),
        operations="\n".join(
            f"{operation}({', '.join(map(repr, arguments))})" for operation, *arguments in _operations(source)
        ),
        log=_log(source),
        ways="\n".join(_way(*each) for each in WAYS),
    )


def _tree(value: Any, name: str = "", depth: int = 0) -> list[str]:
    """Return a node and its descendants, one line each, without empty fields."""
    head = f"{'  ' * depth}{name}{': ' if name else ''}"
    if isinstance(value, Node):
        lines = [f"{head}{type(value).__name__}"]
        for cls in reversed(type(value).__mro__):
            for field in getattr(cls, "__slots__", ()):
                inner = getattr(value, field, None)
                if (
                    field not in ("start", "end", "source", "tokens")
                    and inner is not False
                    and inner not in (None, [], (), "")
                ):
                    lines += _tree(inner, field, depth + 1)
        return lines
    if isinstance(value, (list, tuple)):
        return [line for each in value for line in _tree(each, name, depth)]
    return [f"{head}{value!r}"]


def _code(source: Source) -> str:
    program = DIALECT.program(source, {})
    units = listed_units(source, program.graph)
    lines = "".join(render_steps(DIALECT, units, colour=False)).splitlines()
    begin = next(i for i, line in enumerate(lines) if line.endswith(STATEMENT))
    end = next(i for i in range(begin + 1, len(lines)) if lines[i][:4].strip())
    return "\n".join(lines[begin:end])


def _functions(source: Source) -> dict[str, str]:
    """Return the functions that check the statement, those that make its step, and the stack that loads its move."""
    found: dict[str, list[tuple[str, str]]] = {"check": [], "makers": [], "stack": []}
    # The frame of `keywords.write` for the statement, and the frames of the shown functions that it has called.
    head: list[FrameType] = []
    open_: list[FrameType] = []

    def enter(frame: FrameType, event: str, _: object) -> None:
        code = frame.f_code
        path = Path(code.co_filename)
        if not path.is_relative_to(PACKAGE):
            return
        file, name = path.relative_to(PACKAGE).as_posix(), code.co_name
        if event == "call" and (file, name) == (MAKERS[0], "write"):
            given = frame.f_locals
            if given["w"].program.line(given["node"].start) == LINE:
                head.append(frame)
        if event == "call" and head and file.startswith(MAKERS) and not name.startswith("<"):
            key = "check" if head[0].f_locals["w"].checks else "makers"
            found[key].append((f"{'  ' * len(open_)}{name}", file))
            open_.append(frame)
        if event == "return" and frame in open_:
            open_.remove(frame)
        if event == "return" and frame in head:
            head.remove(frame)
        if event == "call" and name == LOADS:
            found["stack"] = _stack(frame)

    run(source)
    before = sys.getprofile()
    sys.setprofile(enter)
    try:
        run(source)
    finally:
        sys.setprofile(before)
    return {key: "\n".join(f"{name:<26} {file}" for name, file in rows) for key, rows in found.items()}


def _stack(frame: FrameType) -> list[tuple[str, str]]:
    """Return the functions that are running, from that which does the steps to `frame`."""
    found: list[tuple[str, str]] = []
    at: FrameType | None = frame
    while at is not None and (not found or found[0][0] != "_run"):
        found.insert(0, (at.f_code.co_name, Path(at.f_code.co_filename).relative_to(PACKAGE).as_posix()))
        at = at.f_back
    return found


def _way(file: str, text: str, statement: str) -> str:
    files = entered(Source(file, text), text[: text.rindex(statement)].count("\n") + 1)
    return f"* `{statement}`: " + ", ".join(f"`{each}`" for each in files)


def entered(source: Source, line: int) -> list[str]:
    """Return the files of the package that the steps of a line enter, in a second run that imports nothing."""
    run(source)
    found: dict[str, None] = {}

    def enter(frame: FrameType, event: str, _: object) -> None:
        path = Path(frame.f_code.co_filename)
        if event == "call" and path.is_relative_to(PACKAGE) and path.name != LISTENER:
            found[path.relative_to(PACKAGE).as_posix()] = None

    def traced(do: Callable[[Any], Any]) -> Callable[[Any], Any]:
        def call(values: Any) -> Any:
            before = sys.getprofile()
            sys.setprofile(enter)
            try:
                return do(values)
            finally:
                sys.setprofile(before)

        return call

    add = Steps.add

    def add_traced(
        steps: Steps, kind: int, do: Any = None, to: int = -1, at: int = -1, *others: Any, **more: Any
    ) -> int:
        is_traced = do is not None and at >= 0 and source.location(at)[0] == line
        return add(steps, kind, traced(do) if is_traced else do, to, at, *others, **more)

    Steps.add = add_traced  # type: ignore[method-assign,assignment]
    try:
        run(source)
    finally:
        Steps.add = add  # type: ignore[method-assign]
    return list(found)


def _operations(source: Source) -> list[tuple[Any, ...]]:
    machine, recorder = Machine(), Recorder()
    machine.controller, machine.clock = recorder, recorder.clock  # type: ignore[assignment]
    task = DIALECT.program(source).start(machine)
    Scheduler(machine.controller, task).run_program()
    return [call for call in recorder.calls if str(call[0]).startswith("load") or call[0] == "go"]


def _log(source: Source) -> str:
    (move,) = run(source).machine.log.moves
    assert move.profile is not None
    return (
        f"axis {move.axis}, {move.command} of line {move.line}: {move.profile.shape} from {move.start_time:.5f} s, "
        f"{move.profile.duration:.6g} s, {move.profile.start:g} to {move.profile.end:g} counts"
    )


def files() -> dict[Path, str]:
    return {PAGE: written()}

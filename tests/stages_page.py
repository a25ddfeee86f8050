"""Writer of docs/contributing/one-statement.md: `python -m tests.stages_page`.

The page follows one statement through every stage.
"""

from __future__ import annotations

from pathlib import Path
from typing import Any

from motionlang.execution import run
from motionlang.lang.machine.machine import Machine
from motionlang.lang.scheduler import Scheduler
from motionlang.mint import DIALECT
from motionlang.mint.syntax.node import Node
from motionlang.mint.syntax.parser import parse
from motionlang.mint.syntax.tokens import tokens
from motionlang.source import Source
from motionlang.views.listing import render_listing
from tests.recorder import Recorder

PAGE = Path(__file__).parents[1] / "docs" / "contributing" / "one-statement.md"
STATEMENT = "MOVER(0) = 2 * 12.5"
PROGRAM = (
    f"SCALE(0) = 10\nSPEED(0) = 100\nACCEL(0) = 500\nDECEL(0) = 500\n{STATEMENT}\nGO(0)\nPAUSE IDLE(0)\n"
)
LINE = 5
TEXT = """\
# One statement through every stage

This page follows `{statement}`, line {line} of the program below, from its text to the log of the run. It is generated
by `python -m tests.stages_page`, and a test compares it, so what you see is what the code does.

```mint
{program}```

## Tokens

Lark splits the text by the terminals of the grammar (`mint/syntax/tokens.py`): kind, text and offset in the statement.

```text
{tokens}
```

## Tree

The parser builds nodes of `mint/syntax/nodes.py`. The base class is `mint/syntax/node.py`.

```text
{tree}
```

## Generated Python

`mint/resolve/` finds what each name refers to, and `mint/compile/` writes Python. The constant is folded. The operation
`k4` loads the move; its arguments are the statements to charge to machine time first,
the value and the line.

```text
{code}
```

## Verbs

At run time the operation checks the axis and calls verbs of the controller (`controller/verbs.py`) in counts and
seconds: 25 user units are 250 counts.

```text
{verbs}
```

## Log

`GO` starts the move: a planner makes a profile, and the log stores the move (`log/records.py`). From rest to rest at
100 uu/s with 500 uu/s², 25 uu take 25 / 100 + 100 / 500 = 0.45 s.

```text
{log}
```
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
        verbs="\n".join(f"{verb}({', '.join(map(repr, arguments))})" for verb, *arguments in _verbs(source)),
        log=_log(source),
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
                    field not in ("start", "end", "source")
                    and inner is not False
                    and inner not in (None, [], (), "")
                ):
                    lines += _tree(inner, field, depth + 1)
        return lines
    if isinstance(value, (list, tuple)):
        return [line for each in value for line in _tree(each, name, depth)]
    return [f"{head}{value!r}"]


def _code(source: Source) -> str:
    listing = DIALECT.listing(source, {}, {}, None)
    lines = "".join(render_listing(DIALECT, source, listing, colour=False)).splitlines()
    begin = next(i for i, line in enumerate(lines) if line.endswith(STATEMENT))
    end = next(i for i in range(begin + 1, len(lines)) if lines[i].startswith("#"))
    return "\n".join(lines[begin:end])


def _verbs(source: Source) -> list[tuple[Any, ...]]:
    machine, recorder = Machine(), Recorder()
    machine._controller, machine.clock = recorder, recorder.clock  # type: ignore[assignment]
    task = DIALECT.compile(source).start(machine)
    Scheduler(machine, task).run_program()
    return [call for call in recorder.calls if str(call[0]).startswith("load") or call[0] == "go"]


def _log(source: Source) -> str:
    (move,) = run(source, cache=False).machine.log.moves
    assert move.profile is not None
    return (
        f"axis {move.axis}, {move.command} of line {move.line}: {move.profile.shape} from {move.start_time:.5f} s, "
        f"{move.profile.duration:.6g} s, {move.profile.start:g} to {move.profile.end:g} counts"
    )


if __name__ == "__main__":
    PAGE.write_text(written(), encoding="utf-8")

"""Split long blocks into chunks, each a function of its own.

The time that CPython's compiler takes for one function grows with the square of its jumps: ten thousand
statements in a row would take a second, and a hundred thousand would take minutes. Statements that no Exit,
Return or jump leaves are moved into a chunk, and replaced by a call of it:

    yield from q1()

The text of the statements does not change, so virtual time passes in the same steps. A chunk shares the time
and the variables of its function. Tasks and event handlers never run twice at a time, so their shared variables
become cells of the program and their chunks are separate units. A sub may be called again before it ends, so
its chunks are nested inside it.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence

from motionlang.lang.task import CHUNK, DISPATCHER
from motionlang.mint.compile.body import Body
from motionlang.mint.compile.lines import BREAK, DEPTH, LEAVES, LOOP, YIELDS, Line, moved, names_in
from motionlang.mint.resolve.symbols import Function

# A block with more lines than MAX_LINES is split into parts of about SIZE lines. In a function with labels, which
# may have many blocks below that, this holds from SIZE lines on after its first MANY lines.
MAX_LINES = 600
SIZE = 200
MANY = 6000
# A block at this depth becomes a part, and so does a statement with this many nested loops. Python allows
# twenty nested loops, and each of ours may take two, or have a `try` around it.
MAX_INDENT = 60
MAX_LOOPS = 8


def dispatcher(function: Function) -> str:
    """Return the name of the dispatcher of a function with labels (`jumps.py`)."""
    return f"{DISPATCHER}{function.python}"


class Chunk:
    """A chunk of a function; its lines are indented as in an outermost function.

    `given` are its parameters and `names` the variables in it. `inside` is true if it is nested in its function.
    """

    __slots__ = ("given", "inside", "lines", "name", "names", "waits")

    def __init__(self, name: str, given: str, lines: list[Line], inside: bool) -> None:
        self.name, self.given, self.lines, self.inside = name, given, lines, inside
        self.names = names_in(lines)
        self.waits = YIELDS in self.names

    def written(self, shared: Iterable[str], indent: int) -> list[Line]:
        """Return the whole function; `shared` are names that belong to other functions."""
        at = self.lines[0].at
        names = sorted(shared)
        head = [
            Line(1, f"def {self.name}({self.given}):", at),
            Line(2, f"nonlocal {', '.join(names)}", at, names=names),
        ]
        end = (
            [Line(2, "if 0: yield", at)] if self.waits else []
        )  # a generator, even if all yields are in inner functions
        return moved([*head, *self.lines, *end], indent)


def cut(b: Body, first: int, ends: list[int]) -> None:
    """Split the lines of a block from `first` on into chunks, if they are many.

    `ends` are the line numbers at which its statements end.
    """
    most = SIZE if b.function.jumps and len(b.lines) > MANY else MAX_LINES
    if b.whole.typed or len(b.lines) - first <= most:
        return
    statements = [b.lines[start:end] for start, end in zip([first, *ends], ends, strict=False)]
    while sum(map(len, statements)) > most:
        shorter = _shortened(b, statements)
        if len(shorter) == len(statements):
            break
        statements = shorter
    b.lines[first:] = [line for statement in statements for line in statement]


def fold(b: Body, first: int) -> bool:
    """Move all lines from `first` on into a chunk, if possible; return True if moved."""
    lines = b.lines[first:]
    if b.whole.typed or not lines or _is_left(lines):
        return False
    b.lines[first:] = [split_off(b, lines, b.indent)]
    return True


def _shortened(b: Body, statements: list[list[Line]]) -> list[list[Line]]:
    """Return the statements with runs of them replaced by calls."""
    out: list[list[Line]] = []
    run: list[list[Line]] = []
    length = 0
    for statement in statements:
        movable = not _is_left(statement)
        if run and (not movable or length + len(statement) > SIZE):
            out += _moved(b, run, length)
            run, length = [], 0
        if movable:
            run.append(statement)
            length += len(statement)
        else:
            out.append(statement)
    return out + _moved(b, run, length)


def _is_left(statement: list[Line]) -> bool:
    """True if some path leaves the statement other than to the next statement."""
    loops: list[int] = []
    for line in statement:
        while loops and line.indent <= loops[-1]:
            loops.pop()
        if line.kind == LEAVES or (line.kind == BREAK and not loops):
            return True
        if line.kind == LOOP:
            loops.append(line.indent)
    return False


def _moved(b: Body, run: list[list[Line]], length: int) -> list[list[Line]]:
    """Return a run of statements as the call of a chunk, if it is long enough."""
    if len(run) < 2 or length < SIZE // 2:
        return run
    return [[split_off(b, [line for statement in run for line in statement], b.indent)]]


def split_off(b: Body, lines: list[Line], indent: int, parameters: Sequence[str] = ()) -> Line:
    """Move lines with this indent into a chunk, and return the call of it.

    A chunk also receives the remaining stack depth and the dispatcher of its function, if it uses them.
    """
    used = names_in(lines)
    given = [name for name in (dispatcher(b.function), DEPTH) if name in used]
    b.whole.chunk_count += 1
    name, values = f"{CHUNK}{b.whole.chunk_count}", ", ".join([*parameters, *given])
    b.chunks.append(Chunk(name, values, moved(lines, 2 - indent), b.function.kind == "sub"))
    call = f"{name}({values})"
    if YIELDS in used:
        call, given = f"yield from {call}", [*given, YIELDS]
    return Line(indent, call, lines[0].at, names=given)

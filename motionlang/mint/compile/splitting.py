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

from motionlang.lang.task import PART
from motionlang.mint.compile.lines import BREAK, LEAVES, LOOP, ROOM, YIELDS, Line, moved, names_in

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Iterable

    from motionlang.mint.compile.body import Body

# A block with more lines than LONGEST is split into parts of about SIZE lines.
MAX_LINES = 600
SIZE = 200
# A block at this depth becomes a part, and so does a statement with this many nested loops. Python allows
# twenty nested loops, and each of ours may take two, or have a `try` around it.
MAX_INDENT = 60
MAX_LOOPS = 8


class Chunk:
    """A chunk of a function; its lines are indented as in an outermost function.

    `given` are its parameters and `names` the variables in it. `inside` is true if it is nested in its function.
    """

    __slots__ = ("given", "inside", "lines", "name", "names", "waits")

    def __init__(self, name: str, lines: list[Line], inside: bool) -> None:
        self.name, self.lines, self.inside = name, lines, inside
        self.names = names_in(lines)
        self.waits = YIELDS in self.names
        self.given = ROOM if ROOM in self.names and not inside else ""

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
    if b.whole.typed:
        return
    statements = [b.lines[start:end] for start, end in zip([first, *ends], ends, strict=False)]
    while sum(map(len, statements)) > MAX_LINES:
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
    b.lines[first:] = _part(b, lines)
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
    return [_part(b, [line for statement in run for line in statement])]


def _part(b: Body, lines: list[Line]) -> list[Line]:
    """Move lines into a part and return the call of it."""
    b.whole.parts += 1
    part = Chunk(f"{PART}{b.whole.parts}", moved(lines, 2 - b.indent), b.function.kind == "sub")
    b.parts.append(part)
    call, names = f"{part.name}({part.given})", [ROOM] if ROOM in part.names else []
    if part.waits:
        call, names = f"yield from {call}", [*names, YIELDS]
    return [Line(b.indent, call, lines[0].at, names=names)]

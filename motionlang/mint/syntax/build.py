"""Tree-building steps that take more than one constructor call.

`motionlang.mint.syntax.tables` calls them.
"""

from __future__ import annotations

from math import inf

from motionlang.lang.parsing.parser import TooDeep
from motionlang.mint.syntax.nodes import (
    Call,
    Case,
    Const,
    Event,
    Expr,
    For,
    If,
    Label,
    Module,
    Name,
    Node,
    Number,
    Print,
    PrintItem,
    Select,
    Startup,
    Stmt,
    Sub,
    Task,
    TypeName,
    UserType,
    Variable,
)

TYPE_CHECKING = False
if TYPE_CHECKING:
    from motionlang.lang.parsing.parser import Stack

# Nesting of blocks. This is a limit of motionlang, not of Mint.
MAX_DEPTH = 200
MAX_EXPRESSION_DEPTH = (
    200  # nesting of nodes; each level takes two or three of the compiler's 1,000 stack frames
)
LINKS = 50  # operations in a row that remain nested
_BEYOND = 1 << 1023
MAX_NUMBERS = 50_000
ESCAPES = {"n": "\n", "r": "\r", "t": "\t", "0": "\0"}


class Misuse(Exception):
    """Raised for text that the grammar accepts but the language does not allow.

    `motionlang.mint.syntax.errors` then finds the error and its position.
    """


def number(text: str) -> float:
    """Return the value of a literal number, such as `12`, `1.5e-3`, `0x1F` or `0b101`.

    The value is infinite if the number is too large for a Float.
    """
    if text[1:2] in ("x", "X", "b", "B"):
        return _finite(int(text, 0))
    try:
        return _finite(int(text)) if text.isdigit() else float(text)
    except ValueError:  # more digits than Python converts
        return inf


def _finite(whole: int) -> float:
    """Return an integer, or infinity if a Float cannot hold it."""
    return whole if whole < _BEYOND else inf


class Numbers(dict[str, float]):
    """A cache of the values of literals by text; raises Misuse for infinite values."""

    def __missing__(self, text: str) -> float:
        value = number(text)
        if value == inf:
            raise Misuse
        if len(self) >= MAX_NUMBERS:  # bounds the memory of a long session
            self.clear()
        self[text] = value
        return value


NUMBERS = Numbers()


def string(text: str) -> str:
    """Return the text of a literal string or character, without its quotes."""
    if "\\" not in text:
        return text[1:-1]
    first, *rest = text[1:-1].split("\\")
    out = [first]
    pieces = iter(rest)
    for piece in pieces:
        if piece:
            out.append(ESCAPES.get(piece[0], piece[0]) + piece[1:])
        else:  # `\\`: the text after it is literal
            out.append("\\" + next(pieces, ""))
    return "".join(out)


def dotted(at: int, text: str) -> Name:
    """Build the name for `REMOTEOUT.1.2`: a keyword with its channels."""
    name, *channels = text.split(".")
    return Name(at, name, [Number(at, NUMBERS[each]) for each in channels], True)


def body(stack: Stack) -> list[Stmt]:
    """Return the empty list of statements at the beginning of a block.

    Raises TooDeep if the blocks are nested too deeply.
    """
    depth = 0
    while stack:
        stack, _, value = stack
        if value.__class__ is list:
            depth += 1
    if depth > MAX_DEPTH:
        raise TooDeep
    return []


def if_head(first: If) -> tuple[If, If]:
    """Begin a block If: return its first and its last branch."""
    return first, first


def else_if(head: tuple[If, If], body: list[Stmt], branch: If) -> tuple[If, If]:
    """Complete the last branch of a block If with its body, and add an ElseIf branch."""
    first, last = head
    last.body, last.orelse = body, [branch]
    return first, branch


def if_end(head: tuple[If, If], body: list[Stmt], orelse: list[Stmt]) -> If:
    """Complete a block If with the body of its last branch and the body of its Else."""
    first, last = head
    last.body, last.orelse = body, orelse
    return first


def label_before(body: list[Stmt], at: int, texts: list[str]) -> list[Stmt]:
    """Turn `NAME:` on a line of its own, which was parsed as a call, into a label."""
    if at >= 2 and texts[at - 1] == ":" and body:
        last = body[-1]
        if (
            last.at == at - 2
            and type(last) is Call
            and last.target.args is None
            and _opens_line(texts, at - 2)
        ):
            body[-1] = Label(at - 2, last.target.name)
    return body


def _opens_line(texts: list[str], at: int) -> bool:
    return at == 0 or "\n" in texts[at - 1]


def extended(members: list[Variable], more: list[Variable]) -> list[Variable]:
    """Append the members from one more line of a user type to its members."""
    members += more
    return members


def printed(
    items: list[PrintItem], last: PrintItem | None, using: list[Expr], separator: str
) -> tuple[list[Expr], str, list[PrintItem]]:
    """Collect the rest of a LINE after its first value.

    It consists of formats, a separator and more values.
    """
    return using, separator, items if last is None else [*items, last]


def line_print(
    at: int, word: str, values: list[Expr], rest: tuple[list[Expr], str, list[PrintItem]]
) -> Print:
    """Build a `LINE row, values` that has formats or separators, as a PRINT can."""
    using, separator, items = rest
    row = None if using and len(values) == 1 else values[0]
    shown = [PrintItem(each.at, each, [], ",") for each in values[1 if row is not None else 0 :]]
    if shown:
        shown[-1].using, shown[-1].separator = using, separator
    return Print(at, [*shown, *items], None, word, row)


def declare(name: Name, type: TypeName | None = None, value: Expr | None = None) -> Variable:
    """Build a variable of a `Dim`; the values in brackets are its dimensions."""
    return Variable(name.at, name.name, name.args or [], type, [] if value is None else [value])


def more_values(variables: list[Variable], value: Expr) -> list[Variable]:
    """Handle a `,` after an initial value: extend an array or begin a variable.

    A second value for a simple variable is stored with it. The compiler counts the values and reports the error.
    """
    last = variables[-1]
    if isinstance(value, Name) and not last.dimensions and not value.axes:
        variables.append(declare(value))
    else:
        last.values.append(value)
    return variables


def counted(loop: For, body: list[Stmt], following: int | None, texts: list[str]) -> For:
    """Complete a `For` with its body; raise Misuse if `Next` names another variable."""
    if following is not None and texts[following].lower() != loop.variable.name.lower():
        raise Misuse
    loop.body = body
    return loop


def constants(at: int, names: list[Const]) -> Const:
    """Build a `Const` statement: the node of the first name holds the further ones."""
    first, *first.more = names
    first.at = at
    return first


def next_case(select: Select, body: list[Stmt], case: Case) -> Select:
    """Complete the last case of a `Select` with its body, and add a `Case`."""
    last_case(select, body).cases.append(case)
    return select


def last_case(select: Select, body: list[Stmt]) -> Select:
    """Complete the last case of a `Select` with its body."""
    select.cases[-1].body = body
    return select


def task(at: int, name: str, items: list[Stmt | Sub]) -> Task:
    """Build a task: its statements, and in separate lists the subs declared inside it."""
    return Task(
        at, name, [i for i in items if not isinstance(i, Sub)], [i for i in items if isinstance(i, Sub)]
    )


def module(items: list[Node]) -> Module:
    """Build a program: its statements, and in separate lists its blocks by kind."""
    sorts: dict[type, list[Node]] = {Sub: [], Task: [], Event: [], Startup: [], UserType: []}
    statements: list[Node] = []
    for item in items:
        sorts.get(type(item), statements).append(item)
    return Module(statements, *sorts.values())  # type: ignore[arg-type]

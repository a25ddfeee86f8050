"""The pieces of tree-building that are more than one constructor call; `motionlang.mint.syntax.tables` calls them."""

from __future__ import annotations

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

# Blocks inside one another: a limit of this program, not of Mint.
DEEPEST = 200
DEEPEST_EXPRESSION = 200  # nodes inside one another; each costs the compiler two or three frames of 1,000
LINKS = 50  # operations behind one another that stay nested
INFINITE = float("inf")
_BEYOND = 1 << 1023
MOST_NUMBERS = 50_000
ESCAPES = {"n": "\n", "r": "\r", "t": "\t", "0": "\0"}


class Misuse(Exception):
    """The grammar has a place for it, the language has not; `motionlang.mint.syntax.errors` says what and where."""


def number(text: str) -> float:
    """The value of a literal, `12`, `1.5e-3`, `0x1F`, `0b101`; infinite where no number is so large."""
    if text[1:2] in ("x", "X", "b", "B"):
        return _finite(int(text, 0))
    try:
        return _finite(int(text)) if text.isdigit() else float(text)
    except ValueError:  # more digits than Python converts
        return INFINITE


def _finite(whole: int) -> float:
    """A whole number that a Float can hold, or infinite."""
    return whole if whole < _BEYOND else INFINITE


class Numbers(dict[str, float]):
    """From the text of a literal to its value, which must be finite; a text is looked at once."""

    def __missing__(self, text: str) -> float:
        value = number(text)
        if value == INFINITE:
            raise Misuse
        if len(self) >= MOST_NUMBERS:  # a long session must not keep every number it ever saw
            self.clear()
        self[text] = value
        return value


NUMBERS = Numbers()


def string(text: str) -> str:
    """The value of a literal string or character, without its quotes."""
    if "\\" not in text:
        return text[1:-1]
    first, *rest = text[1:-1].split("\\")
    out = [first]
    pieces = iter(rest)
    for piece in pieces:
        if piece:
            out.append(ESCAPES.get(piece[0], piece[0]) + piece[1:])
        else:  # `\\`: what follows it is plain
            out.append("\\" + next(pieces, ""))
    return "".join(out)


def dotted(at: int, text: str) -> Name:
    """`REMOTEOUT.1.2`: a keyword with its channels."""
    name, *channels = text.split(".")
    return Name(at, name, [Number(at, NUMBERS[each]) for each in channels], True)


def body(stack: Stack) -> list[Stmt]:
    """The empty list of statements with which a block begins."""
    depth = 0
    while stack:
        stack, _, value = stack
        if value.__class__ is list:
            depth += 1
    if depth > DEEPEST:
        raise TooDeep
    return []


def if_head(first: If) -> tuple[If, If]:
    """A block If up to a body: its first and its last branch."""
    return first, first


def else_if(head: tuple[If, If], body: list[Stmt], branch: If) -> tuple[If, If]:
    """A block If with the body of its last branch and a further ElseIf."""
    first, last = head
    last.body, last.orelse = body, [branch]
    return first, branch


def if_end(head: tuple[If, If], body: list[Stmt], orelse: list[Stmt]) -> If:
    """A whole block If: the body of its last branch, and that of its Else."""
    first, last = head
    last.body, last.orelse = body, orelse
    return first


def label_before(body: list[Stmt], at: int, texts: list[str]) -> list[Stmt]:
    """`NAME:` on a line of its own has been read as a call; make it the label it is."""
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
    """The members of a user type, line after line."""
    members += more
    return members


def printed(
    items: list[PrintItem], last: PrintItem | None, using: list[Expr], separator: str
) -> tuple[list[Expr], str, list[PrintItem]]:
    """What comes after the first value of a LINE: its formats, the sign behind it, the other values."""
    return using, separator, items if last is None else [*items, last]


def line_print(
    at: int, word: str, values: list[Expr], rest: tuple[list[Expr], str, list[PrintItem]]
) -> Print:
    """`LINE row, values` with what only stands between printed values."""
    using, separator, items = rest
    row = None if using and len(values) == 1 else values[0]
    shown = [PrintItem(each.at, each, [], ",") for each in values[1 if row is not None else 0 :]]
    if shown:
        shown[-1].using, shown[-1].separator = using, separator
    return Print(at, [*shown, *items], None, word, row)


def declare(name: Name, type: TypeName | None = None, value: Expr | None = None) -> Variable:
    """A variable of a `Dim`: what stands in its brackets are its dimensions."""
    return Variable(name.at, name.name, name.args or [], type, [] if value is None else [value])


def more_values(variables: list[Variable], value: Expr) -> list[Variable]:
    """After a `,` that follows an initial value: an array goes on with its values, else a variable begins.

    A second value for a simple variable stays with it; the compiler counts values and says so.
    """
    last = variables[-1]
    if isinstance(value, Name) and not last.dimensions and not value.axes:
        variables.append(declare(value))
    else:
        last.values.append(value)
    return variables


def counted(loop: For, body: list[Stmt], following: int | None, texts: list[str]) -> For:
    """A `For` with its body, and the variable after its `Next`, which must be its own."""
    if following is not None and texts[following].lower() != loop.variable.name.lower():
        raise Misuse
    loop.body = body
    return loop


def constants(at: int, names: list[Const]) -> Const:
    """A `Const` statement: its first name, which carries the others."""
    first, *first.more = names
    first.at = at
    return first


def next_case(select: Select, body: list[Stmt], case: Case) -> Select:
    """A `Case` after another one, whose body has now been read."""
    last_case(select, body).cases.append(case)
    return select


def last_case(select: Select, body: list[Stmt]) -> Select:
    """The end of a `Select`, or of one of its cases."""
    select.cases[-1].body = body
    return select


def task(at: int, name: str, items: list[Stmt | Sub]) -> Task:
    """A task: its statements apart from the subs written inside it."""
    return Task(
        at, name, [i for i in items if not isinstance(i, Sub)], [i for i in items if isinstance(i, Sub)]
    )


def module(items: list[Node]) -> Module:
    """A whole program, its statements and each sort of block apart."""
    sorts: dict[type, list[Node]] = {Sub: [], Task: [], Event: [], Startup: [], UserType: []}
    statements: list[Node] = []
    for item in items:
        sorts.get(type(item), statements).append(item)
    return Module(statements, *sorts.values())  # type: ignore[arg-type]

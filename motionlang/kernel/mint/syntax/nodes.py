"""The abstract syntax of Mint, which the parser builds and the later stages read.

Every node extends from the character at `start` to the one before `end` of the text, and so does every name, which is
a `Word`. `Module.line(start)` and `Module.column(start)` turn an offset into a position.

The grammar contains no keyword of the motion library: `SPEED(0) = 10` is an `Assign` to a `Name`, and `GO(0)` is a
`Call` of a `Name`. Name resolution finds their meaning in the keyword table.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

from motionlang.kernel.errors import Diagnostic
from motionlang.kernel.lang.syntax.word import Word
from motionlang.kernel.mint.syntax.node import ClosedByName, Expression, Resolved, ResolvedName
from motionlang.kernel.mint.syntax.node import Node as Node  # noqa: PLC0414 - nodes.Node to everybody else
from motionlang.kernel.source import Source

if TYPE_CHECKING:
    from motionlang.kernel.lang.syntax.grammar import Token
    from motionlang.kernel.mint.resolve.symbols import Type

NO_WORD = Word("")

# --------------------------------------------------------------------------------------------- expressions


@dataclass(eq=False, repr=False, slots=True)
class Number(Expression):
    """A literal number.

    `value` is an int if the text has neither a point nor an exponent, else a float.
    """

    value: float


@dataclass(eq=False, repr=False, slots=True)
class String(Expression):
    """A literal string, without its quotes."""

    value: str


@dataclass(eq=False, repr=False, slots=True)
class Name(ResolvedName):
    """A variable, array element, keyword or function, with or without arguments.

    `name` preserves the spelling of the source. `args` is None if no bracket follows. `axes` is True for the v4 forms
    `MOVER.0` and `MOVER[0, 1]`, whose indices can only be axes or channels.
    """

    name: Word
    args: list[Expr] | None = None
    axes: bool = False


@dataclass(eq=False, repr=False, slots=True)
class Member(ResolvedName):
    """A member `value.field` of a value of user type.

    `args` are the subscripts of `value.field(…)`, None without brackets.
    """

    value: Expr
    field: Word
    args: list[Expr] | None = None


@dataclass(eq=False, repr=False, slots=True)
class Unary(Expression):
    """A unary operation; `op` is one of `-`, `+`, `Not`, `~`."""

    op: str
    operand: Expr


@dataclass(eq=False, repr=False, slots=True)
class Binary(Expression):
    """A binary operation; `op` is in canonical spelling.

    It is one of `^ * / \\ Mod + - << >> & | Xor = <> < > <= >= And Or`.
    """

    op: str
    left: Expr
    right: Expr


@dataclass(eq=False, repr=False, slots=True)
class Omitted(Expression):
    """An omitted value, as in `SPEED(0, 1) = , 20`: the empty text before a `,`."""


@dataclass(eq=False, repr=False, slots=True)
class Link(Expression):
    """An operator of a `Chain` and the operand after it.

    Its type and constant are those of the operations up to this one.
    """

    op: str
    value: Expr


@dataclass(eq=False, repr=False, slots=True)
class Chain(Expression):
    """A long left-associative run of operations, such as `a + b - c …`.

    As nested `Binary` nodes it would be thousands of levels deep; `nesting.py` makes it from these.
    """

    first: Expr
    links: list[Link]


@dataclass(eq=False, repr=False, slots=True)
class Given(Expression):
    """A value that the program receives when it starts.

    It replaces the initial value of a name that differs between runs of one compiled program.
    """

    name: str
    is_text: bool


@dataclass(eq=False, repr=False, slots=True)
class Cast(Expression):
    """A conversion to another type: a `Const` with a type whose value is a `Given`."""

    value: Expr
    to: Type


@dataclass(eq=False, repr=False, slots=True)
class Wrong(Expression):
    """A text that does not follow the grammar, in place of a statement or an expression.

    Only the tree of a text with syntax errors has it.
    """


Expr = Number | String | Given | Cast | Name | Member | Unary | Binary | Chain | Omitted | Wrong


# ---------------------------------------------------------------------------------------------- statements


@dataclass(eq=False, repr=False, slots=True)
class Assign(Node):
    """An assignment `target = value, value …`.

    `repeat` is True if a trailing `;` gives the last value to all other axes. An `Omitted` among the values
    leaves its axis unchanged. The last value is never omitted.
    """

    target: Name | Member
    values: list[Expr]
    repeat: bool = False


@dataclass(eq=False, repr=False, slots=True)
class Call(Node):
    """A call of a command or a sub: `GO(0)`, `Fill(3)`, `Fill 3, 4`.

    The arguments in brackets are in `target.args`, those without brackets in `args`.
    """

    target: Name


@dataclass(eq=False, repr=False, slots=True)
class PrintItem(Node):
    """One value of a PRINT with its `USING` formats.

    `separator` is the sign that follows it: `,` or `;` or "".
    """

    value: Expr
    using: list[Expr]
    separator: str


@dataclass(eq=False, repr=False, slots=True)
class Print(Resolved):
    """A `PRINT [#terminal,] items`; the last separator decides whether the line ends.

    `word` is the keyword in front of the items if it is not PRINT; only LINE is valid there. `line` is the row of a
    LINE, which comes before the items.
    """

    items: list[PrintItem]
    terminal: Expr | None = None
    word: Word = NO_WORD
    line: Expr | None = None


@dataclass(eq=False, repr=False, slots=True)
class Input(Node):
    """`INPUT [#terminal,] ["prompt",] variable [USING …]`."""

    target: Name | Member
    prompt: Expr | None
    using: list[Expr]
    terminal: Expr | None


@dataclass(eq=False, repr=False, slots=True)
class TypeName(Resolved):
    """The name of a type, built-in or user-defined; `String` has a `size`."""

    name: Word
    size: Expr | None = None


@dataclass(eq=False, repr=False, slots=True)
class Variable(Resolved):
    """One name of a `Dim`: its dimensions (empty for a scalar), type, initial values."""

    name: Word
    dimensions: list[Expr]
    type: TypeName | None
    values: list[Expr]


@dataclass(eq=False, repr=False, slots=True)
class Dim(Node):
    """`Dim a As Integer, b(3) = 1, 2, 3`; `nv` marks data that survives between runs."""

    variables: list[Variable]
    nv: bool = False


class Const(Resolved):
    """`Const name [As type] = value, …`; `more` holds a node for each further name."""

    __slots__ = ("more", "name", "type", "value")

    def __init__(self, start: int, end: int, name: Word, type: TypeName | None, value: Expr) -> None:
        self.start, self.end, self.name, self.type, self.value = start, end, name, type, value
        self.more: list[Const] = []


@dataclass(eq=False, repr=False, slots=True)
class Define(Resolved):
    """`Define name = text`: `name` stands for an expression at each use."""

    name: Word
    value: Expr


@dataclass(eq=False, repr=False, slots=True)
class If(Node):
    """A block or one-line `If`; an `ElseIf` is an `If` in `orelse`.

    The block form is `If … Then … ElseIf … Else … End If`.
    """

    condition: Expr
    body: list[Stmt]
    orelse: list[Stmt]


@dataclass(eq=False, repr=False, slots=True)
class CaseTest(Node):
    """One entry of a `Case`: a value (`op` "="), a range ("To") or `Is op value`.

    `high` is the upper end of a range.
    """

    op: str
    value: Expr
    high: Expr | None = None


@dataclass(eq=False, repr=False, slots=True)
class Case(Node):
    """`Case tests`; `Case Else` has no tests."""

    tests: list[CaseTest]
    body: list[Stmt]


@dataclass(eq=False, repr=False, slots=True)
class Select(Node):
    """`Select Case subject … End Select`."""

    subject: Expr
    cases: list[Case]


@dataclass(eq=False, repr=False, slots=True)
class For(ClosedByName):
    """`For variable = first To stop Step step … Next`; `last_name` is the name after `Next`, None without one."""

    variable: Name
    first: Expr
    stop: Expr
    step: Expr | None
    body: list[Stmt]


@dataclass(eq=False, repr=False, slots=True)
class While(Node):
    """`While condition … End While`."""

    condition: Expr
    body: list[Stmt]


@dataclass(eq=False, repr=False, slots=True)
class Repeat(Node):
    """`Repeat … Until condition`."""

    body: list[Stmt]
    condition: Expr


@dataclass(eq=False, repr=False, slots=True)
class Loop(Node):
    """`Loop … End Loop`."""

    body: list[Stmt]


@dataclass(eq=False, repr=False, slots=True)
class Exit(Node):
    """`Exit [For | While | Repeat | Loop | Select | Sub | Function | Task | Event]`.

    `kind` is lower case.
    """

    kind: str


@dataclass(eq=False, repr=False, slots=True)
class Pause(Node):
    """`Pause condition`: wait until the condition is true."""

    condition: Expr


@dataclass(eq=False, repr=False, slots=True)
class Run(Resolved):
    """`Run task`."""

    name: Word


@dataclass(eq=False, repr=False, slots=True)
class End(Resolved):
    """`End`, which ends the program, or `End task`."""

    name: Word | None = None


@dataclass(eq=False, repr=False, slots=True)
class Label(Resolved):
    """`#NAME` (v4) or `NAME:` on a line of its own."""

    name: Word


@dataclass(eq=False, repr=False, slots=True)
class Jump(Resolved):
    """A jump of `kind` "goto" or "gosub"."""

    kind: str
    name: Word


@dataclass(eq=False, repr=False, slots=True)
class Return(Node):
    """`Return` from a `Gosub`, an event or a sub."""


@dataclass(eq=False, repr=False, slots=True)
class Auto(Node):
    """`Auto`: start the program at power-up."""


Stmt = (
    Assign
    | Call
    | Print
    | Input
    | Dim
    | Const
    | Define
    | If
    | Select
    | For
    | While
    | Repeat
    | Loop
    | Exit
    | Pause
    | Run
    | End
    | Label
    | Jump
    | Return
    | Auto
    | Wrong
)


# -------------------------------------------------------------------------------------------- declarations


@dataclass(eq=False, repr=False, slots=True)
class Parameter(Resolved):
    """One parameter of a sub or a function."""

    name: Word
    type: TypeName | None
    by_ref: bool = False
    is_array: bool = False


@dataclass(eq=False, repr=False, slots=True)
class Sub(Resolved):
    """`Sub name(parameters) … End Sub`; a `Function` has a `result` type."""

    name: Word
    parameters: list[Parameter]
    body: list[Stmt]
    function: bool = False
    result: TypeName | None = None


@dataclass(eq=False, repr=False, slots=True)
class Task(Resolved):
    """`Task name … End Task`, with the subs and functions written inside it."""

    name: Word
    body: list[Stmt]
    subs: list[Sub]


@dataclass(eq=False, repr=False, slots=True)
class Event(Resolved):
    """`Event name … End Event`."""

    name: Word
    body: list[Stmt]


@dataclass(eq=False, repr=False, slots=True)
class Startup(Node):
    """`Startup … End Startup`."""

    body: list[Stmt]


@dataclass(eq=False, repr=False, slots=True)
class UserType(Resolved):
    """`Type name … End Type`."""

    name: Word
    members: list[Variable]


class Located(Node):
    """A tree with its source, its syntax errors and, if there are none, its tokens; comparisons ignore these."""

    __slots__ = ("errors", "source", "tokens")

    source: Source
    errors: list[Diagnostic]
    tokens: list[Token]

    def line(self, at: int) -> int:
        """Return the line, from 1, of an offset."""
        return self.source.location(at)[0]

    def column(self, at: int) -> int:
        """Return the column, from 1, of an offset."""
        return self.source.location(at)[1]


class Module(Located):
    """A whole program: the parent task's statements, then its blocks, in source order."""

    __slots__ = ("body", "events", "startup", "subs", "tasks", "types")

    def __init__(
        self,
        start: int,
        end: int,
        body: list[Stmt],
        subs: list[Sub],
        tasks: list[Task],
        events: list[Event],
        startup: list[Startup],
        types: list[UserType],
    ) -> None:
        self.start, self.end = start, end
        self.body, self.subs, self.tasks, self.events = body, subs, tasks, events
        self.startup, self.types = startup, types

    @property
    def everything(self) -> list[Node]:
        """All statements and blocks, without the types."""
        return [*self.body, *self.subs, *self.tasks, *self.events, *self.startup]

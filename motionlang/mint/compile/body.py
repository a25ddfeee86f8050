"""The Python text of one function, and how it counts virtual time.

Problem. A Mint program becomes Python functions. Each statement takes machine time (10 µs by default), events must
take effect between the right two statements, and a task must give way in the middle of any loop or sub. Counting and
comparing after each statement would take longer than most statements themselves.

Idea. Time is counted in statements, and as late as possible. `pending` is the number of statements written since `t`
was last up to date. It becomes a constant in the text where a statement needs the time, and at the end of a block. The
exact time of a statement that only computes makes no difference, so several are paid for together.

    n = 1             v_n = 1.0
    n = n + 2         v_n = v_n + 2
    MOVER(0) = n      if k0(2.0, v_n, 3): yield       pays for the 2 statements before it; 3 is the line
    GO(0)             if k1(1.0, 4): yield            pays for MOVER
    n = 0             v_n = 0.0
                      t += 2.0                        pays for GO and n = 0, at the end of the block

The names in the text:

    t, H        the statement, and the first one at which something else may happen; cells that others write, so both
                may differ after a `yield`
    T(n)        pays for n statements and sets the clock; true if something else is due first, and the task gives way
    kN          an operation or another object of the run, described in `Whole.specs`
    E, P        the environment of the program, and its print function
    v_ p_ s_    variables, parameters and subs; other prefixes are the compiler's own

Data. `Whole` is what the functions of a program share: names, problems, specs. `Body` is one function, with its `lines`
and what is known at the point that is being written. A `Line` has a text, the source offset that it comes from, and the
names of its variables, so that later passes need not parse the text. A `Value` is an expression: its text, its type and
what is known of its value.

Invariants.
- Machine time is base + t × cost and never a running sum, so it does not matter how often the clock is set.
- A statement that reads the world or acts on it runs after all that is due before it: `settle` and `operate` write the
  check in front of it.
- `t` is up to date (`pending` is 0) at both ends of an indented block, so all branches agree on it.
- Each line has the source offset of its statement. Errors, waits and the log's loops are located by it.
- A function is a generator unless it is `plain` (`names.py`).

Cost. A statement that computes adds nothing, a block one addition, and an iteration one comparison with `H`.
"""

from __future__ import annotations

from motionlang.mint.compile import intervals
from motionlang.mint.compile.lines import HORIZON, JUST_YIELDS, NONE, PLAIN, YIELDS, Line
from motionlang.mint.resolve.handlers import handles
from motionlang.mint.resolve.symbols import INTEGER, NUMERIC, Function, Symbol
from motionlang.mint.syntax import nodes

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Callable, Sequence

    from motionlang.lang.dialect import Ranges
    from motionlang.lang.keyword import Keyword, Table
    from motionlang.mint.compile.loop_times import Region
    from motionlang.mint.compile.polling import Poll
    from motionlang.mint.compile.splitting import Part
    from motionlang.mint.resolve.names import Names
    from motionlang.mint.resolve.problems import Problems
    from motionlang.mint.resolve.symbols import Type

    # What an operation is bound to: an axis, several, each, or none.
    Where = int | tuple[int, ...] | str | None

Spec = tuple[object, ...]
# In the place of an axis: whichever one the program names.
EACH = "each"


# The call of a sub that may wait, and what may stand before it where nothing is worked out yet.
CALL = "(yield from "
_WORKS_NOTHING_OUT = frozenset(("if", "elif", "not", "while", "return"))
# How tightly an operator binds whose brackets may be left out: a sum, a product.
SUM, PRODUCT = 1, 2


class Value:
    """An expression in Python: its text, its Mint type, what is known of it, its value where that is known.

    The text can stand anywhere. Where it is a sum or a product in brackets, `binds` says which, and `bare` leaves the
    brackets out: CPython takes as long for two of them as for a name.
    """

    __slots__ = ("binds", "const", "range", "text", "type")

    # Of a reading that takes the level it is compared with: its text with that; and without its sign.
    solved: Callable[[str], str] | None = None
    unsigned: Callable[[str], str] | None = None

    def __init__(
        self,
        text: str,
        type: str,
        range: intervals.Range = intervals.FLOAT,
        const: float | str | None = None,
        binds: int = 0,
    ) -> None:
        self.text, self.type, self.range, self.const, self.binds = text, type, range, const, binds

    @property
    def bare(self) -> str:
        """The text where nothing beside it binds."""
        return self.text[1:-1] if self.binds else self.text

    @property
    def truth(self) -> str:
        """The text where only its truth counts."""
        return self.text

    @property
    def is_number(self) -> bool:
        return self.type in NUMERIC


class Reading(Value):
    """What may say until when it holds."""

    __slots__ = ("solved", "unsigned")

    def __init__(self, text: str, type: str, range: intervals.Range) -> None:
        super().__init__(text, type, range)
        self.solved = self.unsigned = None


class Answer(Value):
    """What is true or false in Python, without brackets: an Integer, 1 or 0, but in a condition as it is.

    `joined`: it is made of several answers, or turned round, so that a Not in front of it needs brackets.
    """

    __slots__ = ("_truth", "joined")

    def __init__(self, truth: str, joined: bool = False) -> None:
        super().__init__(f"(1 if {truth} else 0)", INTEGER, intervals.BOOL)
        self._truth, self.joined = truth, joined

    @property
    def truth(self) -> str:
        return self._truth


class Whole:
    """What all functions of a program share: names, problems, and the run-time objects the text refers to.

    `specs[n]` tells the runtime what `kN` is (`kN` and a suffix where earlier lines have theirs).
    """

    __slots__ = (
        "_operations",
        "axes",
        "axis_texts",
        "checks",
        "guarded",
        "line",
        "names",
        "others",
        "parts",
        "problems",
        "ranges",
        "rewritten",
        "spec_names",
        "specs",
        "suffix",
        "table",
        "told",
        "typed",
    )

    def __init__(
        self,
        table: Table,
        problems: Problems,
        names: Names,
        axes: range,
        suffix: str,
        told: frozenset[str] = frozenset(),
    ) -> None:
        self.table, self.problems, self.names, self.axes = table, problems, names, axes
        self.typed, self.suffix = names.typed, suffix
        # What knows the ranges of a function's variables; None where they are not analysed.
        self.ranges: Ranges | None = None
        self.told = told  # words whose values the machine file says
        self.axis_texts: dict[float, str] = {axis: str(axis) for axis in axes}
        self.specs: list[Spec] = []
        self.spec_names: dict[Spec, str] = {}
        self._operations: dict[tuple[str, Keyword, Where], str] = {}
        # What loops that poll may write over and over.
        self.rewritten: set[Keyword] = set()
        self.parts = 0  # how many there are
        self.line = problems.line
        # Whether an ONERROR handler takes what fails, so that the program goes on.
        self.guarded = handles(names, "onerror")
        # Whether others can change what a function reads while it gives way.
        self.others = self.typed or any(f.jumps or f.kind in ("task", "event") for f in names.functions)
        # Whether the statement being written holds what may fail, or what there is but once.
        self.checks = False

    def use(self, *spec: object) -> str:
        """The name, in the generated text, of what `spec` describes; what is used there may fail."""
        self.checks = True
        return self._named(*spec)

    def _named(self, *spec: object) -> str:
        name = self.spec_names.get(spec)
        if name is None:
            name = self.spec_names[spec] = f"k{len(self.specs)}{self.suffix}"
            self.specs.append(spec)
        return name

    def described(self) -> list[Spec]:
        """What the `kN` are, now that it is known which of them loops that poll use, and what was cut into parts."""
        if self.rewritten:
            numbers = {name: number for number, name in enumerate(self.spec_names.values())}
            for (how, row, _), name in self._operations.items():
                if how in ("write", "do") and row in self.rewritten:
                    number = numbers[name]
                    self.specs[number] = (f"re{how}", *self.specs[number][1:])
        if self.parts:  # whose places have callers
            self.specs = [(*spec[:3], False) if spec[0] == "wait" else spec for spec in self.specs]
        return self.specs

    def called(self, how: str, row: Keyword, where: list[str]) -> tuple[str, list[str]]:
        """What is called to "read", "write", "load" or "do" a keyword at `where`, as text, and what it is then given.

        What has to do with one axis is bound to it by its number; a reading and a writing also by a text that finds it
        in the run.
        """
        if row.index not in ("axis", "axes") or not row.simulated:
            return self._operation(how, row, None), where
        axis, *rest = where
        if axis.isdecimal():
            return self._operation(how, row, int(axis)), rest
        if how in ("load", "do"):
            return self._operation(how, row, None), where
        self.checks = True  # as there may be no such axis
        return f"{self._operation(how, row, EACH)}[{axis}]", rest

    def called_together(self, how: str, row: Keyword, axes: list[str]) -> tuple[str, list[str]]:
        """The same of what loads or does something with several axes at once, bound to them where they are known."""
        if row.simulated and all(map(str.isdecimal, axes)):
            return self._operation(how, row, tuple(map(int, axes))), []
        return self._operation(how, row, None), [f"({', '.join(axes)},)"]

    def _operation(self, how: str, row: Keyword, axis: Where) -> str:
        name = self._operations.get((how, row, axis))
        if name is None:
            of = () if axis is None else (axis,)
            name = self._named(how, row.name, *of)
            self._operations[how, row, axis] = name
        return name


class Body:
    """One function being written."""

    __slots__ = (
        "_labels",
        "_stretches",
        "analysed",
        "at",
        "callee",
        "calls",
        "deepest",
        "facts",
        "function",
        "indent",
        "levels",
        "lines",
        "loops",
        "names",
        "noted",
        "observes",
        "outside",
        "parts",
        "pending",
        "polls",
        "regions",
        "scope",
        "stretch",
        "targets",
        "temps",
        "thrown",
        "timed",
        "turn",
        "values",
        "waits",
        "watching",
        "whole",
    )

    def __init__(self, whole: Whole, function: Function) -> None:
        self.whole, self.function, self.scope = whole, function, function.scope
        self.lines: list[Line] = []
        # What the next line has of variables.
        self.names: list[str] = []
        self.indent = 2  # in its function, which stands in what makes the cells
        self.at = function.at
        self.pending = 0
        self.temps = 0
        # Names of outer functions that this one assigns to.
        self.outside: set[str] = set()
        self._stretches: list[tuple[str, list[nodes.Stmt]]] | None = None
        self._labels: dict[str, int] | None = None
        # What a turn that a Goto ends is compared by, where it is known; () where it is not watched.
        self.turn: tuple[dict[str, Symbol], bool, bool, str] | tuple[()] | None = None
        # The stretch between labels that is being written; the watches on jumps back, which begin with the dispatcher.
        self.stretch = 0
        self.polls: list[Poll] = []
        # In how many loops that are watched it stands; what readings are compared with that loops only keep, by node.
        self.watching = 0
        self.levels: dict[int, str] = {}
        self.parts: list[Part] = []
        self.loops: list[tuple[str, str]] = []
        # The source offsets of the loops around what is written, and the loops that Gotos make.
        self.timed: list[int] = []
        self.regions: list[Region] = []
        # The loops that a jump is thrown out of.
        self.thrown: set[int] = set()
        # How many loops stand within one another at most in what was written last.
        self.deepest = 0
        self.facts: dict[int, intervals.Range] = {}
        self.analysed: set[Symbol] = set()
        # Variables that are the same wherever they are read, by their spelling.
        self.values: dict[str, Value] = {}
        # Variables that were given a value, by their spelling.
        self.targets: dict[str, tuple[str, Type, Symbol]] = {}
        # Of the statement being written: does it take note of time, does it call a sub that may wait?
        self.observes = self.calls = False
        # The sub that was called last.
        self.callee: Function | None = None
        # Of the function so far: was `t` used as an absolute time; does it hold a `yield`?
        self.noted = self.waits = False

    # -------------------------------------------------------------------------------------------- lines

    def emit(self, text: str, kind: str = PLAIN, cost: int = 0) -> None:
        """Write a line; one that calls a sub with part of an expression worked out counts that (`E.midway`)."""
        if CALL in text and self.whole.others and not _calls_first(text):
            text = text.replace(CALL, f"{CALL}E.midway or ")
        if self.names:
            self.lines.append(Line(self.indent, text, self.at, kind, self.names, cost))
            self.names = []
        else:
            self.lines.append(Line(self.indent, text, self.at, kind, NONE, cost))

    def spelt(self, symbol: Symbol) -> str:
        """A variable in the text of the next line."""
        self.names.append(symbol.python)
        return symbol.python

    def gives_way(self) -> None:
        """The next line holds a `yield`."""
        self.names.append(YIELDS)
        self.waits = True

    def temp(self, kind: str = "w") -> str:
        """A name for what the program does not name; of kind `SCRATCH` where nothing asks for it after a `yield`."""
        self.temps += 1
        return f"{kind}{self.temps}"

    # --------------------------------------------------------------------------------------------- time

    def begin(self) -> None:
        """A statement begins: nothing is known of it yet."""
        self.observes = self.calls = self.whole.checks = False

    def flush(self) -> None:
        """Bring `t` up to date."""
        if self.pending:
            self.emit(f"t += {self.pending}.0", cost=self.pending)
            self.pending = 0

    def _give_way(self, text: str) -> None:
        """A line by which others run when their time has come."""
        self.waits = self.noted = True
        names = JUST_YIELDS
        if self.names:
            names, self.names = [*self.names, YIELDS], []
        self.lines.append(Line(self.indent, text, self.at, HORIZON, names))

    def horizon(self, answer: str = "t", then: str = "") -> None:
        """Bring `t` up to date and let others run when their time has come, `then` look again."""
        now = "t"
        if self.pending:
            now, self.pending = f"(t := t + {self.pending}.0)", 0
        give_way = "yield" if answer == "t" else f"yield {answer}"
        self._give_way(f"if {now} >= H: {give_way}{then}")

    def settle(self, tell: bool = True) -> None:
        """Before a statement that takes note of time: let everything happen that is due until then.

        `tell`: the clock is told, as what follows reads it.
        """
        if self.observes and tell:
            self._give_way(f"if T({self.pending}.0): yield")
            self.pending = 0
        elif self.observes:
            self.horizon()
        elif self.calls:
            self.flush()
            self.noted = True

    def operate(self, calls: Sequence[tuple[str, list[str]]]) -> None:
        """A statement of operations, which look themselves whether something is due until then.

        That is before them where what they are given reads the time, may fail, or may be another one afterwards.
        """
        if (
            not calls
            or self.observes
            or self.calls
            or self.whole.checks
            or (self.names and self.whole.others)
        ):
            tell, self.observes = self.observes, True
            self.settle(tell)
        for operation, arguments in calls:
            if self.calls and arguments:  # time passes in the sub, so what it is given is worked out before
                given = self.temp()
                self.emit(f"{given} = {', '.join(arguments)},")
                arguments = [f"*{given}"]
            self.operation(operation, arguments)
        self.pending = 1

    def operation(self, operation: str, arguments: list[str]) -> None:
        """The call of an operation, which brings `t` up to date, and the way for others where it is put off."""
        self._give_way(f"if {operation}({', '.join([f'{self.pending}.0', *arguments])}): yield")
        self.pending = 0

    def act(self, text: str) -> None:
        """A statement of one line that may take note of time."""
        self.settle()
        self.emit(text)
        self.pending += 1

    def wait(self, expression: str, at_once: str = "") -> None:
        """Give way until a `Wait` is over; `at_once or` says when it was over before anything could happen."""
        self.flush()
        self.gives_way()
        self.emit(f"t, H = {at_once}(yield {expression})" if at_once else f"t, H = yield {expression}")
        self.noted = True

    # ------------------------------------------------------------------------------------------- labels

    def stretches(self) -> list[tuple[str, list[nodes.Stmt]]]:
        """The statements between labels, each stretch with the label that leads to it ("" for the first)."""
        if self._stretches is None:
            self._stretches = [("", [])]
            for node in self.function.body:
                if type(node) is nodes.Label:
                    self._stretches.append((node.name.lower(), []))
                else:
                    self._stretches[-1][1].append(node)
        return self._stretches

    def labels(self) -> dict[str, int]:
        """The number of the stretch that each label leads to."""
        if self._labels is None:
            self._labels = {}
            for number, (label, _) in enumerate(self.stretches()):
                self._labels.setdefault(label, number)
        return self._labels

    # ------------------------------------------------------------------------------------------- errors

    def problem(self, code: str, message: str, node: nodes.Node, hint: str = "") -> None:
        self.whole.problems.add(code, message, node.at, hint)

    def warn(self, code: str, message: str, node: nodes.Node, hint: str = "") -> None:
        self.whole.problems.add(code, message, node.at, hint, "warning")

    # ---------------------------------------------------------------------------------------- variables

    def use_outside(self, symbol: Symbol) -> None:
        """Note that the function assigns to a variable that lives outside it (or outside its dispatcher)."""
        if self.function.jumps or not self.keeps(symbol):
            self.outside.add(symbol.python)

    def keeps(self, symbol: Symbol) -> bool:
        """Whether a variable lives in this Python function: what others use too does only in subs, which recur."""
        function = self.function
        if symbol.home is not function:
            return False
        return function.kind == "sub" or not (symbol.shared or (self.whole.typed and function.kind == "main"))

    def range_of(self, symbol: Symbol, node: nodes.Node) -> intervals.Range:
        """What is known of a variable where `node` reads it."""
        fact = self.facts.get(id(node))
        if fact is not None:
            return fact
        if symbol.type.name == INTEGER:
            return intervals.INTEGER
        return intervals.ANY if symbol in self.analysed else intervals.FLOAT


def _calls_first(text: str) -> bool:
    """Whether nothing is worked out in a line before its one call of a sub that may wait."""
    before, _, after = text.partition(CALL)
    words = before.rpartition(" = ")[2].replace("(", " ").split()
    return CALL not in after and all(each in _WORKS_NOTHING_OUT for each in words)

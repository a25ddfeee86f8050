"""Write the Python text of one function, and count virtual time in it.

Problem. A Mint program becomes Python functions. Each statement takes machine time (10 µs by default), events
must take effect between the right two statements, and a task must give way in the middle of any loop or sub.
Counting and comparing after each statement would take longer than most statements themselves.

Idea. Time is counted in statements, and as late as possible. `pending` is the number of statements written
since `t` was last up to date. It becomes a constant in the text where a statement needs the time, and at the
end of a block. The exact time of a statement that only computes makes no difference, so several are paid for
together.

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
    kN          an operation or another object of the run, described in `SharedData.specs`
    E, P        the environment of the program, and its print function
    v_ p_ s_    variables, parameters and subs; other prefixes are the compiler's own

Data. `SharedData` is what the functions of a program share: names, problems, specs. `Body` is one function, with
its `lines` and the known facts at the point that is being written. A `Line` has a text, the source offset
that it comes from, and the names of its variables, so that later passes need not parse the text. A `Value` is
an expression: its text, its type and its possible values.

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
    from motionlang.lang.keyword import Keyword
    from motionlang.lang.vocabulary import Vocabulary
    from motionlang.mint.compile.loop_times import Region
    from motionlang.mint.compile.polling import Poll
    from motionlang.mint.compile.splitting import Chunk
    from motionlang.mint.compile.stops import Debugging
    from motionlang.mint.resolve.names import Names
    from motionlang.mint.resolve.problems import Problems
    from motionlang.mint.resolve.symbols import Type

    # The binding of an operation: to one axis, to several axes, to `EACH`, or to none.
    Where = int | tuple[int, ...] | str | None

Spec = tuple[object, ...]
# In place of an axis: the axis that the program names at run time.
EACH = "each"


# The call of a sub that may wait, and the words that may come before it without any evaluation.
CALL = "(yield from "
_WORKS_NOTHING_OUT = frozenset(("if", "elif", "not", "while", "return"))
# The precedence of an operator whose brackets may be left out: sum, product.
SUM, PRODUCT = 1, 2


class Value:
    """An expression in Python: its text, Mint type, range and, if known, its value.

    The text is valid in any context. If it is a sum or a product in brackets, `binds` says which, and `bare`
    leaves the brackets out: CPython takes as long for a pair of them as for a name.
    """

    __slots__ = ("binds", "const", "range", "text", "type")

    # For a reading that accepts the level it is compared with: its text with that level, and its text for the
    # distance from the centre that is its second argument.
    solved: Callable[[str], str] | None = None
    unsigned: Callable[[str, str], str] | None = None

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
        """Return the text without brackets, for use where no operator is next to it."""
        return self.text[1:-1] if self.binds else self.text

    @property
    def truth(self) -> str:
        """Return the text for use where only the truth value counts."""
        return self.text

    @property
    def is_number(self) -> bool:
        return self.type in NUMERIC


class Reading(Value):
    """The value of a keyword whose comparison can predict how long its result holds."""

    __slots__ = ("solved", "unsigned")

    def __init__(self, text: str, type: str, range: intervals.Range) -> None:
        super().__init__(text, type, range)
        self.solved = self.unsigned = None


class Answer(Value):
    """A truth value in Python: the Integer 1 or 0, or the bare test in a condition.

    `joined` is true if it consists of several tests or is negated, so a Not in front of it needs brackets.
    """

    __slots__ = ("_truth", "joined")

    def __init__(self, truth: str, joined: bool = False) -> None:
        super().__init__(f"(1 if {truth} else 0)", INTEGER, intervals.BOOL)
        self._truth, self.joined = truth, joined

    @property
    def truth(self) -> str:
        return self._truth


class SharedData:
    """The data that all functions of a program share.

    It holds names, problems and the run-time objects of the text. `specs[n]` defines `kN` for the runtime
    (with a suffix at a prompt, because earlier lines have their own).
    """

    def __init__(
        self,
        table: Vocabulary,
        problems: Problems,
        names: Names,
        axes: range,
        suffix: str,
        supplied: frozenset[str] = frozenset(),
    ) -> None:
        self.table, self.problems, self.names, self.axes = table, problems, names, axes
        self.typed, self.suffix = names.typed, suffix
        # Returns the ranges of a function's variables; None if they are not analysed.
        self.ranges: Ranges | None = None
        # What a debugger may know of the program; None if it has no stops.
        self.debugging: Debugging | None = None
        self.supplied = supplied  # keywords whose values the machine file gives
        self.axis_texts: dict[float, str] = {axis: str(axis) for axis in axes}
        self.specs: list[Spec] = []
        self.spec_names: dict[Spec, str] = {}
        self._operations: dict[tuple[str, Keyword, Where], str] = {}
        # Keywords that polling loops may write repeatedly.
        self.rewritten: set[Keyword] = set()
        self.chunk_count = 0  # the number of parts so far
        self.line = problems.line
        # True if an ONERROR handler catches failures, so that the program continues.
        self.guarded = handles(names, "onerror")
        # True if others can change data that a function reads while it yields.
        self.others = self.typed or any(f.jumps or f.kind in ("task", "event") for f in names.functions)
        # True if the statement being written uses a run-time object, which may fail or exist only once.
        self.checks = False

    def use(self, *spec: object) -> str:
        """Return the name in the generated text for `spec`, an operation that may fail."""
        self.checks = True
        return self._named(*spec)

    def _named(self, *spec: object) -> str:
        name = self.spec_names.get(spec)
        if name is None:
            name = self.spec_names[spec] = f"k{len(self.specs)}{self.suffix}"
            self.specs.append(spec)
        return name

    def described(self) -> list[Spec]:
        """Return the final descriptions of the `kN`.

        By now it is known which of them polling loops use, and which functions were split into chunks.
        """
        if self.rewritten:
            numbers = {name: number for number, name in enumerate(self.spec_names.values())}
            for (how, row, _), name in self._operations.items():
                if how in ("write", "do") and row in self.rewritten:
                    number = numbers[name]
                    self.specs[number] = (f"re{how}", *self.specs[number][1:])
        if self.chunk_count:  # waits in parts have callers
            self.specs = [(*spec[:3], False) if spec[0] == "wait" else spec for spec in self.specs]
        return self.specs

    def called(self, how: str, row: Keyword, where: list[str]) -> tuple[str, list[str]]:
        """Return the text of the operation on a keyword, and its arguments.

        `how` is "read", "write", "load" or "do". An operation on one axis is bound to the number of the axis.
        If the axis is computed at run time, the text of a read or a write looks the operation up by axis.
        """
        if row.index not in ("axis", "axes") or not row.simulated:
            return self._operation(how, row, None), where
        axis, *rest = where
        if axis.isdecimal():
            return self._operation(how, row, int(axis)), rest
        if how in ("load", "do"):
            return self._operation(how, row, None), where
        self.checks = True  # the axis may not exist
        return f"{self._operation(how, row, EACH)}[{axis}]", rest

    def called_together(self, how: str, row: Keyword, axes: list[str]) -> tuple[str, list[str]]:
        """Return one operation on several axes at once; see `called`.

        It is bound to the axes if they are known.
        """
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

    def __init__(self, whole: SharedData, function: Function) -> None:
        self.whole, self.function, self.scope = whole, function, function.scope
        self.lines: list[Line] = []
        # The variables in the next line.
        self.names: list[str] = []
        self.indent = 2  # inside its function, which is inside the one that makes the cells
        self.at = function.at
        self.pending = 0
        self.temps = 0
        # Names of outer functions that this one assigns to.
        self.outside: set[str] = set()
        # Names of its own variables that are cells of the program.
        self.cells: set[str] = set()
        self._stretches: list[tuple[str, list[nodes.Stmt]]] | None = None
        self._labels: dict[str, int] | None = None
        # The state that is compared for an iteration that ends with a Goto, None until it is known, () if the
        # loop is not watched.
        self.watched_iteration: tuple[dict[str, Symbol], bool, bool, str] | tuple[()] | None = None
        # The stretch between labels that is being written, and the watches on backward jumps, which begin
        # with the dispatcher.
        self.stretch = 0
        self.polls: list[Poll] = []
        # The number of watched loops around the statement, and, by node, the level for readings that a loop
        # only stores.
        self.watching = 0
        self.levels: dict[int, str] = {}
        # Writes to host memory that decide nothing in their polling loop, by the identity of their nodes.
        self.copies: set[int] = set()
        self.chunks: list[Chunk] = []
        self.loops: list[tuple[str, str]] = []
        # The source offsets of the loops around the statement, and the loops made of Gotos.
        self.timed: list[int] = []
        self.regions: list[Region] = []
        # The loops that a jump leaves by an exception.
        self.thrown: set[int] = set()
        # The maximum nesting of loops in the lines written last.
        self.deepest = 0
        self.facts: dict[int, intervals.Range] = {}
        self.analysed: set[Symbol] = set()
        # Variables with the same text at each read, by their spelling.
        self.values: dict[str, Value] = {}
        # Variables that were assigned to, by their spelling.
        self.targets: dict[str, tuple[str, Type, Symbol]] = {}
        # For the statement being written: True if it observes time, and True if it calls a sub that may wait.
        self.observes = self.calls = False
        # The sub that was called last.
        self.callee: Function | None = None
        # For the function so far: True if `t` was used as an absolute time, and True if it contains a
        # `yield`. `hooked` is True after the hook of a debug build, which needs `t` too but may not change when it is
        # brought up to date.
        self.noted = self.waits = self.hooked = False

    # -------------------------------------------------------------------------------------------- lines

    def emit(self, text: str, kind: str = PLAIN, cost: int = 0) -> None:
        """Write a line.

        If the line calls a sub after it has evaluated part of its expression, the call is counted in `E.midway`.
        """
        if CALL in text and self.whole.others and not _calls_first(text):
            text = text.replace(CALL, f"{CALL}E.midway or ")
        if self.names:
            self.lines.append(Line(self.indent, text, self.at, kind, self.names, cost))
            self.names = []
        else:
            self.lines.append(Line(self.indent, text, self.at, kind, NONE, cost))

    def spelt(self, symbol: Symbol) -> str:
        """Return the name of a variable and record its use in the next line."""
        self.names.append(symbol.python)
        return symbol.python

    def note_yield(self) -> None:
        """Record that the next line contains a `yield`."""
        self.names.append(YIELDS)
        self.waits = True

    def temp(self, kind: str = "w") -> str:
        """Return a new name for a temporary value.

        Use the kind `SCRATCH` for a value that is not used after a `yield`.
        """
        self.temps += 1
        return f"{kind}{self.temps}"

    # --------------------------------------------------------------------------------------------- time

    def begin(self) -> None:
        """Begin a statement, whose properties are not known yet."""
        self.observes = self.calls = self.whole.checks = False

    def flush(self) -> None:
        """Write the line that brings `t` up to date."""
        if self.pending:
            self.emit(f"t += {self.pending}.0", cost=self.pending)
            self.pending = 0

    def _emit_yield(self, text: str) -> None:
        """Write a line at which the task yields to other tasks that are due."""
        self.waits = self.noted = True
        names = JUST_YIELDS
        if self.names:
            names, self.names = [*self.names, YIELDS], []
        self.lines.append(Line(self.indent, text, self.at, HORIZON, names))

    def horizon(self, answer: str = "t", then: str = "") -> None:
        """Bring `t` up to date and yield to tasks that are due; then carry out `then`."""
        now = "t"
        if self.pending:
            now, self.pending = f"(t := t + {self.pending}.0)", 0
        statement = "yield" if answer == "t" else f"yield {answer}"
        self._emit_yield(f"if {now} >= H: {statement}{then}")

    def settle(self, sets_clock: bool = True) -> None:
        """Write the check before a statement that observes time.

        Everything that is due before the statement happens first. With `sets_clock` the check also sets the clock,
        which the statement reads.
        """
        if self.observes and sets_clock:
            self._emit_yield(f"if T({self.pending}.0): yield")
            self.pending = 0
        elif self.observes:
            self.horizon()
        elif self.calls:
            self.flush()
            self.noted = True

    def operate(self, calls: Sequence[tuple[str, list[str]]]) -> None:
        """Write a statement made of operations, which themselves check for earlier events.

        The check comes before the arguments if these read the time, may fail, or may be changed by another task.
        """
        if (
            not calls
            or self.observes
            or self.calls
            or self.whole.checks
            or (self.names and self.whole.others)
        ):
            sets_clock, self.observes = self.observes, True
            self.settle(sets_clock)
        for operation, arguments in calls:
            if self.calls and arguments:  # time passes in the sub, so its arguments are evaluated before
                given = self.temp()
                self.emit(f"{given} = {', '.join(arguments)},")
                arguments = [f"*{given}"]
            self.operation(operation, arguments)
        self.pending = 1

    def operation(self, operation: str, arguments: list[str]) -> None:
        """Write the call of an operation, which brings `t` up to date.

        If the operation must wait for earlier events, the task yields.
        """
        self._emit_yield(f"if {operation}({', '.join([f'{self.pending}.0', *arguments])}): yield")
        self.pending = 0

    def act(self, text: str) -> None:
        """Write a one-line statement that may observe time."""
        self.settle()
        self.emit(text)
        self.pending += 1

    def wait(self, expression: str, at_once: str = "") -> None:
        """Write a wait: yield until the `Wait` is over.

        If nothing else can happen before the end of the wait, `at_once` returns its result without a yield.
        """
        self.flush()
        self.note_yield()
        self.emit(f"t, H = {at_once}(yield {expression})" if at_once else f"t, H = yield {expression}")
        self.noted = True

    # ------------------------------------------------------------------------------------------- labels

    def stretches(self) -> list[tuple[str, list[nodes.Stmt]]]:
        """Return the statements between labels, each stretch with the label before it.

        The label of the first stretch is "".
        """
        if self._stretches is None:
            self._stretches = [("", [])]
            for node in self.function.body:
                if type(node) is nodes.Label:
                    self._stretches.append((node.name.lower(), []))
                else:
                    self._stretches[-1][1].append(node)
        return self._stretches

    def labels(self) -> dict[str, int]:
        """Map each label to the number of its stretch."""
        if self._labels is None:
            self._labels = {}
            for number, (label, _) in enumerate(self.stretches()):
                self._labels.setdefault(label, number)
        return self._labels

    # ------------------------------------------------------------------------------------------- errors

    def problem(self, code: str, message: str, node: nodes.Node, hint: str = "") -> None:
        self.whole.problems.add(code, message, node.start, hint)

    def warn(self, code: str, message: str, node: nodes.Node, hint: str = "") -> None:
        self.whole.problems.add(code, message, node.start, hint, "warning")

    # ---------------------------------------------------------------------------------------- variables

    def use_outside(self, symbol: Symbol) -> None:
        """Record an assignment to a variable outside the function or its dispatcher."""
        if self.function.jumps or not self.is_local(symbol):
            self.outside.add(symbol.python)

    def is_local(self, symbol: Symbol) -> bool:
        """True if a variable lives in this Python function.

        Shared variables are local only in subs, because a sub may call itself.
        """
        function = self.function
        if symbol.home is not function:
            return False
        return function.kind == "sub" or not (symbol.shared or (self.whole.typed and function.kind == "main"))

    def range_of(self, symbol: Symbol, node: nodes.Node) -> intervals.Range:
        """Return the range of a variable where `node` reads it."""
        fact = self.facts.get(id(node))
        if fact is not None:
            return fact
        if symbol.type.name == INTEGER:
            return intervals.INTEGER
        return intervals.ANY if symbol in self.analysed else intervals.FLOAT


def _calls_first(text: str) -> bool:
    """True if a line evaluates nothing before its only call of a sub that may wait."""
    before, _, after = text.partition(CALL)
    words = before.rpartition(" = ")[2].replace("(", " ").split()
    return CALL not in after and all(each in _WORKS_NOTHING_OUT for each in words)

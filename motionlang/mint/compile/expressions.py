"""Compile an expression node to a `Value`, with the run-time checks it needs."""

from __future__ import annotations

from collections.abc import Callable
from math import inf

from motionlang.errors import count_of
from motionlang.mint.compile import intervals, operators
from motionlang.mint.compile.body import Answer, Body, Reading, Value
from motionlang.mint.compile.conversions import NOTHING, article, as_integer, converted, literal
from motionlang.mint.resolve.folding import binary as fold_binary
from motionlang.mint.resolve.folding import unary as fold_unary
from motionlang.mint.resolve.symbols import (
    FLOAT,
    INTEGER,
    NUMERIC,
    RECORD,
    SEMAPHORE,
    STRING,
    TIME,
    Symbol,
    Type,
)
from motionlang.mint.runtime.code_units import given_name
from motionlang.mint.syntax import nodes
from motionlang.mint.syntax.nesting import LINKS

_SAME = frozenset((INTEGER, FLOAT, STRING))
# Integers that have been written, up to a maximum number.
_SEEN: dict[float, Value] = {}
MAX_SEEN = 20_000


def value(b: Body, node: nodes.Expr) -> Value:
    """Return the value of any expression; report an error and return a harmless value."""
    return _VALUES[node.__class__](b, node)


def number(b: Body, node: nodes.Expr, what: str = "a number") -> Value:
    """Return the value of an expression that must be a number."""
    found = _VALUES[node.__class__](b, node)
    if found.type not in NUMERIC:
        b.problem("type", f"{what} is needed here, not {article(found.type)}", node)
        return NOTHING
    return found


def condition(b: Body, node: nodes.Expr) -> str:
    """Return the text of a condition; only its truth value counts.

    The text needs brackets next to another operator.
    """
    if type(node) is nodes.Binary and node.op in ("And", "Or"):
        return f"{_operand(b, node.left, node.op)} {node.op.lower()} {_operand(b, node.right, node.op)}"
    if type(node) is nodes.Unary and node.op == "Not":
        return f"not {_operand(b, node.operand, node.op)}"
    return number(b, node, "a condition").truth


def _operand(b: Body, node: nodes.Expr, op: str) -> str:
    """Return the text of an operand of And, Or or Not, in brackets if necessary."""
    if type(node) is nodes.Binary and node.op in ("And", "Or"):
        text = condition(b, node)
        return text if node.op == op else f"({text})"
    if type(node) is nodes.Unary and node.op == "Not":
        return condition(b, node)
    found = number(b, node, "a condition")
    return f"({found.truth})" if isinstance(found, Answer) and found.joined else found.truth


# ------------------------------------------------------------------------------------------------- literals


def _given(b: Body, node: nodes.Given) -> Value:
    """Return a global name whose value is set when the program starts.

    The value is a Python float or a string.
    """
    text = given_name(node.name)
    return Value(text, STRING, intervals.ANY) if node.is_text else Value(text, FLOAT, intervals.FLOAT)


def _number(b: Body, node: nodes.Number) -> Value:
    known = node.value
    if known.__class__ is float and 0 <= known < inf:
        return Value(repr(known), FLOAT, intervals.FLOAT, known)
    found = _SEEN.get(known)
    if found is not None and found.const.__class__ is known.__class__:
        return found
    if known.__class__ is int and 0 <= known <= intervals.INT_HIGH:
        found = Value(repr(known), INTEGER, (known, known, "i"), known)
        if len(_SEEN) < MAX_SEEN:
            _SEEN[known] = found
        return found
    if known in (inf, -inf):
        b.problem("overflow", "the number is too large", node)
        return NOTHING
    if (
        intervals.INT_HIGH < known < 1 << 32
        and type(known) is int
        and b.whole.problems.is_pattern(node.start)
    ):
        known -= 1 << 32  # a 32-bit pattern is an Integer, even if its highest bit is set
    return literal(known)


def _string(b: Body, node: nodes.String) -> Value:
    return literal(node.value)


def _cast(b: Body, node: nodes.Cast) -> Value:
    text = converted(b, value(b, node.value), node.to, node)
    known = {INTEGER: intervals.INTEGER, FLOAT: intervals.FLOAT}.get(node.to.name, intervals.ANY)
    return Value(text, node.to.name, known)


# ---------------------------------------------------------------------------------------------------- names


def _name(b: Body, node: nodes.Name) -> Value:
    if node.args is None:
        found = b.values.get(node.name)
        if found is not None:
            b.names.append(found.text)
            return found
    symbol, row = node.symbol, node.row
    result = b.function.result
    if result is not None and node.args is None and result.name.lower() == node.name.lower():
        return load(b, node, result)  # inside a function, its name without brackets is the result so far
    if symbol is not None:
        if symbol.kind == "const" and node.args is None:
            assert symbol.const is not None
            return literal(symbol.const)
        if symbol.kind == "define" and node.args is None:
            return NOTHING if node.definition is None else value(b, node.definition)
        if symbol.kind == "sub":
            from motionlang.mint.compile.calls import call

            return call(b, node, symbol, wanted=True)
        if symbol.kind in ("variable", "parameter"):
            return _remembered(b, node, symbol)
        b.problem("type", f"{symbol.name} is a {symbol.kind} and has no value", node)
        return NOTHING
    if row is None:
        unknown(b, node)
        return NOTHING
    from motionlang.mint.compile.words import read

    return read(b, node, row)


def _remembered(b: Body, node: nodes.Name, symbol: Symbol) -> Value:
    """Return the value of a variable, cached if its text is the same at each read."""
    found = load(b, node, symbol)
    if found.text == symbol.python and symbol.type.name in _SAME and symbol not in b.analysed:
        b.values[node.name] = found
    return found


def unknown(b: Body, node: nodes.Name) -> None:
    """Report a word that is no variable: a keyword, or neither declared nor a keyword."""
    if node.row is not None:
        b.problem("type", f"a variable is needed here, and {node.row.name} is a keyword", node)
        return
    is_constant = node.name.startswith("_")

    def words() -> list[str]:
        symbols = [symbol.name for symbol in b.scope.symbols()]
        rows = [row.name for row in b.whole.table if row.kind not in ("statement", "command")]
        return [word for word in (*symbols, *rows) if word.startswith("_") or not is_constant]

    otherwise = (
        "" if node.args is not None else "a variable must be declared or assigned to before it is read"
    )
    if is_constant:
        otherwise = (
            f"if the controller has this constant, declare its value: Const {node.name} As Integer = …"
        )
    b.whole.problems.unknown(
        f"{node.name} is unknown", node.name, words, node.start, otherwise, b.whole.table
    )


def reference(b: Body, node: nodes.Name | nodes.Member) -> tuple[str, Type, Symbol | None]:
    """Return the location of a variable, element or member.

    It is Python text that can be read and assigned to.
    """
    if type(node) is nodes.Member:
        return _member_reference(b, node)
    assert type(node) is nodes.Name
    symbol = node.symbol
    assert symbol is not None
    if not symbol.is_array:
        if node.args is not None:
            b.problem("type", f"{symbol.name} is not an array", node)
        text = b.spelt(symbol)
        if symbol.by_ref:
            text = f"{text}[{text}_k]"
        elif symbol.boxed:
            text = f"{text}[0]"
        return text, symbol.type, symbol
    return element(b, node, b.spelt(symbol), symbol.name, symbol.dimensions, node.args), symbol.type, None


def element(
    b: Body, node: nodes.Node, text: str, name: str, sizes: tuple[int, ...], args: list[nodes.Expr] | None
) -> str:
    """Return the text of an array element, with checks of uncertain subscripts.

    A subscript is uncertain if it may be out of range.
    """
    if args is None:
        b.problem("index", f"{name} is an array and needs a subscript", node)
        return f"{text}[1]"
    if len(args) != len(sizes):
        given = f"{len(args)} {'is' if len(args) == 1 else 'are'} given"
        b.problem("index", f"{name} has {count_of(len(sizes), 'subscript')}, {given}", node)
        return f"{text}[1]"
    counts = counted(text, sizes)
    subscripts = [_subscript(b, *each) for each in zip(args, sizes, counts, strict=True)]
    flat = subscripts[0]
    for subscript, count in zip(subscripts[1:], counts[1:], strict=True):
        flat = f"({flat} - 1) * {count} + {subscript}"
    return f"{text}[{flat}]"


def counted(text: str, sizes: tuple[int, ...]) -> list[str]:
    """Return Python texts for the sizes of an array.

    The sizes of an array parameter are known only when the sub is called.
    """
    if sizes == (0,):
        return [f"len({text}) - 1"]
    return [str(size) if size else f"{text}_N{index}" for index, size in enumerate(sizes)]


def _subscript(b: Body, node: nodes.Expr, size: int, count: str) -> str:
    found = number(b, node, "a subscript")
    if found.const is not None and size:
        if not 1 <= found.const <= size:  # type: ignore[operator]
            b.problem("index", f"there is no element {found.const}: the subscript must be 1 to {size}", node,
                      "the first element of an array has the subscript 1")  # fmt: skip
        return as_integer(b, found)
    low, high, kind = found.range
    if kind == "i" and size and low >= 1 and high <= size:
        return found.text
    return f"{b.whole.use('fn', 'subscript')}({found.bare}, {count})"


def load(b: Body, node: nodes.Name, symbol: Symbol) -> Value:
    """Return the value of a variable or an element."""
    if symbol.is_array and node.args is None:
        b.problem("index", f"{symbol.name} is an array and needs a subscript", node)
        return NOTHING
    text, type, scalar = (
        reference(b, node) if symbol is not b.function.result else (b.spelt(symbol), symbol.type, symbol)
    )
    return _loaded(b, text, type, b.range_of(scalar, node) if scalar is not None else None)


def _loaded(b: Body, text: str, type: Type, known: intervals.Range | None) -> Value:
    if type.name == TIME:
        b.observes = True
        operation = b.whole.use("env", "elapsed")
        found = Reading(f"{operation}({text})", INTEGER, intervals.INTEGER)
        found.solved = lambda level: f"{operation}({text}, {level})"
        return found
    if type.name == SEMAPHORE:
        return Answer(f"{text}[0] is not None")
    if known is None:
        known = intervals.INTEGER if type.name == INTEGER else intervals.FLOAT
    return Value(text, str(type) if type.name == RECORD else type.name, known)


def _member(b: Body, node: nodes.Member) -> Value:
    text, type, _ = _member_reference(b, node)
    return _loaded(b, text, type, None)


def _member_reference(b: Body, node: nodes.Member) -> tuple[str, Type, Symbol | None]:
    found = member(b, node)
    if found is None:
        return "[0][0]", Type(FLOAT), None
    text, type_, sizes = found
    if sizes:
        text = element(b, node, text, node.field, sizes, node.args)
    elif node.args is not None:
        b.problem("type", f"{node.field} is not an array", node)
    return text, type_, None


def member(b: Body, node: nodes.Member) -> tuple[str, Type, tuple[int, ...]] | None:
    """Return text, type and sizes of a member as a whole; report an error."""
    if type(node.value) is nodes.Name and node.value.symbol is None:
        if node.value.args is None and node.value.row is not None:
            b.problem("syntax", f"{node.value.name} needs a number after the dot, not a name", node,
                      f"write {node.value.name}[{node.field}]")  # fmt: skip
        else:
            unknown(b, node.value)
        return None
    if type(node.value) not in (nodes.Name, nodes.Member):
        b.problem("type", "only a variable has members", node)
        return None
    owner, kind, _ = reference(b, node.value)  # type: ignore[arg-type]
    if kind.record is None:
        b.problem(
            "type", f"{article(str(kind))} has no members", node, "declare the variable with a Type of yours"
        )
        return None
    found = kind.record.members.get(node.field.lower())
    if found is None:
        b.whole.problems.unknown(f"{kind.record.name} has no member {node.field}", node.field,
                                 kind.record.members.keys, node.start)  # fmt: skip
        return None
    position, type_, sizes = found
    return f"{owner}[{position}]", type_, sizes


# ------------------------------------------------------------------------------------------------ operators


def _unary(b: Body, node: nodes.Unary) -> Value:
    if node.op == "Not":
        return Answer(condition(b, node))
    found = number(b, node.operand)
    if found.const is not None:
        known = fold_unary(node.op, found.const)
        if known is not None:
            return literal(known)
    if node.op == "+":
        return found
    if node.op == "~":
        return Value(f"(~{as_integer(b, found)})", INTEGER, intervals.INTEGER)
    if found.type == FLOAT:
        low, high, kind = found.range
        return Value(f"(-{found.text})", FLOAT, (-high, -low, kind))
    return operators.arithmetic(b, "-", literal(0), found)


def _binary(b: Body, node: nodes.Binary) -> Value:
    op = node.op
    if op in operators.COMPARISONS:
        return _comparison(b, node)
    if op == "And" or op == "Or":  # noqa: PLR1714 - quicker
        return Answer(condition(b, node), True)
    left_node, right_node = node.left, node.right
    left, right = _VALUES[left_node.__class__](b, left_node), _VALUES[right_node.__class__](b, right_node)
    if left.type in NUMERIC and right.type in NUMERIC and (left.const is None or right.const is None):
        if op not in operators.ARITHMETIC:
            return operators.operate(b, op, left, right)
        if op != "*" and (left.solved is None) is not (right.solved is None) and not b.calls:
            return _shifted(b, op, left, right)
        return operators.arithmetic(b, op, left, right)
    return _known(b, node, left, right)


def _shifted(b: Body, op: str, left: Value, right: Value) -> Value:
    """Return a reading plus or minus a value, or a value minus a reading.

    A comparison of the result with a level becomes one of the reading with the shifted level. A value that
    changes by itself adds a dependency of its own.
    """
    plain = operators.arithmetic(b, op, left, right)
    reading, other = (left, right) if left.solved is not None else (right, left)
    solved, unsigned = reading.solved, reading.unsigned
    assert solved is not None

    def with_level(read_at: Callable[[str], str], level: Callable[[str], str]) -> str:
        again = first = other.text
        if other.const is None and not first.isidentifier():
            again = b.temp()
            first = f"({again} := {first})"
        if reading is left:  # the level is evaluated before the value to the right
            read = Value(read_at(level(first)), reading.type, reading.range)
            return operators.arithmetic(b, op, read, Value(again, right.type, right.range, right.const)).text
        read = Value(read_at(level(again)), reading.type, reading.range)
        return operators.arithmetic(b, op, Value(first, left.type, left.range, left.const), read).text

    # The level of the reading, from that of the sum and the value.
    inverse = ("{0} - {1}" if op == "+" else "{0} + {1}" if reading is left else "{1} - ({0})").format
    shifted = Reading(plain.text, plain.type, plain.range)
    shifted.binds = plain.binds
    shifted.solved = lambda level: with_level(solved, lambda value: inverse(level, value))
    if unsigned is not None:
        shifted.unsigned = lambda distance, centre: with_level(
            lambda middle: unsigned(distance, middle), lambda value: inverse(centre, value)
        )
    return shifted


class _Done(nodes.Node):
    """The operations at the start of a chain that are already compiled."""

    __slots__ = ("value",)

    def __init__(self, node: nodes.Node, value: Value) -> None:
        self.start, self.end, self.value = node.start, node.end, value


def _done(b: Body, node: _Done) -> Value:
    return node.value


def _nested(first: nodes.Expr, links: list[nodes.Link]) -> nodes.Expr:
    """Return some operations of a chain as nested nodes, as the grammar defines them."""
    for link in links:
        first = nodes.Binary(first.start, first.end, link.op, first, link.value)
    return first


def _chain(b: Body, node: nodes.Chain) -> Value:
    """Compile a long chain of operators in groups, each assigned to a variable.

    A single expression would exceed Python's limit on nesting.
    """
    steps: list[str] = []
    first: nodes.Expr = node.first
    for begin in range(0, len(node.links), LINKS):
        found = value(b, _nested(first, node.links[begin : begin + LINKS]))
        if begin + LINKS >= len(node.links):
            break
        if found.const is None:
            name = b.temp()
            steps.append(f"({name} := {found.truth if isinstance(found, Answer) else found.text})")
            found = Answer(name) if isinstance(found, Answer) else Value(name, found.type, found.range)
        first = _Done(node, found)  # type: ignore[assignment]
    if not steps:
        return found
    if isinstance(found, Answer):
        return Answer(f"({', '.join([*steps, found.truth])})[-1]")
    return Value(f"({', '.join([*steps, found.text])})[-1]", found.type, found.range)


def _comparison(b: Body, node: nodes.Binary) -> Value:
    called, b.calls = b.calls, False
    left, right = value(b, node.left), value(b, node.right)
    calls, b.calls = b.calls, b.calls or called
    if not (left.is_number and right.is_number) or (left.const is not None and right.const is not None):
        return _known(b, node, left, right)
    if not calls:  # an operand that calls a sub remains before or after the reading
        if left.solved is not None and right.solved is None:
            left, right = _compared(b, left, right)
        elif right.solved is not None and left.solved is None:
            right, left = _compared(b, right, left, level_first=True)
    return operators.operate(b, node.op, left, right)


def _known(b: Body, node: nodes.Binary, left: Value, right: Value) -> Value:
    """Evaluate an operation on known values, or compile one on non-numeric operands."""
    op = node.op
    if not (left.is_number and right.is_number):
        return _other_than_numbers(b, node, left, right)
    assert left.const is not None
    assert right.const is not None
    known = fold_binary(op, left.const, right.const)
    if known is not None:
        return literal(known)
    if op in ("/", "\\", "Mod") and right.const == 0:
        b.problem("division-by-zero", "division by zero", node, "the divisor is 0 whatever the program does")
        return NOTHING
    return (operators.arithmetic if op in operators.ARITHMETIC else operators.operate)(b, op, left, right)


def _compared(b: Body, reading: Value, level: Value, level_first: bool = False) -> tuple[Value, Value]:
    """Return a reading to which the compared level is passed, and the level.

    The level is evaluated only once.
    """
    assert reading.solved is not None
    given = text = level.text
    if level.const is None and not text.isidentifier():
        name = b.temp()
        worked_out = f"({name} := {text})"
        given, text = (name, worked_out) if level_first else (worked_out, name)
    solved = Value(reading.solved(given), reading.type, reading.range)
    return solved, Value(text, level.type, level.range, level.const)


def _other_than_numbers(b: Body, node: nodes.Binary, left: Value, right: Value) -> Value:
    if STRING in (left.type, right.type):
        return operators.text(b, node, left, right)
    side, found = (node.right, right) if left.is_number else (node.left, left)
    b.problem("type", f"{node.op} needs numbers, not {article(found.type)}", side)
    return NOTHING


def _omitted(b: Body, node: nodes.Omitted) -> Value:
    hint = "only a list of values for single axes may leave one out: SPEED(0, 1) = , 20"
    b.problem("values", "a value is missing here", node, hint)
    return NOTHING


_VALUES: dict[type, Callable[..., Value]] = {
    nodes.Omitted: _omitted,
    nodes.Given: _given,
    nodes.Cast: _cast,
    nodes.Number: _number,
    nodes.String: _string,
    nodes.Name: _name,
    nodes.Member: _member,
    nodes.Unary: _unary,
    nodes.Binary: _binary,
    nodes.Chain: _chain,
    _Done: _done,
}

"""Expressions: from a node to the `Value` that works it out.

A function of the program is called by steps and not in the middle of an expression, so every call can wait, be shown
and be stored. Its steps are written first, and what was worked out before the call waits in the list of the caller.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator
from functools import partial
from math import inf
from typing import TYPE_CHECKING, Any

from motionlang.kernel.lang.steps import BRANCH, DO, Values, own
from motionlang.kernel.lang.variable_uses import Span
from motionlang.kernel.mint.check.counting import check_subscript
from motionlang.kernel.mint.check.unknown_words import unknown_name
from motionlang.kernel.mint.resolve.folding import binary as fold_binary
from motionlang.kernel.mint.resolve.folding import unary as fold_unary
from motionlang.kernel.mint.resolve.symbols import (
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
from motionlang.kernel.mint.runtime import functions
from motionlang.kernel.mint.runtime.functions import INT_HIGH, MAX_TEXT
from motionlang.kernel.mint.steps import calls, words
from motionlang.kernel.mint.steps.places import is_shared, subscript
from motionlang.kernel.mint.steps.values import (
    ARITHMETIC,
    COMPARISONS,
    NOTHING,
    Get,
    Value,
    answer,
    article,
    as_float,
    as_integer,
    combined,
    literal,
    negated,
    typed,
)
from motionlang.kernel.mint.syntax import nodes
from motionlang.kernel.mint.syntax.nesting import LINKS
from motionlang.kernel.mint.syntax.traversal import meant, walk
from motionlang.kernel.tools import count_of

if TYPE_CHECKING:
    from motionlang.kernel.mint.steps.unit import UnitWriter


_LOGIC = frozenset(("And", "Or"))


def value(w: UnitWriter, node: nodes.Expr) -> Value:
    """Return a value that may be used in any way."""
    found = linear(w, node)
    w.nonlinear |= found.sum_of
    return found


def linear(w: UnitWriter, node: nodes.Expr) -> Value:
    """Return a value that is only added, compared or stored; a check annotates its node."""
    if node.const is not None:
        return literal(node.const)
    found = _VALUES[type(node)](w, node)
    if w.checks:
        node.type, node.const = found.type, found.const
    return found


def condition(w: UnitWriter, node: nodes.Expr) -> Get:
    """Return the function for the truth of a condition."""
    return _truth(w, as_number(w, value(w, node), node, "a condition"))


def _truth(w: UnitWriter, found: Value) -> Get:
    """Return the function for the truth of a value; a debug build reports that of a number."""
    tested = w.program.tested
    if tested is None or found.truth is not None:
        return found.holds
    get = found.get

    def holds(values: Values) -> Any:
        number = get(values)
        tested(number)
        return number

    return holds


def number(w: UnitWriter, node: nodes.Expr, what: str = "a number") -> Value:
    """Return a value that must be a number."""
    return as_number(w, value(w, node), node, what)


def as_number(w: UnitWriter, found: Value, node: nodes.Node, what: str = "a number") -> Value:
    """Return a value that must be a number; report one that is none."""
    if found.type in NUMERIC:
        return found
    w.error("type", f"{what} is needed here, not {article(found.type)}", node)
    return NOTHING


def values(w: UnitWriter, given: Iterable[nodes.Expr], work_out: Callable[..., Value] = value) -> list[Value]:
    """Return several values in the order of the text; one in front of a call is worked out before it."""
    found, given = [], list(given)
    for index, node in enumerate(given):
        one = work_out(w, node)
        if one.const is None and any(w.has_steps(each) for each in given[index + 1 :]):
            one = stored(w, one)
        found.append(one)
    return found


def assigned(w: UnitWriter, found: Value, kind: Type, node: nodes.Node) -> Get:
    """Return the function for a value as one of a variable's type; a check reports one that cannot be that."""
    if not w.checks or found is NOTHING:
        return converted(w, found, kind)
    is_text = found.type == STRING
    if is_text if kind.name == STRING else kind.name in NUMERIC and found.is_number:
        return converted(w, found, kind)
    hint = ""
    if kind.name == STRING and found.is_number:
        hint = "convert the number with Str"
    elif is_text:
        hint = "convert the text with Val"
    w.error("type", f"cannot assign {article(found.type)} to {article(str(kind))}", node, hint)
    return NOTHING.get


def converted(w: UnitWriter, found: Value, kind: Type) -> Get:
    """Return the function for a value as one of a variable's type."""
    if kind.name == FLOAT:
        return as_float(found)
    if kind.name != found.type:
        w.nonlinear |= found.sum_of
    get = found.get
    if kind.name == INTEGER:
        return as_integer(found)
    if kind.name == STRING:
        size = MAX_TEXT if kind.size is None else kind.size
        if isinstance(found.const, str) and len(found.const) <= size:
            return get
        return lambda values: functions.fit(get(values), size)
    if kind.name == TIME:
        since = w.program.environment.since
        return lambda values: since(get(values))
    return get


def stored(w: UnitWriter, found: Value) -> Value:
    """Write a step that keeps a value for later steps of the statement."""
    if w.checks:
        return found
    index, get = w.new_index(), found.get

    def store(values: Values) -> None:
        values[index] = get(values)

    w.nonlinear |= found.sum_of
    w.add(DO, store, sets=own(index))
    return kept(w, index, found.type)


def kept(w: UnitWriter, index: int, kind: str) -> Value:
    """Return the value that an earlier step has stored."""
    w.reads.add(own(index))
    return Value(lambda values: values[index], kind)


def parts(node: object) -> Iterator[nodes.Node]:
    """Yield a node and every node below it, in Defines, too."""
    for each in walk([node]):
        yield each
        if isinstance(each, nodes.Name) and each.definition is not None:
            yield from parts(each.definition)


def is_word(node: nodes.Expr) -> bool:
    """True if an expression is a word of the language without arguments."""
    return isinstance(node, nodes.Name) and node.symbol is None and not node.args


# ------------------------------------------------------------------------------------------------------- names


def _name(w: UnitWriter, node: nodes.Name) -> Value:
    symbol, result = node.symbol, w.function.result_named(node)
    if result is not None:
        return _variable(w, node, result)  # inside a function, its name without brackets is the result so far
    if symbol is None:
        if node.row is not None:
            return words.read(w, node, node.row)
        unknown_name(w, node)
        return NOTHING
    if symbol.kind == "const" and node.args is None:
        assert symbol.const is not None
        return literal(symbol.const)
    if symbol.kind == "define" and node.args is None:
        return NOTHING if node.definition is None else linear(w, node.definition)
    if symbol.kind == "sub":
        return calls.call(w, node, symbol, wanted=True)
    if symbol.kind not in ("variable", "parameter"):
        w.error("type", f"{symbol.name} is a {symbol.kind} and has no value", node)
    elif symbol.is_array and node.args is None:
        w.error("index", f"{symbol.name} is an array and needs a subscript", node)
    else:
        return _variable(w, node, symbol)
    return NOTHING


def _variable(w: UnitWriter, node: nodes.Name, symbol: Symbol) -> Value:
    is_plain = not (symbol.is_array or symbol.by_ref or symbol.boxed)
    if not is_plain or node.args is not None or symbol.type.name in (TIME, SEMAPHORE):
        return _loaded(w, *place(w, node, symbol))
    number = w.program.places.number(symbol)
    w.reads.add(number)
    w.spans.discard(number)
    kind = str(symbol.type) if symbol.type.name == RECORD else symbol.type.name
    return Value(whole(w, symbol), kind, sum_of=frozenset((number,)))


def whole(w: UnitWriter, symbol: Symbol) -> Get:
    """Return the function for the content of a variable or of an array."""
    places = w.program.places
    index, shared = places.index(symbol), places.shared
    w.reads.add(places.number(symbol))
    return (lambda values: shared[index]) if is_shared(symbol) else (lambda values: values[index])


def target(w: UnitWriter, node: nodes.Name | nodes.Member) -> tuple[Get, Get, Type]:
    """Return the place that a statement gives a value, which it does not read."""
    if w.checks:
        return place(w, node)
    reads = set(w.reads)
    found = place(w, node)
    if plain_variable(w, node) is not None:
        w.reads = reads
        return found
    while isinstance(node, nodes.Member):
        node = node.value  # type: ignore[assignment]
    w.parts.add(w.program.places.number(w.symbol(node)))
    return found


def place(
    w: UnitWriter, node: nodes.Name | nodes.Member, symbol: Symbol | None = None
) -> tuple[Get, Get, Type]:
    """Return where a variable, an element or a member is, and its type, with which its node is annotated."""
    if isinstance(node, nodes.Member):
        return _member_place(w, node)
    symbol = symbol or w.function.result_named(node) or node.symbol
    assert symbol is not None
    if w.checks:
        node.type = str(symbol.type)
    if symbol.is_array:
        array = whole(w, symbol)
        return array, _element(w, node, symbol.name, symbol, array), symbol.type
    if node.args is not None:
        w.error("type", f"{symbol.name} is not an array", node)
    places = w.program.places
    index, shared = places.index(symbol), places.shared
    w.reads.add(places.number(symbol))
    if symbol.by_ref:
        w.is_known = False
        return (lambda values: values[index][0]), (lambda values: values[index][1]), symbol.type
    if symbol.boxed:
        return whole(w, symbol), lambda values: 0, symbol.type
    here: Get = (lambda values: shared) if is_shared(symbol) else (lambda values: values)
    return here, lambda values: index, symbol.type


def _element(w: UnitWriter, node: nodes.Name | nodes.Member, name: str, symbol: Symbol, array: Get) -> Get:
    """Return the function for the index of an element; the sizes of an array parameter are 0."""
    args, sizes = node.args, symbol.dimensions
    if args is None:
        w.error("index", f"{name} is an array and needs a subscript", node)
        return NOTHING.get
    if len(args) != len(sizes):
        given = f"{len(args)} {'is' if len(args) == 1 else 'are'} given"
        w.error("index", f"{name} has {count_of(len(sizes), 'subscript')}, {given}", node)
        return NOTHING.get
    found = values(w, args, _subscript)
    for arg, one, size in zip(args, found, sizes, strict=True):
        if one.const is not None:
            check_subscript(w, arg, one.const, size)  # type: ignore[arg-type]
    gets = [each.get for each in found]
    if len(gets) == 1:
        (only,) = gets
        return lambda values: functions.subscript(only(values), len(array(values)) - 1)
    return lambda values: subscript(array(values), [each(values) for each in gets])


def _subscript(w: UnitWriter, node: nodes.Expr) -> Value:
    return number(w, node, "a subscript")


def _member_place(w: UnitWriter, node: nodes.Member) -> tuple[Get, Get, Type]:
    owner, symbol = _owner(w, node)
    kind = Type(FLOAT) if symbol is None else symbol.type
    if w.checks:
        node.type = str(kind)
    if symbol is None:
        return owner, owner, kind
    if symbol.is_array:
        content = _content(owner, symbol)
        return content, _element(w, node, node.field, symbol, content), kind
    if node.args is not None:
        w.error("type", f"{node.field} is not an array", node)
    return owner, lambda values: symbol.index, kind


def member(w: UnitWriter, node: nodes.Member) -> tuple[Get, Symbol | None]:
    """Return the function for the content of a member as a whole, and its symbol; report an error."""
    owner, symbol = _owner(w, node)
    return owner if symbol is None else _content(owner, symbol), symbol


def _content(owner: Get, symbol: Symbol) -> Get:
    position = symbol.index
    return lambda values: owner(values)[position]


def _owner(w: UnitWriter, node: nodes.Member) -> tuple[Get, Symbol | None]:
    """Return the function for the record with a member, and the member; report an error."""
    owner, get = node.value, NOTHING.get
    if type(owner) is nodes.Name and owner.symbol is None:
        if owner.args is None and owner.row is not None:
            w.error("syntax", f"{owner.name} needs a number after the dot, not a name", node,
                    f"write {owner.name}[{node.field}]")  # fmt: skip
        else:
            unknown_name(w, owner)
        return get, None
    if type(owner) is not nodes.Name and type(owner) is not nodes.Member:
        w.error("type", "only a variable has members", node)
        return get, None
    where, which, kind = place(w, owner)
    if kind.record is None:
        hint = "declare the variable with a Type of yours"
        w.error("type", f"{article(str(kind))} has no members", node, hint)
        return get, None
    if node.symbol is None:
        message = f"{kind.record.name} has no member {node.field}"
        w.program.names.diagnostics.unknown(message, node.field, kind.record.members.keys, node.start)
    return (lambda values: where(values)[which(values)]), node.symbol


def _loaded(w: UnitWriter, where: Get, which: Get, kind: Type) -> Value:
    def get(values: Values) -> Any:
        return where(values)[which(values)]

    if kind.name == TIME:
        elapsed = w.program.environment.elapsed
        return Value(
            lambda values: elapsed(get(values)),
            INTEGER,
            solved=lambda values, level: elapsed(get(values), level),
        )
    if kind.name == SEMAPHORE:
        return answer(lambda values: get(values)[0] is not None)
    return Value(get, str(kind) if kind.name == RECORD else kind.name)


def _given(w: UnitWriter, node: nodes.Given) -> Value:
    """Return the value that a run gives a name; the check knows its type only."""
    if w.checks:
        return typed(STRING if node.is_text else FLOAT)
    return literal(w.program.given[node.name.lower()])


def _cast(w: UnitWriter, node: nodes.Cast) -> Value:
    return Value(assigned(w, value(w, node.value), node.to, node), node.to.name)


def _number(w: UnitWriter, node: nodes.Number) -> Value:
    known = node.value
    if known in (inf, -inf):
        w.error("overflow", "the number is too large", node)
        return NOTHING
    if type(known) is int and INT_HIGH < known < 1 << 32 and w.program.names.diagnostics.is_pattern(node):
        known -= 1 << 32  # a 32-bit pattern is an Integer, even if its highest bit is set
    return literal(known)


def _omitted(w: UnitWriter, node: nodes.Omitted) -> Value:
    hint = "only a list of values for single axes may leave one out: SPEED(0, 1) = , 20"
    w.error("values", "a value is missing here", node, hint)
    return NOTHING


# --------------------------------------------------------------------------------------------------- operators


def _unary(w: UnitWriter, node: nodes.Unary) -> Value:
    if node.op == "Not":
        holds = condition(w, node.operand)
        return answer(lambda values: not holds(values))
    found = as_number(w, linear(w, node.operand), node.operand)
    if w.checks and found.const is not None and (known := fold_unary(node.op, found.const)) is not None:
        return literal(known)
    if node.op == "~":
        w.nonlinear |= found.sum_of
        get = as_integer(found)
        return Value(lambda values: ~get(values), INTEGER)
    return found if node.op == "+" else negated(found)


def _binary(w: UnitWriter, node: nodes.Binary) -> Value:
    if node.op in _LOGIC:
        return _either(w, node.op, node.left, linear(w, node.left), node.right)
    number, right = None, meant(node.right)
    is_variable = (
        isinstance(right, nodes.Name) and right.symbol is not None and right.symbol.kind == "variable"
    )
    if node.op == "-" and is_word(node.left) and is_variable and plain_variable(w, right) is not None:
        number = w.program.places.number(w.symbol(right))
    is_read = number in w.reads - w.spans
    one, other = values(w, (node.left, node.right), linear)
    made = _operated(w, node.op, (node.left, one), (node.right, other))
    if number is not None and made.solved is not None:
        if not is_read:
            w.spans.add(number)
        made.solved = w.marking(partial(Span, number), made.solved)
    return made


# An operand: its node and its value.
Side = tuple[nodes.Node, Value]


def _operated(w: UnitWriter, op: str, left: Side, right: Side) -> Value:
    """Return the result of an operation; a check reports operands that it cannot have."""
    (at, one), (_, other) = left, right
    if w.checks:
        if not (one.is_number and other.is_number) and _is_wrong(w, op, left, right):
            return NOTHING
        if one.const is not None and other.const is not None:
            known = fold_binary(op, one.const, other.const)
            if known is not None:
                return literal(known)
            if op in ("/", "\\", "Mod") and other.const == 0:
                hint = "the divisor is 0 whatever the program does"
                w.error("division-by-zero", "division by zero", at, hint)
                return NOTHING
    is_sum = op in ("+", "-") or (op in ARITHMETIC and not (one.sum_of and other.sum_of))
    is_test = op in COMPARISONS and one.solved is None and other.solved is None
    if STRING in (one.type, other.type) or not (is_sum or is_test):
        w.nonlinear |= one.sum_of | other.sum_of
    return combined(op, one, other, w.program.environment.loops.compared, w.program.report)


def _is_wrong(w: UnitWriter, op: str, left: Side, right: Side) -> bool:
    """True if an operation cannot have these operands, of which at least one is no number."""
    (at, one), (_, other) = left, right
    if STRING not in (one.type, other.type):
        side, found = right if one.is_number else left
        w.error("type", f"{op} needs numbers, not {article(found.type)}", side)
    elif one is NOTHING or other is NOTHING:
        pass
    elif one.type != STRING or other.type != STRING:
        hint = "convert the number with Str" if op in ("+", "&") else ""
        w.error("type", f"{op} cannot take {article(one.type)} and {article(other.type)}", at, hint)
    elif op in ("+", "&") or op in COMPARISONS:
        return False
    else:
        w.error("type", f"{op} needs numbers, not texts", at)
    return True


def _either(w: UnitWriter, op: str, at: nodes.Node, left: Value, right: nodes.Expr) -> Value:
    """And and Or leave out the right side if the left one decides."""
    w.nonlinear |= left.sum_of
    first = _truth(w, as_number(w, left, at, "a condition"))
    if not w.has_steps(right):
        second = condition(w, right)
        if op == "And":
            return answer(lambda values: first(values) and second(values))
        return answer(lambda values: first(values) or second(values))
    index = w.new_index()

    def decides(values: Values) -> bool:
        holds = values[index] = bool(first(values))
        return holds is (op == "And")

    skip = w.add(BRANCH, decides, sets=own(index))
    second = condition(w, right)

    def store(values: Values) -> None:
        values[index] = bool(second(values))

    w.add(DO, store, sets=own(index))
    w.here(skip)
    w.reads.add(own(index))
    return answer(lambda values: values[index])


def _chain(w: UnitWriter, node: nodes.Chain) -> Value:
    """Work out a long chain of operations in groups, so that functions do not nest as deeply as it is long."""
    found = linear(w, node.first)
    for number, link in enumerate(node.links, 1):
        if link.op in _LOGIC:
            found = _either(w, link.op, node, found, link.value)
        else:
            if w.has_steps(link.value):
                found = stored(w, found)
            found = _operated(w, link.op, (node, found), (link.value, linear(w, link.value)))
        if w.checks:
            link.type, link.const = found.type, found.const
        if number % LINKS == 0 and number < len(node.links):
            found = stored(w, found)
    return found


_VALUES: dict[type, Callable[..., Value]] = {
    nodes.Given: _given,
    nodes.Cast: _cast,
    nodes.Number: _number,
    nodes.String: lambda w, node: literal(node.value),
    nodes.Name: _name,
    nodes.Member: lambda w, node: _loaded(w, *place(w, node)),
    nodes.Unary: _unary,
    nodes.Binary: _binary,
    nodes.Chain: _chain,
    nodes.Omitted: _omitted,
    nodes.Wrong: lambda w, node: NOTHING,  # the parser has reported it
}


# ------------------------------------------------------------------------------------------------------ storing


def storing(
    w: UnitWriter, target: nodes.Name | nodes.Member, where: Get, which: Get, get: Get
) -> Callable[[Values], None]:
    """Return the function that stores a value at a place.

    A change of an element, a member or a reference counts as an action, because loops do not compare their contents.
    """
    plain = plain_variable(w, target)
    if plain is not None:
        index, shared = w.program.places.index(plain), w.program.places.shared
        if is_shared(plain):

            def store_shared(values: Values) -> None:
                shared[index] = get(values)

            return store_shared

        def store_own(values: Values) -> None:
            values[index] = get(values)

        return store_own
    environment = w.program.environment

    def store(values: Values) -> None:
        new, content, position = get(values), where(values), which(values)
        old = content[position]
        content[position] = new
        if new != old or isinstance(new, int) is not isinstance(old, int):
            environment.acts += 1

    return store


def plain_variable(w: UnitWriter, node: nodes.Expr) -> Symbol | None:
    """Return the variable that a name means if it has a place of its own: no array, member or reference."""
    node = meant(node)
    if not isinstance(node, nodes.Name):
        return None
    symbol = w.symbol(node)
    return None if symbol.is_array or symbol.by_ref or symbol.boxed else symbol

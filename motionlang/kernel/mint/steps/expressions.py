"""Expressions: from a node to the `Value` that works it out.

A function of the program is called by steps and not in the middle of an expression, so every call can wait, be shown
and be stored. Its steps are written first, and what was worked out before the call waits in the list of the caller.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator
from functools import partial
from typing import TYPE_CHECKING, Any

from motionlang.kernel.lang.steps import BRANCH, DO, Values, own
from motionlang.kernel.lang.variable_uses import Span
from motionlang.kernel.mint.check.values import (
    ARITHMETIC,
    COMPARISONS,
    Get,
    Value,
    answer,
    as_float,
    as_integer,
    combined,
    literal,
    negated,
)
from motionlang.kernel.mint.resolve.symbols import (
    FLOAT,
    INTEGER,
    RECORD,
    SEMAPHORE,
    STRING,
    TIME,
    Symbol,
    Type,
)
from motionlang.kernel.mint.runtime import functions
from motionlang.kernel.mint.runtime.functions import MAX_TEXT
from motionlang.kernel.mint.steps import calls, words
from motionlang.kernel.mint.steps.places import is_shared, subscript
from motionlang.kernel.mint.syntax import nodes
from motionlang.kernel.mint.syntax.nesting import LINKS
from motionlang.kernel.mint.syntax.traversal import meant, walk

if TYPE_CHECKING:
    from motionlang.kernel.mint.steps.unit import UnitWriter


def value(w: UnitWriter, node: nodes.Expr) -> Value:
    """Return a value that may be used in any way."""
    found = linear(w, node)
    w.nonlinear |= found.sum_of
    return found


def linear(w: UnitWriter, node: nodes.Expr) -> Value:
    """Return a value that is only added, compared or stored."""
    if node.const is not None:
        return literal(node.const)
    return _VALUES[type(node)](w, node)


def condition(w: UnitWriter, node: nodes.Expr) -> Get:
    """Return the function for the truth of a condition."""
    return _truth(w, value(w, node))


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


def values(w: UnitWriter, given: Iterable[nodes.Expr], work_out: Callable[..., Value] = value) -> list[Value]:
    """Return several values in the order of the text; one in front of a call is worked out before it."""
    found, given = [], list(given)
    for index, node in enumerate(given):
        one = work_out(w, node)
        if one.const is None and any(w.has_steps(each) for each in given[index + 1 :]):
            one = stored(w, one)
        found.append(one)
    return found


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
        assert node.row is not None
        return words.read(w, node, node.row)
    if symbol.kind == "const":
        assert symbol.const is not None
        return literal(symbol.const)
    if symbol.kind == "define":
        assert node.definition is not None
        return linear(w, node.definition)
    if symbol.kind == "sub":
        return calls.call(w, node, symbol)
    return _variable(w, node, symbol)


def _variable(w: UnitWriter, node: nodes.Name, symbol: Symbol) -> Value:
    if symbol.is_array or symbol.by_ref or symbol.boxed or symbol.type.name in (TIME, SEMAPHORE):
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
    """Return where a variable, an element or a member is, and its type."""
    if isinstance(node, nodes.Member):
        return _member_place(w, node)
    symbol = symbol or w.symbol(node)
    if symbol.is_array:
        array = whole(w, symbol)
        return array, _element(w, array, node.args or []), symbol.type
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


def _element(w: UnitWriter, array: Get, args: list[nodes.Expr]) -> Get:
    found = [each.get for each in values(w, args)]
    if len(found) == 1:
        (only,) = found
        return lambda values: functions.subscript(only(values), len(array(values)) - 1)
    return lambda values: subscript(array(values), [each(values) for each in found])


def _member_place(w: UnitWriter, node: nodes.Member) -> tuple[Get, Get, Type]:
    symbol = w.symbol(node)
    if symbol.is_array:
        content = member(w, node)
        return content, _element(w, content, node.args or []), symbol.type
    return _owner(w, node), lambda values: symbol.index, symbol.type


def member(w: UnitWriter, node: nodes.Member) -> Get:
    """Return the function for the content of a member as a whole."""
    owner, position = _owner(w, node), w.symbol(node).index
    return lambda values: owner(values)[position]


def _owner(w: UnitWriter, node: nodes.Member) -> Get:
    where, which, _ = place(w, node.value)  # type: ignore[arg-type]
    return lambda values: where(values)[which(values)]


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
    known = w.program.given[node.name.lower()]
    return literal(known)


def _cast(w: UnitWriter, node: nodes.Cast) -> Value:
    return Value(converted(w, value(w, node.value), node.to), node.to.name)


# --------------------------------------------------------------------------------------------------- operators


def _unary(w: UnitWriter, node: nodes.Unary) -> Value:
    if node.op == "Not":
        holds = condition(w, node.operand)
        return answer(lambda values: not holds(values))
    if node.op == "~":
        get = as_integer(value(w, node.operand))
        return Value(lambda values: ~get(values), INTEGER)
    found = linear(w, node.operand)
    return found if node.op == "+" else negated(found)


def _binary(w: UnitWriter, node: nodes.Binary) -> Value:
    if node.op in ("And", "Or"):
        return _either(w, node.op, linear(w, node.left), node.right)
    number, right = None, meant(node.right)
    is_variable = (
        isinstance(right, nodes.Name) and right.symbol is not None and right.symbol.kind == "variable"
    )
    if node.op == "-" and is_word(node.left) and is_variable and plain_variable(w, right) is not None:
        number = w.program.places.number(w.symbol(right))
    is_read = number in w.reads - w.spans
    made = _of_two(w, node.op, *values(w, (node.left, right), linear))
    if number is not None and made.solved is not None:
        if not is_read:
            w.spans.add(number)
        made.solved = w.marking(partial(Span, number), made.solved)
    return made


def _of_two(w: UnitWriter, op: str, left: Value, right: Value) -> Value:
    is_sum = op in ("+", "-") or (op in ARITHMETIC and not (left.sum_of and right.sum_of))
    is_test = op in COMPARISONS and left.solved is None and right.solved is None
    if STRING in (left.type, right.type) or not (is_sum or is_test):
        w.nonlinear |= left.sum_of | right.sum_of
    return combined(op, left, right, w.program.environment.loops.compared, w.program.report)


def _either(w: UnitWriter, op: str, left: Value, right: nodes.Expr) -> Value:
    """And and Or leave out the right side if the left one decides."""
    w.nonlinear |= left.sum_of
    first = _truth(w, left)
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
        if link.op in ("And", "Or"):
            found = _either(w, link.op, found, link.value)
        else:
            if w.has_steps(link.value):
                found = stored(w, found)
            found = _of_two(w, link.op, found, linear(w, link.value))
        if number % LINKS == 0 and number < len(node.links):
            found = stored(w, found)
    return found


_VALUES: dict[type, Callable[..., Value]] = {
    nodes.Given: _given,
    nodes.Cast: _cast,
    nodes.Number: lambda w, node: literal(node.value),
    nodes.String: lambda w, node: literal(node.value),
    nodes.Name: _name,
    nodes.Member: lambda w, node: _loaded(w, *place(w, node)),
    nodes.Unary: _unary,
    nodes.Binary: _binary,
    nodes.Chain: _chain,
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

"""If, Select, loops, Exit and jumps."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from motionlang.kernel.lang.steps import (
    BACK,
    BRANCH,
    CALL,
    DO,
    END,
    ENDLESS,
    HEAD,
    JUMP,
    NEXT,
    NOTE,
    NOW,
    RETURN,
    TEST,
    UNTIL,
    Steps,
    Values,
    own,
)
from motionlang.kernel.mint.check.values import Get, Value, arithmetic, combined, comparison
from motionlang.kernel.mint.resolve.folding import Known, fold
from motionlang.kernel.mint.steps import expressions
from motionlang.kernel.mint.steps.unit import UnitWriter
from motionlang.kernel.mint.syntax import nodes
from motionlang.kernel.mint.syntax.traversal import is_stop

Block = Callable[[UnitWriter, list[nodes.Stmt]], None]

# ------------------------------------------------------------------------------------------------ If and Select


def if_(w: UnitWriter, node: nodes.If, block: Block) -> None:
    """Write an If with its ElseIfs."""
    ends: list[int] = []
    while True:
        w.at = node.start
        w.settle(node.condition)
        otherwise = w.add(BRANCH, expressions.condition(w, node.condition), cost=1.0, role=TEST)
        block(w, node.body)
        if node.orelse:
            ends.append(w.add(JUMP))
        w.here(otherwise)
        if len(node.orelse) != 1 or type(node.orelse[0]) is not nodes.If:
            break
        node = node.orelse[0]
        w.begins(node.start)
    block(w, node.orelse)
    w.here(*ends)


def select(w: UnitWriter, node: nodes.Select, block: Block) -> None:
    """Write a Select: the subject is worked out once, and the tests in the order of the text."""
    tests = [(each.value, each.high) for case in node.cases for each in case.tests]
    w.settle(node.subject, *[side for both in tests for side in both if side is not None])
    subject = expressions.value(w, node.subject)
    if any(w.has_steps(side) for both in tests for side in both if side is not None):
        subject = expressions.stored(w, subject)
    chosen, first = w.new_index(), subject.get
    found = [[_case_test(w, each, chosen) for each in case.tests] for case in node.cases]

    def choose(values: Values) -> None:
        values[chosen] = first(values)

    reads, nonlinear = set(w.reads), set(w.nonlinear)
    w.add(DO, choose, cost=1.0, sets=own(chosen))
    ends: list[int] = []
    w.around.append(("select", ends))
    for case, holds in zip(node.cases, found, strict=True):
        w.at = case.start
        otherwise = []
        if holds:
            w.reads |= reads | {own(chosen)}
            w.nonlinear |= nonlinear | {own(chosen)}
            otherwise.append(w.add(BRANCH, _any(holds)))
        block(w, case.body)
        ends.append(w.add(JUMP))
        w.here(*otherwise)
        if not holds:
            break
    w.around.pop()
    w.here(*ends)


def _any(tests: list[Get]) -> Get:
    if len(tests) == 1:
        return tests[0]
    return lambda values: any(each(values) for each in tests)


def _case_test(w: UnitWriter, test: nodes.CaseTest, chosen: int) -> Get:
    low = expressions.value(w, test.value).get
    if test.high is not None:
        high, at_least = expressions.value(w, test.high).get, comparison(">=", w.program.report)
        at_most = comparison("<=", w.program.report)
        return lambda values: at_least(values[chosen], low(values)) and at_most(values[chosen], high(values))
    compare = comparison(test.op, w.program.report)
    return lambda values: compare(values[chosen], low(values))


# -------------------------------------------------------------------------------------------------------- loops


def while_(w: UnitWriter, node: nodes.While, block: Block) -> None:
    """Write `While condition … End While`."""
    w.pay()
    noted = _begin(w)
    begin, leaving = len(w.steps), list[int]()
    w.settle(node.condition)
    role = ENDLESS if _constant(node.condition) else TEST
    leaving.append(w.add(BRANCH, expressions.condition(w, node.condition), role=role))
    _body(w, "while", node, leaving, block)
    w.add(BACK, to=begin, cost=1.0)
    _end(w, node, noted, begin, leaving)


def repeat(w: UnitWriter, node: nodes.Repeat, block: Block) -> None:
    """Write `Repeat … Until condition`."""
    noted = _begin(w)
    begin, leaving = len(w.steps), list[int]()
    _body(w, "repeat", node, leaving, block)
    w.at = node.condition.start
    w.settle(node.condition)
    ends = expressions.condition(w, node.condition)
    role = ENDLESS if _constant(node.condition) == 0 else UNTIL
    leaving.append(w.add(BRANCH, lambda values: not ends(values), cost=1.0, role=role))
    w.add(BACK, to=begin)
    _end(w, node, noted, begin, leaving)


def _constant(node: nodes.Expr) -> Known | None:
    is_name = isinstance(node, nodes.Name) and node.symbol is None
    return fold(node) if is_name or isinstance(node, nodes.Number) else None


def loop(w: UnitWriter, node: nodes.Loop, block: Block) -> None:
    """Write `Loop … End Loop`."""
    noted = _begin(w)
    begin, leaving = len(w.steps), list[int]()
    _body(w, "loop", node, leaving, block)
    w.add(BACK, to=begin, cost=1.0)
    _end(w, node, noted, begin, leaving)


def for_(w: UnitWriter, node: nodes.For, block: Block) -> None:
    """Write `For variable = first To stop Step step … Next`; limit and step are worked out once."""
    program = w.program
    where, which, kind = expressions.target(w, node.variable)
    step = node.step if node.step is not None else nodes.Number(node.start, node.end, 1)
    w.settle(node.first, node.stop, step)
    first, stop, by = expressions.values(w, [node.first, node.stop, step], expressions.linear)
    begins = expressions.converted(w, first, kind)
    stop, by = (each if each.const is not None else _kept(w, each) for each in (stop, by))
    plain = expressions.plain_variable(w, node.variable)
    sets = None if plain is None else program.places.number(plain)
    w.add(DO, expressions.storing(w, node.variable, where, which, begins), cost=1.0, sets=sets)
    noted = _begin(w)
    begin, leaving = len(w.steps), list[int]()
    leaving.append(w.add(BRANCH, _goes_on(w, node, stop, by), role=HEAD))
    _body(w, "for", node, leaving, block)
    counter = expressions.linear(w, node.variable)
    w.reads |= by.sum_of
    counts = expressions.converted(w, arithmetic("+", counter, by), kind)
    w.add(DO, expressions.storing(w, node.variable, where, which, counts), cost=1.0, sets=sets, role=NEXT)
    w.add(BACK, to=begin)
    _end(w, node, noted, begin, leaving)


def _kept(w: UnitWriter, found: Value) -> Value:
    """Keep the limit or the step of a For, which may count."""
    index, get = w.new_index(), found.get

    def store(values: Values) -> None:
        values[index] = get(values)

    w.add(DO, store, sets=own(index))
    return Value(lambda values: values[index], found.type, sum_of=frozenset((own(index),)))


def _goes_on(w: UnitWriter, node: nodes.For, stop: Value, by: Value) -> Get:
    counter, compare = expressions.linear(w, node.variable), w.program.environment.loops.compared
    w.reads |= stop.sum_of | by.sum_of
    up, down = (combined(op, counter, stop, compare).holds for op in ("<=", ">="))
    if isinstance(by.const, (int, float)):
        return up if by.const >= 0 else down
    step = by.get
    return lambda values: up(values) if step(values) >= 0 else down(values)


def _body(w: UnitWriter, kind: str, node: Any, leaving: list[int], block: Block) -> None:
    at = w.at
    if not any(map(is_stop, node.body)):
        w.begins(at)  # so that a debugger can stop the loop
    w.around.append((kind, leaving))
    block(w, node.body)
    w.around.pop()
    w.at = at


def _begin(w: UnitWriter) -> int:
    return w.add(NOTE)


def _end(w: UnitWriter, node: Any, noted: int, first: int, leaving: list[int]) -> None:
    last, at, environment = len(w.steps) - 1, w.steps[noted].at, w.program.environment
    w.steps.loops[last] = node
    w.steps[noted] = w.steps[noted]._replace(
        do=lambda values: environment.task.loop_log.begin(at, first, last)
    )
    w.here(*leaving)
    w.at = at
    w.add(NOTE, lambda values: environment.task.loop_log.passed())


# ----------------------------------------------------------------------------------------------- Exit and jumps


def exit_(w: UnitWriter, node: nodes.Exit) -> None:
    """Write `Exit` and `Exit For …`: leave the innermost loop, or the innermost block of a kind."""
    if node.kind in ("sub", "function", "task", "event"):
        _go_back(w) if w.function.kind == "sub" else w.add(END)
        return
    kinds = [
        (kind, jumps) for kind, jumps in w.around if node.kind == kind or (not node.kind and kind != "select")
    ]
    kinds[-1][1].append(w.add(JUMP))


def _go_back(w: UnitWriter) -> None:
    result = w.function.result
    index = None if result is None else w.program.places.index(result)
    w.add(RETURN, None if index is None else lambda values: values[index])


def return_(w: UnitWriter, node: nodes.Return) -> None:
    """Write `Return` from a Gosub, an event or a sub."""
    if w.function.jumps:
        w.pay()
    _go_back(w)


def label(w: UnitWriter, node: nodes.Label) -> None:
    """Write a label; the loop of a jump back to it begins here."""
    name = node.name.lower()
    w.label = name
    w.labels[name] = len(w.steps)
    w.steps.labels[len(w.steps)] = node.name
    region = w.regions.get(name)
    if region is not None:
        at, environment = node.start, w.program.environment
        region.first = w.add(
            NOTE, lambda values: environment.task.loop_log.begin_once(at, region.first, region.last)
        )


def jump(w: UnitWriter, node: nodes.Jump) -> None:
    """Write a Goto or a Gosub."""
    name = node.name.lower()
    if node.kind == "gosub":
        w.pay()
        w.add(NOW)
        w.jumps.append((w.add(CALL, _gosub(w)), name))
    else:
        w.jumps.append((w.add(BACK, cost=1.0), name))


def _gosub(w: UnitWriter) -> Callable[[Values], tuple[Steps, Values]]:
    steps = w.steps
    return lambda values: (steps, values)

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
from motionlang.kernel.mint.check.counting import check_elements, check_step
from motionlang.kernel.mint.check.unknown_words import another_name, label_hint
from motionlang.kernel.mint.keywords.event_kinds import label_event
from motionlang.kernel.mint.resolve.folding import Known, fold
from motionlang.kernel.mint.resolve.symbols import NUMERIC, STRING
from motionlang.kernel.mint.steps import expressions
from motionlang.kernel.mint.steps.unit import UnitWriter
from motionlang.kernel.mint.steps.values import NOTHING, Get, Value, arithmetic, article, combined, comparison
from motionlang.kernel.mint.syntax import nodes
from motionlang.kernel.mint.syntax.traversal import is_stop

Block = Callable[[UnitWriter, list[nodes.Stmt]], None]

# ------------------------------------------------------------------------------------------------ If and Select


def if_(w: UnitWriter, node: nodes.If, block: Block) -> None:
    """Write an If with its ElseIfs."""
    ends: list[int] = []
    while True:
        if w.checks:
            _warn_of_else_if(w, node.orelse)
        w.at = node.start
        w.settle(node.condition)
        otherwise = w.add(BRANCH, expressions.condition(w, node.condition), cost=1.0, role=TEST)
        block(w, node.body)
        if node.orelse:
            ends.append(w.add(JUMP))
        w.here(otherwise)
        if (chained := _else_if(node.orelse)) is None:
            break
        node = chained
        w.begins(node.start)
    block(w, node.orelse)
    w.here(*ends)


def _else_if(orelse: list[nodes.Stmt]) -> nodes.If | None:
    first = orelse[0] if len(orelse) == 1 else None
    return first if type(first) is nodes.If else None


def _warn_of_else_if(w: UnitWriter, orelse: list[nodes.Stmt]) -> None:
    """Warn of `Else If b Then x = 1`, which may mean an Else with a one-line If.

    In that case the statements after it belong to the Else.
    """
    chained = _else_if(orelse)
    if chained is None or len(chained.body) < 2:
        return
    diagnostics = w.program.names.diagnostics
    first, last, here = (
        diagnostics.line(each.start) for each in (chained.body[0], chained.body[-1], chained)
    )
    if here == first < last and diagnostics.text(chained.start).lower() == "else":
        message = "this is read as an ElseIf, which continues to its end"
        hint = "write ElseIf, or Else on a line of its own"
        diagnostics.add("else-if", message, chained.start, hint, "warning")


def select(w: UnitWriter, node: nodes.Select, block: Block) -> None:
    """Write a Select: the subject is worked out once, and the tests in the order of the text."""
    tests = [(each.value, each.high) for case in node.cases for each in case.tests]
    w.settle(node.subject, *[side for both in tests for side in both if side is not None])
    subject = expressions.value(w, node.subject)
    if any(w.has_steps(side) for both in tests for side in both if side is not None):
        subject = expressions.stored(w, subject)
    chosen, first = w.new_index(), subject.get
    found = [[_case_test(w, each, subject, chosen) for each in case.tests] for case in node.cases]

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


def _case_test(w: UnitWriter, test: nodes.CaseTest, subject: Value, chosen: int) -> Get:
    sides = [expressions.value(w, side) for side in (test.value, test.high) if side is not None]
    for side in sides:
        is_known = side is not NOTHING and subject is not NOTHING
        if is_known and (side.type == STRING) is not (subject.type == STRING):
            message = f"{article(side.type)} cannot be compared with the {subject.type} of the Select"
            w.error("type", message, test)
    low = sides[0].get
    if test.high is not None:
        high, at_least = sides[1].get, comparison(">=", w.program.report)
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
    program, symbol = w.program, node.variable.symbol
    if symbol is None or symbol.kind not in ("variable", "parameter") or symbol.type.name not in NUMERIC:
        name, row = node.variable.name, node.variable.row
        hint = another_name(name, row) if row else ""
        w.error("type", f"{name} cannot count: it is not a numeric variable", node.variable, hint)
        return
    where, which, kind = expressions.target(w, node.variable)
    step = node.step if node.step is not None else nodes.Number(node.start, node.end, 1)
    w.settle(node.first, node.stop, step)
    first, stop, by = expressions.values(w, [node.first, node.stop, step], _limit)
    if w.checks:
        check_step(w, node, symbol, by.const)
        _body(w, "for", node, [], block)
        check_elements(w, node, symbol)
        return
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


def _limit(w: UnitWriter, node: nodes.Expr) -> Value:
    return expressions.as_number(w, expressions.linear(w, node), node)


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
    if w.checks:
        return
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
    if w.checks:
        _check_exit(w, node)
        return
    if node.kind in ("sub", "function", "task", "event"):
        _go_back(w) if w.function.kind == "sub" else w.add(END)
        return
    kinds = [
        (kind, jumps) for kind, jumps in w.around if node.kind == kind or (not node.kind and kind != "select")
    ]
    kinds[-1][1].append(w.add(JUMP))


def _check_exit(w: UnitWriter, node: nodes.Exit) -> None:
    kind, function, around = node.kind, w.function, [each for each, _ in w.around]
    if kind in ("sub", "function", "task", "event"):
        wanted = "sub" if kind == "function" else kind
        is_inside = function.kind == wanted and (kind == "function") is (function.result is not None)
    else:
        is_inside = kind in around if kind else any(each != "select" for each in around)
    if not is_inside:
        outside = f"Exit {kind.capitalize()} outside a {kind.capitalize()}" if kind else "Exit outside a loop"
        hint = "" if kind else "Exit Sub leaves a sub, Exit Function a function"
        w.error("stray-end", outside, node, hint)


def _go_back(w: UnitWriter) -> None:
    result = w.function.result
    index = None if result is None else w.program.places.index(result)
    w.add(RETURN, None if index is None else lambda values: values[index])


def return_(w: UnitWriter, node: nodes.Return) -> None:
    """Write `Return` from a Gosub, an event or a sub."""
    if w.function.kind == "main" and not w.function.jumps:
        w.error("stray-end", "Return without a Gosub", node)
    if w.function.jumps:
        w.pay()
    _go_back(w)


def label(w: UnitWriter, node: nodes.Label) -> None:
    """Write a label; the loop of a jump back to it begins here."""
    name = node.name.lower()
    w.label = name
    w.labels[name] = len(w.steps)
    if label_event(name) is None:  # of several labels the first one has the name of the subroutine
        w.steps.labels.setdefault(len(w.steps), node.name)
    else:
        w.steps.labels[len(w.steps)] = node.name
    region = w.regions.get(name)
    if region is not None:
        at, environment = node.start, w.program.environment
        region.first = w.add(
            NOTE, lambda values: environment.task.loop_log.begin_once(at, region.first, region.last)
        )


def jump(w: UnitWriter, node: nodes.Jump) -> None:
    """Write a Goto or a Gosub; name resolution reports labels that are declared twice."""
    if w.checks:
        _check_label(w, node)
        return
    name = node.name.lower()
    if node.kind == "gosub":
        w.pay()
        w.add(NOW)
        w.jumps.append((w.add(CALL, _gosub(w)), name))
    else:
        w.jumps.append((w.add(BACK, cost=1.0), name))


def _check_label(w: UnitWriter, node: nodes.Jump) -> None:
    name, label, diagnostics = node.name, node.symbol, w.program.names.diagnostics
    if label is not None and label.declared:
        return
    symbol = w.function.scope.find(name)
    if symbol is not None and symbol.kind == "sub":
        hint = f"a sub is called by its name alone: {symbol.name}"
        diagnostics.add("unknown-word", f"{symbol.name} is a sub, not a label", name.start, hint)
        return

    def labels() -> list[str]:
        return [key for key, label in w.function.labels.items() if label.declared]

    diagnostics.unknown(f"there is no label {name}", name, labels, name.start, label_hint(name))


def _gosub(w: UnitWriter) -> Callable[[Values], tuple[Steps, Values]]:
    steps = w.steps
    return lambda values: (steps, values)

"""Check statements; each kind has a function in `STATEMENTS`."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from math import prod
from typing import TYPE_CHECKING

from motionlang.kernel.mint.check.unknown_words import (
    another_name,
    label_hint,
    task_named,
    unknown_command,
    unknown_name,
)
from motionlang.kernel.mint.check.values import NOTHING, Value, article
from motionlang.kernel.mint.resolve.handlers import label_handlers
from motionlang.kernel.mint.resolve.symbols import INTEGER, NUMERIC, RECORD, SEMAPHORE, STRING, Symbol, Type
from motionlang.kernel.mint.steps import keywords, terminal, waiting
from motionlang.kernel.mint.steps.calls import call
from motionlang.kernel.mint.steps.expressions import check_subscript, place
from motionlang.kernel.mint.syntax import nodes
from motionlang.kernel.mint.syntax.traversal import meant, walk

if TYPE_CHECKING:
    from motionlang.kernel.mint.steps.unit import UnitWriter

# ---------------------------------------------------------------------------------------------- assignments


def _assign(b: UnitWriter, node: nodes.Assign) -> None:
    target = meant(node.target)
    if type(target) is not nodes.Name:
        _assign_other(b, node)
    elif (result := b.function.result_named(target)) is not None:
        target.type = str(result.type)
        _assign_value(b, node, result.type)
    elif target.symbol is not None:
        _assign_variable(b, node, target, target.symbol)
    elif target.row is not None:
        keywords.write(b, node, target, target.row)
    else:
        unknown_name(b, target)
        for each in node.values:
            b.value(each)


def _assign_other(b: UnitWriter, node: nodes.Assign) -> None:
    """Check an assignment to a member; a Define that is no name cannot be assigned to."""
    if type(node.target) is nodes.Member:
        _assign_value(b, node, place(b, node.target)[2])
        return
    named = node.target.symbol.name  # type: ignore[union-attr]
    b.problem("type", f"{named} is an expression and cannot be assigned to", node)


def _assign_variable(b: UnitWriter, node: nodes.Assign, target: nodes.Name, symbol: Symbol) -> None:
    if symbol.kind in ("variable", "parameter"):
        _assign_value(b, node, place(b, target)[2])
        return
    is_function = symbol.kind == "sub" and symbol.home.result is not None
    what = {"const": "constant"}.get(symbol.kind, "function" if is_function else symbol.kind)
    b.problem("read-only", f"{symbol.name} is a {what} and cannot be assigned to", target)


def _assign_value(b: UnitWriter, node: nodes.Assign, kind: Type) -> None:
    if len(node.values) != 1:
        b.problem("values", f"a variable takes one value, {len(node.values)} given", node)
        return
    if node.repeat:
        b.problem("values", "a ; after the value is only for keywords with axes", node)
        return
    found = b.value(node.values[0])
    if kind.name == RECORD:
        if found.type != str(kind) and found is not NOTHING:
            b.problem("type", f"cannot assign {article(found.type)} to {article(str(kind))}", node)
    else:
        b.convert(found, Type(INTEGER) if kind.name == SEMAPHORE else kind, node.values[0])


def _dim(b: UnitWriter, node: nodes.Dim) -> None:
    """Check the initial values of variables."""
    for variable in node.variables:
        symbol, given = variable.symbol, len(variable.values)
        if not given or symbol is None or symbol.kind != "variable":
            continue
        if symbol.is_array and given > (count := prod(symbol.dimensions)):
            b.problem("values", f"{variable.name} has {count} elements, {given} values are given", variable)
        elif not symbol.is_array and given > 1:
            b.problem("values", f"{variable.name} is one value, {given} given", variable)
        else:
            for each in variable.values:
                b.convert(b.value(each), symbol.type, each)


def _nothing(b: UnitWriter, node: nodes.Stmt) -> None:
    """Check nothing: name resolution has checked declarations and labels, the parser a `Wrong`."""


# ------------------------------------------------------------------------------------------ calls and tasks


def _call(b: UnitWriter, node: nodes.Call) -> None:
    target = node.target
    symbol = target.symbol
    if symbol is not None and symbol.kind == "sub":
        call(b, target, symbol, wanted=False)
    elif symbol is not None:
        hint = f"write {symbol.name} = value to give it one" if symbol.kind == "variable" else ""
        b.problem("not-a-command", f"{symbol.name} is a {symbol.kind}, not a command", target, hint)
    elif target.row is None:
        unknown_command(b, target)
    else:
        keywords.command(b, node, target.row)


def _run(b: UnitWriter, node: nodes.Run) -> None:
    task_named(b, node, node.name)


def _end(b: UnitWriter, node: nodes.End) -> None:
    if node.name is not None:
        task_named(b, node, node.name)


def _return(b: UnitWriter, node: nodes.Return) -> None:
    if b.function.kind == "main" and not b.function.jumps:
        b.problem("stray-end", "Return without a Gosub", node)


def _jump(b: UnitWriter, node: nodes.Jump) -> None:
    """Check a Goto or a Gosub; name resolution reports labels that are declared twice."""
    assert node.symbol is not None
    if node.symbol.declared:
        return
    name, problems = node.name, b.program.names.problems
    symbol = b.function.scope.find(name)
    if symbol is not None and symbol.kind == "sub":
        hint = f"a sub is called by its name alone: {symbol.name}"
        problems.add("unknown-word", f"{symbol.name} is a sub, not a label", name.start, hint)
        return

    def labels() -> list[str]:
        return [key for key, label in b.function.labels.items() if label.declared]

    problems.unknown(f"there is no label {name}", name, labels, name.start, label_hint(name))


# ----------------------------------------------------------------------------------------- If and Select


def _if(b: UnitWriter, node: nodes.If) -> None:
    """Check an If and its ElseIfs, of which there may be thousands."""
    branch: nodes.If | None = node
    while branch is not None:
        _warn_of_else_if(b, branch.orelse)
        b.condition(branch.condition)
        b.statements(STATEMENTS, branch.body)
        last, branch = branch, _else_if(branch.orelse)
    b.statements(STATEMENTS, last.orelse)


def _else_if(orelse: list[nodes.Stmt]) -> nodes.If | None:
    first = orelse[0] if len(orelse) == 1 else None
    return first if type(first) is nodes.If else None


def _warn_of_else_if(b: UnitWriter, orelse: list[nodes.Stmt]) -> None:
    """Warn of `Else If b Then x = 1`, which may mean an Else with a one-line If.

    In that case the statements after it belong to the Else.
    """
    chained = _else_if(orelse)
    if chained is None or len(chained.body) < 2:
        return
    line = b.program.names.problems.line
    first, last, here = line(chained.body[0].start), line(chained.body[-1].start), line(chained.start)
    if here == first < last and b.program.names.problems.text(chained.start).lower() == "else":
        hint = "write ElseIf, or Else on a line of its own"
        b.problem(
            "else-if", "this is read as an ElseIf, which continues to its end", chained, hint, "warning"
        )


def _select(b: UnitWriter, node: nodes.Select) -> None:
    """Check a Select; the Cases after a Case Else are never reached."""
    subject = b.value(node.subject)
    for case in node.cases:
        for test in case.tests:
            _case_test(b, test, subject)
    b.loops.append("select")
    for case in node.cases:
        b.statements(STATEMENTS, case.body)
        if not case.tests:
            break
    b.loops.pop()


def _case_test(b: UnitWriter, test: nodes.CaseTest, subject: Value) -> None:
    for side in [b.value(side) for side in (test.value, test.high) if side is not None]:
        is_known = side is not NOTHING and subject is not NOTHING
        if is_known and (side.type == STRING) is not (subject.type == STRING):
            message = f"{article(side.type)} cannot be compared with the {subject.type} of the Select"
            b.problem("type", message, test)


# -------------------------------------------------------------------------------------------------- loops


def _for(b: UnitWriter, node: nodes.For) -> None:
    """Check `For variable = first To stop Step step … Next`."""
    symbol = node.variable.symbol
    if symbol is None or symbol.kind not in ("variable", "parameter") or symbol.type.name not in NUMERIC:
        name, row = node.variable.name, node.variable.row
        hint = another_name(name, row) if row else ""
        b.problem("type", f"{name} cannot count: it is not a numeric variable", node.variable, hint)
        return
    place(b, node.variable)
    b.number(node.first)
    b.number(node.stop)
    if node.step is not None and _may_be_0(b, node.step) and not _may_end(node, symbol):
        b.problem("range", "a For that counts by 0 never ends", node.step, "leave it with Exit For")
    _body(b, "for", node.body)
    others = symbol.shared and any(each.kind in ("task", "event") for each in b.program.names.functions)
    if not (others or _may_end(node, symbol) or label_handlers(b.function)):
        _check_elements(b, node, symbol)


def _check_elements(b: UnitWriter, node: nodes.For, symbol: Symbol) -> None:
    """Report the elements outside their arrays that a For comes to by its first or its last value, each time."""
    loops = nodes.While | nodes.Repeat | nodes.Loop
    if any(isinstance(each, loops) or _is_function(each) for each in walk(node.body)):
        return
    for statement in _every_time(node.body):
        for name in walk([statement]):
            if type(name) is not nodes.Name or name.symbol is None:
                continue
            for arg, size in zip(name.args or (), name.symbol.dimensions, strict=False):
                for value in _ends(node) if _is_variable(arg, symbol) else ():
                    check_subscript(b, arg, value, size)


def _ends(node: nodes.For) -> tuple[int, ...]:
    """Return the first and the last value of a For that is carried out, () if they are not known before the run."""
    first, stop, step = node.first.const, node.stop.const, 1 if node.step is None else node.step.const
    if not (isinstance(first, int) and isinstance(stop, int) and isinstance(step, int) and step):
        return ()
    return (first, stop - (stop - first) % step) if (stop - first) * step >= 0 else ()


def _every_time(body: list[nodes.Stmt]) -> Iterator[nodes.Stmt]:
    """Yield the assignments and prints of a body that are carried out whole whenever it is."""
    for each in body:
        if type(each) is nodes.For and _ends(each):
            yield from _every_time(each.body)
        elif isinstance(each, nodes.Assign | nodes.Print) and not any(
            type(part) is nodes.Binary and part.op in ("And", "Or") for part in walk([each])
        ):
            yield each


def _is_function(node: nodes.Node) -> bool:
    return isinstance(node, nodes.Name) and node.symbol is not None and node.symbol.kind == "sub"


def _may_be_0(b: UnitWriter, step: nodes.Expr) -> bool:
    """True if a step is 0, or if its value is only known when the program starts."""
    known = b.number(step).const
    return known == 0 or (known is None and _is_known_at_start(step))


def _is_known_at_start(node: nodes.Expr) -> bool:
    match meant(node):
        case nodes.Given():
            return True
        case nodes.Cast(value=value) | nodes.Unary(operand=value):
            return _is_known_at_start(value)
        case nodes.Binary(left=left, right=right):
            return _is_known_at_start(left) and _is_known_at_start(right)
        case other:
            return other.const is not None


def _may_end(node: nodes.For, symbol: Symbol) -> bool:
    """True if the body may leave the loop, or assigns to its variable."""
    for each in walk(node.body):
        if isinstance(each, (nodes.Exit, nodes.Jump, nodes.Return, nodes.End)):
            return True
        if isinstance(each, nodes.Call) and each.target.row is None:
            return True
        if isinstance(each, nodes.Assign | nodes.Input) and _is_variable(each.target, symbol):
            return True
        if isinstance(each, nodes.For) and _is_variable(each.variable, symbol):
            return True
    return False


def _is_variable(node: nodes.Expr, symbol: Symbol) -> bool:
    return type(node) is nodes.Name and node.args is None and node.symbol is symbol


def _while(b: UnitWriter, node: nodes.While) -> None:
    """Check `While condition … End While`."""
    b.condition(node.condition)
    _body(b, "while", node.body)


def _repeat(b: UnitWriter, node: nodes.Repeat) -> None:
    """Check `Repeat … Until condition`."""
    _body(b, "repeat", node.body)
    b.condition(node.condition)


def _body(b: UnitWriter, kind: str, body: list[nodes.Stmt]) -> None:
    b.loops.append(kind)
    b.statements(STATEMENTS, body)
    b.loops.pop()


def _exit(b: UnitWriter, node: nodes.Exit) -> None:
    """Check `Exit` and `Exit For …`, which leave a loop, a Select or the function."""
    kind, function = node.kind, b.function
    if kind in ("sub", "function", "task", "event"):
        wanted = "sub" if kind == "function" else kind
        inside = function.kind == wanted and (kind == "function") is (function.result is not None)
        outside = f"Exit {kind.capitalize()} outside a {kind.capitalize()}"
    elif kind:
        inside, outside = kind in b.loops, f"Exit {kind.capitalize()} outside a {kind.capitalize()}"
    else:
        inside, outside = any(each != "select" for each in b.loops), "Exit outside a loop"
    if not inside:
        hint = "" if kind else "Exit Sub leaves a sub, Exit Function a function"
        b.problem("stray-end", outside, node, hint)


STATEMENTS: dict[type, Callable[..., None]] = {
    nodes.Assign: _assign,
    nodes.Dim: _dim,
    nodes.Const: _nothing,
    nodes.Define: _nothing,
    nodes.Auto: _nothing,
    nodes.Call: _call,
    nodes.Print: terminal.print_,
    nodes.Input: waiting.input_,
    nodes.Run: _run,
    nodes.End: _end,
    nodes.Pause: lambda b, node: b.condition(node.condition),
    nodes.If: _if,
    nodes.Select: _select,
    nodes.For: _for,
    nodes.While: _while,
    nodes.Repeat: _repeat,
    nodes.Loop: lambda b, node: _body(b, "loop", node.body),
    nodes.Exit: _exit,
    nodes.Label: _nothing,
    nodes.Jump: _jump,
    nodes.Return: _return,
    nodes.Wrong: _nothing,
}

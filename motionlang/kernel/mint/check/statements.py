"""Check statements; each kind has a function in `STATEMENTS`."""

from __future__ import annotations

from collections.abc import Callable
from math import prod

from motionlang.kernel.mint.check import keywords, labels, loops, terminal
from motionlang.kernel.mint.check.body import Body
from motionlang.kernel.mint.check.calls import call
from motionlang.kernel.mint.check.unknown_words import task_named, unknown_command, unknown_name
from motionlang.kernel.mint.check.values import NOTHING, KnownValue, article
from motionlang.kernel.mint.check.variables import location
from motionlang.kernel.mint.resolve.symbols import INTEGER, RECORD, SEMAPHORE, STRING, Symbol, Type
from motionlang.kernel.mint.syntax import nodes
from motionlang.kernel.mint.syntax.traversal import meant

# ---------------------------------------------------------------------------------------------- assignments


def _assign(b: Body, node: nodes.Assign) -> None:
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


def _assign_other(b: Body, node: nodes.Assign) -> None:
    """Check an assignment to a member; a Define that is no name cannot be assigned to."""
    if type(node.target) is nodes.Member:
        _assign_value(b, node, location(b, node.target))
        return
    named = node.target.symbol.name  # type: ignore[union-attr]
    b.problem("type", f"{named} is an expression and cannot be assigned to", node)


def _assign_variable(b: Body, node: nodes.Assign, target: nodes.Name, symbol: Symbol) -> None:
    if symbol.kind in ("variable", "parameter"):
        _assign_value(b, node, location(b, target))
        return
    is_function = symbol.kind == "sub" and symbol.home.result is not None
    what = {"const": "constant"}.get(symbol.kind, "function" if is_function else symbol.kind)
    b.problem("read-only", f"{symbol.name} is a {what} and cannot be assigned to", target)


def _assign_value(b: Body, node: nodes.Assign, kind: Type) -> None:
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


def _dim(b: Body, node: nodes.Dim) -> None:
    for variable in node.variables:
        symbol = variable.symbol
        if variable.values and symbol is not None and symbol.kind == "variable":
            _initial_values(b, variable, symbol)


def _initial_values(b: Body, node: nodes.Variable, symbol: Symbol) -> None:
    given = len(node.values)
    if symbol.is_array and given > (count := prod(symbol.dimensions)):
        b.problem("values", f"{node.name} has {count} elements, {given} values are given", node)
    elif not symbol.is_array and given > 1:
        b.problem("values", f"{node.name} is one value, {given} given", node)
    else:
        for each in node.values:
            b.convert(b.value(each), symbol.type, each)


def _nothing(b: Body, node: nodes.Stmt) -> None:
    """Check nothing: name resolution has checked declarations and labels, the parser a `Wrong`."""


# ------------------------------------------------------------------------------------------ calls and tasks


def _call(b: Body, node: nodes.Call) -> None:
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


def _run(b: Body, node: nodes.RunTask) -> None:
    task_named(b, node, node.name)


def _end(b: Body, node: nodes.End) -> None:
    if node.name is not None:
        task_named(b, node, node.name)


def _return(b: Body, node: nodes.Return) -> None:
    if b.function.kind == "main" and not b.function.jumps:
        b.problem("stray-end", "Return without a Gosub", node)


def _pause(b: Body, node: nodes.Pause) -> None:
    b.condition(node.condition)


# ----------------------------------------------------------------------------------------- If and Select


def _if(b: Body, node: nodes.If) -> None:
    """Check an If and its ElseIfs, of which there may be thousands."""
    branch: nodes.If | None = node
    while branch is not None:
        _warn_of_else_if(b, branch.orelse)
        b.condition(branch.condition)
        b.statements(branch.body)
        last, branch = branch, _else_if(branch.orelse)
    b.statements(last.orelse)


def _else_if(orelse: list[nodes.Stmt]) -> nodes.If | None:
    """Return the If of an ElseIf, None for an Else."""
    first = orelse[0] if len(orelse) == 1 else None
    return first if type(first) is nodes.If else None


def _warn_of_else_if(b: Body, orelse: list[nodes.Stmt]) -> None:
    """Warn of `Else If b Then x = 1`, which may mean an Else with a one-line If.

    In that case the statements after it belong to the Else.
    """
    chained = _else_if(orelse)
    if chained is None or len(chained.body) < 2:
        return
    line = b.program.problems.line
    first, last, here = line(chained.body[0].start), line(chained.body[-1].start), line(chained.start)
    if here == first < last and b.program.problems.text(chained.start).lower() == "else":
        hint = "write ElseIf, or Else on a line of its own"
        b.warn("else-if", "this is read as an ElseIf, which continues to its end", chained, hint)


def _select(b: Body, node: nodes.Select) -> None:
    """Check a Select; the Cases after a Case Else are never reached."""
    subject = b.value(node.subject)
    for case in node.cases:
        for test in case.tests:
            _case_test(b, test, subject)
    b.loops.append("select")
    for case in node.cases:
        b.statements(case.body)
        if not case.tests:
            break
    b.loops.pop()


def _case_test(b: Body, test: nodes.CaseTest, subject: KnownValue) -> None:
    for side in [b.value(side) for side in (test.value, test.high) if side is not None]:
        is_known = side is not NOTHING and subject is not NOTHING
        if is_known and (side.type == STRING) is not (subject.type == STRING):
            message = f"{article(side.type)} cannot be compared with the {subject.type} of the Select"
            b.problem("type", message, test)


STATEMENTS: dict[type, Callable[..., None]] = {
    nodes.Assign: _assign,
    nodes.Dim: _dim,
    nodes.Const: _nothing,
    nodes.Define: _nothing,
    nodes.Auto: _nothing,
    nodes.Call: _call,
    nodes.Print: terminal.print_,
    nodes.Input: terminal.input_,
    nodes.RunTask: _run,
    nodes.End: _end,
    nodes.Pause: _pause,
    nodes.If: _if,
    nodes.Select: _select,
    nodes.For: loops.count,
    nodes.While: loops.while_,
    nodes.Repeat: loops.repeat,
    nodes.Loop: loops.endless,
    nodes.Exit: loops.exit_,
    nodes.Label: _nothing,
    nodes.Jump: labels.jump,
    nodes.Return: _return,
    nodes.Wrong: _nothing,
}

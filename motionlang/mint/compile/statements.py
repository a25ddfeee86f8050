"""Compile statements: each writes its Python lines into a `Body`."""

from __future__ import annotations

from collections.abc import Callable

from motionlang.mint.compile import (
    for_loops,
    jumps,
    keyword_use,
    loop_times,
    loops,
    pause,
    splitting,
    stops,
    terminal_use,
    words,
)
from motionlang.mint.compile.body import Body, Value
from motionlang.mint.compile.calls import call
from motionlang.mint.compile.conversions import NOTHING, article, converted
from motionlang.mint.compile.expressions import condition, reference, unknown, value
from motionlang.mint.compile.lines import BREAK, LEAVES, LOOP, NONE, Line
from motionlang.mint.resolve.symbols import INTEGER, RECORD, SEMAPHORE, STRING, TIME, Symbol, Type
from motionlang.mint.runtime.code_units import SCRATCH
from motionlang.mint.syntax import nodes
from motionlang.mint.syntax.traversal import meant


def block(b: Body, body: list[nodes.Stmt]) -> None:
    """Write statements in sequence."""
    guarded = b.whole.guarded and not _handles_errors(b)
    whole, lines, around = b.whole, b.lines, b.loops
    first, outer, b.deepest = len(lines), b.deepest, len(around)
    begin, ends = first, []
    for node in body:
        b.at = node.start
        b.observes = b.calls = whole.checks = False
        if whole.debugging is not None:
            stops.before(b, node)
        if guarded and type(node) in _CAN_FAIL:
            _guard(b, node)
        else:
            _STATEMENTS[node.__class__](b, node)
        if b.calls and not b.timed:
            loop_times.call(b, node, begin)
        if around and b.deepest - len(around) >= splitting.MAX_LOOPS and splitting.fold(b, begin):
            b.deepest = len(around)
        begin = len(lines)
        ends.append(begin)
    if begin - first > splitting.SIZE:
        splitting.cut(b, first, ends)
    b.deepest = max(outer, b.deepest)


def _handles_errors(b: Body) -> bool:
    """True within ONERROR itself, where a failing statement ends the program."""
    return b.function.name.lower() == "onerror" or (
        b.function.jumps and b.stretches()[b.stretch][0] == "onerror"
    )


def _guard(b: Body, node: nodes.Stmt) -> None:
    """Write a statement whose failure goes to ONERROR; then the next statement runs."""
    b.flush()
    b.emit("try:")
    b.indent += 1
    before = len(b.lines)
    _STATEMENTS[type(node)](b, node)
    b.flush()
    if len(b.lines) == before:
        b.emit("pass")
    b.indent -= 1
    b.at = node.start
    b.noted = True
    b.emit(f"except {b.whole.use('env', 'TROUBLE')} as x:")
    b.emit(f" t = H = {b.whole.use('env', 'failed')}(x, t, {b.whole.line(node.start)})")
    b.note_yield()
    b.emit(" t, H = yield t")  # ONERROR runs before the next statement, even if that only computes


def inner(b: Body, body: list[nodes.Stmt]) -> None:
    """Write an indented block that starts and ends with `t` up to date."""
    b.indent += 1
    before = len(b.lines)
    block(b, body)
    b.flush()
    if len(b.lines) == before:
        b.emit("pass")
    elif b.indent % splitting.MAX_INDENT == 0:
        splitting.fold(b, before)
    b.indent -= 1


# ---------------------------------------------------------------------------------------------- assignments


def _assign(b: Body, node: nodes.Assign) -> None:
    target: nodes.Expr = node.target
    if type(target) is nodes.Name and target.args is None:
        known = b.targets.get(target.name)
        if known is not None and target.definition is None:
            text, kind, scalar = known
            b.names.append(scalar.python)
            _give(b, node, text, kind, scalar)
            return
        target = meant(target)
    if type(target) is nodes.Name:
        symbol = target.symbol
        result = b.function.result
        if result is not None and target.args is None and target.name.lower() == result.name.lower():
            b.use_outside(result)
            _give(b, node, b.spelt(result), result.type, result)
            return
        if symbol is None:
            _assign_keyword(b, node, target)
            return
        if symbol.kind not in ("variable", "parameter"):
            is_function = symbol.kind == "sub" and symbol.home.result is not None
            what = {"const": "constant"}.get(symbol.kind, "function" if is_function else symbol.kind)
            b.problem("read-only", f"{symbol.name} is a {what} and cannot be assigned to", target)
            return
    elif target is not node.target:
        named = node.target.symbol.name  # type: ignore[union-attr]
        b.problem("type", f"{named} is an expression and cannot be assigned to", node)
        return
    _assign_variable(b, node, target)


def _assign_keyword(b: Body, node: nodes.Assign, target: nodes.Name) -> None:
    row = target.row
    if row is None:
        unknown(b, target)
        for each in node.values:
            value(b, each)
        return
    words.write(b, node, target, row)


def _assign_variable(b: Body, node: nodes.Assign, target: nodes.Name | nodes.Member) -> None:
    text, kind, scalar = reference(b, target)
    if scalar is not None:
        if not (scalar.boxed or scalar.by_ref):
            b.use_outside(scalar)
        if type(target) is nodes.Name and target.args is None:
            b.targets[target.name] = text, kind, scalar
    _give(b, node, text, kind, scalar)


def _give(b: Body, node: nodes.Assign, text: str, kind: Type, symbol: Symbol | None) -> None:
    if len(node.values) != 1:
        b.problem("values", f"a variable takes one value, {len(node.values)} given", node)
        return
    if node.repeat:
        b.problem("values", "a ; after the value is only for keywords with axes", node)
        return
    found = value(b, node.values[0])
    if kind.name == SEMAPHORE:
        _take_or_give(b, text, converted(b, found, Type(INTEGER), node.values[0]))
        return
    if kind.name == RECORD:
        _give_record(b, node, text, kind, found)
        return
    source = converted(b, found, kind, node.values[0], exact=symbol not in b.analysed)
    if source is found.text:
        source = found.bare
    if kind.name == TIME:
        b.observes = True
    b.act(f"{text} = {source}")


def _give_record(b: Body, node: nodes.Assign, text: str, kind: Type, found: Value) -> None:
    if found.type != str(kind) and found is not NOTHING:
        b.problem("type", f"cannot assign {article(found.type)} to {article(str(kind))}", node)
        return
    b.act(f"{text}[:] = {b.whole.use('env', 'copy')}({found.text})")


def _take_or_give(b: Body, text: str, wanted: str) -> None:
    """Write an assignment to a semaphore.

    `s = _TRUE` waits until no other task holds it and takes it, `s = _FALSE` releases it.
    """
    b.observes = True
    b.flush()
    b.settle()
    take, wait = b.whole.use("env", "take"), b.whole.use("env", "wait_for_semaphore")
    b.note_yield()
    b.emit(f"while not {take}({text}, {wanted}): t, H = yield {wait}(t, {text})")
    b.emit("H = t")
    b.pending += 1


def _dim(b: Body, node: nodes.Dim) -> None:
    _initialise(b, node)
    if node.nv:
        for variable in node.variables:
            symbol = variable.symbol
            if symbol is not None and symbol.kind == "variable":
                where = "" if b.function.kind == "main" else f"{b.function.name.lower()}."
                b.emit(
                    f"{b.whole.use('env', 'restore_variable')}({where + symbol.name.lower()!r}, {b.spelt(symbol)})"
                )


def _initialise(b: Body, node: nodes.Dim) -> None:
    for variable in node.variables:
        if not variable.values:
            continue
        symbol = variable.symbol
        if symbol is None or symbol.kind != "variable":
            continue
        if symbol.is_array:
            _fill(b, variable, symbol)
        elif len(variable.values) > 1:
            b.problem("values", f"{variable.name} is one value, {len(variable.values)} given", variable)
        else:
            found = value(b, variable.values[0])
            text, kind, _ = reference(
                b, nodes.Name(variable.start, variable.end, variable.name).resolve(symbol)
            )
            source = converted(b, found, kind, variable.values[0], exact=symbol not in b.analysed)
            b.settle()
            if not symbol.boxed:
                b.use_outside(symbol)
            b.emit(f"{text} = {source}")


def _fill(b: Body, variable: nodes.Variable, symbol: Symbol) -> None:
    count = 1
    for size in symbol.dimensions:
        count *= size
    if len(variable.values) > count:
        b.problem(
            "values",
            f"{variable.name} has {count} elements, {len(variable.values)} values are given",
            variable,
        )
        return
    texts = [converted(b, value(b, each), symbol.type, each) for each in variable.values]
    b.settle()
    b.emit(f"{b.spelt(symbol)}[1:{len(texts) + 1}] = [{', '.join(texts)}]")


def _nothing(b: Body, node: nodes.Stmt) -> None:
    """Write nothing: declarations cost nothing and have no effect at run time."""


# ----------------------------------------------------------------------------------------------------- calls


def _call(b: Body, node: nodes.Call) -> None:
    target = node.target
    symbol, row = target.symbol, target.row
    if symbol is not None and symbol.kind == "sub":
        found = call(b, target, symbol, wanted=False)
        b.act(found.text)
    elif symbol is not None:
        b.problem("not-a-command", f"{symbol.name} is a {symbol.kind}, not a command", target,
                  f"write {symbol.name} = value to give it one" if symbol.kind == "variable" else "")  # fmt: skip
    elif row is None:
        unknown_command(b, target)
    else:
        words.command(b, node, row)


# Words of the grammar that begin a statement and are often misspelled.
_FIRST_WORDS = ("Const", "Pause", "Print", "Return", "Input", "Repeat")
# Blocks whose End is a word of its own.
_BLOCKS = ("event", "function", "loop", "select", "sub", "task", "while")
# Words that begin a statement in other languages, and what is written here.
_OTHER_WORDS = {
    "break": "Exit leaves a loop",
    "call": "a sub is called by its name alone",
    **dict.fromkeys(("catch", "try"), "an event handles errors: Event ONERROR"),
    "continue": "there is no Continue: put the rest of the loop in an If",
    **{f"end{word}": f"this is two words: End {word.capitalize()}" for word in _BLOCKS},
    "let": "a variable is assigned to by its name alone: k = 3",
    **dict.fromkeys(
        ("local", "private", "public", "static", "var"), "Dim declares a variable: Dim k As Integer"
    ),
    "switch": "a choice between values is Select Case k … End Select",
}


def unknown_command(b: Body, target: nodes.Name) -> None:
    """Report an unknown word used as a statement.

    A word that is only a value is not suggested.
    """

    def known() -> list[str]:
        subs = [symbol.name for symbol in b.scope.symbols() if symbol.kind == "sub"]
        commands = [row.name for row in b.whole.table if row.kind == "command" or row.verb == "wait"]
        return [*subs, *commands, *_FIRST_WORDS]

    message = f"{target.name} is neither a keyword nor a sub of this program"
    hint = _OTHER_WORDS.get(target.name.lower())
    if hint is not None:
        following = b.scope.find(b.whole.problems.text(target.name.end))
        if target.name.lower() == "call" and following is not None and following.kind == "sub":
            hint += f": {following.name}"
        b.whole.problems.add("unknown-word", message, target.start, hint)
        return
    b.whole.problems.unknown(message, target.name, known, target.start, table=b.whole.table)


def _run(b: Body, node: nodes.Run) -> None:
    symbol = keyword_use.task(b, node, node.name)
    if symbol is None:
        return
    b.observes = True
    b.settle()
    b.emit(f"{b.whole.use('env', 'start_task')}({symbol.name.lower()!r}, {symbol.python})")
    b.flush()
    b.emit("H = t")  # the new task may have something to do before the next event
    b.pending += 1


# ---------------------------------------------------------------------------------------------- If and Select


def _if(b: Body, node: nodes.If) -> None:
    if loops.is_long(node):
        _long_if(b, node)
        return
    _warn_of_else_if(b, node.orelse)
    test = condition(b, node.condition)
    b.settle()
    b.pending += 1
    calls = b.calls
    noted, b.noted, hooked, b.hooked = b.noted, False, b.hooked, False
    outer, b.lines = b.lines, []
    owed, b.pending = b.pending, 0
    at = b.at
    b.emit(f"if {test}:")
    inner(b, node.body)
    if node.orelse:
        b.at = at
        b.emit("else:")
        inner(b, node.orelse)
    written, b.lines = b.lines, outer
    b.pending = owed
    b.at = at
    if b.hooked and calls and not b.noted:  # without hooks the call begins before this statement is paid for
        known, first = b.temp(SCRATCH), written[0]
        b.lines.append(Line(first.indent, f"{known} = {first.text[3:-1]}", first.at, first.kind, first.names))
        first.text, first.names = f"if {known}:", NONE
    if b.noted or b.hooked:
        b.flush()
    b.lines += written
    b.noted, b.hooked = b.noted or noted, b.hooked or hooked


def _long_if(b: Body, node: nodes.If) -> None:
    """Write a long chain of ElseIfs as tests in a loop of one iteration.

    The chosen branch leaves the loop.
    """
    b.flush()
    b.noted = True
    b.emit("while True:", LOOP)
    b.indent += 1
    b.loops.append(("if", ""))
    for branch in loops.branches(node):
        _warn_of_else_if(b, branch.orelse)
        b.at = branch.start
        b.observes = b.calls = b.whole.checks = False
        test = condition(b, branch.condition)
        b.settle()
        b.pending += 1
        b.flush()
        b.emit(f"if {test}:")
        inner(b, branch.body)
        b.emit(" break", BREAK)
    block(b, branch.orelse)
    b.flush()
    b.loops.pop()
    b.emit("break", BREAK)
    b.indent -= 1
    loops.go_on_leaving(b)


def _warn_of_else_if(b: Body, orelse: list[nodes.Stmt]) -> None:
    """Warn of `Else If b Then x = 1`, which may mean an Else with a one-line If.

    In that case the statements after it belong to the Else.
    """
    chained = orelse[0] if len(orelse) == 1 else None
    if type(chained) is not nodes.If or len(chained.body) < 2:
        return
    line = b.whole.line
    first, last, here = line(chained.body[0].start), line(chained.body[-1].start), line(chained.start)
    if here == first < last and b.whole.problems.text(chained.start).lower() == "else":
        hint = "write ElseIf, or Else on a line of its own"
        b.warn("else-if", "this is read as an ElseIf, which continues to its end", chained, hint)


def _select(b: Body, node: nodes.Select) -> None:
    subject = value(b, node.subject)
    tests = [_case_test(b, case, subject, name) for name in (b.temp(),) for case in node.cases]
    name = f"w{b.temps}"
    b.settle()
    b.pending += 1
    b.flush()
    b.emit(f"{name} = {subject.bare}")
    once = loops.is_loop(node)
    flag = ""
    if once:
        flag = loops.flag_for(b, "select", [each for case in node.cases for each in case.body])
        b.emit("while True:", LOOP)
        b.indent += 1
    b.loops.append(("select" if once else "", flag))
    _cases(b, node, tests)
    b.loops.pop()
    if once:
        b.emit("break", BREAK)
        b.indent -= 1
        loops.go_on_leaving(b)


def _cases(b: Body, node: nodes.Select, tests: list[str]) -> None:
    word, many = "if", len(node.cases) > loops.MANY_CASES
    for case, test in zip(node.cases, tests, strict=True):
        b.at = case.start
        if case.tests or not (many or word == "if"):
            b.emit(f"{word} {test}:" if case.tests else "else:")
        else:
            b.emit("if True:")
        inner(b, case.body)
        if many:
            b.emit(" break", BREAK)
        else:
            word = "elif"
        if not case.tests:
            break


def _case_test(b: Body, case: nodes.Case, subject: Value, name: str) -> str:
    return " or ".join(_one_test(b, test, subject, name) for test in case.tests) or "True"


def _one_test(b: Body, test: nodes.CaseTest, subject: Value, name: str) -> str:
    sides = [value(b, side) for side in (test.value, test.high) if side is not None]
    for side in sides:
        is_known = side is not NOTHING and subject is not NOTHING
        if is_known and (side.type == STRING) is not (subject.type == STRING):
            b.problem(
                "type", f"{article(side.type)} cannot be compared with the {subject.type} of the Select", test
            )
    if test.op == "To":
        return f"{sides[0].text} <= {name} <= {sides[1].text}"
    return f"{name} {loops.COMPARISONS[test.op]} {sides[0].text}"


# ---------------------------------------------------------------------------------------- End, Exit, Return


def handle_errors(b: Body) -> None:
    """Write code at the end of the program that reports a last error to ONERROR."""
    if b.function.kind == "main" and b.whole.guarded:
        b.horizon()


def _end(b: Body, node: nodes.End) -> None:
    if node.name is not None:
        symbol = keyword_use.task(b, node, node.name)
        if symbol is None:
            return
        b.observes = True
        b.act(f"{b.whole.use('env', 'end_task')}({symbol.name.lower()!r})")
        return
    b.flush()
    b.noted = True
    handle_errors(b)
    if b.function.kind == "main" and not b.function.jumps:
        loop_times.leave(b)
        b.emit("return", LEAVES)
    else:
        b.emit(f"{b.whole.use('env', 'end_main')}(t)")


def leave(b: Body) -> None:
    """Write the exit from the function."""
    b.flush()
    b.noted = True
    loop_times.leave(b)
    result = b.function.result
    if result is not None and not b.function.jumps:
        b.emit(f"return {b.spelt(result)}", LEAVES)
    else:
        b.emit("return", LEAVES)


def _exit(b: Body, node: nodes.Exit) -> None:
    kind = node.kind
    if kind in ("sub", "function", "task", "event"):
        wanted = {"function": "sub"}.get(kind, kind)
        if b.function.kind != wanted or (kind == "function") is not (b.function.result is not None):
            b.problem("stray-end", f"Exit {kind.capitalize()} outside a {kind.capitalize()}", node)
            return
        leave(b)
        return
    loops.leave_loop(b, node, kind)


def _return(b: Body, node: nodes.Return) -> None:
    if b.function.jumps:
        jumps.return_(b, node)
    elif b.function.kind == "main":
        b.problem("stray-end", "Return without a Gosub", node)
    else:
        leave(b)


_STATEMENTS: dict[type, Callable[..., None]] = {
    nodes.Assign: _assign,
    nodes.Call: _call,
    nodes.Print: terminal_use.print_,
    nodes.Input: terminal_use.input_,
    nodes.Dim: _dim,
    nodes.Const: _nothing,
    nodes.Define: _nothing,
    nodes.If: _if,
    nodes.Select: _select,
    nodes.For: for_loops.count,
    nodes.While: loops.while_,
    nodes.Repeat: loops.repeat,
    nodes.Loop: loops.endless,
    nodes.Exit: _exit,
    nodes.Pause: pause.pause,
    nodes.Run: _run,
    nodes.End: _end,
    nodes.Label: jumps.label,
    nodes.Jump: jumps.jump,
    nodes.Return: _return,
    nodes.Auto: _nothing,
}


# Statements whose failure ONERROR can handle. The statements inside a loop are guarded separately.
_CAN_FAIL = frozenset(
    (nodes.Assign, nodes.Call, nodes.Print, nodes.Input, nodes.Dim, nodes.If, nodes.Select, nodes.For, nodes.While,
     nodes.Repeat, nodes.Pause, nodes.Run)
)  # fmt: skip

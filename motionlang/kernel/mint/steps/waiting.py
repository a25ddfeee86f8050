"""WAIT, PAUSE and INPUT, and waits for a semaphore."""

from __future__ import annotations

from math import inf

from motionlang.kernel.errors import Diagnostic, Rejected
from motionlang.kernel.lang.keyword import Keyword
from motionlang.kernel.lang.machine.machine import CONSOLE
from motionlang.kernel.lang.steps import BRANCH, DO, JUMP, NOW, TRY, TURN, WAIT, Values
from motionlang.kernel.lang.waits import Delay, Wait, next_tick
from motionlang.kernel.mint.check.unknown_words import unknown_name
from motionlang.kernel.mint.resolve.symbols import FLOAT, STRING
from motionlang.kernel.mint.runtime.environment import Environment
from motionlang.kernel.mint.runtime.functions import leading_number
from motionlang.kernel.mint.runtime.task import until_free
from motionlang.kernel.mint.steps import expressions, keywords, terminal
from motionlang.kernel.mint.steps.unit import UnitWriter
from motionlang.kernel.mint.steps.values import Get, Value
from motionlang.kernel.mint.syntax import nodes
from motionlang.kernel.mint.syntax.traversal import meant
from motionlang.kernel.mint.syntax.unparse import shown
from motionlang.kernel.tools import clipped
from motionlang.kernel.traced import reading


def wait(w: UnitWriter, node: nodes.Node, given: list[nodes.Expr], row: Keyword) -> None:
    """Write `WAIT = ms` and `WAIT(ms)`.

    A WAIT reads nothing, so what is due by then happens while it waits.
    """
    if len(given) != 1:
        w.error("values", f"WAIT needs 1 value, {len(given)} given", node, "WAIT = 100 waits for 100 ms")
        return
    w.settle(*given)
    get = keywords.given_to(w, given[0], row).get
    environment = w.program.environment
    clock, statements, loops = environment.clock, environment.statements, environment.loops

    def rest(values: Values) -> Delay:
        milliseconds = get(values)
        if not 0 <= milliseconds < inf:
            raise Rejected("range", f"WAIT cannot be {milliseconds:.10g}", "a wait lasts 0 ms or longer")
        seconds = milliseconds / 1000.0
        loops.waits(seconds)
        ends = environment.end_of_wait(statements.base, statements.count, seconds)
        return Delay(clock, statements.at(statements.count), ends)

    w.add(WAIT, rest, name=row.name)
    w.pay()


def pause(w: UnitWriter, node: nodes.Pause) -> None:
    """Write `PAUSE condition`: the readings in it say when it may become true."""
    if w.has_steps(node.condition):
        _pause_by_ticks(w, node.condition)
        return
    holds = expressions.condition(w, node.condition)
    if w.checks:
        return
    environment, why = w.program.environment, f"until {shown(node.condition)}"
    axes = _at_rest(node.condition)
    ignores_data = bool(axes) or _ignores_data(node.condition)

    def paused(values: Values) -> Wait | None:
        if holds(values):
            return None
        return environment.pause(lambda: holds(values), why, axes, ignores_data)

    w.add(NOW)
    w.add(WAIT, paused, name="PAUSE")
    w.pay()


def _pause_by_ticks(w: UnitWriter, condition: nodes.Expr) -> None:
    """Write the wait for a condition that calls a function of the program: it is tested at every tick."""
    environment = w.program.environment

    def tick(values: Values) -> Delay:
        environment.acts += 1
        now = environment.statements.at(environment.statements.count)
        return Delay(environment.clock, now, next_tick(now))

    w.add(NOW)
    begin = len(w.steps)
    again = w.add(BRANCH, expressions.condition(w, condition))
    w.pay()
    over = w.add(JUMP)
    w.here(again)
    w.add(WAIT, tick)
    w.add(JUMP, to=begin)
    w.here(over)


def _at_rest(node: nodes.Expr) -> tuple[int, ...]:
    """Return the axes of a condition that only tests whether given axes are at rest, () for any other."""
    node = meant(node)
    if isinstance(node, nodes.Binary) and node.op == "And":
        left, right = _at_rest(node.left), _at_rest(node.right)
        return left + right if left and right else ()
    if not isinstance(node, nodes.Name) or node.row is None or node.row.function != "is_idle":
        return ()
    args = node.args or []
    axes = tuple(
        each.value for each in args if isinstance(each, nodes.Number) and isinstance(each.value, int)
    )
    return axes if len(axes) == len(args) else ()


def _ignores_data(node: nodes.Expr) -> bool:
    """True if a condition reads only axes, inputs and the like: no variable, setting or memory of the program."""
    return all(
        each.row is not None
        and each.symbol is None
        and each.row.kind == "reading"
        and each.row.access == "R"
        and each.row.group in ("io", "state")
        for each in expressions.parts(node)
        if isinstance(each, nodes.Name)
    )


def take_or_give(w: UnitWriter, semaphore: Get, wanted: Get) -> None:
    """Write an assignment to a semaphore.

    `s = _TRUE` waits until no other task holds it and takes it, `s = _FALSE` releases it.
    """
    environment = w.program.environment

    def taken(values: Values) -> Wait | None:
        held = semaphore(values)
        if environment.take_semaphore(held, wanted(values)):
            return None
        return until_free(environment.clock.now, held)

    w.add(NOW)
    w.add(TRY, taken)
    w.add(TURN, cost=1.0)


def input_(w: UnitWriter, node: nodes.Input) -> None:
    """Write `INPUT "prompt", variable`."""
    environment, named = w.program.environment, node.target
    symbol = named.symbol if isinstance(named, nodes.Name) else None
    if isinstance(named, nodes.Name) and symbol is None:
        unknown_name(w, named)
        return
    if symbol is not None and symbol.kind not in ("variable", "parameter"):
        expressions.place(w, named)
        w.error("type", f"INPUT needs a variable, and {symbol.name} is a {symbol.kind}", named)
        return
    where, which, kind = expressions.target(w, named)
    number = terminal.number_of(w, node.terminal)
    chosen = w.new_index()
    is_console = number is None and not w.program.names.uses_terminal
    w.add(NOW)
    if not is_console:
        one, which_one = terminal.hidden(w, "terminal"), number or (lambda values: -1)

        def choose(values: Values) -> None:
            values[chosen] = one(which_one(values))

        w.add(DO, choose)
    if node.prompt is not None:
        write = terminal.printer(w, None if is_console else lambda values: values[chosen])
        prompt = expressions.value(w, node.prompt).get
        w.add(DO, lambda values: write(values, prompt(values)), name="INPUT")

    def ask(values: Values) -> Wait:
        environment.acts += 1
        now = environment.statements.at(environment.statements.count)
        return _wait_for_answer(environment, now, CONSOLE if is_console else values[chosen])

    w.add(WAIT, ask, name="INPUT")
    is_text = kind.name == STRING
    typed = Value(
        lambda values: _take(environment, is_text, CONSOLE if is_console else values[chosen], node.start),
        STRING if is_text else FLOAT,
    )
    get = expressions.assigned(w, typed, kind, node)
    if w.checks:
        return
    plain = expressions.plain_variable(w, named)
    sets = None if plain is None else w.program.places.number(plain)
    w.add(DO, expressions.storing(w, named, where, which, get), cost=1.0, sets=sets)


def _wait_for_answer(environment: Environment, t: float, terminal: int) -> Wait:
    """Return the wait for the next line.

    It never ends if no `[[answer]]` is left and there is no operator at the terminal.
    """
    machine = environment.machine
    operator = machine.operator_at(terminal)
    if terminal == CONSOLE and machine.ask is not None and not operator.has_answer():
        line = machine.ask()
        operator.lines += [] if line is None else [(line, "")]
    operator.asking = not operator.has_answer()
    if operator.asking and machine.stop is not None:
        machine.stop.asks()

    def answered() -> bool:
        operator.asking = operator.asking and not operator.has_answer()
        return operator.has_answer()

    return Wait(t, answered, lambda: inf, "for the operator to answer INPUT", "operator")


def _take(environment: Environment, as_text: bool, terminal: int, at: int) -> float | str:
    """Take the next answer and echo it as on the operator's terminal.

    If a number is expected, return the number at the beginning of the answer, and warn, for the INPUT at the source
    offset `at`, of an answer that is none.
    """
    text = environment.machine.operator_at(terminal).take_answer()
    environment.machine.terminal_at(terminal).write(f"{text}\n")
    if as_text:
        return text
    number, rest = leading_number(text)
    if rest or not text.strip():
        line = 0 if environment.line_of is None else environment.line_of(at)
        message = f'the answer "{clipped(text)}" is not a number: INPUT takes {number:.10g}'
        hint = "type a number alone; a controller may ask again (mint.input)"
        environment.machine.complain(Diagnostic("not-a-number", message, line, hint=hint, severity="warning"))
    return reading(number, "answer", at) if environment.controller.reads.traces else number

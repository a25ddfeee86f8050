"""Compile a syntax tree to Python, function by function; `assembly` joins them.

    def main(t, H): …                 the parent task, tasks and events: generators
    def s_fill(p_n): …                subs: plain functions, or generators where they may wait

A line typed at a prompt is compiled by itself. Its names are the globals of one namespace that lives as long
as the session.
"""

from __future__ import annotations

from marshal import dumps

from motionlang.errors import ProgramError, Spellings
from motionlang.lang.collector import CollectorOff
from motionlang.lang.nesting import StackSpace
from motionlang.mint.compile import handler_counters, jumps
from motionlang.mint.compile.assembly import assemble, assemble_line
from motionlang.mint.compile.body import Body, SharedData
from motionlang.mint.compile.overrides import override
from motionlang.mint.compile.statements import block, handle_errors, leave
from motionlang.mint.compile.stops import Debugging
from motionlang.mint.keywords import table
from motionlang.mint.keywords.machine_readings import words
from motionlang.mint.resolve.aliases import rename_old_words
from motionlang.mint.resolve.chosen_rates import chosen_rates
from motionlang.mint.resolve.names import Names
from motionlang.mint.resolve.problems import Problems, bracketed
from motionlang.mint.resolve.short_ramps import warn_of_short_ramps
from motionlang.mint.syntax.extent import blocks_of
from motionlang.mint.syntax.parser import parse

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Mapping

    from motionlang.lang.dialect import Ranges
    from motionlang.mint.compile.assembly import TypedLine
    from motionlang.mint.compile.stops import Stops
    from motionlang.mint.resolve.recall import Recall
    from motionlang.mint.resolve.symbols import Function, Scope
    from motionlang.mint.runtime.code_units import Code
    from motionlang.mint.syntax.nodes import Module
    from motionlang.source import Source

DEFAULT_AXES = 8


class Compiled:
    """A compiled program: its code, its names and its problems.

    `outline` is packed: the program's blocks and the line of each source offset, so a profile need not parse
    the text again. `stops` is the payload of `Debugging` in a debug build.
    """

    __slots__ = ("code", "names", "outline", "problems", "remarks", "stops")

    def __init__(self, code: Code, names: Names, problems: Problems, stops: Stops | None = None) -> None:
        self.code, self.names, self.problems, self.stops = code, names, problems, stops
        self.outline = b""
        self.remarks: list[str] = []


def compile_module(
    module: Module,
    settings: dict[str, object] | None = None,
    ranges: Ranges | None = None,
    debug: bool = False,
    recall: Recall | None = None,
) -> Compiled:
    """Compile a program; raise ProgramError with all errors.

    With `debug` the program counts its statements, and a debugger can stop it. With `recall` the functions that it
    already has are not compiled, so the code is incomplete.
    """
    rename_old_words(module, settings or {})
    problems = Problems(module)
    _mark_faults(module, settings, problems)
    whole = _declared(module, settings, problems, None, "")
    whole.ranges, whole.debugging = ranges, Debugging() if debug else None
    bodies = _new_bodies(whole, recall)
    warn_of_misspellings(whole)
    warn_of_short_ramps(module, problems)
    problems.raise_errors()
    code = assemble(whole, bodies)
    return Compiled(code, whole.names, problems, whole.debugging.payload() if whole.debugging else None)


def _new_bodies(whole: SharedData, recall: Recall | None) -> dict[Function, Body]:
    """Write the functions that are not recalled; report the problems of all functions."""
    if recall is None:
        return {function: _function(whole, function) for function in whole.names.functions}
    names, problems = whole.names, whole.problems
    interfaces, bank = recall.resolve(names), names.default_bank
    facts = (
        whole.axes, whole.supplied, whole.guarded, whole.others, names.uses_axes, names.uses_terminal,
        None if bank is None else bank.name, interfaces.types,
    )  # fmt: skip
    bodies: dict[Function, Body] = {}
    problems.recorder = recall.recorder
    for function in names.functions:
        key = recall.key("compile", function, facts)
        known = recall.find(key)
        if known is not None:
            recall.repeat(known, function, problems.add)
            continue
        recall.recorder.begin()
        bodies[function] = _function(whole, function)
        recall.store(key, function)
    problems.recorder = None
    return bodies


def compile_line(
    module: Module,
    settings: dict[str, object] | None,
    scope: Scope,
    suffix: str,
    file: str,
    of_program: bool = False,
) -> TypedLine:
    """Compile a line typed at a prompt, with the names of `scope`.

    With `of_program` it is a whole program, whose lines may trigger faults of the machine file. Raises
    ProgramError with all errors.
    """
    known_before = dict(scope.names)
    problems = Problems(module)
    if of_program:
        _mark_faults(module, settings, problems)
    with StackSpace():
        whole = _declared(module, settings, problems, scope, suffix)
        bodies = {function: _function(whole, function) for function in whole.names.functions}
        problems.raise_errors()
        return assemble_line(whole, bodies, known_before, file)


def _mark_faults(module: Module, settings: Mapping[str, object] | None, problems: Problems) -> None:
    """Mark the lines at which the machine file triggers a fault."""
    if settings and "fault" in settings:
        from motionlang.mint.compile.line_triggers import mark

        mark(module, settings, problems)


def _declared(
    module: Module, settings: dict[str, object] | None, problems: Problems, scope: Scope | None, suffix: str
) -> SharedData:
    """Declare the names of a module and return the data that its functions share."""
    names = Names(table(), problems, scope)
    names.declare_module(module)
    return SharedData(
        table(), problems, names, range(_number_of_axes(settings)), suffix, words(settings or {})
    )


def _number_of_axes(settings: dict[str, object] | None) -> int:
    count = (settings or {}).get("controller.axes", DEFAULT_AXES)
    return count if isinstance(count, int) else DEFAULT_AXES


# ------------------------------------------------------------------------------------------------ functions


def _function(whole: SharedData, function: Function) -> Body:
    """Write the body of one function."""
    b = Body(whole, function)
    # A failure under ONERROR leaves its statement unfinished, so nothing is certain after it.
    certain = not (whole.guarded or (whole.typed and function is whole.names.main))
    if certain and whole.ranges is not None:
        b.analysed, b.facts = whole.ranges(function)
    if function.jumps:
        b.indent += 1
        jumps.write(b, block)
        b.indent -= 1
        return b
    block(b, function.body)
    b.flush()
    handle_errors(b)
    handler_counters.describe(b)
    is_called = function.plain or b.waits
    if function.result is not None or not is_called:
        leave(b)
    if not is_called:
        b.emit("yield")  # makes the function a generator
    return b


def warn_of_misspellings(whole: SharedData) -> None:
    """Warn of names that are only assigned to and resemble a keyword.

    Such a name may be a typing error, or a variable that an old program no longer uses. A keyword with a number and
    without brackets, as in `OUT3 = 1`, is an error.
    """
    words: Spellings | None = None
    for function in whole.names.functions:
        for symbol in function.scope.names.values():
            if whole.problems.is_full:
                return
            if symbol.kind != "variable" or symbol.declared or symbol.uses > 0 or len(symbol.name) < 3:
                continue
            message, meant = f"{symbol.name} is assigned but never read", bracketed(symbol.name, whole.table)
            if meant is not None:
                hint = f"did you mean {meant}? If it is a variable, declare it with Dim"
                whole.problems.add("unknown-word", message, symbol.at, hint, fix=meant)
                continue
            words = words or Spellings(r.name for r in whole.table if r.simulated and r.kind != "statement")
            near = words.nearest(symbol.name, 0.75)
            if near is not None:
                whole.problems.in_run.add(("unused-variable", symbol.at))
                whole.problems.add(
                    "unused-variable",
                    message,
                    symbol.at,
                    f"did you mean {near}?",
                    "warning",
                    candidates=(near,),
                )


def compile_text(
    source: Source,
    settings: dict[str, object] | None,
    overrides: Mapping[str, float | str] | None,
    given: Mapping[str, bool] | None = None,
    ranges: Ranges | None = None,
    debug: bool = False,
) -> Compiled:
    """Parse and compile a program; raise ProgramError with all errors.

    For `given` see `override`.
    """
    with CollectorOff(), StackSpace():
        module = _parsed(source, settings)
        if overrides or given:
            override(module, overrides or {}, given)
        blocks = blocks_of(module)
        compiled = compile_module(module, settings, ranges, debug)
        compiled.remarks = chosen_rates(module, settings or {})
        compiled.outline = dumps((blocks, [module.line(at) for at in compiled.code.offsets]))
        return compiled


def _parsed(source: Source, settings: dict[str, object] | None) -> Module:
    try:
        return parse(source)
    except ProgramError as error:
        from motionlang.mint.compile.error_recovery import with_other_lines

        raise with_other_lines(source, settings, error) from None

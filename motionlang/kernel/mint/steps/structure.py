"""The structure of a Mint program: its statements from the checked tree, its graph from the steps."""

from __future__ import annotations

from collections.abc import Iterator, Mapping

from motionlang.kernel.lang.machine.machine import Machine
from motionlang.kernel.lang.step_graph import StepGraph
from motionlang.kernel.lang.steps import CALL, Steps
from motionlang.kernel.lang.structure import READ, ChannelUse, Structure, Unit
from motionlang.kernel.lang.wait_causes import KINDS
from motionlang.kernel.mint.keywords.event_kinds import is_timed
from motionlang.kernel.mint.resolve.forms import form
from motionlang.kernel.mint.resolve.handlers import label_handlers, raised_by
from motionlang.kernel.mint.resolve.names import Symbols
from motionlang.kernel.mint.resolve.statements import FactsReader
from motionlang.kernel.mint.resolve.symbols import Function
from motionlang.kernel.mint.runtime.environment import Environment
from motionlang.kernel.mint.steps.places import Places
from motionlang.kernel.mint.steps.program import ProgramWriter
from motionlang.kernel.mint.syntax import nodes
from motionlang.kernel.source import Source


def written(
    source: Source, names: Symbols, settings: Mapping[str, object]
) -> tuple[dict[Function, Steps], dict[int, str]]:
    """Return the steps of the functions of a checked program on a machine with these settings.

    The second result has the names of its shared variables, by their numbers.
    """
    environment = Environment(Machine(dict(settings)), Places())
    environment.prepare()

    def line_of(offset: int) -> int:
        return source.location(offset)[0]

    environment.line_of = line_of
    steps = ProgramWriter(names, environment, line_of, {}).steps
    return steps, environment.places.names()


def graph_of(names: Symbols, steps: Mapping[Function, Steps]) -> StepGraph:
    """Return the graph of the steps of the functions."""
    graph = StepGraph(list(steps.values()))
    last = graph.ranges[names.main.qualified_name][-1]
    graph.points[last] = graph.points[last]._replace(at=-1)  # the end of the text is no statement
    return graph


def structure(
    facts: FactsReader,
    steps: Mapping[Function, Steps],
    graph: StepGraph,
    variables: Mapping[int, str],
) -> Structure:
    """Return the structure of a checked program."""
    units = sorted(_units(steps, graph, facts), key=lambda each: each.line)
    result = Structure(facts.source, facts.statements, graph, units, facts.writes, variables)
    for made in facts.statements.values():
        found = result.waits.at(made.at) if made.waits == "condition" else None
        if found is not None:
            causes = {KINDS[kind] for kind, _ in found.leaves}
            made.waits = causes.pop() if len(causes) == 1 else "condition"
            axes = {number for kind, number in found.leaves if KINDS[kind] == "axis" and number is not None}
            made.what = tuple(sorted(axes))
    return result


def _units(written: Mapping[Function, Steps], graph: StepGraph, reader: FactsReader) -> Iterator[Unit]:
    """Yield the functions, and the labels that a Gosub calls or that handle an event."""
    for function, steps in written.items():
        entry = graph.first(steps)
        line = reader.line(function.at)
        if function.kind == "main":
            yield Unit("program", "program", 0, entry)
        elif function.kind == "event":
            yield _handler(reader, function.name, function.at, entry)
        else:
            sub = function.node if isinstance(function.node, nodes.Sub) else None
            kind = "function" if sub is not None and sub.function else function.kind
            head = (
                ""
                if sub is None or not (sub.parameters or sub.result)
                else form([*sub.parameters, sub.result])
            )
            yield Unit(function.name, kind, line, entry, head=head)
        handlers = label_handlers(function)
        called = {to for index, (_, to) in steps.called.items() if steps[index].kind == CALL and to > 0}
        for index, label in steps.labels.items():
            at = reader.labels.get((function, label.lower()), function.at)
            if label.lower() in handlers:
                yield _handler(reader, label, at, entry + index)
            elif index in called:
                yield Unit(label, "subroutine", reader.line(at), entry + index)


def _handler(reader: FactsReader, name: str, at: int, entry: int) -> Unit:
    """Return a handler, with the channels whose change starts it."""
    triggers = [
        ChannelUse(channel, str(number) if number >= 0 else "?", READ, at)
        for channel, number in raised_by(reader.names, name)
    ]
    return Unit(name, "event", reader.line(at), entry, triggers, is_timed(name), name.lower())

"""A trace as a value change dump, for GTKWave and other wave viewers.

pyvcd writes the format. Digital channels are wires that change at the exact times. Axes are reals at the trace's
rate; unchanged values are not written. The run's events are a string, which GTKWave and Surfer show as text. The
timescale is a nanosecond.
"""

from __future__ import annotations

import codecs
from collections.abc import Callable, Iterator
from heapq import merge
from itertools import groupby
from math import nan
from operator import itemgetter
from typing import IO, TYPE_CHECKING, Any, cast

import numpy as np

from motionlang.kernel.log.records import Event
from motionlang.kernel.tools import need
from motionlang.kernel.tracks.trace import Trace
from motionlang.kernel.version import __version__
from motionlang.views.lanes import lanes

if TYPE_CHECKING:
    from vcd.writer import Variable, VCDWriter

Report = Callable[[float], object]

# Nanoseconds, a variable and its value.
Change = tuple[int, "Variable[Any]", float | str]

PER_SECOND = 10**9


def write_vcd(trace: Trace, file: IO[bytes], rate: float, progress: Report) -> None:
    """Write the values at 0, then every change in chronological order.

    Needs the package pyvcd.
    """
    need("a value change dump", "vcd")
    from vcd.writer import VCDWriter

    text = cast("IO[str]", codecs.getwriter("ascii")(file))
    writer = VCDWriter(text, "1 ns", date="", version=f"motionlang {__version__}")
    # `merge` takes the first change of each before it yields any, so all variables exist before the first change.
    streams = _movements(trace, writer, rate, progress), _switchings(trace, writer), _events(trace, writer)
    for time, variable, value in merge(*streams, key=itemgetter(0)):
        if time and value == variable.value:
            writer.flush()  # the values at 0
            variable.value = nan  # pyvcd omits a value that is equal to the last one
        writer.change(variable, time, value)
    writer.close(round(trace.end * PER_SECOND))


def _events(trace: Trace, writer: VCDWriter) -> Iterator[Change]:
    """Yield the events as strings, each valid until the next.

    Simultaneous events share one string.
    """
    events = trace.controller.log.events
    if not events:
        return
    variable = writer.register_var("events", "event", "string")
    for time, some in groupby(events, lambda event: round(event.time * PER_SECOND)):
        yield time, variable, ",".join(dict.fromkeys(_text_of(event) for event in some))


def _text_of(event: Event) -> str:
    """Return an event without blanks, which are not allowed in strings of this format."""
    axis = "" if event.axis is None else f"_axis{event.axis}"
    value = "" if event.value is None else f"_{event.value:.6g}"
    return event.kind.replace(" ", "_") + axis + value


def _switchings(trace: Trace, writer: VCDWriter) -> Iterator[Change]:
    """Yield the changes of the channels in chronological order."""
    changes: list[Change] = []
    for lane in lanes(trace.controller):
        kind, size = ("wire", 1) if lane.is_digital else ("real", 64)
        variable = writer.register_var(lane.group.replace(" ", "_"), lane.name, kind, size)
        values = [int(value != 0.0) for value in lane.values] if lane.is_digital else lane.values
        changes += [
            (round(time * PER_SECOND), variable, value)
            for time, value in zip(lane.times, values, strict=True)
        ]
    yield from sorted(changes, key=itemgetter(0))


def _movements(trace: Trace, writer: VCDWriter, rate: float, progress: Report) -> Iterator[Change]:
    """Yield the changes from row to row, to a thousandth of a count.

    A value at standstill is repeated in the row before it changes. Viewers draw straight lines between the
    values of a real, and would otherwise draw a slope over the whole standstill.
    """
    columns = trace.columns()[1:]
    variables = [
        writer.register_var(scope, name, "real")
        for scope, _, name in (column.name.partition("_") for column in columns)
    ]
    decimals = [trace.decimals(column) for column in columns]
    before, time_before = np.full(len(columns), np.nan), 0
    written = np.ones(len(columns), dtype=bool)
    total, done = trace.rows(rate), 0
    for chunk in trace.chunks(rate):
        table = np.stack([np.round(values, n) for values, n in zip(chunk.data[1:], decimals, strict=True)], 1)
        table = np.concatenate((before[None], table))
        times = np.concatenate(([time_before], np.rint(chunk.time * PER_SECOND).astype(np.int64)))
        changed = np.concatenate((written[None], table[1:] != table[:-1]))
        # The first row is the last of the previous chunk: only its unwritten values are due.
        shown = changed | np.concatenate((changed[1:], np.zeros((1, len(columns)), dtype=bool)))
        shown[0] &= ~written
        rows, which = np.nonzero(shown)
        values = (table[rows, which] + 0.0).tolist()  # + 0.0 turns -0.0 into 0.0
        for time, k, value in zip(times[rows].tolist(), which.tolist(), values, strict=True):
            yield time, variables[k], value
        before, time_before, written = table[-1], int(times[-1]), changed[-1]
        done += len(chunk)
        progress(done / total)

"""A trace as a value change dump, for GTKWave and other wave viewers.

The format is IEEE 1364, section 18. Digital channels are wires that change at the exact times. Axes are reals
at the trace's rate; unchanged values are not written. The run's events are a string, which GTKWave and Surfer
show as text. The timescale is a nanosecond.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Sequence
from heapq import merge
from itertools import groupby
from operator import itemgetter
from typing import IO

import numpy as np
from numpy.typing import NDArray

from motionlang import __version__
from motionlang.log.records import Event
from motionlang.log.trace import Column, Trace
from motionlang.views.lanes import Lane, lanes

Report = Callable[[float], object]

# Nanoseconds, and a line of the file.
Change = tuple[int, str]

PER_SECOND = 10**9
# Identifiers are numbers in this base, in the characters from "!" on.
_BASE = 94


def write_vcd(trace: Trace, file: IO[bytes], rate: float, progress: Report) -> None:
    """Write the header, the values at 0, then every change in chronological order."""
    columns, channels = trace.columns()[1:], lanes(trace.controller)
    names = [_identifier(i) for i in range(len(columns) + len(channels))]
    events = trace.controller.log.events
    happened = _identifier(len(names)) if events else ""
    file.write(_header(columns, channels, names, happened).encode("ascii"))
    moved = _movements(trace, columns, names[: len(columns)], rate, progress)
    switched = _switchings(channels, names[len(columns) :])
    file.write(b"#0\n$dumpvars\n")
    last = 0
    for time, line in merge(moved, switched, _happened(events, happened), key=itemgetter(0)):
        if time != last:
            line = f"#{time}\n{line}" if last else f"$end\n#{time}\n{line}"
            last = time
        file.write(line.encode("ascii"))
    end = round(trace.end * PER_SECOND)
    file.write(b"" if last else b"$end\n")
    file.write(b"" if end == last else b"#%d\n" % end)


def _header(columns: Sequence[Column], channels: Sequence[Lane], names: Sequence[str], happened: str) -> str:
    """Return the header, with a scope for each axis and kind of channel.

    Events, if there are any, have a scope of their own.
    """
    lines = [f"$version motionlang {__version__} $end", "$timescale 1 ns $end"]
    scopes: dict[str, list[str]] = {}
    for column, name in zip(columns, names, strict=False):
        scope, _, what = column.name.partition("_")
        scopes.setdefault(scope, []).append(f"$var real 64 {name} {what} $end")
    for lane, name in zip(channels, names[len(columns) :], strict=True):
        kind = "wire 1" if lane.is_digital else "real 64"
        scopes.setdefault(lane.group.replace(" ", "_"), []).append(f"$var {kind} {name} {lane.name} $end")
    if happened:
        scopes["events"] = [f"$var string 1 {happened} event $end"]
    for scope, variables in scopes.items():
        lines += [f"$scope module {scope} $end", *variables, "$upscope $end"]
    return "\n".join([*lines, "$enddefinitions $end"]) + "\n"


def _happened(events: Iterable[Event], name: str) -> Iterator[Change]:
    """Return the events as strings, each valid until the next.

    Simultaneous events share one string.
    """
    for time, some in groupby(events, lambda event: round(event.time * PER_SECOND)):
        text = ",".join(dict.fromkeys(_text_of(event) for event in some))
        yield time, f"s{text} {name}\n"


def _text_of(event: Event) -> str:
    """Return an event without blanks, which are not allowed in strings of this format."""
    axis = "" if event.axis is None else f"_axis{event.axis}"
    value = "" if event.value is None else f"_{event.value:.6g}"
    return event.kind.replace(" ", "_") + axis + value


def _switchings(channels: Sequence[Lane], names: Sequence[str]) -> Iterator[Change]:
    """Return the changes of the channels in chronological order."""
    changes = [
        (round(time * PER_SECOND), f"{int(value != 0.0)}{name}\n" if lane.is_digital else _real(value, name))
        for lane, name in zip(channels, names, strict=True)
        for time, value in zip(lane.times, lane.values, strict=True)
    ]
    return iter(sorted(changes, key=itemgetter(0)))


def _movements(
    trace: Trace, columns: Sequence[Column], names: Sequence[str], rate: float, progress: Report
) -> Iterator[Change]:
    """Return the changes from row to row, to a thousandth of a count.

    A value at standstill is repeated in the row before it changes. Viewers draw straight lines between the
    values of a real, and would otherwise draw a slope over the whole standstill.
    """
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
        for time, k, value in zip(
            times[rows].tolist(), which.tolist(), _plain(table[rows, which]), strict=True
        ):
            yield time, _real(value, names[k])
        before, time_before, written = table[-1], int(times[-1]), changed[-1]
        done += len(chunk)
        progress(done / total)


def _plain(values: NDArray[np.float64]) -> list[float]:
    """Return the values, with -0.0 replaced by 0.0."""
    plain: list[float] = (values + 0.0).tolist()
    return plain


def _real(value: float, name: str) -> str:
    return f"r{value!r} {name}\n"


def _identifier(number: int) -> str:
    text = ""
    while not text or number:
        number, digit = divmod(number, _BASE)
        text += chr(33 + digit)
    return text

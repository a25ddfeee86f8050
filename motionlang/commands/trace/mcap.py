"""A trace as an MCAP file, for PlotJuggler and Foxglove.

It has the motion, the channels and the activity of the program. Messages are JSON, each with a JSON schema.
There is one topic per axis at the trace's rate, and one per channel with each change. `/program` names the
program line of each move and phase. Times are machine times.
"""

from __future__ import annotations

import json
from collections.abc import Callable, Iterator, Mapping
from heapq import merge
from operator import itemgetter
from typing import IO, Any

from motionlang.kernel import Trace
from motionlang.kernel.tools import need
from motionlang.kernel.tracks import TraceColumn
from motionlang.kernel.version import __version__
from motionlang.views.lanes import lanes
from motionlang.views.terminal import printable

Report = Callable[[float], object]
# Nanoseconds, the number of the topic, and the message.
Message = tuple[int, int, bytes]

PER_SECOND = 10**9
_TEXTS = {"line": "integer", "command": "string", "state": "string", "axis": "integer"}


def write_mcap(trace: Trace, file: IO[bytes], rate: float, progress: Report) -> None:
    """Write all messages in chronological order.

    Needs the package mcap.
    """
    need("an MCAP file", "mcap")
    from mcap.writer import CompressionType, Writer

    writer = Writer(file, compression=CompressionType.ZSTD)
    writer.start(profile="", library=f"motionlang {__version__}")
    topics = _Topics(writer)
    streams = [
        _motion(trace, rate, topics, progress),
        _channels(trace, topics),
        _program(trace, topics),
        _events(trace, topics),
    ]
    for sequence, (time, topic, message) in enumerate(merge(*streams, key=itemgetter(0))):
        writer.add_message(
            channel_id=topic, log_time=time, publish_time=time, data=message, sequence=sequence & 0xFFFFFFFF
        )
    writer.finish()  # type: ignore[no-untyped-call]


class _Topics:
    """Topics, created on first use, each with its own schema."""

    def __init__(self, writer: Any) -> None:
        self._writer = writer

    def add(self, name: str, fields: Mapping[str, str]) -> int:
        """Return the number of a new topic whose messages have `fields`.

        `fields` maps names to JSON types.
        """
        schema = {"type": "object", "properties": {field: {"type": kind} for field, kind in fields.items()}}
        number = self._writer.register_schema(
            name=name.strip("/"), encoding="jsonschema", data=json.dumps(schema).encode()
        )
        topic: int = self._writer.register_channel(topic=name, message_encoding="json", schema_id=number)
        return topic


def _motion(trace: Trace, rate: float, topics: _Topics, progress: Report) -> Iterator[Message]:
    """Return a message per axis and row.

    Names include units, like the columns of a CSV file.
    """
    columns = trace.columns()[1:]
    groups: dict[str, list[tuple[int, str]]] = {}
    for index, column in enumerate(columns):
        axis, field = _named(column)
        groups.setdefault(axis, []).append((index, field))
    numbers = [topics.add(f"/{axis}", {field: "number" for _, field in of}) for axis, of in groups.items()]
    total, done = trace.rows(rate), 0
    for chunk in trace.chunks(rate):
        rows = zip(*(values.tolist() for values in chunk.data), strict=True)
        for time, *values in rows:
            at = round(time * PER_SECOND)
            for number, fields in zip(numbers, groups.values(), strict=True):
                text = ",".join(f'"{field}":{values[index] + 0.0!r}' for index, field in fields)
                yield at, number, f"{{{text}}}".encode()
        done += len(chunk)
        progress(done / total)


def _named(column: TraceColumn) -> tuple[str, str]:
    axis, _, field = column.name.partition("_")
    return axis, field


def _channels(trace: Trace, topics: _Topics) -> Iterator[Message]:
    found: list[Message] = []
    for lane in lanes(trace.controller):
        number = topics.add(f"/{lane.group.replace(' ', '_')}/{lane.name}", {"value": "number"})
        for time, value in zip(lane.times, lane.values, strict=True):
            found.append((round(time * PER_SECOND), number, json.dumps({"value": value}).encode()))
    return iter(sorted(found))


def _events(trace: Trace, topics: _Topics) -> Iterator[Message]:
    """Return limits, faults, clamps and jumps; docs/events.md lists the kinds."""
    fields = {"kind": "string", "axis": "integer", "value": "number", "limit": "number", "text": "string"}
    number = topics.add("/events", fields)
    for event in trace.controller.log.events:
        about = {"kind": event.kind, "axis": event.axis, "value": event.value, "limit": event.limit}
        message = {name: value for name, value in about.items() if value is not None} | {"text": event.text}
        yield round(event.time * PER_SECOND), number, json.dumps(message).encode()


def _program(trace: Trace, topics: _Topics) -> Iterator[Message]:
    """Return the activity of each axis over time.

    A message has the move and its phase, or the end of a move.
    """
    number = topics.add("/program", _TEXTS)
    found: list[tuple[float, int, int, str, str]] = []
    for move in trace.controller.log.moves:
        profile, time = move.profile, move.start_time
        about = move.axis, move.line, printable(move.command or "move")
        for phase in profile.phases if profile is not None else ():
            if time <= trace.end:
                found.append((time, *about, phase.name))
            time += phase.duration
        if time <= trace.end:
            found.append((time, *about, "end"))
    for time, axis, line, command, state in sorted(found):
        message = {"axis": axis, "line": line, "command": command, "state": state}
        yield round(time * PER_SECOND), number, json.dumps(message).encode()

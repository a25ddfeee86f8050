"""`motionlang trace`: sample the motion of a run into a file."""

from __future__ import annotations

import sys
from dataclasses import dataclass
from typing import ClassVar

from motionlang.cli.command import argument, flag, option
from motionlang.cli.readers import columns, real
from motionlang.cli.run_to_file import RunToFile
from motionlang.kernel import Run as Result
from motionlang.kernel.tools import need
from motionlang.views.lanes import ChannelLane, lanes
from motionlang.views.progress import Progress

TRACES = (".csv", ".npz", ".parquet")
RATE = 1000.0
# What a value takes in a file, in bytes, and the size from which a trace says how large it becomes.
BYTES, LARGE = 10, 100e6
HERTZ = real("a rate above 0 and up to 10,000,000 samples per second", 0.0, 10e6, above=True)


@dataclass
class TraceCommand(RunToFile):
    """Sample the motion of a run into a file."""

    title: ClassVar[str] = "trace"
    epilog: ClassVar[str] = """\
examples:
  motionlang trace pick.mnt pick.csv --rate 500 --columns position,velocity.0
  motionlang trace pick.mnt log.csv --columns position --channels   as a logger
"""
    out: str = argument("OUT", "the file to write", suffixes=TRACES)
    rate: float = option("HZ", f"samples per second ({RATE:.10g})", read=HERTZ, default=RATE)
    columns: list[str] | None = option(
        "NAME,…",
        "the columns in addition to time, for every axis or for one, such as position,velocity.0",
        read=columns,
    )
    channels: bool = flag("add a column for each input and output, such as in3, out9 and ain0")

    def prepare(self) -> None:
        super().prepare()
        need("motionlang trace", "numpy")

    def write(self, result: Result) -> None:
        from motionlang.commands.trace.export import write_trace

        trace, rate = result.trace, self.rate
        if self.columns is not None:
            trace.choose(self.columns)
        size = trace.rows(rate) * len(trace.columns()) * BYTES
        if size > LARGE:
            sys.stderr.write(f"note: {trace.rows(rate):,} rows, some {size / 1e6:,.0f} MB\n")
        progress = Progress(sys.stderr, self.out)
        try:
            write_trace(trace, self.out, rate, progress, _wired(result) if self.channels else ())
        finally:
            progress.done()


def _wired(result: Result) -> list[ChannelLane]:
    """Return the channels of a run that changed, and the inputs that its program reads and that stayed off."""
    found = {(each.group, each.number): each for each in lanes(result.controller)}
    program = result.program or result.dialect.program(result.source)
    for _, use in program.structure.inputs():
        if use.channel == "input" and use.number.isdecimal():
            key = "inputs", int(use.number)
            found.setdefault(key, ChannelLane(*key, [0.0], [0.0]))
    return [found[key] for key in sorted(found)]

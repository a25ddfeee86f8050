"""Trace files, written chunk by chunk in bounded memory.

The file extension selects one of the writers.
"""

from __future__ import annotations

import codecs
import csv
import os
from collections.abc import Callable, Sequence
from typing import IO
from zipfile import ZipFile, ZipInfo

import numpy as np
from numpy.typing import NDArray

from motionlang.kernel import Trace
from motionlang.kernel.files import replacing
from motionlang.kernel.tools import need
from motionlang.views.lanes import ChannelLane

Array = NDArray[np.float64]
Report = Callable[[float], object]
# Decimals of an analogue channel in a text.
ANALOGUE_DECIMALS = 6


def write_trace(
    trace: Trace,
    path: str,
    rate: float = 1000.0,
    progress: Report = lambda fraction: None,
    lanes: Sequence[ChannelLane] = (),
) -> int:
    """Sample `trace` at `rate` (Hz) into `path`, and `lanes` as further columns; return the number of rows.

    The extension of `path` selects the format. `progress` is called with the completed fraction. Raises OSError, and
    leaves no incomplete file behind.
    """
    with replacing(path) as file:
        _WRITERS[os.path.splitext(path)[1].lower()](trace, file, rate, progress, lanes)
    return trace.rows(rate)


def _levels(lane: ChannelLane, times: Array) -> Array:
    """Return the values of a channel at some times; a change counts from its time on."""
    return np.array(lane.values)[np.searchsorted(lane.times, times, "right") - 1]


def _write_csv(
    trace: Trace, file: IO[bytes], rate: float, progress: Report, lanes: Sequence[ChannelLane]
) -> None:
    """Write a header with names and units, then the values with the decimals of their columns."""
    columns = trace.columns()
    decimals = [trace.decimals(column) for column in columns]
    decimals += [0 if lane.is_digital else ANALOGUE_DECIMALS for lane in lanes]
    # "z" writes a number that rounds to zero without a sign.
    formats = [f"{{:z.{each}f}}".format for each in decimals]
    writer = csv.writer(codecs.getwriter("ascii")(file), lineterminator="\n")
    writer.writerow([*(column.name for column in columns), *(lane.name for lane in lanes)])
    total, done = trace.rows(rate), 0
    for chunk in trace.chunks(rate):
        data = [*chunk.data, *(_levels(lane, chunk.time) for lane in lanes)]
        cells = [map(shown, values.tolist()) for shown, values in zip(formats, data, strict=True)]
        writer.writerows(zip(*cells, strict=True))
        done += len(chunk)
        progress(done / total)


def _write_npz(
    trace: Trace, file: IO[bytes], rate: float, progress: Report, lanes: Sequence[ChannelLane]
) -> None:
    """Write the same file as `np.savez`, one chunk at a time and deterministically."""
    columns, total = trace.columns(), trace.rows(rate)
    work = total * (len(columns) + len(lanes))
    done = 0
    header = {"descr": "<f8", "fortran_order": False, "shape": (total,)}
    with ZipFile(file, "w") as archive:
        for column in columns:
            with archive.open(_entry(column.name), "w", force_zip64=True) as out:
                np.lib.format.write_array_header_1_0(out, header)
                axes = () if column.axis is None else (column.axis,)
                for chunk in trace.chunks(rate, axes, quantities=(column.quantity,) if axes else ()):
                    out.write(chunk.data[-1].astype("<f8", copy=False).tobytes())
                    done += len(chunk)
                    progress(done / work)
        for lane in lanes:
            with archive.open(_entry(lane.name), "w", force_zip64=True) as out:
                np.lib.format.write_array_header_1_0(out, header)
                for chunk in trace.chunks(rate, (), quantities=()):
                    out.write(_levels(lane, chunk.time).tobytes())
                    done += len(chunk)
                    progress(done / work)


def _entry(name: str) -> ZipInfo:
    return ZipInfo(f"{name}.npy", (1980, 1, 1, 0, 0, 0))


def _write_parquet(
    trace: Trace, file: IO[bytes], rate: float, progress: Report, lanes: Sequence[ChannelLane]
) -> None:
    """Write one row group per chunk, with the unit of each column as metadata.

    Needs pyarrow.
    """
    need("a Parquet file", "pyarrow")
    import pyarrow as arrow  # type: ignore[import-untyped]
    from pyarrow.parquet import ParquetWriter  # type: ignore[import-untyped]

    units = {column.name: column.unit for column in trace.columns()}
    units |= {lane.name: "" if lane.is_digital else "%" for lane in lanes}
    schema = arrow.schema(
        [
            arrow.field(name, arrow.float64(), nullable=False, metadata={"unit": unit})
            for name, unit in units.items()
        ]
    )
    total, done = trace.rows(rate), 0
    with ParquetWriter(file, schema) as writer:
        for chunk in trace.chunks(rate):
            # Copied, because the next chunk reuses the same arrays.
            data = [*chunk.data, *(_levels(lane, chunk.time) for lane in lanes)]
            writer.write_table(arrow.table([values.copy() for values in data], schema=schema))
            done += len(chunk)
            progress(done / total)


_WRITERS = {".csv": _write_csv, ".npz": _write_npz, ".parquet": _write_parquet}

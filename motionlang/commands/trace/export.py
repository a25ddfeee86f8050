"""Trace files, written chunk by chunk in bounded memory.

`--trace OUT` selects one of `_WRITERS` by file extension.
"""

from __future__ import annotations

import codecs
import csv
import os
from collections.abc import Callable
from typing import IO
from zipfile import ZipFile, ZipInfo

import numpy as np

from motionlang.commands.trace.mcap import write_mcap
from motionlang.commands.trace.vcd import write_vcd
from motionlang.kernel.files import replacing
from motionlang.kernel.tools import need
from motionlang.kernel.tracks.trace import Trace

Report = Callable[[float], object]


def write_trace(
    trace: Trace, path: str, rate: float = 1000.0, progress: Report = lambda fraction: None
) -> int:
    """Sample `trace` at `rate` (Hz) into `path`; return the number of rows.

    The extension of `path` selects the format. `progress` is called with the completed fraction. Raises OSError,
    and leaves no incomplete file behind.
    """
    write = _WRITERS[os.path.splitext(path)[1].lower()]
    with replacing(path) as file:
        write(trace, file, rate, progress)
    return trace.rows(rate)


def _write_csv(trace: Trace, file: IO[bytes], rate: float, progress: Report) -> None:
    """Write a header with names and units, then the values with the decimals of their columns."""
    columns = trace.columns()
    # "z" writes a number that rounds to zero without a sign.
    formats = [f"{{:z.{trace.decimals(column)}f}}".format for column in columns]
    writer = csv.writer(codecs.getwriter("ascii")(file), lineterminator="\n")
    writer.writerow(column.name for column in columns)
    total, done = trace.rows(rate), 0
    for chunk in trace.chunks(rate):
        cells = [map(shown, values.tolist()) for shown, values in zip(formats, chunk.data, strict=True)]
        writer.writerows(zip(*cells, strict=True))
        done += len(chunk)
        progress(done / total)


def _write_npz(trace: Trace, file: IO[bytes], rate: float, progress: Report) -> None:
    """Write the same file as `np.savez`, one chunk at a time and deterministically."""
    columns, total = trace.columns(), trace.rows(rate)
    work = total * len(columns)
    done = 0
    with ZipFile(file, "w") as archive:
        for column in columns:
            with archive.open(_entry(column.name), "w", force_zip64=True) as out:
                np.lib.format.write_array_header_1_0(
                    out, {"descr": "<f8", "fortran_order": False, "shape": (total,)}
                )
                axes = () if column.axis is None else (column.axis,)
                for chunk in trace.chunks(rate, axes, quantities=(column.quantity,) if axes else ()):
                    out.write(chunk.data[-1].astype("<f8", copy=False).tobytes())
                    done += len(chunk)
                    progress(done / work)


def _entry(name: str) -> ZipInfo:
    return ZipInfo(f"{name}.npy", (1980, 1, 1, 0, 0, 0))


def _write_parquet(trace: Trace, file: IO[bytes], rate: float, progress: Report) -> None:
    """Write one row group per chunk, with the unit of each column as metadata.

    Needs pyarrow.
    """
    need("a Parquet file", "pyarrow")
    import pyarrow as arrow  # type: ignore[import-untyped]
    from pyarrow.parquet import ParquetWriter  # type: ignore[import-untyped]

    schema = arrow.schema(
        [
            arrow.field(column.name, arrow.float64(), nullable=False, metadata={"unit": column.unit})
            for column in trace.columns()
        ]
    )
    total, done = trace.rows(rate), 0
    with ParquetWriter(file, schema) as writer:
        for chunk in trace.chunks(rate):
            # Copied, because the next chunk reuses the same arrays.
            writer.write_table(arrow.table([values.copy() for values in chunk.data], schema=schema))
            done += len(chunk)
            progress(done / total)


_WRITERS = {
    ".csv": _write_csv,
    ".mcap": write_mcap,
    ".npz": _write_npz,
    ".parquet": _write_parquet,
    ".vcd": write_vcd,
}

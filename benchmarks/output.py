"""The cost of a run's output: reports, traces as CSV and npz, a chart, a picture.

The run has 20 000 moves. Prints `name value unit`. Ratios compare times within one run, the best of several
interleaved rounds.
"""

from __future__ import annotations

import gc
import io
import os
import sys
import tempfile
from functools import partial
from time import perf_counter, process_time
from typing import TYPE_CHECKING

import numpy as np

from motionlang import report
from motionlang.lang.dialect import Dialect
from motionlang.lang.machine.machine import Machine
from motionlang.result import Run
from motionlang.source import Source
from motionlang.views.chart import velocity_chart
from motionlang.views.csv import Formatter
from motionlang.views.export import write_trace
from motionlang.views.outline import outline
from motionlang.views.scope import page
from motionlang.views.table import render

if TYPE_CHECKING:
    from collections.abc import Callable

ROWS = 200_000
MOVES = 20_000
SHIFT = 8 * 3600.0


class Nameless(Dialect):
    """A dialect without a language: its moves are loaded directly into the controller.

    The cost of the language is measured elsewhere.
    """

    name = "mint"


def shift() -> Run:
    """Return a run of 20 000 different moves of four axes in eight hours."""
    machine = Machine({"controller.axes": 4})
    run = Run(Source("shift.mnt", ""), Nameless(), machine)
    controller = run.controller
    lengths = np.random.default_rng(3).uniform(-50_000.0, 50_000.0, MOVES).tolist()
    for axis in range(4):
        controller.set_scale(axis, 1200.0)
    for i, length in enumerate(lengths):
        controller.move_by(i % 4, length, "MOVER", 5)
        controller.clock.advance((i + 1) * SHIFT / MOVES)
    run.time = controller.clock.now
    return run


def columns() -> list[np.ndarray]:
    """Return time, three waves and noise as columns, with a row per millisecond."""
    t = np.arange(ROWS) * 1e-3
    waves = [500 * np.sin(t * 0.7) + 3, 350 * np.cos(t * 0.7), -245 * np.sin(t * 0.7)]
    return [t, *waves, np.random.default_rng(0).normal(0.0, 1.0, ROWS)]


def best(rounds: int, jobs: dict[str, Callable[[], object]]) -> dict[str, float]:
    """Return the best time of each job in seconds; the jobs alternate for `rounds`."""
    times = dict.fromkeys(jobs, float("inf"))
    for _ in range(rounds):
        for name, job in jobs.items():
            gc.collect()
            begin = perf_counter()
            job()
            times[name] = min(times[name], perf_counter() - begin)
    return times


def measure_csv() -> None:
    """Compare the CSV formatter with `np.savetxt`, both to memory with six decimals."""
    data = columns()
    table = np.stack(data, axis=1)
    first_rows = table[: ROWS // 10]
    formatter = Formatter([6] * len(data))
    times = best(
        7,
        {
            "csv": lambda: formatter.lines(data),
            "savetxt": lambda: np.savetxt(io.BytesIO(), first_rows, fmt="%.6f", delimiter=","),
        },
    )
    ours, theirs = times["csv"] / ROWS, times["savetxt"] / len(first_rows)
    print(f"output.csv {ours * 1e9:.0f} ns/row")
    print(f"output.savetxt {theirs * 1e9:.0f} ns/row")
    print(f"output.savetxt_over_csv {theirs / ours:.1f} x")


def measure_report(run: Run) -> None:
    """Measure the report of the shift, as JSON and as a table."""
    times = best(5, {"json": lambda: report.text(run), "table": lambda: render(run, charts=True)})
    print(f"output.report_json_20000_moves {times['json']:.3f} s")
    print(f"output.report_table_20000_moves {times['table']:.3f} s")


def measure_trace(run: Run) -> None:
    """Measure sampling the motion of four axes and writing it to files.

    The columns are position, velocity and acceleration.
    """
    trace = run.trace
    for axis in trace.axes:
        trace.table(axis)
    rate = 10.0
    rows = trace.rows(rate)
    with tempfile.TemporaryDirectory() as folder:
        paths = {name: os.path.join(folder, f"shift.{name}") for name in ("csv", "npz", "vcd")}
        jobs: dict[str, Callable[[], object]] = {
            name: partial(write_trace, trace, path, rate) for name, path in paths.items()
        }
        jobs["csv_as_controller"] = lambda: write_trace(trace.as_controller(rate), paths["csv"], rate)
        times = best(3, jobs)
    for name, seconds in times.items():
        print(f"output.trace_{name} {seconds / rows * 1e9:.0f} ns/row")


def measure_five_columns(run: Run) -> None:
    """Measure writing twenty minutes of the shift as CSV at 1 kHz, five columns.

    They are time and four quantities, selected as by --columns.
    """
    trace = run.trace
    trace.end = 1200.0
    trace.choose(["position.0", "velocity.0", "position.1", "velocity.1"])
    with tempfile.TemporaryDirectory() as folder:
        path = os.path.join(folder, "shift.csv")
        best_time = min(_processor(lambda: write_trace(trace, path, 1000.0)) for _ in range(5))
    print(f"output.csv_five_columns {best_time / 1_200_000 * 1e9:.0f} ns/row")
    print(f"output.csv_five_columns_speed {1200.0 / best_time:.0f} x_real_time")


def _processor(job: Callable[[], object]) -> float:
    began = process_time()
    job()
    return process_time() - began


def measure_pictures(run: Run) -> None:
    """Measure a chart for the terminal, an outline, the scope page and the picture."""
    trace, axis = run.trace, run.controller.axes[0]
    trace.table(0)
    jobs: dict[str, Callable[[], object]] = {
        "chart": lambda: velocity_chart(axis, run.time, width=100, height=6),
        "outline": lambda: outline(trace, 0, "velocity"),
        "scope_page": lambda: page(run),
    }
    with tempfile.TemporaryDirectory() as folder:
        try:
            from motionlang.views.plot import write_plot

            write_plot(run, os.path.join(folder, "warm.png"))
            jobs["plot_png"] = lambda: write_plot(run, os.path.join(folder, "shift.png"))
        except ImportError:
            print("matplotlib is missing: no plot measured", file=sys.stderr)
        for name, seconds in best(3, jobs).items():
            print(f"output.{name}_20000_moves {seconds * 1e3:.1f} ms")


def main() -> None:
    """Measure and print."""
    measure_csv()
    run = shift()
    measure_report(run)
    measure_trace(run)
    measure_five_columns(run)
    measure_pictures(run)


if __name__ == "__main__":
    main()

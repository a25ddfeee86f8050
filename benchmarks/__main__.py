"""Run the benchmarks and compare each figure with its target.

Usage: `python -m benchmarks [--halfway | --prove] [NAME …]`.

A benchmark is a file in this folder that prints lines of `name value unit`. The figures that matter are ratios
within one run, to a peer, a limit or an alternative; `BARS` has their targets. The exit status is 1 if a
target is missed. With `--halfway` it is 1 only if one is missed by more than a factor of two, so that a loaded
machine passes, too. With `--prove` no figures are printed: every run is proved, which shows that the measured
programs observe their limits.
"""

from __future__ import annotations

import os
import subprocess
import sys
from pathlib import Path
from typing import NamedTuple

from rich.console import Console
from rich.table import Table

# The benchmarks are scripts that import one another from their own folder.
sys.path.append(str(Path(__file__).parent))
from growth import GROWTH

FOLDER = Path(__file__).parent
# Order: the ones that take seconds first.
NAMES = ("loop", "keywords", "mccl", "shift", "start", "compile", "parse", "poll", "sweep", "diff", "plan",
         "sample", "output", "servo", "serve", "mcapi", "pvt", "watches", "cycle", "events", "editor", "growth",
         "debug", "proof")  # fmt: skip


class Bar(NamedTuple):
    """The target of a figure: a minimum or a maximum."""

    at_least: bool
    value: float

    def holds(self, figure: float, slack: float = 1.0) -> bool:
        """True if a figure meets the target; `slack` 2 allows a factor of two."""
        return figure * slack >= self.value if self.at_least else figure <= self.value * slack


def _least(value: float) -> Bar:
    return Bar(True, value)


def _most(value: float) -> Bar:
    return Bar(False, value)


BARS: dict[str, Bar] = {
    # MCAPI against ASCII MCCL, and the replay of a log.
    "mcapi_read_over_1tp": _most(1.3),
    "mcapi_20_hosts_least_share": _least(0.8),
    "mcapi_next_to_a_wait": _least(0.9),
    "mcapi_virtual_over_1tp": _most(0.7),
    "mcapi_replay": _least(8_000.0),
    "mcapi_replay_memory_growth": _most(20.0),
    # Loops against equal loops in Python.
    "loop_declared": _most(1.0),
    "loop_undeclared": _most(1.0),
    "loop_while": _most(2.0),
    "loop_shared": _most(2.0),
    "loop_four_tasks": _most(1.1),
    # A statement against reading POS of an axis at rest.
    "keyword_inx": _most(1.2),
    "keyword_adc": _most(1.5),
    "keyword_outx": _most(1.5),
    "keyword_time": _most(0.75),
    # Text to code, against CPython and Lark; ms a kB.
    "parse": _most(5.0),
    "parse_growth": _most(1.3),
    "mccl_parse": _most(60.0),
    "mccl_known": _most(80.0),
    # Nine parts of it are Lark's.
    "compile_runnable": _most(13.0),
    "compile_everything": _most(15.0),
    "compile_over_cached_load": _least(80.0),
    # Typing in an editor, 10 000 lines, against their parse.
    "editor_key": _most(0.1),
    "editor_key_95": _most(0.5),
    "editor_names": _most(2.2),
    "editor_formatting": _most(0.2),
    "editor_check_after_a_key": _most(6.0),
    "editor_tokens_of_60_lines": _most(0.15),
    "editor_memory": _most(1.1),
    # A process against an empty Python.
    "start_cached": _most(3.0),
    "start_import": _most(1.3),
    "start_first_sight": _most(15.0),
    "start_table": _most(5.5),
    "start_first_sight_table": _most(15.0),
    "start_hello": _most(2.5),
    "start_check": _most(17.0),
    "start_keywords": _most(5.0),
    # Machine time against CPU time.
    "shift_speed": _least(250_000.0),
    "shift_core_speed": _least(500_000.0),
    "shift_travel": _most(8.0),
    "shift_four_tasks": _most(10.0),
    "shift_wait": _most(0.2),
    "shift_move_and_pause": _most(5.0),
    # Debug builds against plain ones; a step back against running as far.
    "debug_moves": _most(1.15),
    "debug_poll": _most(1.15),
    "debug_mccl": _most(1.15),
    "debug_loop": _most(6.0),
    "debug_step_back": _most(1.2),
    "poll_stands": _least(20_000.0),
    "poll_error": _least(20_000.0),
    "poll_jog_panel": _least(20_000.0),
    "poll_cut_to_length": _least(20_000.0),
    "poll_maximum": _least(5_000.0),
    "poll_top_speed": _least(5_000.0),
    "poll_counter": _least(5_000.0),
    "poll_copy": _least(5_000.0),
    "poll_left_alone_display": _least(0.95),
    "poll_left_alone_mean": _least(0.95),
    "poll_left_alone_cam_switch": _least(0.95),
    "poll_left_alone_clock": _least(0.95),
    "poll_left_alone_sum": _least(0.95),
    "poll_left_alone_line": _least(0.95),
    "poll_32_tasks_reading": _most(2.0),
    "poll_32_tasks_writing": _most(2.0),
    "poll_32_tasks_beside_moves": _most(2.0),
    "watches_thousand": _most(3.0),
    "quantised-real-time": _least(80.0),
    "both-real-time": _least(80.0),
    "simulate-real-time": _least(500.0),
    "quantised-in-a-run": _least(80.0),
    "linear-in-a-run": _least(200.0),
    "suggestion": _most(20.0),
    # An S-curve from motion against one from rest, and against ruckig if that is installed.
    "plan.from_velocity_over_rest": _most(3.0),
    "plan.from_acceleration_over_rest": _most(5.0),
    "plan.from_rest_over_ruckig": _most(5.0),
    "plan.from_velocity_over_ruckig": _most(10.0),
    "plan.from_acceleration_over_ruckig": _most(20.0),
    # Sampling against filling an array, a table of numbers against NumPy's.
    "sample.one_profile_over_fill": _most(5.0),
    "sample.table_of_2000_moves_over_fill": _most(25.0),
    "output.savetxt_over_csv": _least(8.0),
    "output.csv_five_columns_speed": _least(6_500.0),
    # Sweeps against a bare run and against a loop in a shell.
    "sweep_variant_by_bare_run": _most(1.3),
    "sweep_thousand": _most(1.2),
    "sweep_faster_than_shell": _least(50.0),
    "diff_way_motion": _most(2.0),
    "diff_command": _most(2.0),
    # The cost of the reports of a run.
    "events_quiet": _most(1.03),
    "cycle_by_run_and_table": _most(1.1),
    "cycle_by_run_and_json": _most(1.1),
    "cycle_command": _most(1.1),
    # The exponent by which calls grow with the size of a program.
    **{f"growth_{stage}_{name}": _most(1.1) for stage, names in GROWTH.items() for name in names.split()},
    # The time of a proof of twice the run.
    "proof_168_over_82": _most(2.2),
}


def ran(name: str, *further: Path) -> subprocess.CompletedProcess[str]:
    """Run a benchmark in a separate process, with additional import folders.

    Raises CalledProcessError if it fails.
    """
    path = os.pathsep.join(map(str, (*further, FOLDER.parent, FOLDER)))
    return subprocess.run(
        [sys.executable, str(FOLDER / f"{name}.py")],
        capture_output=True,
        text=True,
        check=True,
        env=os.environ | {"PYTHONPATH": path},
    )


def figures(name: str) -> dict[str, tuple[float, str]]:
    """Return the output of one benchmark: value and unit by name.

    Raises CalledProcessError if it fails.
    """
    found = {}
    for line in ran(name).stdout.splitlines():
        label, _, rest = line.partition(" ")
        value, _, unit = rest.strip().partition(" ")
        try:
            found[label] = float(value.replace(",", "")), unit
        except ValueError:
            continue
    return found


def prove(names: list[str]) -> int:
    """Prove every run of the named benchmarks; return 1 if a proof fails."""
    failed = 0
    for name in names:
        try:
            lines = ran(name, FOLDER / "proved").stderr.strip().splitlines()
        except subprocess.CalledProcessError as error:
            lines, failed = error.stderr.strip().splitlines(), 1
        print(f"{name}: {lines[-1] if lines else 'no run of a program'}", flush=True)
    return failed


def main(names: list[str]) -> int:
    """Run the named benchmarks, or all; print a table after each; return the status."""
    slack = 1.0
    if "--halfway" in names:
        slack, os.environ["BENCHMARKS_HALFWAY"] = 2.0, "1"
    to_prove = "--prove" in names
    names = [name for name in names if name not in ("--halfway", "--prove")]
    unknown = [name for name in names if name not in NAMES]
    if unknown:
        sys.stderr.write(f"there is no benchmark {unknown[0]}: {', '.join(NAMES)}\n")
        return 2
    if to_prove:
        return prove(names or list(NAMES))
    console, short = Console(), []
    for name in names or NAMES:
        try:
            found = figures(name)
        except subprocess.CalledProcessError as error:
            sys.stderr.write(f"{name}: {error.stderr.strip().splitlines()[-1]}\n")
            short.append(name)
            continue
        table = Table("figure", "measured", "unit", "bar", "", title=name, title_justify="left", box=None)
        for label, (value, unit) in found.items():
            bar = BARS.get(label)
            text = "" if bar is None else f"{'at least' if bar.at_least else 'at most'} {bar.value:g}"
            verdict = "" if bar is None else "reached" if bar.holds(value) else "[red]short of it[/]"
            if bar is not None and not bar.holds(value, slack):
                short.append(label)
            table.add_row(label, f"{value:g}", unit, text, verdict)
        console.print(table)
        console.print()
    if short:
        console.print(f"short of their bars: {', '.join(short)}")
    return 1 if short else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))

"""The cost of `run --profile` for a shift of eight hours, run and reported.

Ratios within one process compare the best of several interleaved rounds, in CPU time; the collector is off, as
in a separate process. `cycle_command` compares complete processes, `run shift.mnt` with and without
`--profile`. `cycle_command_json` compares the JSON report alone with the report plus the profile in a file.
Both are the median of the ratios of pairs.
"""

from __future__ import annotations

import gc
import os
import tempfile
from itertools import pairwise
from time import process_time

from shift import PROGRAM
from start import command
from start import seconds as process_seconds

from motionlang.analysis.cycle.profile import TimeProfile
from motionlang.execution import run
from motionlang.report import text
from motionlang.source import Source
from motionlang.views.cycle import render_profile
from motionlang.views.table import render

ROUNDS, PAIRS = 9, 9


def main() -> None:
    """Print `name value unit` lines."""
    best = dict.fromkeys(("run", "table", "json", "profile"), float("inf"))
    for _ in range(ROUNDS):
        gc.collect()
        gc.disable()
        marks = [process_time()]
        ran = run(Source("shift.mnt", PROGRAM), cache=False)
        marks.append(process_time())
        render(ran)
        marks.append(process_time())
        text(ran)
        marks.append(process_time())
        render_profile(TimeProfile(ran))
        marks.append(process_time())
        gc.enable()
        for name, (begin, end) in zip(best, pairwise(marks), strict=True):
            best[name] = min(best[name], end - begin)
    print(f"cycle_profile {best['profile']:.3f} s")
    print(f"cycle_by_run_and_table {1.0 + best['profile'] / (best['run'] + best['table']):.3f} x")
    print(f"cycle_by_run_and_json {1.0 + best['profile'] / (best['run'] + best['json']):.3f} x")
    for name, ratio in whole().items():
        print(f"{name} {ratio:.3f} x")


def whole() -> dict[str, float]:
    """Return the CPU time of complete processes with the profile, by that without."""
    with tempfile.TemporaryDirectory() as folder:
        environment = {**os.environ, "MOTIONLANG_CACHE": folder, "PYTHONPYCACHEPREFIX": f"{folder}/pyc"}
        environment.pop("PYTHONDONTWRITEBYTECODE", None)
        with open(f"{folder}/shift.mnt", "w", encoding="utf-8") as file:
            file.write(PROGRAM)
        plain = [*command(), "run", f"{folder}/shift.mnt"]
        written = [*plain, "--format", "json"]
        cases = {
            "cycle_command": (plain, [*plain, "--profile"]),
            "cycle_command_json": (written, [*written, "--profile-to", f"{folder}/cycle.json"]),
        }
        ratios: dict[str, list[float]] = {name: [] for name in cases}
        for number in range(PAIRS + 1):
            for name, (without, with_it) in cases.items():
                ratio = 1.0 / process_seconds(without, environment) * process_seconds(with_it, environment)
                if number:  # the first pair writes bytecode and fills the cache
                    ratios[name].append(ratio)
    return {name: sorted(values)[PAIRS // 2] for name, values in ratios.items()}


if __name__ == "__main__":
    main()

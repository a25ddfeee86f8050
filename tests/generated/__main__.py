"""`python -m tests.generated [COUNT] [--seed N] [--jobs N] [--into FOLDER]`: run generated programs with their checks.

Takes the seeds N, N + 1 and so on, and prints each finding with its seed. `--into` writes the programs that led to a
finding to a folder, each with its machine file. `--show SEED` prints one program and its machine file instead.
"""

from __future__ import annotations

import argparse
import sys
from collections import Counter
from concurrent.futures import ProcessPoolExecutor
from pathlib import Path

from tests.generated.checks import findings
from tests.generated.motion import generate

# Seeds that one process takes at a time.
BATCH = 50


def _checked(seeds: range) -> list[tuple[int, list[str]]]:
    return [(seed, findings(generate(seed))) for seed in seeds]


def main(arguments: list[str]) -> int:
    """Run the programs; exit with 1 if one has a finding."""
    parser = argparse.ArgumentParser(prog="tests.generated")
    parser.add_argument("count", nargs="?", type=int, default=300)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--jobs", type=int, default=1)
    parser.add_argument("--into", type=Path)
    parser.add_argument("--show", type=int)
    given = parser.parse_args(arguments)
    if given.show is not None:
        program = generate(given.show)
        print(program.text, program.machine_file, sep="")
        return 0
    end, bad = given.seed + given.count, Counter[str]()
    batches = [range(first, min(first + BATCH, end)) for first in range(given.seed, end, BATCH)]
    with ProcessPoolExecutor(given.jobs) as pool:
        for batch in pool.map(_checked, batches):
            for seed, found in batch:
                if not found:
                    continue
                bad[found[0].partition(":")[0]] += 1
                print(f"seed {seed}: {generate(seed).language}", *found[:4], sep="\n  ", flush=True)
                if given.into is not None:
                    given.into.mkdir(parents=True, exist_ok=True)
                    program = generate(seed)
                    (given.into / program.name).write_text(program.text, encoding="utf-8")
                    machine = (given.into / program.name).with_suffix(".machine.toml")
                    machine.write_text(program.machine_file, encoding="utf-8")
    kinds = ", ".join(f"{count} {kind}" for kind, count in bad.most_common()) or "no findings"
    print(f"{given.count} programs from seed {given.seed}: {kinds}", flush=True)
    return 1 if bad else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))

"""`python -m tests.generated [COUNT] [--seed N] [--jobs N] [--into FOLDER]`.

Run COUNT generated programs with their checks, for the seeds N, N + 1 and so on. Each finding is printed with
its seed. `--family words` runs programs of every keyword of both languages instead of motion programs.
`--into` writes each program with a finding to a folder, together with its machine file.

Three options print something instead. `--show SEED` prints one program and its machine file. `--shrink SEED`
prints the smallest program that still has the finding. `--words` prints how many of the programs have each
simulated keyword, and why some keywords are missing.
"""

from __future__ import annotations

import argparse
import sys
from collections import Counter
from concurrent.futures import ProcessPoolExecutor
from functools import partial
from pathlib import Path

from tests.generated.checks import findings
from tests.generated.motion import FAMILIES, generate
from tests.generated.shrink import shrunk
from tests.generated.words import NEVER, simulated, words

# Seeds that one process takes at a time.
BATCH = 50


def _checked(seeds: range, family: str) -> list[tuple[int, list[str]]]:
    return [(seed, findings(generate(seed, family))) for seed in seeds]


def report_keywords_without_effect(seeds: range, family: str) -> int:
    """Print how many programs have each simulated keyword; return 1 if one is missing.

    A missing keyword that has a listed reason does not count.
    """
    drawn: dict[str, Counter[str]] = {language: Counter() for language in NEVER}
    for seed in seeds:
        program = generate(seed, family)
        drawn[program.language].update(words(program.language, program.text))
    unexplained = 0
    for language, reasons in NEVER.items():
        names = sorted(simulated(language), key=lambda name: (drawn[language][name], name))
        for name in names:
            reason = reasons.get(name, "no reason") if not drawn[language][name] else ""
            print(f"{language} {name:<24} {drawn[language][name]:>7}  {reason}".rstrip())
            unexplained += reason == "no reason"
    return 1 if unexplained else 0


def main(arguments: list[str]) -> int:
    """Run the programs; return 1 if one has a finding."""
    parser = argparse.ArgumentParser(prog="tests.generated")
    parser.add_argument("count", nargs="?", type=int, default=300)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--jobs", type=int, default=1)
    parser.add_argument("--into", type=Path)
    parser.add_argument("--show", type=int)
    parser.add_argument("--shrink", type=int)
    parser.add_argument("--family", choices=FAMILIES, default="motion")
    parser.add_argument("--words", action="store_true")
    given = parser.parse_args(arguments)
    if given.show is not None or given.shrink is not None:
        program = generate(given.show if given.shrink is None else given.shrink, given.family)
        program = program if given.shrink is None else shrunk(program)
        print(program.text, program.machine_file, sep="")
        return 0
    if given.words:
        return report_keywords_without_effect(range(given.seed, given.seed + given.count), given.family)
    end, bad = given.seed + given.count, Counter[str]()
    batches = [range(first, min(first + BATCH, end)) for first in range(given.seed, end, BATCH)]
    with ProcessPoolExecutor(given.jobs) as pool:
        for batch in pool.map(partial(_checked, family=given.family), batches):
            for seed, found in batch:
                if not found:
                    continue
                bad[found[0].partition(":")[0]] += 1
                print(
                    f"seed {seed}: {generate(seed, given.family).language}",
                    *found[:4],
                    sep="\n  ",
                    flush=True,
                )
                if given.into is not None:
                    given.into.mkdir(parents=True, exist_ok=True)
                    program = generate(seed, given.family)
                    (given.into / program.name).write_text(program.text, encoding="utf-8")
                    machine = (given.into / program.name).with_suffix(".machine.toml")
                    machine.write_text(program.machine_file, encoding="utf-8")
    kinds = ", ".join(f"{count} {kind}" for kind, count in bad.most_common()) or "no findings"
    print(f"{given.count} programs from seed {given.seed}: {kinds}", flush=True)
    return 1 if bad else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))

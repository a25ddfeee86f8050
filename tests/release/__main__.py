"""Build all artefacts of a release and check them: `python -m tests.release [OPTION] [FOLDER]`.

The artefacts remain in FOLDER (default build/release): in `dist` source distributions and wheels, in `more` the program
for people without Python, the VS Code extension, and the site with the playground. The table shows the size, the check
and the start time of each. An artefact whose tools are not installed is skipped, and the table says why. A package
index is needed, and npm's registry. `--quick` has the part that CI runs: the distributions, and the wheel with the
newest libraries. `--only PART` has one part, such as `program`.
"""

from __future__ import annotations

import argparse
import shutil
import sys
import tempfile
from collections.abc import Callable, Iterator
from pathlib import Path

from motionlang import __version__
from tests.built import ROOT
from tests.release import artefacts, indexes, trial
from tests.release.artefacts import Row, Skipped


def line(row: Row) -> str:
    """Return a row as text."""
    size = "" if row.size_mb is None else f"{row.size_mb:.2f} MB"
    start = "" if row.start_s is None else f"{row.start_s:.2f} s"
    return f"{row.artefact:<52} {size:>9} {start:>8}  {row.check}"


def parts(scratch: Path, quick: bool) -> Iterator[tuple[str, Callable[[], Iterator[Row]]]]:
    """Yield the parts of the check by name; the distributions, which the others need, are built first."""
    sdist, wheel = artefacts.distributions(scratch)
    yield "distributions", lambda: artefacts.check_distributions(scratch, sdist, wheel)
    yield "extras", lambda: artefacts.extras(scratch, wheel)
    yield "installs", lambda: artefacts.check_installs(scratch, wheel, sdist, only_here=quick)
    if quick:
        return
    yield "program", lambda: artefacts.program(scratch, wheel)
    yield "extension", lambda: artefacts.extension(scratch)
    yield "site", lambda: artefacts.site(scratch)
    yield "indexes", lambda: indexes.check(scratch, wheel)
    built = scratch / "site"
    yield "trial", lambda: trial.check(scratch, wheel, built if built.exists() else None)


def main() -> int:
    """Print the table; 1 if a check failed."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("folder", nargs="?", type=Path, default=ROOT / "build" / "release")
    some = parser.add_mutually_exclusive_group()
    some.add_argument("--quick", action="store_true")
    some.add_argument(
        "--only", choices=("distributions", "extras", "installs", "program", "extension", "site", "indexes")
    )
    given = parser.parse_args()
    shutil.rmtree(given.folder, ignore_errors=True)
    failed = 0
    with tempfile.TemporaryDirectory() as scratch:
        for name, part in parts(Path(scratch), given.quick):
            if given.only not in (None, name):
                continue
            try:
                for row in part():
                    print(line(row), flush=True)
            except Skipped as reason:
                print(line(Row(name, f"skipped: {reason}")), flush=True)
            except AssertionError as error:
                failed = 1
                print(line(Row(name, f"failed: {error}")), flush=True)
        for artefact in sorted(Path(scratch).glob("motionlang[-_]*.*")):
            if artefact.is_file():
                is_distribution = artefact.suffix == ".whl" or artefact.name.endswith(
                    f"-{__version__}.tar.gz"
                )
                target = given.folder / ("dist" if is_distribution else "more")
                target.mkdir(parents=True, exist_ok=True)
                shutil.copy(artefact, target)
    return failed


if __name__ == "__main__":
    sys.exit(main())

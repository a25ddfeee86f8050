"""Start-up of `motionlang run` against `python -c pass`: CPU time of processes.

The program is start.mnt, a hundred lines of an ordinary machine program. `start_cached` takes its code from the
user's cache; for `start_first_sight` the text is new each time, and is compiled and cached. Both run without a
report; `start_table` and `start_first_sight_table` print the table for a terminal, too.

The command is the script that a current pip writes for it. An older pip (up to 25.0) writes a script that
imports `re`, which takes half as long as an empty Python. The package cannot avoid that, and it would hide
half of the measured time. `start_installed` is therefore the command as it is installed on this machine, and
`start_re` that import alone. `start_hello` is a program of one line. `start_check` checks the program, and
`start_keywords` shows the page of a keyword. The bytecode of the package exists already, as after an
installation.
"""

from __future__ import annotations

import os
import resource
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

ROOT = Path(__file__).parent.parent
PROGRAM = str(ROOT / "benchmarks" / "start.mnt")
HELLO = str(ROOT / "scripts" / "mint" / "hello.mnt")
ROUNDS = 25
SCRIPT = """\
import sys
from motionlang.__main__ import main
if __name__ == '__main__':
    sys.argv[0] = sys.argv[0].removesuffix('.exe')
    sys.exit(main())
"""
FIGURES = (
    "cached",
    "first_sight",
    "table",
    "first_sight_table",
    "hello",
    "check",
    "keywords",
    "installed",
    "re",
    "import",
)


def command() -> list[str]:
    """Return the installed command `motionlang`, or `python -m` if there is none."""
    found = shutil.which("motionlang", path=os.path.dirname(sys.executable))
    return [found] if found else [sys.executable, "-m", "motionlang"]


def seconds(arguments: list[str], environment: dict[str, str], statuses: tuple[int, ...] = (0,)) -> float:
    """Return the CPU time of one process, which must exit with one of `statuses`."""
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    ended = subprocess.run(arguments, env=environment, stdout=subprocess.DEVNULL, check=False)
    assert ended.returncode in statuses, arguments
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    return after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime


def main() -> None:
    """Print `name value unit` lines; the rounds of all cases are interleaved."""
    with tempfile.TemporaryDirectory() as folder:
        environment = {**os.environ, "MOTIONLANG_CACHE": folder, "PYTHONPYCACHEPREFIX": f"{folder}/pyc"}
        environment.pop("PYTHONDONTWRITEBYTECODE", None)
        script, fresh = Path(folder, "motionlang"), Path(folder, "fresh.mnt")
        script.write_text(SCRIPT)
        text, texts = Path(PROGRAM).read_text(), 0
        run = [sys.executable, str(script), "run"]
        silent = ["--format", "none"]
        cases = {
            "pass": [sys.executable, "-c", "pass"],
            "re": [sys.executable, "-c", "import re"],
            "import": [sys.executable, "-c", "import motionlang"],
            "cached": [*run, PROGRAM, *silent],
            "first_sight": [*run, str(fresh), *silent],
            "table": [*run, PROGRAM],
            "first_sight_table": [*run, str(fresh)],
            "hello": [*run, HELLO, *silent],
            "check": [sys.executable, str(script), "check", PROGRAM],
            "keywords": [sys.executable, str(script), "keywords", "SPEED"],
            "installed": [*command(), "run", PROGRAM, *silent],
        }
        times: dict[str, list[float]] = {name: [] for name in cases}
        for _ in range(1 + ROUNDS):
            for name, arguments in cases.items():
                texts += 1
                fresh.write_text(f"{text}' {texts}\n")
                times[name].append(seconds(arguments, environment))
    middle = {name: sorted(values[1:])[ROUNDS // 2] for name, values in times.items()}
    print(f"start_pass {middle['pass'] * 1e3:.1f} ms")
    for name in FIGURES:
        print(f"start_{name} {middle[name] / middle['pass']:.2f} x_pass")


if __name__ == "__main__":
    main()

"""Start-up of `motionlang run hello.mnt` against `python -c pass`: CPU time of whole processes, in one run.

First sight parses and compiles; cached takes the compiled program from the user's cache; the table report, of a
program that moves, is what a person sees. The command that pip writes imports `re` (`start_re` is that alone), which
some versions of it do no more: `start_cached_without_re` is a cached start without that command. Bytecode of the
package is written first, as an installation does.
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
HELLO = str(ROOT / "scripts" / "mint" / "hello.mnt")
BALLSCREW = str(ROOT / "scripts" / "mint" / "ballscrew.mnt")
ROUNDS = 25
CALL = "import sys; from motionlang.__main__ import main; sys.exit(main())"


def command() -> list[str]:
    """The installed `motionlang`, or the module where none is installed."""
    found = shutil.which("motionlang", path=os.path.dirname(sys.executable))
    return [found] if found else [sys.executable, "-m", "motionlang"]


def seconds(arguments: list[str], environment: dict[str, str], statuses: tuple[int, ...] = (0,)) -> float:
    """CPU time of one process, which must end with one of `statuses`."""
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
        for program in (HELLO, BALLSCREW):
            subprocess.run(
                [*command(), "run", program], env=environment, stdout=subprocess.DEVNULL, check=True
            )
        run = [*command(), "run", HELLO]
        cases = {
            "pass": [sys.executable, "-c", "pass"],
            "re": [sys.executable, "-c", "import re"],
            "cached": [*run, "--report", "none"],
            "cached_without_re": [sys.executable, "-c", CALL, "run", HELLO, "--report", "none"],
            "first_sight": [*run, "--report", "none", "--no-cache"],
            "table": [*command(), "run", BALLSCREW],
        }
        times: dict[str, list[float]] = {name: [] for name in cases}
        for _ in range(ROUNDS):
            for name, arguments in cases.items():
                times[name].append(seconds(arguments, environment))
    middle = {name: sorted(values)[ROUNDS // 2] for name, values in times.items()}
    print(f"start_pass {middle['pass'] * 1e3:.1f} ms")
    for name in ("cached", "cached_without_re", "first_sight", "table", "re"):
        print(f"start_{name} {middle[name] / middle['pass']:.2f} x_pass")


if __name__ == "__main__":
    main()

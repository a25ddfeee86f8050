"""Test with the lowest versions of the dependencies: `python -m tests.lowest`.

For each Python, an environment in a temporary folder gets the wheel and the lowest versions that it declares.
There the help and the real uses of every command run, with all warnings as errors; in the first environment, also
without assertions and docstrings (-OO), since each compiles all modules anyway. The commands of the folder extras say
there what to install. Then motionlang-explore is installed, too, and its commands run. With the first Python, the tests
of `FOLDERS`, which show what these libraries write, then run with the lowest versions of the extras, too; those of the
command line show that the package needs no distribution of the folder extras. Without arguments, each Python from 3.11
to 3.14 on PATH or of pyenv is used; missing ones are skipped. A package index is needed.
"""

from __future__ import annotations

import os
import shutil
import subprocess
import sys
import tempfile
from collections.abc import Iterable
from concurrent.futures import ThreadPoolExecutor
from importlib.util import find_spec
from pathlib import Path

from packaging.requirements import Requirement
from packaging.version import Version

from tests.built import ROOT, distributions
from tests.installed import (
    DRIVER,
    ELSEWHERE,
    EXTRAS,
    PROJECT,
    STRICT,
    USES_OF_EXPLORE,
    check_elsewhere,
    check_helps,
    check_uses,
    drive,
    helps,
    needed,
    write_files,
)

SUPPORTED = ("3.11", "3.12", "3.13", "3.14")
TEST_TOOLS = ("hypothesis", "pytest", "jsonschema", "packaging")
WHEELS = ("--quiet", "--only-binary", ":all:")
# The tests that use the libraries, and the extras whose files and pictures they read.
FOLDERS = (
    "tests/cli",
    "tests/golden",
    "tests/lab/pvt",
    "tests/views",
    "tests/repl",
    "tests/kernel/log",
    "tests/kernel/tracks",
    "tests/generated/test_results.py",
)
TESTED_EXTRAS = ("plot", "parquet", "completion")
VERSION = "import platform; print(platform.python_version())"


def lowest(python_version: str, extras: Iterable[str] = (), more: Iterable[str] = ()) -> list[str]:
    """Return each dependency with its lowest version for a Python, like "numpy==1.26"; also those of extras.

    `more` are dependencies of other distributions.
    """
    environment = {"python_version": ".".join(python_version.split(".")[:2])}
    found = []
    for text in [*PROJECT["dependencies"], *(each for extra in extras for each in EXTRAS[extra]), *more]:
        required = Requirement(text)
        bounds = [Version(each.version) for each in required.specifier if each.operator == ">="]
        if bounds and (required.marker is None or required.marker.evaluate(environment)):
            found.append(f"{required.name}=={max(bounds)}")
    return found


def run(python: str, wheel: Path, explore: Path, folder: Path, *flags: str, newest: bool = False) -> str:
    """Run every command with `python` and its flags in an environment of its own.

    It has the wheel, then also that of motionlang-explore, and the lowest versions of the libraries, or the newest
    ones. Return the packages in the environment, which is created below `folder`, a new folder.
    """
    folder.mkdir()
    version = subprocess.check_output([python, "-c", VERSION], text=True).strip()
    versions = [] if newest else lowest(version)
    # An installer of this Python serves the environment, which saves the installation of another one.
    subprocess.run([python, "-m", "venv", "--without-pip", str(folder / "env")], check=True)
    installed = str(folder / "env" / ("Scripts" if os.name == "nt" else "bin") / "python")
    install = [sys.executable, "-m", *installer(installed), *WHEELS]
    subprocess.run([*install, str(wheel), *versions], check=True)
    work = folder / "work"
    work.mkdir()
    write_files(work)
    (folder / "driver.py").write_text(DRIVER, encoding="utf-8")
    environment = {name: value for name, value in os.environ.items() if name != "PYTHONPATH"}
    environment |= {"MOTIONLANG_CACHE": str(folder / "cache"), "PYTHONUTF8": "1"}
    uses = {use: extra for use, extra in needed().items() if not extra}
    command = [installed, *STRICT, *flags, str(folder / "driver.py")]
    ran = drive(command, [*helps(), *uses, *ELSEWHERE], work, environment)
    check_helps(ran)
    check_uses(ran, uses, set())
    check_elsewhere(ran)
    subprocess.run([*install, "--no-deps", str(explore)], check=True)
    check_uses(drive(command, USES_OF_EXPLORE, work, environment), dict.fromkeys(USES_OF_EXPLORE, ""), set())
    libraries = ", ".join(versions) or "the newest libraries"
    count = len(uses) + len(USES_OF_EXPLORE)
    return f"Python {' '.join((version, *flags))} with {libraries}: {len(helps())} helps, {count} uses"


def run_tests(python: str, wheel: Path, folder: Path) -> str:
    """Run the tests of `FOLDERS` with `python`, the wheel and the lowest versions in an environment of its own."""
    version = subprocess.check_output([python, "-c", VERSION], text=True).strip()
    versions = lowest(version, TESTED_EXTRAS)
    subprocess.run([python, "-m", "venv", "--without-pip", str(folder / "env")], check=True)
    installed = str(folder / "env" / ("Scripts" if os.name == "nt" else "bin") / "python")
    command = [sys.executable, "-m", *installer(installed), *WHEELS, str(wheel), *versions, *TEST_TOOLS]
    subprocess.run(command, check=True)
    # Old libraries use what the newest versions of their own dependencies deprecate.
    ignored = ("-W", "ignore::DeprecationWarning", "-W", "ignore::PendingDeprecationWarning")
    tests = [installed, "-m", "pytest", "-p", "no:cacheprovider", *ignored, *FOLDERS]
    subprocess.run(tests, cwd=ROOT, check=True)
    return f"Python {version} with {', '.join(versions)}: {', '.join(FOLDERS)}"


def installer(python: str) -> list[str]:
    """Return the installer for `python`, uv if present or pip, with its arguments."""
    if find_spec("uv") is not None:
        return ["uv", "pip", "install", "--python", python]
    return ["pip", "--python", python, "install", "--disable-pip-version-check", "--no-compile"]


def interpreters() -> dict[str, str | None]:
    """Return a Python of this machine for each supported version; None if missing."""
    found: dict[str, str | None] = {}
    for name in SUPPORTED:
        candidates = [
            sys.executable,
            shutil.which(f"python{name}") or "",
            *map(str, sorted(Path.home().glob(f".pyenv/versions/{name}.*/bin/python"))),
        ]
        found[name] = next((each for each in candidates if each and is_version(each, name)), None)
    return found


def is_version(python: str, name: str) -> bool:
    """True if `python` has the version `name` and can create virtual environments.

    On Debian that takes a separate package.
    """
    code = "import ensurepip, sys; print('%d.%d' % sys.version_info[:2])"
    ran = subprocess.run([python, "-c", code], capture_output=True, text=True, check=False)
    return ran.stdout.strip() == name


def main() -> int:
    """Build the wheel once, and test it with every Python, on all processors."""
    given: dict[str, str | None] = {each: each for each in sys.argv[1:]} or interpreters()
    present = [python for python in given.values() if python is not None]
    with tempfile.TemporaryDirectory() as name, ThreadPoolExecutor(os.cpu_count()) as pool:
        folder = Path(name)
        (wheel,) = distributions(folder / "core", "wheel")
        (explore,) = distributions(folder / "explore", "wheel", source=ROOT / "extras" / "explore")
        tested = pool.submit(run_tests, present[0], wheel, folder / "suite")
        for line in pool.map(
            lambda number: run(
                present[number], wheel, explore, folder / str(number), *([] if number else ["-OO"])
            ),
            range(len(present)),
        ):
            print(line, flush=True)
        print(tested.result(), flush=True)
    for version, python in given.items():
        if python is None:
            print(f"Python {version} skipped: this machine has none that can make environments")
    return 0


if __name__ == "__main__":
    sys.exit(main())

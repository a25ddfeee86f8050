"""Build and check each artefact; every function returns rows of the table."""

from __future__ import annotations

import json
import os
import platform
import shutil
import subprocess
import sys
import time
import tomllib
import zipfile
from collections.abc import Iterable, Iterator
from dataclasses import dataclass
from importlib.util import find_spec
from itertools import combinations
from pathlib import Path

from motionlang import __version__
from tests.built import IGNORED, ROOT
from tests.installed import USES_OF_EXPLORE, needed, write_files
from tests.lowest import installer, interpreters, lowest, run

PROGRAM = ROOT / "scripts" / "mint" / "ballscrew.mnt"
PRINTED = "the nut is at 200.0000 mm"
# A use of each distribution in extras, and what it prints.
USES = {
    "explore": ("cover scripts/mint/ballscrew.mnt", "100 %"),
    "copley": ("copley stream --scurve 1000 --time 100", "move ended at 1000"),
    "lsp": ("lsp --help", "--tcp HOST:PORT"),
    "mcapi": ("mcapi replay extras/mcapi/test_mcapi/stage.mcapi-log", "0 differences"),
}
# The start of the program for people without Python: workers of `sweep` and `check` are processes of the same file.
ENTRY = """\
import multiprocessing, sys
from motionlang.__main__ import main
if __name__ == "__main__":
    multiprocessing.freeze_support()
    sys.exit(main())
"""


class Skipped(Exception):
    """A tool that an artefact needs is not installed."""


@dataclass
class Row:
    """A line of the table: size in MB and start time in s, if the artefact has them."""

    artefact: str
    check: str
    size_mb: float | None = None
    start_s: float | None = None


def call(*command: str | Path, folder: Path = ROOT, **environment: str) -> str:
    """Return the output of a command, which must end with 0."""
    clean = {name: value for name, value in os.environ.items() if name != "PYTHONPATH"}
    ran = subprocess.run(
        [*map(str, command)], cwd=folder, env=clean | environment, capture_output=True, text=True,
        encoding="utf-8", check=False,
    )  # fmt: skip
    if ran.returncode:
        raise AssertionError(f"{' '.join(map(str, command))}: {ran.stdout}{ran.stderr}")
    return ran.stdout


def megabytes(path: Path) -> float:
    """Return the size of a file or of all files of a folder, MB."""
    files = path.rglob("*") if path.is_dir() else [path]
    return sum(each.lstat().st_size for each in files if not each.is_dir()) / 1e6


def start_time(*command: str | Path) -> float:
    """Return the best time of three runs of the first program, s."""
    times = []
    for _ in range(3):
        began = time.perf_counter()
        assert PRINTED in call(*command, "run", PROGRAM)
        times.append(time.perf_counter() - began)
    return min(times)


def environment(folder: Path, *packages: str | Path) -> Path:
    """Create a virtual environment with packages, the newest versions; return its folder of programs."""
    call(sys.executable, "-m", "venv", "--without-pip", folder)
    programs = folder / ("Scripts" if os.name == "nt" else "bin")
    call(sys.executable, "-m", *installer(str(programs / "python")), "--quiet", *packages)
    return programs


def find(tool: str) -> str:
    """Return the path of a program; raise Skipped if it is not installed."""
    found = shutil.which(tool)
    if found is None:
        raise Skipped(f"{tool} is not installed")
    return found


def distributions(folder: Path) -> tuple[Path, Path]:
    """Build the source distribution, and from it the wheel, each in isolation, below `folder`.

    Those of the folder extras are built, too.
    """
    if find_spec("build") is None:
        raise Skipped("the package build is not installed")
    copy = folder / "source"
    shutil.copytree(ROOT, copy, ignore=shutil.ignore_patterns(*IGNORED))
    fast = ("--installer", "uv") if find_spec("uv") else ()
    for source in (copy, *sorted((copy / "extras").glob("*"))):
        call(sys.executable, "-m", "build", *fast, "--outdir", folder, source)
    sdist, wheel = (next(folder.glob(f"motionlang-{__version__}{end}")) for end in (".tar.gz", "-*.whl"))
    return sdist, wheel


def check_distributions(folder: Path, sdist: Path, wheel: Path) -> Iterator[Row]:
    """Check metadata and contents; the wheel has exactly the files of the package and the grammars."""
    call(sys.executable, "-m", "twine", "check", "--strict", sdist, wheel)
    call(sys.executable, "-m", "check_wheel_contents", wheel)
    with zipfile.ZipFile(wheel) as archive:
        names = {name for name in archive.namelist() if not name.startswith(f"motionlang-{__version__}")}
    source = folder / "source"
    files = [path for path in (source / "motionlang").rglob("*") if path.is_file() and path.suffix != ".pyc"]
    wanted = {path.relative_to(source).as_posix() for path in files}
    grammars = {name for name in names if name.startswith("motionlang/grammars/")}
    assert names - grammars == wanted, sorted((names - grammars) ^ wanted)[:5]
    assert sorted(name.rpartition(".")[2] for name in grammars) == ["lark"] * 3 + ["table"] * 2
    yield Row(sdist.name, "built in isolation; twine", megabytes(sdist))
    yield Row(wheel.name, f"built from it in isolation; twine; {len(names)} files", megabytes(wheel))


def check_installs(folder: Path, wheel: Path, sdist: Path, *, only_here: bool) -> Iterator[Row]:
    """Install into bare environments, use every command there, and compare the gallery with its golden files.

    That is done with the newest versions of the libraries on each Python of this machine, and with the lowest ones;
    `only_here` restricts it to the newest ones on this Python, as `python -m tests.lowest` has the rest.
    """
    (explore,) = folder.glob("motionlang_explore-*.whl")
    pythons = {"": sys.executable} if only_here else interpreters()
    for number, (name, python) in enumerate(pythons.items()):
        if python is None:
            yield Row(f"Python {name}", "skipped: not on this machine")
            continue
        for newest in (True,) if only_here else (True, False):
            place = folder / f"install-{number}-{'newest' if newest else 'lowest'}"
            told = run(python, wheel, explore, place, newest=newest)
            program = place / "env" / ("Scripts" if os.name == "nt" else "bin") / "motionlang"
            call(program, "verify", "scripts")
            yield Row(
                f"wheel on {told.partition(':')[0]}", told.partition(": ")[2], None, start_time(program)
            )
    if not only_here:
        programs = environment(folder / "from-sdist", sdist)
        yield Row("sdist, installed", "runs a program", None, start_time(programs / "motionlang"))


def extras(folder: Path, wheel: Path) -> Iterator[Row]:
    """Check the distributions in extras; install each alone and each pair with the wheel, and use them."""
    for name in USES:
        package = f"motionlang_{name}"
        sdist, built = (next(folder.glob(f"{package}-{__version__}{end}")) for end in (".tar.gz", "-*.whl"))
        call(sys.executable, "-m", "twine", "check", "--strict", sdist, built)
        call(sys.executable, "-m", "check_wheel_contents", built)
        with zipfile.ZipFile(built) as archive:
            names = {each for each in archive.namelist() if not each.startswith(f"{package}-")}
        source = folder / "source" / "extras" / name
        wanted = {
            each.relative_to(source).as_posix() for each in (source / package).rglob("*") if each.is_file()
        }
        assert names == wanted, sorted(names ^ wanted)[:5]
        yield Row(built.name, f"twine; {len(names)} files", megabytes(built))
    for chosen in (*combinations(USES, 1), *combinations(USES, 2)):
        wheels = [next(folder.glob(f"motionlang_{name}-*.whl")) for name in chosen]
        for libraries, pins in (("newest", []), ("lowest", lowest_with(chosen))):
            programs = environment(folder / "-".join((*chosen, libraries)), wheel, *wheels, *pins)
            for use, printed in (USES[name] for name in chosen):
                assert printed in call(programs / "motionlang", *use.split()), (chosen, libraries, use)
        yield Row(" and ".join(chosen), "used with the newest and the lowest libraries")


def lowest_with(names: Iterable[str]) -> list[str]:
    """Return the lowest versions of the libraries of the wheel and some distributions in extras."""
    projects = (ROOT / "extras" / name / "pyproject.toml" for name in names)
    more = [
        text
        for each in projects
        for text in tomllib.loads(each.read_text(encoding="utf-8"))["project"]["dependencies"]
    ]
    return lowest(platform.python_version(), more=more)


def program(folder: Path, wheel: Path) -> Iterator[Row]:
    """Build the program for people without Python, one folder in an archive, and use every command of it."""
    others = [next(folder.glob(f"motionlang_{name}-*.whl")) for name in ("explore", "lsp")]
    programs = environment(folder / "program-env", wheel, *others, "pyinstaller>=6.11")
    (folder / "entry.py").write_text(ENTRY, encoding="utf-8")
    call(
        programs / "pyinstaller", "--noconfirm", "--log-level", "ERROR", "--name", "motionlang", "--onedir",
        "--collect-data", "motionlang", "--collect-submodules", "motionlang", "--distpath", "program",
        "--copy-metadata", "motionlang-lsp", "--collect-submodules", "motionlang_lsp",
        "--copy-metadata", "motionlang-explore", "--collect-all", "motionlang_explore",
        "--exclude-module", "setuptools", "entry.py", folder=folder,
    )  # fmt: skip
    built = folder / "program" / "motionlang"
    executable = built / ("motionlang.exe" if os.name == "nt" else "motionlang")
    work = folder / "program-work"
    work.mkdir()
    write_files(work)
    uses = [*(use for use, extra in needed().items() if not extra), *USES_OF_EXPLORE]
    for use in [*uses, "sweep move.mnt --vary axis.0.start=1,2 --jobs 2", "lsp --help"]:
        call(executable, *use.split(), folder=work)
    system, machine = platform.system().lower(), platform.machine().lower()
    kind = "zip" if os.name == "nt" else "gztar"
    packed = shutil.make_archive(
        str(folder / f"motionlang-{__version__}-{system}-{machine}"), kind, built.parent, "motionlang"
    )
    check = f"{len(uses) + 2} uses; {megabytes(built):.0f} MB unpacked"
    yield Row(Path(packed).name, check, megabytes(Path(packed)), start_time(executable))


def extension(folder: Path) -> Iterator[Row]:
    """Package the VS Code extension, after its type check and the tests of its grammars."""
    npm, copy = find("npm"), folder / "extension"
    shutil.copytree(ROOT / "editors" / "vscode", copy, ignore=shutil.ignore_patterns("node_modules", "out"))
    shutil.copy(ROOT / "LICENSE", copy)
    for words in (("install", "--no-audit", "--no-fund", "--loglevel=error"), ("test",), ("run", "package")):
        call(npm, *words, folder=copy)
    file = folder / f"motionlang-{__version__}.vsix"
    shutil.move(copy / "motionlang.vsix", file)
    with zipfile.ZipFile(file) as archive:
        names = set(archive.namelist())
        package = json.loads(archive.read("extension/package.json"))
    wanted = {package["main"], *(each["path"] for each in package["contributes"]["grammars"])}
    assert {f"extension/{each.removeprefix('./')}" for each in wanted} <= names, sorted(names)
    assert package["version"] == __version__
    yield Row(file.name, f"types; grammars; {len(names)} files", megabytes(file))


def site(folder: Path) -> Iterator[Row]:
    """Build site and playground, check their links, and pack them; `python -m tests.site` uses them in browsers."""
    from tests.site import __main__ as site
    from tests.site import pages

    find("npm")
    if find_spec("zensical") is None:
        raise Skipped("the extra site is not installed")
    site.playground()
    pages.main()
    built = folder / "site"
    site.build(built, *site.GENERATORS["zensical"])
    assert site.wrong_site(built) == []
    packed = Path(shutil.make_archive(str(folder / f"motionlang-{__version__}-site"), "zip", built))
    check = f"links; {len([*built.rglob('*.html')])} pages; {megabytes(built):.0f} MB unpacked"
    yield Row(packed.name, check, megabytes(packed))

"""The contents of the playground: `python contents.py FOLDER` writes the packages and `contents.json`.

The programs are those of `scripts/`. Each is run once without numpy, as in a browser, to find those that need
it.
"""

from __future__ import annotations

import gzip
import io
import json
import os
import shutil
import subprocess
import sys
import tempfile
import zipfile
from collections.abc import Sequence
from pathlib import Path
from typing import Any

ROOT = Path(__file__).resolve().parent.parent
# The language server.
SERVER = ROOT / "extras" / "lsp"
# The parts of a tree that its wheel is built from.
SOURCES = {
    ROOT: ("motionlang", "grammars", "pyproject.toml", "README.md", "LICENSE"),
    SERVER: ("motionlang_lsp", "pyproject.toml", "README.md", "LICENSE"),
}
# The program that the page opens with, and shows the results of before Python is there.
FIRST = "ballscrew.mnt"
# The libraries of the language server and of a run, with their versions and hashes.
LIBRARIES = ROOT / "playground" / "requirements.txt"
RUN_LIBRARIES = ROOT / "playground" / "requirements-run.txt"
# The version of Python in Pyodide, for the tables of the grammars.
PYTHON = "3.14"
BUILD = "import sys; from setuptools import build_meta; build_meta.build_wheel(sys.argv[1])"


def build_wheel(folder: Path, root: Path = ROOT) -> Path:
    """Build the wheel of a tree in `folder`."""
    with tempfile.TemporaryDirectory() as scratch:
        copy = Path(scratch)
        for name in SOURCES[root]:
            if (root / name).is_dir():
                shutil.copytree(root / name, copy / name, ignore=shutil.ignore_patterns("__pycache__"))
            else:
                shutil.copy(root / name, copy / name)
        command = [sys.executable, "-c", BUILD, str(folder.resolve())]
        subprocess.run(command, cwd=copy, check=True, stdout=subprocess.DEVNULL)
    return next(folder.glob("*.whl"))


def fetch_libraries(folder: Path, requirements: Path) -> list[Path]:
    """Download the wheels of required libraries to `folder`."""
    command = [
        sys.executable, "-m", "pip", "download", "--quiet", "--disable-pip-version-check", "--no-deps",
        "--only-binary=:all:", "--require-hashes", "--requirement", str(requirements), "--dest", str(folder),
    ]  # fmt: skip
    subprocess.run(command, check=True)
    return sorted(folder.glob("*.whl"))


def write_tables(folder: Path, libraries: list[Path]) -> list[Path]:
    """Write the tables of the grammars for the Python of the page, by the Lark that it gets."""
    folder.mkdir()
    path = os.pathsep.join(map(str, libraries))
    command = [sys.executable, "-m", "motionlang.kernel.tables", str(folder), PYTHON]
    subprocess.run(command, cwd=ROOT, check=True, env={**os.environ, "PYTHONPATH": path})
    return sorted(folder.glob("*.table"))


def pack(wheels: list[Path], file: Path, tables: Sequence[Path] = ()) -> str:
    """Write the files of wheels into one archive, compressed as a whole; return its name.

    A wheel compresses each file by itself, which makes it a quarter larger. `tables` replace those in the wheel.
    """
    plain = io.BytesIO()
    with zipfile.ZipFile(plain, "w", zipfile.ZIP_STORED) as archive:
        for wheel in wheels:
            with zipfile.ZipFile(wheel) as source:
                for each in source.infolist():
                    if each.filename.endswith(".table"):
                        continue
                    archive.writestr(zipfile.ZipInfo(each.filename), source.read(each))
        for table in tables:
            archive.writestr(zipfile.ZipInfo(f"motionlang/grammars/{table.name}"), table.read_bytes())
    file.write_bytes(gzip.compress(plain.getvalue(), mtime=0))
    return file.name


def gallery() -> list[dict[str, Any]]:
    """Return the programs in the form of a request to `runner`.

    `needs` is "numpy" or "", and `inputs` has the inputs that the program reads.
    """
    sys.modules["numpy"] = None  # type: ignore[assignment]
    sys.path[:0] = [str(ROOT), str(ROOT / "playground")]
    made = []
    for dialect in ("mint", "mccl"):
        for path in sorted((ROOT / "scripts" / dialect).iterdir()):
            if path.suffix in (".mnt", ".mcl"):
                machine = path.with_suffix(".machine.toml")
                request: dict[str, Any] = {
                    "name": path.name,
                    "dialect": dialect,
                    "program": path.read_text(encoding="utf-8"),
                    "machine": machine.read_text(encoding="utf-8") if machine.exists() else "",
                }
                made.append({**request, "needs": _needs(request), "inputs": _runner().inputs(request)})
    return made


def _runner() -> Any:
    import runner

    return runner


def messages(request: dict[str, Any]) -> list[dict[str, Any]]:
    """Return what the page gets of a run."""
    found: list[dict[str, Any]] = []
    _runner().start(request, found.append)
    return found


def _needs(request: dict[str, Any]) -> str:
    marks = [mark for each in messages(request) for mark in each.get("marks", ())]
    return "numpy" if any(mark["code"] == "extra" for mark in marks) else ""


def commit() -> str:
    """Return the commit of the tree, "unknown" outside a repository."""
    command = ["git", "-C", str(ROOT), "rev-parse", "--short=12", "HEAD"]
    ran = subprocess.run(command, capture_output=True, text=True, check=False)
    return ran.stdout.strip() or "unknown"


def main(folder: Path) -> None:
    """Write everything into `folder`."""
    programs = gallery()
    with tempfile.TemporaryDirectory() as scratch:
        wheel = build_wheel(Path(scratch))
        libraries = fetch_libraries(Path(scratch, "libraries"), RUN_LIBRARIES)
        tables = write_tables(Path(scratch, "tables"), libraries)
        package = pack([wheel, *libraries], folder / "motionlang.zip.gz", tables)
    with tempfile.TemporaryDirectory() as scratch:
        libraries = fetch_libraries(Path(scratch, "libraries"), LIBRARIES)
        server = pack([build_wheel(Path(scratch), SERVER), *libraries], folder / "language-server.zip.gz")
    from motionlang import __version__

    contents = {
        "version": __version__,
        "commit": commit(),
        "wheel": package,
        "server": server,
        "gallery": programs,
        "first": FIRST,
    }
    first = messages(next(each | {"inputs": []} for each in programs if each["name"] == FIRST))
    (folder / "first.json").write_text(json.dumps(first, ensure_ascii=False), encoding="utf-8")
    (folder / "contents.json").write_text(json.dumps(contents, ensure_ascii=False), encoding="utf-8")


if __name__ == "__main__":
    main(Path(sys.argv[1]))

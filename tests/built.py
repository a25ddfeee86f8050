"""Build of the package from a copy of the tree without ignored files."""

from __future__ import annotations

import shutil
import subprocess
import sys
from pathlib import Path

import pytest

ROOT = Path(__file__).parent.parent
BUILD = "from setuptools import build_meta as b; import sys; print(b.build_{}(sys.argv[1]))"
IGNORED = (
    ".git",
    ".venv",
    "build",
    "dist",
    "node_modules",
    "*.egg-info",
    "*.table",
    "__pycache__",
    ".*_cache",
    ".hypothesis",
)


def copy_with_bytecode(source: Path, target: Path, *left_out: str) -> None:
    """Copy a folder of modules with their bytecode.

    Processes that import the copy need not compile it. Bytecode stays valid because files keep their times.
    Bytecode that another process is writing has a longer name, and is left out.
    """
    shutil.copytree(source, target, ignore=shutil.ignore_patterns("*.pyc.*", *left_out))


def distributions(folder: Path, *kinds: str, source: Path = ROOT) -> list[Path]:
    """Build in an empty `folder`; return one file for each kind, "sdist" or "wheel"."""
    pytest.importorskip("setuptools", minversion="77")
    copy, out = folder / "motionlang", folder / "dist"
    shutil.copytree(source, copy, ignore=shutil.ignore_patterns(*IGNORED))
    out.mkdir(parents=True)
    for kind in kinds:
        command = [sys.executable, "-c", BUILD.format(kind), str(out)]
        subprocess.run(command, cwd=copy, check=True, capture_output=True)
    suffix = {"sdist": "*.tar.gz", "wheel": "*.whl"}
    return [next(out.glob(suffix[kind])) for kind in kinds]

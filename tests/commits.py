"""The files of an earlier commit, for comparisons with it."""

from __future__ import annotations

import io
import subprocess
import zipfile
from pathlib import Path

ROOT = Path(__file__).parent.parent


def unpacked(commit: str, folder: Path, *paths: str) -> Path:
    """Unpack the tree of a commit, or these paths of it, into a folder.

    Returns the folder. The tree is packed as a zip file, because `tarfile` has no safe `extractall` before
    Python 3.11.4.
    """
    command = ["git", "archive", "--format=zip", commit, *paths]
    packed = subprocess.run(command, cwd=ROOT, check=True, capture_output=True).stdout
    zipfile.ZipFile(io.BytesIO(packed)).extractall(folder)
    return folder

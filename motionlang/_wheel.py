"""The build step that puts the grammars, which live beside the package, into the wheel.

A `package-dir` mapping would do the same, but makes editable installs start through an import hook; see
docs/decisions.md.
"""

from __future__ import annotations

import shutil
from pathlib import Path

from setuptools.command.build_py import build_py


class BuildWithGrammars(build_py):
    """`build_py`, then `grammars/*.lark` into `motionlang/grammars/`."""

    def run(self) -> None:
        """Build, and copy the grammars into the package; an editable install reads those of the checkout."""
        super().run()
        if self.editable_mode:
            return
        target = Path(self.build_lib, "motionlang", "grammars")
        target.mkdir(parents=True, exist_ok=True)
        for grammar in sorted(Path("grammars").glob("*.lark")):
            shutil.copy(grammar, target)

    def get_source_files(self) -> list[str]:
        """What an sdist needs beside the package."""
        sources: list[str] = super().get_source_files()  # type: ignore[no-untyped-call,unused-ignore]
        return [*sources, *map(str, sorted(Path("grammars").glob("*.lark")))]

"""The build steps of the package: grammars and their tables in the wheel, and its description.

A `package-dir` mapping would do the same, but makes editable installs start through an import hook; see
docs/contributing/decisions.md.
"""

from __future__ import annotations

import re
import shutil
import subprocess
import sys
from pathlib import Path

from setuptools.command.build_py import build_py
from setuptools.command.egg_info import egg_info


class BuildWithGrammars(build_py):
    """`build_py` that also puts `grammars/*.lark` and their tables into `motionlang/grammars/`."""

    def run(self) -> None:
        """Build, copy the grammars to the package and make their tables.

        An editable install reads the grammars of the checkout.
        """
        super().run()
        if self.editable_mode:
            return
        target = Path(self.build_lib, "motionlang", "grammars")
        target.mkdir(parents=True, exist_ok=True)
        for old in target.glob("*.table"):
            old.unlink()
        for grammar in sorted(Path("grammars").glob("*.lark")):
            shutil.copy(grammar, target)
        # A process of its own imports the package that is being built, also if another one is installed.
        make = [sys.executable, "-m", "motionlang.kernel.tables", str(target.resolve())]
        subprocess.run(make, check=True)

    def get_source_files(self) -> list[str]:
        """Return the files that an sdist needs in addition to the package."""
        sources: list[str] = super().get_source_files()  # type: ignore[no-untyped-call,unused-ignore]
        return [*sources, *map(str, sorted(Path("grammars").glob("*.lark")))]


class DescribeWithoutLinks(egg_info):
    """`egg_info` with a README that names repository files instead of linking to them.

    A package index shows the README without these files, and the package metadata has no repository address.
    """

    def run(self) -> None:
        """Write the metadata, with the links in the description replaced."""
        metadata = self.distribution.metadata
        metadata.long_description = without_links(metadata.long_description or "")
        super().run()


def without_links(text: str) -> str:
    """Replace links to repository files by text and path, and remove its pictures."""
    text = re.sub(r"!\[[^\]]*\]\((?![a-z]+:)[^)]+\)\n*", "", text)
    text = re.sub(r"\[([\w/.-]+)\]\(\1\)", r"`\1`", text)
    return re.sub(r"\[([^\]]*)\]\((?![a-z]+:)([^)#]+)[^)]*\)", r"\1 (`\2`)", text)

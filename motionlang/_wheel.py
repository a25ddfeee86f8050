"""The build steps of the package: the grammars, which live beside it, into the wheel, and a description for an index.

A `package-dir` mapping would do the same, but makes editable installs start through an import hook; see
docs/decisions.md.
"""

from __future__ import annotations

import re
import shutil
from pathlib import Path

from setuptools.command.build_py import build_py
from setuptools.command.egg_info import egg_info


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


class DescribeWithoutLinks(egg_info):
    """`egg_info` whose description, the README, names files of the repository instead of linking to them.

    An index shows the README where there is no such file, and the package knows no address of its repository.
    """

    def run(self) -> None:
        """Write the metadata with the links of the description replaced."""
        metadata = self.distribution.metadata
        metadata.long_description = without_links(metadata.long_description or "")
        super().run()


def without_links(text: str) -> str:
    """Replace links to files of the repository by their text and path, and leave out pictures of it."""
    text = re.sub(r"!\[[^\]]*\]\((?![a-z]+:)[^)]+\)\n*", "", text)
    text = re.sub(r"\[([\w/.-]+)\]\(\1\)", r"`\1`", text)
    return re.sub(r"\[([^\]]*)\]\((?![a-z]+:)([^)#]+)[^)]*\)", r"\1 (`\2`)", text)

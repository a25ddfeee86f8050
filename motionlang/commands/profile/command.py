"""`motionlang profile`: where the time of a run goes."""

from __future__ import annotations

from dataclasses import dataclass
from typing import ClassVar

from motionlang.cli.command import flag
from motionlang.cli.run_command import Simulated
from motionlang.commands.profile.budget import within_budget
from motionlang.commands.profile.profile import TimeProfile
from motionlang.commands.profile.view import profile_document, render_profile
from motionlang.kernel import Run as Result
from motionlang.kernel.tools import need
from motionlang.views.table import Document


@dataclass
class ProfileCommand(Simulated):
    """Show where the time of a run goes, by line, sub and cause."""

    title: ClassVar[str] = "profile"
    epilog: ClassVar[str] = """\
examples:
  motionlang profile pick.mnt
  motionlang profile pick.mnt --all
"""
    all: bool = flag("list every move, phase and line in the tables")
    paths: bool = flag(
        "list the paths of several axes: length, path speed, corner angle and the reason for each stop"
    )

    @property
    def lists_all(self) -> bool:
        return self.all

    def prepare(self) -> None:
        if self.paths:
            need("motionlang profile --paths", "numpy")

    def extend(self, result: Result) -> None:
        within_budget(result)

    def print_json(self, result: Result) -> None:
        self.show(self.document(result), "")

    def document(self, result: Result) -> Document:
        made = profile_document(TimeProfile(result))
        if not self.paths:
            return made
        from motionlang.commands.profile.paths import paths, paths_table

        return Document([paths_table(paths(result.trace)), *made.tables], made.values)

    def conclusion(self, result: Result, *, width: int, colour: bool) -> str:
        if not self.shows(result):
            return ""
        shown = render_profile(TimeProfile(result), width=width, colour=colour, everything=self.all)
        if self.paths:
            from motionlang.commands.profile.paths import paths, paths_table

            lines = paths_table(paths(result.trace)).lines(width, colour=colour, everything=self.all)
            shown = "\n".join([*lines, "", shown])
        return shown

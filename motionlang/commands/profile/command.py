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

    @property
    def lists_all(self) -> bool:
        return self.all

    def extend(self, result: Result) -> None:
        within_budget(result)

    def print_json(self, result: Result) -> None:
        self.show(self.document(result), "")

    def document(self, result: Result) -> Document:
        return profile_document(TimeProfile(result))

    def conclusion(self, result: Result, *, width: int, colour: bool) -> str:
        if not self.shows(result):
            return ""
        return render_profile(TimeProfile(result), width=width, colour=colour, everything=self.all)

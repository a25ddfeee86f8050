"""MCCL, PMC's Motion Control Command Language.

`DIALECT` is its interface for programs. `PUBLIC` are the names for hosts and questions. Everything is imported on first
use.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from typing import TYPE_CHECKING

from motionlang.kernel.lang.dialect import Dialect, Interactive
from motionlang.kernel.lazy import lazy_names
from motionlang.kernel.source import Source

if TYPE_CHECKING:
    from motionlang.kernel.lang.keyword import Keyword
    from motionlang.kernel.lang.machine.machine import Machine
    from motionlang.kernel.lang.machine.switch import Switch
    from motionlang.kernel.lang.vocabulary import Vocabulary
    from motionlang.kernel.mccl.axis.axis import AxisState as AxisState
    from motionlang.kernel.mccl.axis.launch import aim as aim
    from motionlang.kernel.mccl.axis.motion_phase import at_target_time as at_target_time
    from motionlang.kernel.mccl.axis.motor import torque as torque
    from motionlang.kernel.mccl.axis.status import RECORD_PERIOD as RECORD_PERIOD
    from motionlang.kernel.mccl.axis.volts import volts as volts
    from motionlang.kernel.mccl.codes import MEANINGS as MEANINGS
    from motionlang.kernel.mccl.codes import Fault as Fault
    from motionlang.kernel.mccl.keywords import table as table
    from motionlang.kernel.mccl.keywords.io import is_on as is_on
    from motionlang.kernel.mccl.keywords.motion_record import recorded_actual as recorded_actual
    from motionlang.kernel.mccl.keywords.motion_record import recorded_optimal as recorded_optimal
    from motionlang.kernel.mccl.keywords.motion_record import recorded_output as recorded_output
    from motionlang.kernel.mccl.keywords.motion_record import recorded_times as recorded_times
    from motionlang.kernel.mccl.models import MODELS as MODELS
    from motionlang.kernel.mccl.models import Model as Model
    from motionlang.kernel.mccl.models import models_with as models_with
    from motionlang.kernel.mccl.models import written_for as written_for
    from motionlang.kernel.mccl.resolve.command import NONE as NONE
    from motionlang.kernel.mccl.resolve.command import NUMBER as NUMBER
    from motionlang.kernel.mccl.resolve.command import Command as Command
    from motionlang.kernel.mccl.resolve.decode import checked as checked
    from motionlang.kernel.mccl.resolve.line import Line as Line
    from motionlang.kernel.mccl.resolve.line import line_of as line_of
    from motionlang.kernel.mccl.resolve.line import locate as locate
    from motionlang.kernel.mccl.resolve.line import too_long as too_long
    from motionlang.kernel.mccl.runtime.board import Board as Board
    from motionlang.kernel.mccl.runtime.program import FileTask as FileTask
    from motionlang.kernel.mccl.runtime.program import MacroFile as MacroFile
    from motionlang.kernel.mccl.runtime.task import FORMS as FORMS
    from motionlang.kernel.mccl.runtime.task import Action as Action
    from motionlang.kernel.mccl.runtime.task import CommandTask as CommandTask
    from motionlang.kernel.mccl.runtime.writer import LineSteps as LineSteps
    from motionlang.kernel.mccl.syntax.comments import COMMENT as COMMENT
    from motionlang.kernel.mccl.syntax.comments import without_comment as without_comment
    from motionlang.kernel.mccl.syntax.parser import MAX_LINE as MAX_LINE


PUBLIC = {
    "codes": "Fault MEANINGS",
    "models": "Model MODELS models_with written_for",
    "keywords": "table",
    "resolve.command": "Command NONE NUMBER",
    "resolve.line": "Line line_of locate too_long",
    "syntax.parser": "MAX_LINE",
    "syntax.comments": "COMMENT without_comment",
    "runtime.board": "Board",
    "runtime.task": "CommandTask Action FORMS",
    "runtime.program": "MacroFile FileTask",
    "runtime.writer": "LineSteps",
    "resolve.decode": "checked",
    "axis.axis": "AxisState",
    "axis.launch": "aim",
    "axis.motion_phase": "at_target_time",
    "axis.motor": "torque",
    "axis.volts": "volts",
    "axis.status": "RECORD_PERIOD",
    "keywords.io": "is_on",
    "keywords.motion_record": "recorded_actual recorded_optimal recorded_times recorded_output",
}


class Mccl(Dialect):
    """MCCL as an implementation of the dialect interface."""

    name, title = "mccl", "MCCL"
    # PMC's own tools have one suffix per controller.
    suffixes = (
        ".mcl", ".mccl", ".dc2", ".stn", ".pc1", ".at1", ".at2", ".at3", ".pci1", ".pci3", ".mfx1",
    )  # fmt: skip
    first_axis = 1
    comment = ";"
    has_one_series = True
    jumps = frozenset(("call_macro", "define_macro", "jump", "jump_by", "jump_macro", "start_task"))

    def program(
        self, source: Source, settings: Mapping[str, object] | None = None, *, is_debug: bool = False
    ) -> MacroFile:
        from motionlang.kernel.mccl.runtime.program import MacroFile

        return MacroFile(source, settings, is_debug)

    def forms(self, row: Keyword) -> tuple[str, ...]:
        from motionlang.kernel.mccl.keywords.row import forms

        return forms(row)

    def models(self) -> tuple[str, ...]:
        from motionlang.kernel.mccl.models import MODELS

        return tuple(MODELS)

    def knows_model(self, name: str) -> bool:
        from motionlang.kernel.mccl.models import named

        return named(name) is not None

    def switches(self) -> Mapping[str, Switch]:
        from motionlang.kernel.mccl.keywords.switchable import SWITCHES

        return SWITCHES

    def table(self) -> Vocabulary:
        from motionlang.kernel.mccl.keywords import table

        return table()

    def locate(self, source: Source, at: int) -> tuple[int, int, int]:
        from motionlang.kernel.mccl.resolve.line import locate

        return locate(source, at)

    def driven_by(self, why: str) -> list[str]:
        import re

        found = re.search(r"(home switch|index mark|channel)( of axis)? (\d+)", why)
        keys = {"home switch": "axis.{}.home_switch", "index mark": "axis.{}.index_every", "channel": "input"}
        return [keys[found[1]].format(found[3])] if found else []

    def interactive(self, machine: Machine) -> Interactive:
        from motionlang.kernel.mccl.runtime.session import BoardSession

        return BoardSession(machine)

    def has_code(self, line: str) -> bool:
        from motionlang.kernel.mccl.syntax.parser import parse

        return bool(parse(line).lines)

    def tokens(self, text: str) -> Iterator[tuple[str, str, int]]:
        from motionlang.kernel.mccl.syntax.tokens import tokens

        return tokens(text)


DIALECT = Mccl()

if not TYPE_CHECKING:
    __getattr__ = lazy_names(__name__, PUBLIC)

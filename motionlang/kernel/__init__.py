"""The parts that run a program: source, languages, controller, planners, servo and log.

    text ─► tree ─► check ─► steps ─► task ─► scheduler ─► operations ─► profiles ─► log ─► report

`execution.run` goes this way, from a `Source` to a `Run`. Two languages, `mint` and `mccl`, become steps, which tasks
of `lang` carry out. They call the operations of one `controller`, whose moves become closed-form profiles of `planners`
on a virtual clock. The `log` has what happened. A result depends on the program and its machine alone: no real time, no
randomness, no order of a hash.

Import from here what most uses need, the rest from the subpackage that has it: `planners`, `controller`, `servo`,
`log`, `tracks`, `lang`, `mint`, `mccl`. `PUBLIC` of each has its names, docs/contributing/kernel.md what each name is.
`tools`, `files`, `report`, `rows`, `cache` and `version` are imported as modules.

Every other package reads what the kernel makes. The kernel imports none, except where `pyproject.toml` lists it.
"""

from typing import TYPE_CHECKING

from motionlang.kernel.lazy import lazy_names

if TYPE_CHECKING:
    from motionlang.kernel.assumptions.used import depended_on as depended_on
    from motionlang.kernel.controller.axis import Axis as Axis
    from motionlang.kernel.controller.clock import INFINITY as INFINITY
    from motionlang.kernel.controller.operations import Controller as Controller
    from motionlang.kernel.errors import CODES as CODES
    from motionlang.kernel.errors import Diagnostic as Diagnostic
    from motionlang.kernel.errors import OutOfTime as OutOfTime
    from motionlang.kernel.errors import ProgramError as ProgramError
    from motionlang.kernel.errors import Rejected as Rejected
    from motionlang.kernel.errors import Terminated as Terminated
    from motionlang.kernel.execution import ONE_SHIFT as ONE_SHIFT
    from motionlang.kernel.execution import CheckedSettings as CheckedSettings
    from motionlang.kernel.execution import checked_settings as checked_settings
    from motionlang.kernel.execution import end_of as end_of
    from motionlang.kernel.execution import run as run
    from motionlang.kernel.execution import run_on as run_on
    from motionlang.kernel.execution import settings_next_to as settings_next_to
    from motionlang.kernel.lang.debugging import Hook as Hook
    from motionlang.kernel.lang.debugging import Variable as Variable
    from motionlang.kernel.lang.dialect import Dialect as Dialect
    from motionlang.kernel.lang.dialect import dialect as dialect
    from motionlang.kernel.lang.dialect import dialect_for as dialect_for
    from motionlang.kernel.lang.dialect import dialect_of as dialect_of
    from motionlang.kernel.lang.dialect import dialects as dialects
    from motionlang.kernel.lang.dialect import language_of as language_of
    from motionlang.kernel.lang.dialect import parse as parse
    from motionlang.kernel.lang.dialect import unknown_model as unknown_model
    from motionlang.kernel.lang.keyword import Keyword as Keyword
    from motionlang.kernel.lang.machine.entries import WrongEntry as WrongEntry
    from motionlang.kernel.lang.machine.entries import entries as entries
    from motionlang.kernel.lang.machine.entries import with_entries as with_entries
    from motionlang.kernel.lang.machine.file import check_setting as check_setting
    from motionlang.kernel.lang.machine.file import read_machine as read_machine
    from motionlang.kernel.lang.machine.file import read_value as read_value
    from motionlang.kernel.lang.machine.machine import DEFAULT_AXES as DEFAULT_AXES
    from motionlang.kernel.lang.machine.machine import Machine as Machine
    from motionlang.kernel.lang.machine.machine import missing_axes as missing_axes
    from motionlang.kernel.lang.program import Program as Program
    from motionlang.kernel.lang.scheduler import Outside as Outside
    from motionlang.kernel.lang.scheduler import Scheduler as Scheduler
    from motionlang.kernel.lang.scheduler import Stuck as Stuck
    from motionlang.kernel.lang.steps import Steps as Steps
    from motionlang.kernel.lang.task import Task as Task
    from motionlang.kernel.lang.waits import Wait as Wait
    from motionlang.kernel.moves import Move as Move
    from motionlang.kernel.moves import Moves as Moves
    from motionlang.kernel.report_types import Report as Report
    from motionlang.kernel.result import Run as Run
    from motionlang.kernel.run_notes import who_ended as who_ended
    from motionlang.kernel.source import MACHINE_SUFFIX as MACHINE_SUFFIX
    from motionlang.kernel.source import MAX_BYTES as MAX_BYTES
    from motionlang.kernel.source import STDIN as STDIN
    from motionlang.kernel.source import STDIN_NAME as STDIN_NAME
    from motionlang.kernel.source import Source as Source
    from motionlang.kernel.source import machine_of as machine_of
    from motionlang.kernel.source import name_of as name_of
    from motionlang.kernel.tracks.trace import Trace as Trace

# The names of each module. Each is imported on first use.
PUBLIC = {
    # Texts and languages.
    "source": "Source STDIN STDIN_NAME name_of machine_of MACHINE_SUFFIX MAX_BYTES",
    "lang.dialect": "Dialect dialect dialects dialect_of dialect_for language_of parse unknown_model",
    "lang.keyword": "Keyword",
    "lang.program": "Program",
    "lang.steps": "Steps",
    # Runs.
    "execution": "run run_on CheckedSettings end_of ONE_SHIFT settings_next_to checked_settings",
    "result": "Run",
    "run_notes": "who_ended",
    "assumptions.used": "depended_on",
    "report_types": "Report",
    "moves": "Move Moves",
    # Machines.
    "lang.machine.machine": "Machine DEFAULT_AXES missing_axes",
    "lang.machine.file": "read_machine read_value check_setting",
    "lang.machine.entries": "entries with_entries WrongEntry",
    # While a program runs.
    "lang.scheduler": "Scheduler Stuck Outside",
    "lang.task": "Task",
    "lang.waits": "Wait",
    "lang.debugging": "Hook Variable",
    # The controller.
    "controller.operations": "Controller",
    "controller.axis": "Axis",
    "controller.clock": "INFINITY",
    # What happened.
    "tracks.trace": "Trace",
    # Errors.
    "errors": "Rejected Diagnostic ProgramError Terminated OutOfTime CODES",
}

if not TYPE_CHECKING:
    __getattr__ = lazy_names(__name__, PUBLIC)

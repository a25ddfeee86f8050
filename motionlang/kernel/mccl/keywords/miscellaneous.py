"""All other commands.

They set the format of the dialogue, or little but their name is known.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

from motionlang.kernel.mccl.keywords import table
from motionlang.kernel.mccl.keywords.row import Group
from motionlang.kernel.version import __version__

if TYPE_CHECKING:
    from motionlang.kernel.mccl.resolve.command import Command
    from motionlang.kernel.mccl.runtime.task import CommandTask


def decimal(task: CommandTask, command: Command) -> None:
    task.board.hexadecimal = False


def hexadecimal(task: CommandTask, command: Command) -> None:
    task.board.hexadecimal = True


def echo_off(task: CommandTask, command: Command) -> None:
    task.board.echo = False


def echo_on(task: CommandTask, command: Command) -> None:
    task.board.echo = True


def prompt_character(task: CommandTask, command: Command) -> None:
    code = task.whole(command)
    task.board.prompt = chr(code) if code >= 32 else ""


def xon_code(task: CommandTask, command: Command) -> None:
    task.board.xon = task.whole(command)


def xoff_code(task: CommandTask, command: Command) -> None:
    task.board.xoff = task.whole(command)


def tell_version(task: CommandTask, command: Command) -> None:
    task.reply(f"{task.board.model.title}, motionlang {__version__}")


def tell_help(task: CommandTask, command: Command) -> None:
    for row in table():
        if row.name not in task.lacks:
            task.reply(f"{row.name} {row.help}")


# ------------------------------------------------------------------------------------------------- keywords

_G = Group("miscellaneous")
_row, _known = _G.row, _G.known
_reports_row = Group("reports").row


ROWS = (
    _row("DM", "command", "C", "none", "", decimal, "Decimal replies.", "DM"),
    _row("HM", "command", "C", "none", "", hexadecimal, "Hexadecimal replies of whole numbers.", "HM,1TS"),
    _row("EF", "command", "C", "none", "", echo_off, "Echo off.", "EF"),
    _row("EN", "command", "C", "none", "", echo_on, "Echo on.", "EN"),
    _row("PC", "command", "W", "none", "number", prompt_character,
         "Set the character code of the prompt; 0 for none.", "PC62", low=0, high=126),
    _row("XN", "command", "W", "none", "number", xon_code,
         "Set the code that lets the controller send; 0 for none.",
         "XN17", low=0, high=255),
    _row("XF", "command", "W", "none", "number", xoff_code, "Set the code that stops the controller sending; 0 for "
         "none.", "XF19", low=0, high=255),
    _known("DW", "command", "none", "Disable the watchdog; there is none here."),
    _known("FM", "command", "none", "Only the name is known, perhaps float mode."),
    _known("CB", "command", "axis", "Capture positions; where the captured ones are read is not known."),
    _known("BC", "command", "axis", "Begin position compare; the output it switches is not known."),
    _known("LC", "command", "axis", "Load a position to compare with; the output it switches is not known."),
    _known("NC", "command", "axis", "No position compare any more."),
    _known("OC", "command", "axis", "Output of position compare: 0 none, 1 static, 2 toggle, 3 one-shot, 5 strobe."),
    _known("OP", "command", "axis", "Period of the one-shot output of position compare."),
    _known("YF", "command", "axis", "Digital filter on."),
    _known("NF", "command", "axis", "Digital filter off."),
    _known("ZF", "command", "axis", "Digital filter cleared."),
    _known("FL", "command", "axis", "Digital filter coefficients loaded."),
    _reports_row("VE", "reading", "R", "none", "text", tell_version, "Tell the model and the version.", "VE"),
    _reports_row("HE", "reading", "R", "none", "text", tell_help, "List the commands.", "HE", meant="HELP"),
)  # fmt: skip

"""How the controller talks, and what it says about itself."""

from __future__ import annotations

from motionlang import __version__
from motionlang.mccl.keywords import TABLE

TYPE_CHECKING = False
if TYPE_CHECKING:
    from motionlang.mccl.resolve.command import Command
    from motionlang.mccl.runtime.task import Action, CommandTask


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
    for row in TABLE:
        if row.name not in task.lacks:
            task.reply(f"{row.name} {row.help}")


ACTIONS: dict[str, Action] = {
    "decimal": decimal,
    "hexadecimal": hexadecimal,
    "echo_off": echo_off,
    "echo_on": echo_on,
    "prompt_character": prompt_character,
    "xon_code": xon_code,
    "xoff_code": xoff_code,
    "tell_version": tell_version,
    "tell_help": tell_help,
}

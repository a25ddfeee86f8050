"""`motionlang completion`: a shell completion script, generated from the parser."""

from __future__ import annotations

import argparse
import sys
from collections.abc import Iterator

from motionlang.cli.commands import build_parser
from motionlang.cli.parser import Commands, add_command
from motionlang.errors import need

SHELLS = ("bash", "zsh", "fish")
# Names of files in the help.
FILES = ("FILE", "PATH", "M.toml")


EPILOG = """\
examples:
  motionlang completion bash > ~/.local/share/bash-completion/completions/motionlang
  motionlang completion zsh > ~/.zfunc/_motionlang
  motionlang completion fish > ~/.config/fish/completions/motionlang.fish
"""


def add_parser(commands: Commands, summary: str) -> None:
    """Add `motionlang completion` and its options."""
    parser = add_command(commands, "completion", summary, completion_command, EPILOG)
    parser.add_argument("shell", choices=SHELLS, help="the shell; needs the extra `completion`")


def completion_command(arguments: argparse.Namespace) -> int:
    """Print the completion script of a shell; raise MissingExtra without shtab."""
    need("motionlang completion", "shtab")
    import shtab

    whole = build_parser("*")
    for action in _actions(whole):
        if str(action.metavar) in FILES:
            action.complete = shtab.FILE  # type: ignore[attr-defined]
    sys.stdout.write(shtab.complete(whole, arguments.shell) + "\n")
    return 0


def _actions(parser: argparse.ArgumentParser) -> Iterator[argparse.Action]:
    """Yield every option and argument of a parser and of its subcommands."""
    for action in parser._actions:
        yield action
        if isinstance(action, argparse._SubParsersAction):
            for inner in action.choices.values():
                yield from _actions(inner)

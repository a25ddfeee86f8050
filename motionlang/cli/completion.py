"""`motionlang completion`: a shell completion script, made from the parsers."""

from __future__ import annotations

import argparse
import sys
from collections.abc import Iterator
from dataclasses import dataclass
from typing import ClassVar

from motionlang.cli.command import Command, argument
from motionlang.cli.commands import build_parser
from motionlang.kernel.tools import need

# Names of files in the help.
FILES = ("FILE", "PATH", "OUT", "M.toml")


@dataclass
class Completion(Command):
    """Print a completion script for bash, zsh or fish."""

    epilog: ClassVar[str] = """\
examples:
  motionlang completion bash > \\
      ~/.local/share/bash-completion/completions/motionlang
  motionlang completion zsh > ~/.zfunc/_motionlang
  motionlang completion fish > ~/.config/fish/completions/motionlang.fish
"""
    shell: str = argument(
        "SHELL", "the shell: bash, zsh or fish; needs the extra `completion`", choices=("bash", "zsh", "fish")
    )

    def run(self) -> int:
        need("motionlang completion", "shtab")
        import shtab

        whole = build_parser("*")
        for action in _actions(whole):
            if isinstance(action, argparse._SubParsersAction):
                action.help = None  # the help lists them itself; shtab leaves out what is suppressed
            if str(action.metavar) in FILES:
                action.complete = shtab.FILE  # type: ignore[attr-defined]
        sys.stdout.write(shtab.complete(whole, self.shell) + "\n")
        return 0


def _actions(parser: argparse.ArgumentParser) -> Iterator[argparse.Action]:
    for action in parser._actions:
        yield action
        if isinstance(action, argparse._SubParsersAction):
            for inner in action.choices.values():
                yield from _actions(inner)

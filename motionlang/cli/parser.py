"""argparse for this command line: no abbreviations, two-line errors, suggestions."""

from __future__ import annotations

import argparse
import os
import re
import sys
from typing import TYPE_CHECKING, Any, NoReturn, TypeAlias

from motionlang.errors import nearest

if TYPE_CHECKING:
    from collections.abc import Callable, Iterable, Mapping, Sequence

    from _typeshed import SupportsWrite


# Numbers below zero are values, never options; argparse itself does not recognise those with an exponent.
_NEGATIVE = re.compile(r"-(\d+\.?\d*|\.\d+)([eE][-+]?\d+)?$")


class Formatter(argparse.RawDescriptionHelpFormatter):
    """Help whose paragraphs fill the width and whose indented lines are not joined."""

    def __init__(self, prog: str, **options: int) -> None:
        # argparse makes one for each option, and would import shutil for its width.
        options.setdefault("width", _columns() - 2)
        super().__init__(prog, **options)

    def _split_lines(self, text: str, width: int) -> list[str]:
        return _filled(text.split(), width)

    def _fill_text(self, text: str, width: int, indent: str) -> str:
        lines: list[str] = []
        for block in text.split("\n\n"):
            paragraph: list[str] = []
            for line in block.split("\n"):
                if line.startswith(" "):
                    lines += _filled(paragraph, width)
                    lines += _example(line, width)
                    paragraph = []
                else:
                    paragraph.append(line)
            lines += [*_filled(paragraph, width), ""]
        return "\n".join(lines).rstrip("\n") + "\n"


def _columns() -> int:
    """Return the terminal width for help texts, like `shutil.get_terminal_size`.

    Importing shutil would load its compression libraries.
    """
    named = os.environ.get("COLUMNS", "")
    if named.isdigit() and int(named) > 0:
        return int(named)
    try:
        return os.get_terminal_size(sys.__stdout__.fileno()).columns or 80  # type: ignore[union-attr]
    except (AttributeError, ValueError, OSError):
        return 80


def _filled(paragraph: list[str], width: int) -> list[str]:
    import textwrap

    return textwrap.wrap(" ".join(paragraph), width, break_on_hyphens=False) if paragraph else []


def _example(line: str, width: int) -> list[str]:
    """Return an indented line; if it is too long, its remark moves to the next line."""
    import textwrap

    if len(line) <= width:
        return [line]
    command, gap, remark = re.fullmatch(r"( +\S+(?: \S+)*)(  +|$)(.*)", line).groups()  # type: ignore[union-attr]
    deeper = " " * (len(line) - len(line.lstrip()) + 4)
    if gap and command.strip().startswith("motionlang"):
        return [*_example(command, width), f"{deeper}{remark}"]
    begin = f"{command}{gap}"
    if gap:
        return textwrap.wrap(
            remark, width, initial_indent=begin, subsequent_indent=" " * len(begin), break_on_hyphens=False
        )
    found = textwrap.wrap(
        line, width - 2, subsequent_indent=deeper, break_on_hyphens=False, drop_whitespace=True
    )
    return [*(f"{each} \\" for each in found[:-1]), found[-1]]


class Parser(argparse.ArgumentParser):
    """argparse without abbreviated options, and with help texts that preserve lines."""

    def __init__(self, **options: object) -> None:
        options.setdefault("formatter_class", Formatter)
        super().__init__(allow_abbrev=False, **options)  # type: ignore[arg-type]
        self._negative_number_matcher = _NEGATIVE
        # The innermost command reports what it does not know.
        self.set_defaults(parser=self)

    def error(self, message: str) -> NoReturn:
        """Report an error in two lines and exit with 2; --help has the usage line."""
        self.exit(2, f"{self.prog}: error: {_in_our_words(message)}\n  hint: {self._hint(message)}\n")

    def _print_message(self, message: str, file: SupportsWrite[str] | None = None) -> None:
        """Write a help text; argparse itself ignores a failed write."""
        (file or sys.stderr).write(message)
        sys.stdout.flush()

    def _hint(self, message: str) -> str:
        wrong = re.search(r"unrecognized arguments: (--[\w-]+)|invalid choice: '([\w-]+)'", message)
        if wrong is not None:
            words = self._options() if wrong[1] else {word: word for word in self._words()}
            near = nearest(wrong[1] or wrong[2], words)
            if near is not None:
                return f"did you mean {words[near]}?"
        file = re.search(r"COMMAND: invalid choice: '(\S+\.\w+)'", message)
        if file is not None:
            return f"{self.prog} run {file[1]} runs a program"
        return f"{self.prog} --help lists the options"

    def _options(self) -> dict[str, str]:
        """Return all options by spelling, with `--CHOICE` as a spelling of each choice.

        Example: `--json` leads to `--format json`.
        """
        spellings: dict[str, str] = {}
        for action in self._actions:
            for choice in action.choices or ():
                spellings[f"--{choice}"] = " ".join((*action.option_strings[-1:], str(choice)))
        return spellings | {option: option for action in self._actions for option in action.option_strings}

    def _words(self) -> list[str]:
        """Return every option and every choice, including those of the commands."""
        words: list[str] = []
        for action in self._actions:
            words += [*action.option_strings, *map(str, action.choices or ())]
            if isinstance(action, argparse._SubParsersAction):
                words += [word for parser in action.choices.values() for word in parser._words()]
        return words


def _in_our_words(message: str) -> str:
    """Return argparse's error of a wrong choice in the wording of this command line.

    The quotes in argparse's message depend on the version of Python.
    """
    wrong = re.fullmatch(r"argument (.+?): invalid choice: '(.*)' \(choose from (.*)\)", message, re.DOTALL)
    if wrong is None:
        return message
    if wrong[1] == "COMMAND":
        return f"there is no command {wrong[2]}"
    if " | " in wrong[1]:
        return f"there is no command {wrong[2]}; choose {either(wrong[1].split(' | '))}"
    choices = wrong[3].replace("'", "")
    return f"argument {wrong[1]}: {wrong[2]!r} is not one of {choices}"


# The names of an option, and the other arguments of `add_argument`.
Row: TypeAlias = "tuple[list[str], dict[str, Any]]"
Commands: TypeAlias = "argparse._SubParsersAction[Parser]"


def add_command(
    commands: Commands, name: str, summary: str, call: Callable[..., int], epilog: str = ""
) -> argparse.ArgumentParser:
    parser = commands.add_parser(name, help=summary, description=sentence(summary), epilog=epilog)
    parser.set_defaults(command=call)
    return parser


def option(
    names: str, metavar: str | None, help: str, type: Callable[[str], object] | None = None, **more: object
) -> Row:
    """Return an option or argument with a value; `more` goes to `add_argument`."""
    if type is not None:
        more["type"] = type
    if metavar is not None:
        more["metavar"] = metavar
    return names.split(), {"help": help, **more}


def flag(name: str, help: str) -> Row:
    """Return an option without a value."""
    return [name], {"action": "store_true", "help": help}


def add_all(parser: argparse._ActionsContainer, rows: Iterable[Row]) -> None:
    for names, options in rows:
        parser.add_argument(*names, **options)


def arrange(parser: argparse.ArgumentParser, groups: Mapping[str, str]) -> None:
    """Show options under headings in help.

    Each group has a title and the names of its options. Options in no group stay under the general heading.
    Names that the parser does not have are skipped, so that commands can share groups.
    """
    for title, names in groups.items():
        actions = [parser._option_string_actions.get(f"--{name}") for name in names.split()]
        group = parser.add_argument_group(title)
        for action in filter(None, actions):
            parser._optionals._group_actions.remove(action)
            group._group_actions.append(action)


def either(words: Sequence[str]) -> str:
    return f"{', '.join(words[:-1])} or {words[-1]}"


def sentence(summary: str) -> str:
    """Return a summary with a capital and a full stop."""
    return summary[0].upper() + summary[1:] + "."

"""argparse for this command line: no abbreviations, two-line errors, suggestions."""

from __future__ import annotations

import argparse
import re
import sys
from typing import TYPE_CHECKING, NoReturn, TypeAlias

from motionlang.kernel.tools import nearest

if TYPE_CHECKING:
    from collections.abc import Collection, Mapping, Sequence

    from _typeshed import SupportsWrite


# Numbers below zero are values, never options; argparse itself does not recognise those with an exponent.
_NEGATIVE = re.compile(r"-(\d+\.?\d*|\.\d+)([eE][-+]?\d+)?$")


class Parser(argparse.ArgumentParser):
    """argparse without abbreviated options, and with help texts that preserve lines."""

    # The names of all commands, for a hint on an option that is one.
    verbs: Collection[str] = ()
    # What replaces each option and subcommand that a command had in the version before.
    removed: Mapping[str, str] = {}

    def __init__(self, **options: object) -> None:
        options.setdefault("formatter_class", argparse.RawDescriptionHelpFormatter)
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
            word = (wrong[1] or wrong[2]).removeprefix("--")
            if word in self.removed:
                return self.removed[word]
            if word in self.verbs:
                return f"motionlang {word} is a command of its own"
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


Commands: TypeAlias = "argparse._SubParsersAction[Parser]"


def both(words: Sequence[str]) -> str:
    return f"{', '.join(words[:-1])} and {words[-1]}" if len(words) > 1 else words[0]


def either(words: Sequence[str]) -> str:
    return f"{', '.join(words[:-1])} or {words[-1]}" if len(words) > 1 else words[0]


def sentence(summary: str) -> str:
    """Return a summary with a capital and a full stop."""
    return summary[0].upper() + summary[1:] + "."

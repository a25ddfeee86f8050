"""The options for the machine and its language, shared by several commands."""

from __future__ import annotations

import argparse
from collections.abc import Sequence

from motionlang.cli.dialect_option import add_dialect
from motionlang.cli.parser import add_all, option
from motionlang.errors import ProgramError, clipped, shown
from motionlang.lang.dialect import Dialect
from motionlang.lang.literals import canonical
from motionlang.lang.machine.file import check_setting, read_value

_MACHINE = (
    option("--machine", "M.toml", "the machine file; default: pick.machine.toml next to pick.mnt, if it exists"),
    option("--set", "NAME=VALUE", "set a name of the program, or a key of the machine file by its dotted name, such "
           "as controller.axes; may be repeated", action="append", default=[]),
)  # fmt: skip


def add_machine(parser: argparse.ArgumentParser) -> None:
    """Add the machine options of `run`, `repl` and `serve`."""
    add_dialect(parser)
    add_all(parser, _MACHINE)


def set_values(
    pairs: Sequence[str],
    settings: dict[str, object],
    overrides: dict[str, float | str],
    parser: argparse.ArgumentParser,
    language: Dialect | None = None,
) -> None:
    """Sort NAME=VALUE pairs into settings (a dot in the name) and variables.

    `language` is that of the program, if it is known. An invalid pair ends the command with status 2.
    """
    for pair in pairs:
        name, equals, text = pair.partition("=")
        name = canonical(name) or name.strip()
        if not equals or not name:
            parser.error(f"--set needs NAME=VALUE, not {shown(pair)}")
        if "." not in name:
            overrides[name] = _value(text)
            continue
        value = _setting(text)
        problem = check_setting(name, value, language)
        if problem is not None:
            parser.error(f"--set {clipped(pair)}: {problem[0]}; {problem[1]}")
        settings[name] = value


def _setting(text: str) -> object:
    """Parse the value of a machine key as in the machine file; a bare word is a text."""
    try:
        return read_value(text)
    except ProgramError:  # no TOML, more digits than Python reads, or nested too deeply
        return text


def _value(text: str) -> float | str:
    """Return the number that the text represents, or the text if it is not a number."""
    try:
        return float(text)
    except ValueError:
        return text

"""The options for what the program receives from outside: inputs, answers, keys."""

from __future__ import annotations

import argparse
from collections.abc import Mapping

from motionlang.cli.complaints import complain
from motionlang.errors import Diagnostic
from motionlang.lang.machine.entries import WrongEntry, with_entries

# Option, parameter of `with_entries`, placeholder, help.
OPTIONS = (
    (
        "input",
        "inputs",
        "CHANNEL=VALUE@S",
        "a digital input: 2=1@0.5 is on from 0.5 s, 2=1@0.5..0.9 until 0.9 s, 2=1@every 1.2 again and again; "
        "2=out4+0.3 follows output 4 after 0.3 s; CHANNEL may be a name of the machine file; may be repeated",
    ),
    ("analog", "analog", "CHANNEL=PERCENT@S", "an analogue input: 0=25@1 is 25 %% from 1 s; may be repeated"),
    (
        "answer",
        "answers",
        "TEXT",
        "the answer to the next INPUT, or, as PROMPT=TEXT, to the next one that asks PROMPT; may be repeated",
    ),
    ("keys", "keys", "TEXT@S", "keys that the operator presses, such as R@0.5; may be repeated"),
)


def add_world(parser: argparse.ArgumentParser, side: str = "") -> None:
    """Add the options; `side` is "", or "a" or "b" for one of two runs."""
    group = parser.add_argument_group(f"world of {side.upper()}" if side else "world")
    for option, parameter, form, text in OPTIONS:
        group.add_argument(
            f"--{option}-{side}" if side else f"--{option}",
            dest=f"{parameter}_{side}" if side else parameter,
            action="append",
            default=[],
            metavar=form,
            help=f"as --{option}, for {side.upper()} only" if side else text,
        )


def world_of(arguments: argparse.Namespace, side: str = "") -> dict[str, list[str]]:
    """Return the values of the options as arguments of `with_entries`.

    The result is empty if none is given.
    """
    given = {each[1]: getattr(arguments, f"{each[1]}_{side}" if side else each[1]) for each in OPTIONS}
    return {parameter: texts for parameter, texts in given.items() if texts}


def with_world(
    settings: Mapping[str, object], world: Mapping[str, list[str]], file: str
) -> dict[str, object] | None:
    """Return the settings, overridden by the entries of the options.

    None if an entry is wrong, which has been reported.
    """
    try:
        return with_entries(settings, **world)
    except WrongEntry as error:
        complain([Diagnostic("option", error.message, hint=error.hint)], None, file)
        return None

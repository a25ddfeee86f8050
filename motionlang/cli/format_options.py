"""The options for printed data that all commands share: --format, -q and -o."""

from __future__ import annotations

import sys
from argparse import ArgumentParser
from collections.abc import Callable, Sequence
from io import TextIOWrapper
from typing import BinaryIO, cast

from motionlang.cli.complaints import complain, unwritten
from motionlang.files import replacing

TABLE_OR_JSON = ("table", "json")
# What each form is, for help.
_FORMS = {
    "table": "a table",
    "text": "text",
    "json": "one JSON document",
    "csv": "CSV",
    "none": "none",
    "sarif": "SARIF",
    "junit": "JUnit XML",
    "github": "GitHub workflow commands, which annotate the lines",
}


def add_format(
    parser: ArgumentParser,
    forms: Sequence[str] = TABLE_OR_JSON,
    what: str = "the output",
    *,
    has_output: bool = False,
) -> None:
    """Add --format with these forms, the first as default, and -o.

    A command that `has_output` already defines -o. If "none" is among the forms, -q selects it.
    """
    listed = [_FORMS[form] for form in forms]
    listed[0] += " (the default)"
    parser.add_argument(
        "--format",
        choices=forms,
        default=forms[0],
        help=f"the form of {what}: {', '.join(listed[:-1])} or {listed[-1]}",
    )
    if "none" in forms:
        parser.add_argument(
            "-q",
            "--quiet",
            action="store_const",
            dest="format",
            const="none",
            default=forms[0],
            help="same as --format none",
        )
    if not has_output:
        parser.add_argument(
            "-o",
            "--output",
            dest="into",
            metavar="FILE",
            help="write to FILE instead of standard output; an old file is replaced",
        )


def into(path: str, command: Callable[[], int]) -> int:
    """Run a command with standard output redirected to a file, replaced at the end.

    Returns the exit status of the command, or 1 if the file cannot be written.
    """
    before = sys.stdout
    try:
        with replacing(path) as out:
            sys.stdout = TextIOWrapper(cast("BinaryIO", out), "utf-8", write_through=True)
            try:
                return command()
            finally:
                sys.stdout.flush()
                sys.stdout.detach()
                sys.stdout = before
    except OSError as error:
        complain([unwritten(path, error)], None, path)
        return 1

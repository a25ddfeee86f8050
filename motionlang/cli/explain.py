"""`motionlang explain CODE`: the meaning of a diagnostic, an example and its fix."""

from __future__ import annotations

import argparse
import re
import sys
import textwrap

from motionlang.cli.explanations import EXAMPLES, FIXES, MCCL, MINT, Example
from motionlang.cli.parser import Commands, add_command
from motionlang.errors import CODES, Diagnostic, nearest
from motionlang.views.diagnostics import render
from motionlang.views.terminal import draws, plain, wants_colour

WIDTH = 80
EPILOG = """\
examples:
  motionlang explain never-started
  motionlang explain "error[never]"
  motionlang explain                   all codes
"""


def add_parser(commands: Commands, summary: str) -> None:
    """Add `motionlang explain` and its argument."""
    parser = add_command(commands, "explain", summary, explain_command, EPILOG)
    parser.add_argument(
        "code",
        metavar="CODE",
        nargs="?",
        help="the code in the brackets of a diagnostic; default: list all codes",
    )


def explain_command(arguments: argparse.Namespace) -> int:
    """Print the explanation of a code, or the list of all; 1 if it is unknown."""
    if arguments.code is None:
        _write("".join(f"{_item(code)}\n" for code in sorted(CODES)))
        return 0
    code = re.sub(r"^(?:error|warning)\[(.*)\]:?$", r"\1", arguments.code.strip()).lower()
    if code not in CODES:
        near = nearest(code, CODES)
        hint = f"did you mean {near}?" if near else "motionlang explain lists all codes"
        found = Diagnostic("unknown-word", f"there is no diagnostic {code}", hint=hint)
        sys.stderr.write(render(found, colour=wants_colour(sys.stderr)))
        return 1
    _write(explanation(code))
    return 0


def explanation(code: str) -> str:
    """Return the text about a code of `CODES`."""
    lines = [code, "", *_wrapped(CODES[code])]
    for title, example in zip(("with it", "without it"), EXAMPLES.get(code, ()), strict=False):
        lines += ["", f"  {title}", *(f"    {line}" for line in listing(example))]
    lines += ["", *_wrapped(f"Fix: {FIXES[code]}.")]
    return "\n".join(lines) + "\n"


def listing(example: Example) -> list[str]:
    """Return the lines of an example.

    Several files are shown with their names, a single one without. A command is shown only if it has options.
    """
    lines: list[str] = []
    for name, text in example.files.items():
        lines += [f"{name}:"] * (len(example.files) > 1) + text.splitlines()
    verb, *rest = example.command.split()
    if verb not in ("check", "run") or rest not in ([MINT], [MCCL]):
        lines.append(f"$ motionlang {example.command}")
    return lines


def _wrapped(text: str) -> list[str]:
    return textwrap.wrap(text, WIDTH - 2, initial_indent="  ", subsequent_indent="  ", break_on_hyphens=False)


def _item(code: str) -> str:
    return textwrap.fill(
        CODES[code], WIDTH, initial_indent=f"{code:<22}", subsequent_indent=" " * 22, break_on_hyphens=False
    )


def _write(text: str) -> None:
    sys.stdout.write(text if draws(sys.stdout) else plain(text))

"""The meaning of a diagnostic, an example and its fix, for `motionlang help CODE`."""

from __future__ import annotations

import textwrap

from motionlang.commands.help.explanations import EXAMPLES, FIXES, MCCL, MINT, Example
from motionlang.kernel import CODES

WIDTH = 80


def codes() -> str:
    """Return a list of all codes."""
    return "".join(f"{_item(code)}\n" for code in sorted(CODES))


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

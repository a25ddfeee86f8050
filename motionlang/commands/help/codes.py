"""The meaning of a diagnostic, an example and its fix, for `motionlang help CODE`."""

from __future__ import annotations

import textwrap
from collections.abc import Iterator
from typing import TYPE_CHECKING

from motionlang.commands.help.explanations import EXAMPLES, FIXES, MACHINE, MCCL, MINT, Example
from motionlang.kernel import CODES, dialect

if TYPE_CHECKING:
    from motionlang.commands.check.rule import Rule

WIDTH = 80


def codes() -> str:
    """Return a list of all codes."""
    return "".join(f"{_item(code)}\n" for code in sorted(CODES))


def explanation(code: str) -> str:
    """Return the text about a code of `CODES`."""
    lines = [code, "", *_wrapped(CODES[code])]
    for title, example in examples(code):
        lines += ["", f"  {title}", *(f"    {line}" for line in listing(example))]
    lines += ["", *_wrapped(f"Fix: {fix(code)}.")]
    return "\n".join(lines) + "\n"


def examples(code: str) -> Iterator[tuple[str, Example]]:
    """Yield the examples with and without a code, each with its title, which names the language if there are two."""
    rule = _rule(code)
    if rule is None:
        yield from zip(("with it", "without it"), EXAMPLES.get(code, ()), strict=False)
        return
    for language, case in rule.cases.items():
        title = f", in {dialect(language).title}" if len(rule.cases) > 1 else ""
        name = {"mint": MINT, "mccl": MCCL}[language]
        machine = {MACHINE: case.machine} if case.machine else {}
        yield f"with it{title}", Example({name: case.wrong, **machine}, f"check {name}")
        yield f"without it{title}", Example({name: case.right, **machine}, f"check {name}")


def fix(code: str) -> str:
    """Return what to do about a code."""
    rule = _rule(code)
    return FIXES[code] if rule is None else rule.fix


def _rule(code: str) -> Rule | None:
    # Here, since help about keywords needs no rules.
    from motionlang.commands.check.rules import RULES

    return RULES.get(code)


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

"""Writer of docs/diagnostics.md."""

from __future__ import annotations

from pathlib import Path

from motionlang.commands.check.rules import RULES
from motionlang.commands.help.codes import examples, fix, listing
from motionlang.kernel.errors import CODES

PAGE = Path(__file__).parents[1] / "docs" / "diagnostics.md"
HEAD = """\
# Diagnostics

Each error and warning has a code in brackets, such as `error[never]`. `motionlang help never` prints what is here.
[lint.md](lint.md) says how `check` is used, and how a warning is silenced.
"""


def written() -> str:
    """Return the page."""
    return HEAD + "".join(f"\n{_section(code)}" for code in sorted(CODES))


def _section(code: str) -> str:
    rule = RULES.get(code)
    about = f"\n{rule.text}" if rule else ""
    sections = [f"## {code}\n\n{CODES[code]}\n{about}"]
    for title, example in examples(code):
        text = "".join(f"{line}\n" for line in listing(example))
        sections.append(f"\n{title[:1].upper()}{title[1:]}:\n\n```text\n{text}```\n")
    return "".join([*sections, f"\nFix: {fix(code)}.\n"])


def files() -> dict[Path, str]:
    return {PAGE: written()}

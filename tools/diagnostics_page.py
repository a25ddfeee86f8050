"""Writer of docs/diagnostics.md."""

from __future__ import annotations

from pathlib import Path

from motionlang.commands.check.silence import WARNINGS
from motionlang.commands.help.codes import listing
from motionlang.commands.help.explanations import EXAMPLES, FIXES
from motionlang.kernel.errors import CODES

PAGE = Path(__file__).parents[1] / "docs" / "diagnostics.md"
HEAD = """\
# Diagnostics

Each error and warning has a code in brackets, such as `error[never]`. `motionlang help never` prints what is here.
The [warnings of `check`](lint.md) have more explanation on their own page.
"""


def written() -> str:
    """Return the page."""
    return HEAD + "".join(f"\n{_section(code)}" for code in sorted(CODES))


def _section(code: str) -> str:
    link = f" [More](lint.md#{code})" if code in WARNINGS and code not in ("unknown-word",) else ""
    sections = [f"## {code}\n\n{CODES[code]}{link}\n"]
    for title, example in zip(("With it", "Without it"), EXAMPLES.get(code, ()), strict=False):
        sections.append(
            f"\n{title}:\n\n```text\n" + "".join(f"{line}\n" for line in listing(example)) + "```\n"
        )
    return "".join([*sections, f"\nFix: {FIXES[code]}.\n"])


def files() -> dict[Path, str]:
    return {PAGE: written()}

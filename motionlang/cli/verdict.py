"""What `motionlang verify` has to say of one program, scenario or sweep: made by any process, told by the first."""

from __future__ import annotations

from typing import TYPE_CHECKING

from motionlang.cli.golden import MOST_DIFFERENCES
from motionlang.errors import Diagnostic

if TYPE_CHECKING:
    from collections.abc import Sequence

    from motionlang.source import Source


class Verdict:
    """Whether it `failed`, the `lines` that are printed, and the `diagnostics`, which are about the file `place`.

    `kind` is "program", "scenario" or "sweep".
    """

    __slots__ = ("diagnostics", "failed", "kind", "lines", "name", "place", "source")

    def __init__(self, name: str, kind: str = "program") -> None:
        self.name = self.place = name
        self.kind = kind
        self.failed = False
        self.lines: list[str] = []
        self.diagnostics: list[Diagnostic] = []
        self.source: Source | None = None

    def refuse(self, diagnostics: list[Diagnostic], source: Source | None = None, place: str = "") -> None:
        """It could not be run, or its golden files not be read or written; a `source` is what is wrong."""
        self.failed, self.diagnostics = True, diagnostics
        self.source, self.place = source, place or self.name

    def fail(self, message: str) -> None:
        """It failed for a reason that is one line."""
        self.failed = True
        self.lines.append(f"{self.name}: {message}")

    def tell(self, found: Sequence[str]) -> None:
        """It failed if anything was found that differs."""
        if found:
            self.fail("differs")
            self.lines += [f"  {each}" for each in found[:MOST_DIFFERENCES]]
            if len(found) > MOST_DIFFERENCES:
                self.lines.append(f"  and {len(found) - MOST_DIFFERENCES} more")

    def findings(self) -> list[Diagnostic]:
        """The same as diagnostics, for other tools."""
        told = [Diagnostic("golden", "\n".join(self.lines))] if self.failed and self.lines else []
        return self.diagnostics + told

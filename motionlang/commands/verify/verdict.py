"""The result of `motionlang verify` for one program, scenario or sweep.

Any process can compute it; the first process reports it.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from contextlib import contextmanager

from motionlang.cli.complaints import unreadable
from motionlang.commands.diff.golden import MAX_DIFFERENCES
from motionlang.kernel import Diagnostic, ProgramError, Source, machine_of


class Verdict:
    """A result: `failed`, `lines` to print, and `diagnostics` about the file `path`.

    `kind` is "program", "scenario", "sweep", "check" or "certificate". `has_golden` is False for a program of
    which only expectations, scenarios or a sweep are checked. `is_outdated` is True if its golden files are missing or
    differ.
    """

    def __init__(self, name: str, kind: str = "program") -> None:
        self.name = self.path = name
        self.kind = kind
        self.failed, self.has_golden, self.is_outdated = False, True, False
        self.lines: list[str] = []
        self.diagnostics: list[Diagnostic] = []
        self.source: Source | None = None

    def refuse(self, diagnostics: list[Diagnostic], source: Source | None = None, path: str = "") -> None:
        """Fail because the program could not run, or golden files not be read or written.

        `source` is the text with the error.
        """
        self.failed, self.diagnostics = True, diagnostics
        self.source, self.path = source, path or self.name

    @contextmanager
    def reading(self) -> Iterator[None]:
        """Fail if a file cannot be read, or if the settings of the file, or next to it, are wrong."""
        try:
            yield
        except OSError as error:
            self.refuse([unreadable(str(error.filename or self.name), error)])
        except ProgramError as error:
            wrong = self.name if self.name.endswith(".toml") else machine_of(self.name)
            self.refuse(error.diagnostics, Source.read(wrong) if wrong else None, wrong or "")

    def fail(self, message: str) -> None:
        """Fail for a reason of one line."""
        self.failed = True
        self.lines.append(f"{self.name}: {message}")

    def report(self, found: Sequence[str]) -> None:
        """Fail if any differences were found."""
        if found:
            self.fail("differs")
            self.lines += [f"  {each}" for each in found[:MAX_DIFFERENCES]]
            if len(found) > MAX_DIFFERENCES:
                self.lines.append(f"  and {len(found) - MAX_DIFFERENCES} more")

    def findings(self) -> list[Diagnostic]:
        """Return the result as diagnostics, for other tools."""
        from_golden = [Diagnostic("golden", "\n".join(self.lines))] if self.failed and self.lines else []
        return self.diagnostics + from_golden

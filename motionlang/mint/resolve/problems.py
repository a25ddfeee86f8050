"""The mistakes of one program, collected so that all of them are told at once."""

from __future__ import annotations

from motionlang.errors import Diagnostic, ProgramError, nearest

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Iterable

    from motionlang.lang.keyword import Table
    from motionlang.mint.syntax.nodes import Module

# More than anybody reads; what follows the first hundred is usually their consequence.
MOST = 100


class Problems:
    """Diagnostics at token numbers, turned into lines and columns."""

    def __init__(self, module: Module) -> None:
        self._module = module
        self.found: dict[tuple[str, int], Diagnostic] = {}
        # Warnings of words at which a run ends, by their keys in `found`: a run tells them beforehand.
        self.ends: set[tuple[str, int]] = set()
        self._wrong = False  # is there an error? Warnings, however many, never hide the first one

    def add(
        self, code: str, message: str, at: int, hint: str = "", severity: str = "error", fix: str = ""
    ) -> None:
        """Note a mistake; the same kind at the same place is told once. `fix` takes the place of the token."""
        if len(self.found) < MOST or (severity == "error" and not self._wrong):
            self._wrong = self._wrong or severity == "error"
            line, column, length = self._place(at)
            self.found.setdefault(
                (code, at),
                Diagnostic(code, message, line, column, length=length, hint=hint, severity=severity, fix=fix),
            )

    def unknown(
        self,
        message: str,
        word: str,
        words: Iterable[str],
        at: int,
        otherwise: str = "",
        table: Table | None = None,
    ) -> None:
        """Note an unknown word, with the nearest known one; with `table`, a keyword of it that lacks brackets, too."""
        if (len(self.found) >= MOST and self._wrong) or ("unknown-word", at) in self.found:
            return
        meant = bracketed(word, table) if table is not None else None
        near = meant or nearest(word, words)
        self.add("unknown-word", message, at, f"did you mean {near}?" if near else otherwise, fix=meant or "")

    def of_the_run(self) -> list[Diagnostic]:
        """The warnings that a run tells, too: where it may end before the program does."""
        return [each for key, each in self.found.items() if key in self.ends]

    def is_pattern(self, at: int) -> bool:
        """Whether the number at a place is written in hexadecimal or binary."""
        return self.text(at)[1:2] in ("x", "X", "b", "B")

    def text(self, at: int) -> str:
        """The text of a token; "" where the program has none."""
        places = getattr(self._module, "places", None)
        return "" if places is None else places.text(at)

    def line(self, at: int) -> int:
        return self._module.line(at)

    def _place(self, at: int) -> tuple[int, int, int]:
        return self._module.line(at), self._module.column(at), self._module.length(at)

    def raise_errors(self) -> None:
        """ProgramError when there is any error; warnings alone raise nothing."""
        if any(each.severity == "error" for each in self.found.values()):
            raise ProgramError(self.found.values())


def bracketed(word: str, table: Table) -> str | None:
    """`GO(3)` for `Go3`: the keyword that somebody has written a number to without brackets; None for other words."""
    stem = word.rstrip("0123456789")
    row = table.get(stem) if stem != word else None
    return None if row is None or row.index == "none" else f"{row.name}({word[len(stem) :]})"

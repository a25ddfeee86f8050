"""Errors and warnings of a program, collected so that all are reported at once."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Sequence
from functools import cached_property

from motionlang.kernel.errors import Diagnostic, ProgramError
from motionlang.kernel.lang.vocabulary import Vocabulary
from motionlang.kernel.mint.models import V4_SUFFIX
from motionlang.kernel.mint.syntax.build import number
from motionlang.kernel.mint.syntax.nodes import Module, Number
from motionlang.kernel.mint.syntax.tokens import token_at, value_length
from motionlang.kernel.mint.syntax.traversal import names_of
from motionlang.kernel.tools import differ_little, nearest

# More are not useful; most errors after the first hundred are consequences of earlier ones.
MAX_DIAGNOSTICS = 100


class Diagnostics:
    """Diagnostics at offsets, turned into lines and columns."""

    def __init__(self, module: Module) -> None:
        self._module = module
        self.found: dict[tuple[str, int], Diagnostic] = {}
        # Keys in `found` of the warnings that a run reports, too: what may end it, and names that may be misspelt.
        self.in_run: set[tuple[str, int]] = set()
        # True once there is an error, so that warnings, however many, never hide the first one.
        self.has_errors = False
        # Declared names that are keywords, in lower case. Their declarations are reported, so their uses are not.
        self.taken: set[str] = set()

    @cached_property
    def is_v4(self) -> bool:
        """True if the program has the dots or square brackets of Mint v4, or its extension and no block of MintMT."""
        module = self._module
        if any(name.axes for name in names_of(module)):
            return True
        blocks = module.subs or module.tasks or module.events or module.startup or module.types
        return not blocks and module.source.name.lower().endswith(V4_SUFFIX)

    @property
    def is_full(self) -> bool:
        """True if further diagnostics are no longer recorded."""
        return len(self.found) >= MAX_DIAGNOSTICS and self.has_errors

    def add(
        self,
        code: str,
        message: str,
        at: int,
        hint: str = "",
        severity: str = "error",
        fix: str = "",
        candidates: Sequence[str] = (),
        end: int = 0,
    ) -> None:
        """Record a problem that is not at a use of a taken name; each code is reported once per position.

        `fix` is the text that would replace the token, or the text up to `end`. `candidates` are texts that might
        replace it.
        """
        if self.taken and self.text(at).partition(".")[0].lower() in self.taken:
            return
        if len(self.found) < MAX_DIAGNOSTICS or (severity == "error" and not self.has_errors):
            self.has_errors = self.has_errors or severity == "error"
            line, column, length = self._location(at)
            self.found.setdefault(
                (code, at),
                Diagnostic(
                    code,
                    message,
                    line,
                    column,
                    length=end - at if end else length,
                    hint=hint,
                    severity=severity,
                    fix=fix,
                    candidates=candidates,
                ),
            )

    def add_to_line(self, line: int, error: Diagnostic) -> None:
        """Record an error about a line without a statement."""
        self.found[error.code, -line] = error
        self.has_errors = True

    def unknown(
        self,
        message: str,
        word: str,
        words: Callable[[], Iterable[str]],
        at: int,
        otherwise: str = "",
        table: Vocabulary | None = None,
    ) -> None:
        """Record an unknown word, with the most similar of `words()` as the suggestion.

        With `table`, keywords are also suggested: one with missing brackets, and those that are meant by the word.
        Without any suggestion the hint is `otherwise`. In a program with the notation of v4, a word that is no
        misspelling may be one of an older Mint.
        """
        if self.is_full or ("unknown-word", at) in self.found:
            return
        meant = bracketed(word, table) if table is not None else None
        known = list(words())
        others = table.meant_by(word) if table is not None else []
        near = [meant] if meant else [each for each in others if each in known] or others
        if not near and (similar := nearest(word, known)):
            near = [similar]
            if table is not None and self.is_v4 and not differ_little(word, similar):
                near = []
        if table is not None and self.is_v4 and not otherwise:
            otherwise = (
                f'for a word of an older Mint, add its keyword to the machine file: [mint.words] {word} = "…"'
            )
        hint = f"did you mean {' or '.join(near)}?" if near else otherwise
        # A candidate replaces the marked text, so that has to be the word.
        candidates = tuple(near) if not meant and self.text(at).lower() == word.lower() else ()
        self.add("unknown-word", message, at, hint, fix=meant or "", candidates=candidates)

    def of_the_run(self) -> list[Diagnostic]:
        """Return the warnings that a run reports before it starts."""
        return [each for key, each in self.found.items() if key in self.in_run]

    def is_pattern(self, node: Number) -> bool:
        """True if a number is written in hexadecimal or binary, and not in place of one that is."""
        text = self.text(node.start)
        return text[1:2] in ("x", "X", "b", "B") and number(text) == node.value

    def text(self, at: int) -> str:
        """Return the text of the token at an offset, "" if the program has none."""
        source = getattr(self._module, "source", None)
        return "" if source is None else token_at(source.text, at)

    def line(self, at: int) -> int:
        return self._module.line(at)

    def line_from(self, at: int) -> str:
        """Return the text from an offset to the end of its line."""
        return self._module.source.text[at:].partition("\n")[0]

    def _location(self, at: int) -> tuple[int, int, int]:
        source = self._module.source
        return (*source.location(at), value_length(source.text, at))

    def raise_errors(self) -> None:
        """Raise ProgramError if there is any error; warnings alone raise nothing."""
        if self.has_errors:
            raise ProgramError(self.found.values())


def bracketed(word: str, table: Vocabulary) -> str | None:
    """Return `GO(3)` for `Go3`, a keyword with a number but no brackets, or None.

    `IN3` and `OUT3` mean one channel, so they become INX(3) and OUTX(3), because IN(3) is a bank.
    """
    stem = word.rstrip("0123456789")
    row = table.get(stem) if stem != word else None
    if row is not None and row.index == "bank":
        row = table.get(f"{stem}X")
    return None if row is None or row.index == "none" else f"{row.name}({word[len(stem) :]})"

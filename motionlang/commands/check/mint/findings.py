"""The warnings of the linter, each reported once."""

from __future__ import annotations

from collections.abc import Sequence

from motionlang.kernel import Diagnostic
from motionlang.kernel.mint.syntax.nodes import Module
from motionlang.kernel.mint.syntax.tokens import value_length


class Findings:
    """Warnings at offsets, turned into lines and columns."""

    def __init__(self, module: Module) -> None:
        self._module = module
        self.found: dict[tuple[str, int, str], Diagnostic] = {}

    def add(
        self,
        code: str,
        message: str,
        at: int,
        hint: str = "",
        candidates: Sequence[str] = (),
        *,
        length: int = 0,
        fix: str = "",
        other: int | None = None,
    ) -> None:
        """Record a warning; the line of offset `other` replaces `{line}` in its message."""
        module = self._module
        if other is not None:
            message = message.replace("{line}", str(module.line(other)))
        where = module.line(at), module.column(at)
        length = length or value_length(module.source.text, at)
        self.found.setdefault(
            (code, at, message),
            Diagnostic(
                code,
                message,
                *where,
                length=length,
                hint=hint,
                severity="warning",
                fix=fix,
                candidates=candidates,
            ),
        )

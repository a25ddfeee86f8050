"""The warnings of the linter, each reported once."""

from __future__ import annotations

from collections.abc import Sequence

from motionlang.kernel.errors import Diagnostic
from motionlang.kernel.mint.resolve.recorder import Recorder
from motionlang.kernel.mint.syntax.nodes import Module
from motionlang.kernel.mint.syntax.tokens import value_length


class Findings:
    """Warnings at offsets, turned into lines and columns.

    They are also passed to `recorder`.
    """

    def __init__(self, module: Module, recorder: Recorder | None = None) -> None:
        self._module, self._recorder = module, recorder
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
        if self._recorder is not None:
            more = {} if other is None else {"other": other}
            self._recorder.note(
                code=code,
                message=message,
                at=at,
                hint=hint,
                candidates=candidates,
                length=length,
                fix=fix,
                **more,
            )
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

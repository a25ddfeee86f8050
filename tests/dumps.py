"""Value change dumps, as pyvcd reads them."""

from __future__ import annotations

from pathlib import Path
from typing import Any

from vcd import reader
from vcd.reader import RealChange, ScalarChange, StringChange, TokenKind


def read(path: Path) -> tuple[dict[str, tuple[str, list[int], list[Any]]], int]:
    """Return the kind, the times (ns) and the values of every variable, and the end (ns)."""
    scope: list[str] = []
    variables: dict[str, tuple[str, list[int], list[Any]]] = {}
    names: dict[str, str] = {}
    now = 0
    with path.open("rb") as file:
        for token in reader.tokenize(file):
            if token.kind is TokenKind.TIMESCALE:
                assert str(token.timescale) == "1 ns"
            elif token.kind is TokenKind.SCOPE:
                scope.append(token.scope.ident)
            elif token.kind is TokenKind.UPSCOPE:
                scope.pop()
            elif token.kind is TokenKind.VAR:
                name = names[token.var.id_code] = ".".join([*scope, token.var.reference])
                variables[name] = token.var.type_.value, [], []
            elif token.kind is TokenKind.CHANGE_TIME:
                assert token.time_change >= now
                now = token.time_change
            elif isinstance(change := token.data, ScalarChange | RealChange | StringChange):
                _, times, values = variables[names[change.id_code]]
                times.append(now)
                values.append(int(change.value) if isinstance(change, ScalarChange) else change.value)
    return variables, now

"""A log whose chunks are small, so that short runs have old moves and profiles."""

from __future__ import annotations

import pytest

from motionlang.kernel.log import log, moves, profiles, stream


def shrink(monkeypatch: pytest.MonkeyPatch, chunk: int = 2, left: int = 4, most: int = 16) -> None:
    """Seal `chunk` rows at a time and leave `left` profiles of an axis of at most `most`; all bytes are in the file."""
    for module in (stream, moves, profiles):
        monkeypatch.setattr(module, "CHUNK", chunk)
    for name, value in (("MAX_OBJECTS", 2 * left), ("LEFT", left)):
        monkeypatch.setattr(moves, name, value)
    monkeypatch.setattr(log, "HURRY", 0.0)
    for name, value in (
        ("FIRST_CHECK", 1), ("MAX_PROFILES", most), ("MAX_FOLLOWED", most), ("LEFT_PROFILES", left)
    ):  # fmt: skip
        monkeypatch.setattr(log, name, value)
    monkeypatch.setattr(stream.Store.__init__, "__defaults__", (400, stream.DISK))

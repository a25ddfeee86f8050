"""A run works equally without the features of CPython that other Pythons lack.

No other Python is run here; the missing features are simulated.
"""

from __future__ import annotations

import gc
import sys
from pathlib import Path

import pytest

from motionlang.__main__ import main as process

ROOT = Path(__file__).parent.parent


@pytest.mark.parametrize("has_settings", [True, False])
def test_what_is_left_when_a_command_ends_is_not_collected(
    monkeypatch: pytest.MonkeyPatch, tmp_path: Path, has_settings: bool
) -> None:
    """The process freezes them, and ends. A collector without these settings is no error."""
    program = tmp_path / "a.mnt"
    program.write_text("PRINT 1\n")
    line = ["run", str(program), "--format", "none"]
    before = gc.get_freeze_count()
    thresholds = gc.get_threshold()
    monkeypatch.setattr(sys, "argv", ["motionlang", *line])
    with monkeypatch.context() as patch:
        if not has_settings:
            patch.delattr(gc, "freeze")
            patch.delattr(gc, "set_threshold")
        assert process() == 0
        assert (gc.get_threshold() != thresholds) == has_settings
        assert (gc.get_freeze_count() > before) == has_settings
    gc.set_threshold(*thresholds)

"""A run works equally without the features of CPython that other Pythons lack.

No other Python is run here; the missing features are simulated.
"""

from __future__ import annotations

import gc
import sys
from pathlib import Path

import pytest

from motionlang.__main__ import main as process
from motionlang.kernel.execution import run
from motionlang.kernel.report import text

ROOT = Path(__file__).parent.parent
PROGRAMS = ("scripts/mint/palletiser.mnt", "scripts/mccl/back-and-forth.mcl")


def reports() -> list[str]:
    return [text(run(ROOT / name)) for name in PROGRAMS]


def test_a_collector_without_thresholds(monkeypatch: pytest.MonkeyPatch) -> None:
    """PyPy's garbage collector has no thresholds and no freeze, but may get one."""
    expected = reports()
    assert expected
    for lacking in (("get_threshold",), ("set_threshold",), ("get_threshold", "set_threshold"), ("freeze",)):
        with monkeypatch.context() as patch:
            for name in lacking:
                patch.delattr(gc, name)
            assert reports() == expected
    before = gc.get_threshold()
    assert reports() == expected
    assert gc.get_threshold() == before


@pytest.mark.parametrize("has_freeze", [True, False])
def test_what_is_left_when_a_command_ends_is_not_collected(
    monkeypatch: pytest.MonkeyPatch, tmp_path: Path, has_freeze: bool
) -> None:
    """The process freezes them, and ends. A collector that cannot freeze is no error."""
    program = tmp_path / "a.mnt"
    program.write_text("PRINT 1\n")
    line = ["run", str(program), "--format", "none"]
    before = gc.get_freeze_count()
    monkeypatch.setattr(sys, "argv", ["motionlang", *line])
    with monkeypatch.context() as patch:
        if not has_freeze:
            patch.delattr(gc, "freeze")
        assert process() == 0
        assert (gc.get_freeze_count() > before) == has_freeze


def test_nothing_uses_what_only_cpython_has() -> None:
    """Only CPython has reference counts and object sizes."""
    for path in (ROOT / "motionlang").rglob("*.py"):
        program = path.read_text(encoding="utf-8")
        for word in ("getrefcount", "getsizeof", "get_referrers", "_PyObject", "ctypes"):
            assert word not in program, f"{path.name}: {word}"

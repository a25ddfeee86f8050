"""The lock of a file of nonvolatile data, without the seconds that a run waits for it."""

from __future__ import annotations

import os
from json import loads
from math import fsum
from pathlib import Path

import pytest

from motionlang.kernel import Machine, Run, Source, files, run
from motionlang.kernel.lang.machine import nonvolatile


def test_a_second_run_on_the_same_data_is_refused(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """Two runs on one file would each miss or overwrite the changes of the other."""
    monkeypatch.setattr(nonvolatile, "PATIENCE", 0.0)
    file, link = tmp_path / "kept.json", tmp_path / "link.json"
    link.symlink_to(file)
    second: list[Run] = []

    def begin_another(machine: Machine) -> None:
        second.append(run(Source("b.mnt", "Dim nv b As Integer = 2"), nv=str(link)))

    run(Source("a.mnt", "Dim nv a As Integer = 1"), nv=str(file), begun=begin_another)
    assert [each.message for each in second[0].diagnostics] == [
        f"the nv data of {link} are in use by another run"
    ]
    assert loads(file.read_text())["values"] == {"a": [1]}
    assert sorted(os.listdir(tmp_path)) == ["kept.json", "link.json"]


def test_a_run_waits_10_seconds_for_its_data(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    file, slept = str(tmp_path / "kept.json"), [0.0]
    monkeypatch.setattr(files, "monotonic", lambda: fsum(slept))
    monkeypatch.setattr(files, "sleep", slept.append)
    holder = files.Lock(file)
    made = run(Source("a.mnt", "Dim nv a As Integer = 1"), nv=file)
    assert [each.message for each in made.diagnostics] == [f"the nv data of {file} are in use by another run"]
    assert fsum(slept) == pytest.approx(10.0, abs=max(slept))
    holder.release()

"""A week takes little more memory than a day: endless runs, each in its own process."""

from __future__ import annotations

import json
import os
import subprocess
import sys
from pathlib import Path

import pytest

SCRIPTS = Path(__file__).parents[1] / "scripts"
DAY = 86_400.0
WEEK = 7.0 * DAY
# Kilobytes that the log of a further day may take: 1 440 moves of a master and a slave.
A_DAY = 20_000


def joystick(folder: Path) -> Path:
    """Return the gallery's joystick, moved every minute, and a program that polls it."""
    moved = [
        f"[[analogue]]\nchannel = 1\nvalue = {25 + minute % 3}\nat = {60.0 * minute}\n"
        for minute in range(10_081)
    ]
    (folder / "week.machine.toml").write_text("".join(moved))
    text = (SCRIPTS / "mccl" / "jog-with-joystick.mcl").read_text().splitlines()
    path = folder / "week.mcl"
    path.write_text("\n".join([*text[:2], "1JN", "WA30,1TV,RP"]) + "\n")
    return path


def conveyor(folder: Path) -> Path:
    """Return the gallery's conveyor, made endless, with a box every 61 seconds."""
    box = "[[input]]\nchannel = 2\naxis = 0\nbetween = [250.0, 300.0]\nevery = 6100.0\ntimes = 10000\n"
    (folder / "week.machine.toml").write_text(box)
    text = (SCRIPTS / "mint" / "conveyor-tracking.mnt").read_text()
    path = folder / "week.mnt"
    path.write_text(text.replace("For n = 1 To 2\n", "Loop\n").replace("\nNext\n", "\nEnd Loop\n"))
    return path


def memory(program: Path, until: float) -> int:
    """Return the peak memory of a run, kB; the run must reach its time limit."""
    command = [
        sys.executable,
        "-m",
        "motionlang",
        "run",
        program.name,
        "--until",
        str(until),
        "--format",
        "json",
    ]
    with open(program.parent / "out.txt", "wb") as out:
        process = subprocess.Popen(command, cwd=program.parent, stdout=out, stderr=out)
        _, status, used = os.wait4(process.pid, 0)
        process.returncode = os.waitstatus_to_exitcode(status)
    report = json.loads((program.parent / "out.txt").read_text())
    assert (report["status"], report["time"], report["diagnostics"]) == ("until", until, [])
    assert len(report["moves"]) >= 0.99 * until / 60.0
    return used.ru_maxrss


@pytest.mark.long
@pytest.mark.skipif(not hasattr(os, "wait4"), reason="POSIX")
@pytest.mark.parametrize("make", [joystick, conveyor])
def test_a_week_takes_little_more_memory_than_a_day(make: object, tmp_path: Path) -> None:
    assert callable(make)
    program = make(tmp_path)
    day, week = memory(program, DAY), memory(program, WEEK)
    print(f"{program.name}: {day} kB for a day, {week} kB for a week")
    assert week <= day + 6 * A_DAY

"""Prove every run of a Python process that has this folder on its path.

A failed proof ends the process. Figures are meaningless then. `python -m benchmarks --prove` adds the folder
for its benchmarks and for every process that they start.
"""

from __future__ import annotations

import atexit
import sys

from motionlang.analysis.proof.prove import prove
from motionlang.lang.machine.machine import Machine
from motionlang.lang.scheduler import Scheduler
from motionlang.log.expected_motion import ExpectedMotion
from motionlang.log.track import Recorded

_run = Scheduler.run
_count = [0]


def _proved(scheduler: Scheduler, until: float = float("inf")) -> str:
    machine = scheduler.machine
    controller = machine.controller if isinstance(machine, Machine) else machine
    expected = controller.expected_motion or ExpectedMotion(controller)
    status = _run(scheduler, until)
    found = prove(Recorded(controller), expected, controller.clock.now).violations
    if found:
        raise SystemExit(f"line {found[0].line}: {found[0].message}; {len(found)} in all")
    _count[0] += 1
    return status


def _report() -> None:
    if _count[0]:
        sys.stderr.write(f"{_count[0]} runs are proved\n")


Scheduler.run = _proved  # type: ignore[assignment,method-assign]
atexit.register(_report)

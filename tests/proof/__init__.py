"""The proof of a run: its motion against the motion that the program commanded, derived a second time.

`pytest --prove` proves every run of the tests; a test that reads the results has `run` and `prove`.
"""

from __future__ import annotations

import os
from typing import TYPE_CHECKING, Any

from motionlang.kernel import Machine, Run, Source
from motionlang.kernel import run as run_program

if TYPE_CHECKING:
    from tests.proof.checker import Proof


def run(program: str | os.PathLike[str] | Source, **given: Any) -> Run:
    """Return the run of a program with its expected motion; `given` is as for `motionlang.kernel.run`."""

    def listen(machine: Machine) -> None:
        from tests.proof.expected_motion import ExpectedMotion

        machine.controller.motion_listener = ExpectedMotion(machine.controller)

    return run_program(program, begun=listen, **given)


def prove(result: Run, views: bool = True) -> Proof:
    """Return the proof of a run, with report and trace if there are `views`; ValueError without expected motion."""
    from tests.proof.proof import proof

    return proof(result, views)


def is_recorded(result: Run) -> bool:
    """True if the motion that is expected of a run is recorded: it is not for a program with errors."""
    from tests.proof.expected_motion import ExpectedMotion

    return isinstance(result.controller.motion_listener, ExpectedMotion)

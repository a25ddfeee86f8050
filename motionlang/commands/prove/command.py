"""`motionlang prove`: the motion of a run against the commanded limits."""

from __future__ import annotations

from dataclasses import dataclass
from typing import ClassVar

from motionlang.cli.run_command import Simulated
from motionlang.commands.prove.checker import Proof
from motionlang.commands.prove.expected_motion import ExpectedMotion
from motionlang.kernel import Controller, Diagnostic
from motionlang.kernel import Run as Result
from motionlang.kernel.tools import need

# Profiles of an interrupted run up to which it is still proved: a report comes within a second of the signal.
PROVED_IN_TIME = 10_000


@dataclass
class Prove(Simulated):
    """Verify the motion of a run against the commanded limits."""

    title: ClassVar[str] = "proof"
    epilog: ClassVar[str] = """\
exit status: 1 if the motion violates a limit, or as in run

examples:
  motionlang prove pick.mnt
"""

    def prepare(self) -> None:
        need(f"motionlang {type(self).__name__.lower()}", "numpy")

    def listener(self, controller: Controller) -> ExpectedMotion:
        return ExpectedMotion(controller)

    def extend(self, result: Result) -> None:
        self.proof = proof_of(result)
        if self.proof is not None:
            result.findings["proof"] = self.proof.as_dict()
            result.diagnostics += self.proof.violations

    def conclusion(self, result: Result, *, width: int, colour: bool) -> str:
        return "\n".join([*self.proof.lines(), ""]) if self.proof is not None else ""


def proof_of(result: Result) -> Proof | None:
    """Return the proof of a run, if possible.

    A run that has crashed, or was interrupted after long motion, has none.
    """
    if result.listener is None or result.crash is not None:
        return None
    profiles = sum(len(axis.profiles) for axis in result.controller.axes.values())
    if result.status == "interrupted" and profiles > PROVED_IN_TIME:
        message = f"the run was not verified: it ended after {profiles} profiles of motion"
        hint = (
            f"at most {PROVED_IN_TIME} are verified after a signal; a run that --until ends is always "
            "verified"
        )
        result.diagnostics.append(Diagnostic("proof", message, hint=hint))
        return None
    from motionlang.commands.prove.proof import proof  # with NumPy

    return proof(result)

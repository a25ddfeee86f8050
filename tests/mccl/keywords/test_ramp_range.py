"""The range of PSn is 0 < n < 0.5 by TN1069.

The check, the run, the message and the page agree on it.
"""

from __future__ import annotations

from motionlang.assumptions.keyword_facts import facts
from motionlang.mccl import DIALECT
from motionlang.mccl.keywords import table
from motionlang.source import Source
from tests.cases import cases
from tests.mccl.conftest import Runner

ACCEPTED = ("", "0", "0.1", "0.49")
REJECTED = ("0.5", "0.6", "-0.1")


@cases("ramp", ACCEPTED)
def test_a_ramp_in_the_range_is_accepted(ramp: str, mccl: Runner) -> None:
    assert not DIALECT.check(Source("ramp.mcl", f"1PS{ramp}\n"))
    assert mccl(f"1PS{ramp}\n").output == []


@cases("ramp", REJECTED)
def test_check_and_run_reject_the_same_ramps_with_the_same_message(ramp: str, mccl: Runner) -> None:
    message = f"PS accepts 0 to below 0.5, not {ramp}"
    (mistake,) = DIALECT.check(Source("ramp.mcl", f"1PS{ramp}\n"))
    assert mistake.message.startswith(message)
    result = mccl(f"AL{ramp},AR10,1PS@10\n")  # a register: only the run knows the number
    assert result.output == ["?-1"]
    assert result.diagnostics[0].message.startswith(message)


def test_the_page_prints_the_range_of_the_message() -> None:
    row = table().get("PS")
    assert row is not None
    assert dict(facts(row, "mccl"))["range"].startswith("0 to below 0.5")

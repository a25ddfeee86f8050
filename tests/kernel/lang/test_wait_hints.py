"""The options that end a wait which nothing in the program ends."""

from __future__ import annotations

import pytest

from motionlang import run
from motionlang.kernel import Machine, Source, Task, Wait
from motionlang.kernel.lang import what_ends
from motionlang.kernel.mint import DIALECT
from tests.cases import cases


@pytest.fixture(scope="module")
def machine() -> Machine:
    """Return a machine after 0.14 s, at which input 2 is on."""
    driven: dict[str, object] = {"input": [{"channel": 2, "at": 0.0}]}
    return run(Source("a.mnt", "WAIT 140"), machine=driven).machine


@cases(
    "why, cause, what, hint",
    [
        ("until INX(3)", "input", (3,), "--input 3=1@0.6 changes it, as does [[input]] of the machine file"),
        (
            "until INX(2) = 0",
            "input",
            (2,),
            "--input 2=0@0.6 changes it, as does [[input]] of the machine file",
        ),
        (
            "until IN(0) > 0",
            "input",
            (7, 1, 5, 3),
            "--input 1=1@0.6 --input 3=1@0.6 --input 5=1@0.6 change it, as does [[input]] of the machine file",
        ),
        ("for a word", "input", (4,), "--input 4=1@0.6 changes it, as does [[input]] of the machine file"),
        ("for the operator", "operator", (), "--answer 1 ends it, as does [[answer]] of the machine file"),
        ("until INKEY = 65", "condition", (), "--keys R@0.6 changes it, as does [[key]] of the machine file"),
        (
            "until ADC(2) > 5",
            "condition",
            (),
            "--analog 0=25@0.6 changes it, as does [[analogue]] of the machine file",
        ),
        ("until COMMS(3) = 1", "condition", (), "[[comms]] of the machine file says when it comes"),
        ("until LATCHVALUE(0) > 5", "condition", (), ""),
        ("for axis 0 to be idle", "axis", (0,), ""),
    ],
)
def test_the_option_that_ends_a_wait(
    machine: Machine, why: str, cause: str, what: tuple[int, ...], hint: str
) -> None:
    """Half a second from now is 0.64 s, about 0.6; a prompt counts from now. Nothing ends these waits."""
    task = Task("parent")
    wait = Wait(0.0, bool, float, why, cause, what)
    found = what_ends(DIALECT, None, machine, task, wait)
    assert found == hint
    prompt = what_ends(DIALECT, None, machine, task, wait, at_prompt=True)
    assert prompt == hint.replace("--", ".").replace("@0.6", "@0.5")

"""Numbers that know of which readings they were worked out: their forms, and that a run with them is the same."""

from __future__ import annotations

import re
from collections.abc import Mapping
from math import isfinite
from pathlib import Path
from random import Random
from typing import Any

import pytest

from motionlang.cli.program_files import programs
from motionlang.kernel import Hook, Run, Source, run
from motionlang.kernel.report import text
from motionlang.kernel.traced import Form, form_of, is_traced
from tests.cases import cases

ROOT = Path(__file__).parents[2]
FORMS = [
    re.split(r" {2,}", line)
    for line in Path(__file__)
    .with_name("traced.txt")
    .read_text(encoding="utf-8")
    .split("\n\n")[1]
    .splitlines()
]
# Machine seconds of a run.
UNTIL = 10.0
# A level is larger by so much, percent.
STEP = 1e-4
WORLD = {
    "input": [{"channel": 3, "at": 0.0}],
    "analogue": [{"channel": 0, "value": 41.0, "at": 0.0}, {"channel": 1, "value": -5.0, "at": 0.0}],
    "netdata": [{"element": 2, "value": 6, "at": 0.0}],
    "key": [{"text": "k", "at": 0.0}],
    "answer": [{"text": "7"}],
}


class Traces(Hook):
    """A debug build with traced numbers, and the form of what has decided last."""

    def __init__(self) -> None:
        super().__init__(lambda task, time, offset: None)
        self.form: Form = {}
        self.left: Any = 0.0

    def compared(self, left: object, right: object) -> None:
        self.left = left
        self.form = form_of(left - right) if is_traced(left) or is_traced(right) else {}  # type: ignore[operator]

    def tested(self, number: object) -> None:
        self.form = form_of(number)


def traced(
    source: Source, hook: Hook, machine: Mapping[str, object] | None = None, until: float | None = None
) -> Run:
    return run(
        source, machine=machine, hook=hook, until=until, begun=lambda each: each.controller.reads.trace()
    )


@pytest.mark.parametrize(("program", "wanted"), FORMS)
def test_forms(program: str, wanted: str) -> None:
    *statements, condition = program.split(" : ")
    lines = [
        *statements,
        f"If {condition} Then Print 1",
        "End",
        "Function twice(x As Float) As Float",
        "twice = 2 * x",
    ]
    hook = Traces()
    result = traced(Source("forms.mnt", "\n".join((*lines, "End Function", ""))), hook, WORLD)
    assert [each.code for each in result.diagnostics if each.code != "unasked"] == []
    factors = sorted(
        (table, channel if table != "answer" else 0, k) for (table, channel, _), k in hook.form.items()
    )
    words = [
        f"{table} {channel}: {f'{k:.6g}' if isfinite(k) else 'in a way'}" for table, channel, k in factors
    ]
    assert (", ".join(words) or "nothing") == wanted


@cases("program", programs([str(ROOT / "scripts")]), ids=lambda path: Path(path).name)
def test_a_run_with_them_is_the_same(program: str) -> None:
    source = Source.read(program)
    plain = run(source, hook=Traces(), until=UNTIL)
    assert text(traced(source, Traces(), dict(plain.machine.settings), UNTIL)) == text(plain)


@cases("seed", range(500))
def test_forms_equal_finite_differences(seed: int) -> None:
    """A drawn expression changes by its factors where a level is larger by a little."""
    random = Random(seed)
    expression = _drawn(random, 4)
    levels = [random.randint(-90, 90) + 0.5, random.randint(-90, 90) + 0.25]
    value = _value(expression, levels)
    factors = {channel: k for (_, channel, _), k in form_of(value).items()}
    for channel in (0, 1):
        moved = [level + STEP * (k == channel) for k, level in enumerate(levels)]
        difference = (_value(expression, moved) - value) / STEP
        factor = factors.get(channel, 0.0)
        assert not isfinite(factor) or factor == pytest.approx(float(difference), abs=1e-3, rel=1e-3), (
            expression
        )


def _drawn(random: Random, depth: int) -> str:
    if not depth or random.random() < 0.2:
        return random.choice(("ADC(0)", "ADC(0)", "ADC(1)", "3", "0.5", "(-20)"))
    if random.random() < 0.15:
        return f"Abs({_drawn(random, depth - 1)})"
    return f"({_drawn(random, depth - 1)} {random.choice('+-*/')} {_drawn(random, depth - 1)})"


def _value(expression: str, levels: list[float]) -> Any:
    """Return what a program works out, 0 if it divides by zero."""
    hook = Traces()
    world = {"analogue": [{"channel": k, "value": level, "at": 0.0} for k, level in enumerate(levels)]}
    program = f"Dim x As Float = {expression}\nIf x > 0 Then Print 1\n"
    traced(Source("drawn.mnt", program), hook, world)
    return hook.left

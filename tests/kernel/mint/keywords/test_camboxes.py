"""Cam boxes in any motion: the output is on exactly where the table states.

Each program reads the output at many times.
"""

from __future__ import annotations

from hypothesis import given, settings
from hypothesis import strategies as st

from motionlang import run
from motionlang.kernel import Source
from tests.cases import examples

POSITIONS = st.lists(st.integers(-60, 60), min_size=2, max_size=8, unique=True).map(
    lambda found: sorted(found)[: len(found) & ~1]
)
WITHIN_WRAP = st.lists(st.integers(0, 79), min_size=2, max_size=6, unique=True).map(
    lambda found: sorted(found)[: len(found) & ~1]
)
STEPS = st.lists(
    st.sampled_from(
        [
            "MOVEA(0) = 50 : GO(0)",
            "MOVEA(0) = -50 : GO(0)",
            "MOVER(0) = 7 : GO(0)",
            "JOG(0) = 120",
            "JOG(0) = -90",
            "STOP(0)",
            "CANCEL(0)",
            "POS(0) = 3",
            "POS(0) = -20",
            "SPEED(0) = 33",
            "SUSPEND(0) = 1",
            "SUSPEND(0) = 0",
            "CAMBOX(0) = 0 : CAMBOX(0) = 1",
            "RESET(0)",
        ]
    ),
    min_size=1,
    max_size=10,
)


def switched(positions: list[int], steps: list[str], setup: str, scale: float) -> list[tuple[float, int]]:
    """Return POS and the state of the output some time after each step."""
    table = ", ".join(map(str, (len(positions), *positions)))
    lines = [
        f"Dim p({len(positions) + 1}) As Float = {table}",
        f"SCALEFACTOR(0) = {scale} : SPEED(0) = 80 : ACCEL(0) = 900 : DECEL(0) = 700 : MOVEBUFFERSIZE(0) = 30",
        setup,
        "CAMBOXDATA(0, 5, 0, 0, 0, p) : CAMBOX(0) = 1",
    ]
    for n, step in enumerate(steps):
        lines += [step, f"WAIT = {37 + 61 * n}", 'PRINT POS(0) Using 1, 6, " ", OUTX(5)']
    lines += ["End", "Event ONERROR", " ERRORCLEAR(0, 0)", "End Event"]
    # An axis that still jogs at the end of the program would go on until the shift is over.
    result = run(Source("box.mnt", "\n".join(lines)), until=10.0)
    assert {each.code for each in result.diagnostics} <= {"never-started"}
    return [(float(line.split()[0]), int(line.split()[1])) for line in result.output]


def check(positions: list[int], seen: list[tuple[float, int]]) -> None:
    for position, on in seen:
        if min(abs(position - edge) for edge in positions) > 0.01:
            inside = any(
                begin < position < end for begin, end in zip(positions[::2], positions[1::2], strict=True)
            )
            assert on == inside, (position, on)


@settings(max_examples=examples(40))
@given(positions=POSITIONS, steps=STEPS, scale=st.sampled_from([1.0, 250.0, 0.5]))
def test_output_is_on_between_the_positions_of_the_table(
    positions: list[int], steps: list[str], scale: float
) -> None:
    check(positions, switched(positions, steps, "POS(0) = 0", scale))


@settings(max_examples=examples(40))
@given(positions=WITHIN_WRAP, steps=STEPS, scale=st.sampled_from([1.0, 250.0]))
def test_output_is_on_there_in_every_revolution(positions: list[int], steps: list[str], scale: float) -> None:
    check(positions, switched(positions, steps, "POSWRAP(0) = 80", scale))

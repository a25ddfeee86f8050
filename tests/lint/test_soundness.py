"""The linter is right about random programs, which print each line before it runs."""

from __future__ import annotations

import re

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from motionlang import run
from motionlang.commands.check import check
from motionlang.kernel import Diagnostic, Run, Source
from motionlang.kernel.mint import DIALECT
from tests.cases import examples

Lines = list[str]

axis = st.integers(0, 1)
number = st.integers(1, 9)
plain = st.one_of(
    st.builds("SPEED({0}) = {1}00".format, axis, st.integers(0, 9)),
    st.builds("ACCEL({0}) = {1}0000".format, axis, number),
    st.builds("ACCELTIME({0}) = {1}0".format, axis, number),
    st.builds("MOVER({0}) = {1}".format, axis, number),
    st.builds("MOVER({0}) = {1}".format, axis, number),
    st.builds("GO({0})".format, axis),
    st.builds("MOVER({0}) = {1} : GO({0})".format, axis, number),
    st.builds("PAUSE IDLE({0})".format, axis),
    st.builds("PAUSE IDLE({0}) And IDLE({1})".format, axis, axis),
    st.builds("STOP({0})".format, axis),
    st.builds("WAIT = {0}".format, number),
    st.builds("k = k + {0}".format, number),
    st.builds('PRINT "read ", IDLE({0}), POS({0})'.format, axis),
    st.just("Goto out"),
    st.just("End"),
)


_ITERATION: list[Lines] = [["k = k + 1"], ["If k > 20 Then Exit Loop"]]


def _counted(iterations: int, body: list[Lines]) -> Lines:
    """Return a For with its own variable; with a shared one it might never end."""
    return _block(f"For i{sum(map(len, body))} = 1 To {iterations}", body, "Next")


def _block(head: str, body: list[Lines], tail: str) -> Lines:
    return [head, *(line for lines in body for line in lines), tail]


statements: st.SearchStrategy[list[Lines]] = st.recursive(
    st.lists(st.builds(lambda line: [line], plain), min_size=1, max_size=6),
    lambda inner: st.lists(
        st.one_of(
            st.builds(lambda line: [line], plain),
            st.builds(lambda n, body: _block(f"If k > {n} Then", body, "End If"), number, inner),
            st.builds(_counted, st.integers(1, 4), inner),
            st.builds(lambda body: _block("Loop", [*body, *_ITERATION], "End Loop"), inner),
        ),
        min_size=1,
        max_size=6,
    ),
    max_leaves=14,
)  # fmt: skip
_SILENT = ("Next", "End If", "End Loop", "If k > 20")


@st.composite
def programs(draw: st.DrawFn) -> str:
    """Return a program that prints the number of each line before executing it."""
    lines = [line for each in draw(statements) for line in each]
    counters = sorted(set(re.findall(r"i\d+", "\n".join(lines))))
    text = f"Dim {', '.join(f'{each} As Integer' for each in ('k', *counters))}\n"
    for line in lines:
        number = text.count("\n") + 1
        text += line if line.startswith(_SILENT) else f'PRINT "line {number}" : {line}'
        text += "\n"
    return text + "#out\n"


def ran(text: str) -> Run:
    return run(Source("random.mnt", text), dialect="mint", until=60.0)


def warned(text: str, code: str) -> list[Diagnostic]:
    return [each for each in check(DIALECT.program(Source("random.mnt", text))) if each.code == code]


@pytest.mark.slow
@settings(max_examples=examples(40))
@given(programs())
def test_what_is_unreachable_is_never_done(text: str) -> None:
    output = ran(text).output
    for each in warned(text, "unreachable"):
        assert f"line {each.line}" not in output


@settings(max_examples=examples(40))
@given(programs())
def test_what_is_never_started_never_moves(text: str) -> None:
    lines = {move.line for move in ran(text).controller.log.moves}
    for each in warned(text, "never-started"):
        assert each.line not in lines


@settings(max_examples=examples(40))
@given(programs())
def test_what_has_no_speed_never_moves(text: str) -> None:
    text = text.replace("SPEED(0) = 100", "SPEED(0) = 0").replace("SPEED(1) = 200", "SPEED(1) = 0")
    lines = {move.line for move in ran(text).controller.log.moves}
    for each in warned(text, "zero-speed"):
        assert each.line not in lines


@settings(max_examples=examples(40))
@given(programs())
def test_an_overfilled_buffer_ends_the_run_there(text: str) -> None:
    result = ran(text)
    lines = [each.line for each in warned(text, "buffer-overfilled")]
    for line in lines:
        if f"line {line}" in result.output:
            (end,) = result.diagnostics
            assert end.code == "never"
            assert end.line in lines


@settings(max_examples=examples(40))
@given(programs())
def test_a_position_that_is_read_too_soon_is_read_in_motion(text: str) -> None:
    for each in warned(text, "in-motion"):
        output = ran(text).output
        read = [output[k + 1] for k, line in enumerate(output[:-1]) if line == f"line {each.line}"]
        assert all(line.startswith("read 0") for line in read)


@settings(max_examples=examples(40))
@given(programs())
def test_without_an_unused_setting_every_move_is_the_same(text: str) -> None:
    for each in warned(text, "unused-setting"):
        lines = text.split("\n")
        lines[each.line - 1] = f'PRINT "line {each.line}" : k = k'
        before, after = moves(text), moves("\n".join(lines))
        assert [move[:2] for move in after] == [move[:2] for move in before]
        # While an axis moves, a setting applies for the ten microseconds of its statement.
        assert [move[2:] for move in after] == [pytest.approx(move[2:], abs=1e-3) for move in before]


@settings(max_examples=examples(40))
@given(programs())
def test_without_a_go_that_starts_nothing_every_move_is_the_same(text: str) -> None:
    lines = text.split("\n")
    for each in warned(text, "nothing-loaded"):
        lines[each.line - 1] = f'PRINT "line {each.line}" : k = k'
    assert moves("\n".join(lines)) == moves(text)


def moves(text: str) -> list[tuple[float, ...]]:
    """Return line, axis, start time, duration and end of every move."""
    found = ran(text).report["moves"]
    assert isinstance(found, list)
    return [tuple(move[key] for key in ("line", "axis", "start_time", "duration", "end")) for move in found]

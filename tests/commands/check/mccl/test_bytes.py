"""A program file with any bytes gives a result, never a traceback or a hang."""

from __future__ import annotations

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from motionlang import run
from motionlang.commands.check import check
from motionlang.kernel import Source
from motionlang.kernel.mccl import DIALECT, table
from tests.cases import examples

names = st.sampled_from([row.name for row in table()])
numbers = st.one_of(
    st.integers(-3, 40).map(str),
    st.floats(allow_nan=True, allow_infinity=True).map(str),
    st.sampled_from(["", "@0", "@9999", "0.1", "-1", "1e400", '"STATUS"', "1000000000000"]),
)
commands = st.builds("{}{}{}".format, st.sampled_from(["", "1", "2", "99"]), names, numbers)
programs = st.lists(st.lists(commands, min_size=1, max_size=8).map(",".join), max_size=8).map("\n".join)


def survives(source: Source) -> None:
    """Check and highlight the file, and run it for a short machine time."""
    result = run(source, dialect="mccl", until=0.02)
    assert result.status in ("ended", "until", "fault")
    assert isinstance(result.report, dict)
    for diagnostic in [*check(DIALECT.program(source)), *result.diagnostics]:
        assert diagnostic.message
    assert "".join(text for _, text, _ in DIALECT.tokens(source.text)) == source.text


@settings(max_examples=examples(150))
@given(st.binary(max_size=200))
def test_any_bytes(data: bytes) -> None:
    survives(Source.from_bytes("any.mcl", data))


@settings(max_examples=examples(250))
@given(programs)
def test_any_commands(text: str) -> None:
    survives(Source("any.mcl", "MN\n" + text))


@pytest.mark.slow
def test_a_line_of_a_megabyte() -> None:
    result = run(Source("long.mcl", "1TP," * 250_000 + "\n1TP\n"), dialect="mccl")
    assert result.output == ["?4", "01 0"]
    assert len(result.diagnostics) == 1

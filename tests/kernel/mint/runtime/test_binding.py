"""Every keyword refuses a value outside the range of its row, and an axis that there is not."""

from __future__ import annotations

from motionlang import run
from motionlang.kernel import Keyword, Source
from motionlang.kernel.mint import table

# Keywords that switch something: any number except 0 is on. TIME and POSROLLOVER take every Integer, which is
# their range.
ANY_NUMBER = {
    "DRIVEENABLE", "HOMESTATUS", "LATCHENABLE", "FASTENABLE", "TIME", "POSROLLOVER",
}  # fmt: skip
# WAIT is a statement of its own.
RANGED = [
    row
    for row in table().rows
    if row.simulated and row.kind == "setting" and "W" in row.access and row.function != "wait"
    if row.high is not None or row.low is not None
]
OF_AXES = [
    row
    for row in table().rows
    if row.simulated and row.kind in ("setting", "reading") and row.index == "axis" and "R" in row.access
]
HEAD = "Dim axis As Integer = 99, value As Float\n"
# The handler reports each error by its text.
HANDLER = (
    "End\nEvent ONERROR\n  While ERRORREADNEXT(_egALL, 0)\n    PRINT ERRSTRING\n  End While\nEnd Event\n"
)
HANDLER += "Task Later\nEnd Task\n"


def printed(statements: list[str]) -> list[str]:
    result = run(Source("a.mnt", HEAD + "\n".join([*statements, HANDLER])), until=10.0)
    assert result.diagnostics == []
    return result.output


def beyond(row: Keyword) -> list[float]:
    """Return values of an Integer outside the range of a row."""
    found = [*([] if row.high is None else [row.high + 1.0]), *([] if row.low is None else [row.low - 1.0])]
    return [each for each in found if -(2.0**31) <= each < 2.0**31]


def test_a_value_outside_the_range_of_its_row_is_refused() -> None:
    uses = [(row, value) for row in RANGED if row.name not in ANY_NUMBER for value in beyond(row)]
    statements = []
    for row, value in uses:
        indices = ", ".join("Later" if each == "task" else "0" for each in row.index.split(", "))
        index = "" if row.index == "none" else f"({indices})"
        statements.append(f"value = {value!r}\n{row.name}{index} = value")
    found = printed(statements)
    assert [line.split(" cannot be ")[0] for line in found] == [row.name for row, _ in uses]


def test_an_axis_that_there_is_not_is_refused() -> None:
    assert printed([f"value = {row.name}(axis)" for row in OF_AXES if row.unit != "text"]) == [
        "there is no axis 99" for row in OF_AXES if row.unit != "text"
    ]

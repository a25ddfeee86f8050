"""What MintMT prints differently from Mint v4: values that are no integers."""

from __future__ import annotations

from motionlang.kernel import Source
from motionlang.kernel.mint import DIALECT
from tests.cases import cases

OLD = Source("old.prg", "#a\nGOTO a\n")
HEAD = "Dim x As Float = 0.5, n As Integer, t As Time\nConst half = 0.5, three = 3\n"


@cases(
    "expression, has_decimals",
    [
        ("x", True), ("n", False), ("t", False), ("half", True), ("three", False),
        ("x + 1", True), ("n + 1", False), ("n + x", True), ("-x", True), ("-n", False), ("~n", False),
        ("n / 2", True), ("n ^ 2", True), ("x \\ 2", False), ("x Mod 2", True), ("n Mod 2", False),
        ("n & 3", False), ("n << 3", False), ("x < 2", False), ("x And n", False), ("Not x", False),
        ("three * half", True), ("7 / 2", True), ("7 \\ 2", False),
        ("POS(0)", True), ("IDLE(0)", False), ("Abs(n)", False), ("Abs(x)", True), ("Sin(n)", True),
        ("Int(x)", False), ("Max(n, x)", True), ("Max(n, 3)", False),
    ],
)  # fmt: skip
def test_a_value_with_decimals_is_printed_differently(expression: str, has_decimals: bool) -> None:
    ported = Source("new.mnt", f"{HEAD}PRINT {expression}\n")
    found = DIALECT.port_differences(
        DIALECT.program(OLD), DIALECT.program(ported, {"controller.model": "NextMove e100"})
    )
    message = f"MintMT prints {expression} with four decimals, Mint v4 with as many as it needs"
    assert [each.message for each in found] == [message] * has_decimals

"""The tokens of a line, for highlighting: kind, text and column."""

from __future__ import annotations

from motionlang.kernel.mccl import DIALECT
from tests.cases import cases


@cases(
    "line, expected",
    [
        ("", ""),
        ("1MR5", "axis:1 command:MR number:5"),
        ("1mr-5.5", "axis:1 command:mr number:-5.5"),
        ("MR@10", "command:MR register:@10"),
        ('LU"x y"', 'command:LU text:"x_y"'),
        ("12XX5", "axis:12 unknown:XX number:5"),
        ("7,1TP", "axis:7 separator:, axis:1 command:TP"),
        ("  NO ;c", "separator:_ separator:_ command:NO separator:_ comment:;c"),
        ("NO, TP", "command:NO separator:, separator:_ command:TP"),
        (" 1MR5", "separator:_ axis:1 command:MR number:5"),
        ("1VE", "axis:1 command:VE"),
        ("; NO", "comment:;_NO"),
    ],
)
def test_a_line_has_its_tokens_in_order(line: str, expected: str) -> None:
    """A blank is shown as _; the tokens follow one another without gaps."""
    found = list(DIALECT.tokens(line))
    assert " ".join(f"{kind}:{text}" for kind, text, _ in found).replace(" ", "_") == expected.replace(
        " ", "_"
    )
    assert [start for _, _, start in found] == [
        sum(len(text) for _, text, _ in found[:k]) for k in range(len(found))
    ]

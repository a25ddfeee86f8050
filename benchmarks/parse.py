"""Parsing speed of both languages: `name value unit` lines, ratios within one run.

    python benchmarks/parse.py [BYTES]

The text is a program of about a quarter of a megabyte, generated twice with equal statements: in Mint and in Python, so
that CPython's own `ast.parse` is a fair comparison. `parse` has the tree and its checks, `lexing_share` is the part of
the tokens alone, and `parse_growth` the time of the whole text over four times that of a quarter. Times are processor
times.

The texts of the MCCL commands are all different. Each is split into its fields, then the command is looked up
and its number checked, which Lark does not do.
"""

from __future__ import annotations

import ast
import sys
from collections import deque
from statistics import median

from parse_program import program
from timing import seconds

from motionlang.lang.syntax.grammar import lex
from motionlang.mccl.resolve.line import lines_of
from motionlang.mccl.syntax.parser import parse as tree
from motionlang.mint.syntax.parser import parse
from motionlang.mint.syntax.tokens import PARSER
from motionlang.source import Source

ROUNDS = 5


def main(arguments: list[str]) -> int:
    """Measure and print."""
    size = int(arguments[0]) if arguments else 250_000
    mint, python = program(size)
    source, quarter = Source("big.mnt", mint), Source("part.mnt", program(size // 4)[0])
    ours, ratios = [], dict[str, list[float]](ast=[], lex=[], growth=[])
    for _ in range(ROUNDS):
        mine = seconds(lambda: parse(source))
        ours.append(mine)
        ratios["ast"].append(mine / seconds(lambda: ast.parse(python)))
        ratios["lex"].append(seconds(lambda: deque(lex(PARSER, mint), maxlen=0)) / mine)
        per_byte = seconds(lambda: parse(quarter)) / len(quarter.text)
        ratios["growth"].append(mine / len(mint) / per_byte)
    print(f"parse_program {len(mint) / 1e6:.2f} MB")
    print(f"parse {median(ours) / len(mint) * 1e6:.2f} ms_per_kB")
    print(f"parse_lexing_share {median(ratios['lex']):.2f} of_parse")
    print(f"parse_over_ast_parse {median(ratios['ast']):.1f} x")
    print(f"parse_growth {median(ratios['growth']):.2f} x_linear")
    mccl(4000)
    return 0


def mccl(count: int) -> None:
    """Measure a file of `count` lines of MCCL with six commands each."""
    lines = [
        f'{k % 8 + 1}MR{k},AL@{k % 256},1MA{k * 0.25:g},LU"STATUS{k}",2SV{k + 7},WA0.{k}'
        for k in range(count)
    ]
    text = "\n".join(lines)
    rounds = [
        (seconds(lambda: tree(text), True), seconds(lambda: list(lines_of(text)), True))
        for _ in range(ROUNDS)
    ]
    size = 6 * count
    print(f"mccl_parse {median(mine for mine, _ in rounds) / size * 1e6:.2f} us_per_command")
    print(f"mccl_known {median(known for _, known in rounds) / size * 1e6:.2f} us_per_command")


if __name__ == "__main__":
    raise SystemExit(main(sys.argv[1:]))

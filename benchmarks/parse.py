"""Parsing speed of both languages: `name value unit` lines, ratios within one run.

    python benchmarks/parse.py [BYTES]

The text is a program of about a megabyte, generated twice with equal statements: in Mint and in Python, so
that CPython's own `ast.parse` is a fair comparison. Lark parses the same text with the same grammar, once as
shipped (its contextual lexer, the collector on) and once with the collector off. Times are processor times.

The texts of the MCCL commands are all different. Each is split into its fields, then the command is looked up
and its number checked, which Lark does not do.
"""

from __future__ import annotations

import ast
import sys
from statistics import median

from parse_program import program
from timing import seconds

from motionlang.lang.parsing.generate import build_lark
from motionlang.mccl.resolve.decode import COMMANDS
from motionlang.mccl.syntax.parser import parts, pieces
from motionlang.mint.syntax.parser import parse
from motionlang.mint.syntax.tables import TABLES
from motionlang.source import Source

ROUNDS = 5


def main(arguments: list[str]) -> int:
    """Measure and print."""
    mint, python = program(int(arguments[0]) if arguments else 1_000_000)
    source = Source("big.mnt", mint)
    # The whole-tree settings of a plain user of Lark: no tokens, no placeholders.
    lark = build_lark("mint.lark", lexer="contextual", keep_all_tokens=False, maybe_placeholders=False)
    lark.parse(mint[: mint.index("End Sub\n") + 8])
    ratios: dict[str, list[float]] = {"lark": [], "lark_gc_off": [], "ast": [], "lex": []}
    ours = []
    for _ in range(ROUNDS):
        mine = seconds(lambda: parse(source))
        ours.append(mine)
        ratios["ast"].append(seconds(lambda: ast.parse(python)) / mine)
        ratios["lex"].append(seconds(lambda: TABLES.texts(mint)) / mine)
    for name, collect in (("lark", True), ("lark_gc_off", False)):
        ratios[name].append(seconds(lambda: lark.parse(mint), collect) / median(ours))
    size = len(mint) / 1e6
    print(f"parse_program {size:.2f} MB")
    print(f"parse_python_program {len(python) / 1e6:.2f} MB")
    print(f"parse {median(ours) * 1e3:.0f} ms")
    print(f"parse_throughput {size / median(ours):.2f} MB/s")
    print(f"parse_lexing_share {median(ratios['lex']):.2f} of_parse")
    print(f"parse_vs_ast_parse {median(ratios['ast']):.2f} x_faster")
    print(f"parse_vs_lark_as_shipped {median(ratios['lark']):.1f} x_faster")
    print(f"parse_vs_lark_gc_off {median(ratios['lark_gc_off']):.1f} x_faster")
    mccl(4000)
    return 0


def mccl(count: int) -> None:
    """Measure a file of `count` lines of MCCL with six commands each."""
    lines = [
        f'{k % 8 + 1}MR{k},AL@{k % 256},1MA{k * 0.25:g},LU"STATUS{k}",2SV{k + 7},WA0.{k}'
        for k in range(count)
    ]
    text = "\n".join(lines)
    lark = build_lark("mccl.lark", lexer="contextual", keep_all_tokens=False, maybe_placeholders=False)

    def parsed() -> object:
        return [[parts(piece) for piece in pieces(line)] for line in text.split("\n")]

    def known() -> object:
        COMMANDS.clear()
        return [[COMMANDS[piece] for piece in pieces(line)] for line in text.split("\n")]

    rounds = [
        (seconds(lambda: lark.parse(text), True), seconds(parsed, True), seconds(known, True))
        for _ in range(ROUNDS)
    ]
    size = 6 * count
    print(f"mccl_parse {median(mine for _, mine, _ in rounds) / size * 1e6:.2f} us_per_command")
    print(f"mccl_parse_vs_lark_as_shipped {median(lark / mine for lark, mine, _ in rounds):.1f} x_faster")
    print(f"mccl_known_vs_lark_as_shipped {median(lark / mine for lark, _, mine in rounds):.1f} x_faster")


if __name__ == "__main__":
    raise SystemExit(main(sys.argv[1:]))

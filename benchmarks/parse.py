"""How fast Mint is parsed: `name value unit` lines, every ratio measured within this one run.

    python benchmarks/parse.py [BYTES]

The text is a program of about a megabyte, made twice with the same statements: in Mint and in Python, so that
CPython's own `ast.parse` is a fair yardstick. Lark parses the same text with the same grammar, once as it is
shipped (its contextual lexer, the collector on) and once with the collector off. Times are processor times.
"""

from __future__ import annotations

import ast
import sys
from statistics import median

from parse_program import program
from timing import seconds

from motionlang.lang.parsing.generate import build_lark
from motionlang.mint.syntax.parser import parse
from motionlang.mint.syntax.tables import TABLES
from motionlang.source import Source

ROUNDS = 5


def main(arguments: list[str]) -> int:
    """Measure and print."""
    mint, python = program(int(arguments[0]) if arguments else 1_000_000)
    source = Source("big.mnt", mint)
    # The whole-tree settings of a plain user of Lark: no tokens kept, no placeholders.
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
    return 0


if __name__ == "__main__":
    raise SystemExit(main(sys.argv[1:]))

"""The changes: another comparison, another sign, another constant, a condition turned round, at a place of a file."""

from __future__ import annotations

import ast
from collections.abc import Iterator
from pathlib import Path
from random import Random

ROOT = Path(__file__).parents[2]
PACKAGE = ROOT / "motionlang"

_COMPARED: dict[type[ast.cmpop], type[ast.cmpop]] = {
    ast.Lt: ast.LtE, ast.LtE: ast.Lt, ast.Gt: ast.GtE, ast.GtE: ast.Gt, ast.Eq: ast.NotEq, ast.NotEq: ast.Eq,
    ast.Is: ast.IsNot, ast.IsNot: ast.Is, ast.In: ast.NotIn, ast.NotIn: ast.In,
}  # fmt: skip
_WORKED: dict[type[ast.operator], type[ast.operator]] = {
    ast.Add: ast.Sub, ast.Sub: ast.Add, ast.Mult: ast.Div, ast.Div: ast.Mult, ast.BitAnd: ast.BitOr,
    ast.BitOr: ast.BitAnd, ast.LShift: ast.RShift, ast.RShift: ast.LShift, ast.FloorDiv: ast.Mult,
}  # fmt: skip


class Mutant:
    """One change: the file, the place that it replaces as offsets of its text, what stood there, what stands there."""

    def __init__(self, path: Path, begin: int, end: int, before: str, after: str, line: int) -> None:
        self.path, self.begin, self.end, self.before, self.after, self.line = (
            path,
            begin,
            end,
            before,
            after,
            line,
        )

    def __str__(self) -> str:
        return f"{self.path.relative_to(ROOT)}:{self.line}: {self.before} -> {self.after}"

    def text(self) -> str:
        """The whole file with the change."""
        text = self.path.read_bytes()
        return (text[: self.begin] + self.after.encode() + text[self.end :]).decode()


def files() -> list[Path]:
    """What is mutated: the motion mathematics, the controller, and what the words of both languages do."""
    found = [*PACKAGE.glob("profile/**/*.py"), *PACKAGE.glob("controller/**/*.py")]
    found += [*PACKAGE.glob("mint/keywords/*_operations.py"), *PACKAGE.glob("mccl/keywords/*_operations.py")]
    found += [PACKAGE / "mccl" / "keywords" / name for name in ("filter_stages.py", "flow_waits.py")]
    return sorted(found)


def mutants(path: Path) -> Iterator[Mutant]:
    """Every change of a file, in the order of its text; what is for types or for people is left alone."""
    text = path.read_bytes()
    starts = [0]
    for line in text.split(b"\n"):
        starts.append(starts[-1] + len(line) + 1)
    for node, after in _changes(ast.parse(text)):
        assert node.end_lineno is not None
        assert node.end_col_offset is not None
        begin = starts[node.lineno - 1] + node.col_offset
        end = starts[node.end_lineno - 1] + node.end_col_offset
        yield Mutant(path, begin, end, ast.unparse(node), f"({after})", node.lineno)


def _changes(tree: ast.AST) -> Iterator[tuple[ast.expr, str]]:
    for node in ast.iter_child_nodes(tree):
        if isinstance(node, ast.Assert | ast.Raise) or _is_for_types(node):
            continue
        if isinstance(node, ast.AnnAssign):
            yield from _changes(ast.Expression(node.value)) if node.value is not None else ()
            continue
        if isinstance(node, ast.JoinedStr) or (
            isinstance(node, ast.Expr) and isinstance(node.value, ast.Constant)
        ):
            continue
        yield from _of(node)
        if isinstance(node, ast.FunctionDef):
            for part in node.body:
                yield from _changes(ast.Module([part], []))
        else:
            yield from _changes(node)


def _is_for_types(node: ast.AST) -> bool:
    what = (
        node.test if isinstance(node, ast.If) else node.targets[0] if isinstance(node, ast.Assign) else None
    )
    return what is not None and "TYPE_CHECKING" in ast.unparse(what)


def _of(node: ast.AST) -> Iterator[tuple[ast.expr, str]]:
    if isinstance(node, ast.Compare) and len(node.ops) == 1 and type(node.ops[0]) in _COMPARED:
        made = ast.Compare(node.left, [_COMPARED[type(node.ops[0])]()], node.comparators)
        yield node, ast.unparse(made)
    elif (
        isinstance(node, ast.BinOp)
        and type(node.op) in _WORKED
        and not isinstance(node.left, ast.Constant | ast.JoinedStr)
    ):
        yield node, ast.unparse(ast.BinOp(node.left, _WORKED[type(node.op)](), node.right))
    elif isinstance(node, ast.BoolOp):
        other = ast.Or() if isinstance(node.op, ast.And) else ast.And()
        yield node, ast.unparse(ast.BoolOp(other, node.values))
    elif isinstance(node, ast.UnaryOp) and isinstance(node.op, ast.Not | ast.USub):
        yield node, ast.unparse(node.operand)
    elif isinstance(node, ast.Constant) and isinstance(node.value, bool):
        yield node, str(not node.value)
    elif isinstance(node, ast.Constant) and isinstance(node.value, int | float):
        yield node, repr(node.value + 1)
    elif isinstance(node, ast.IfExp):
        yield node, ast.unparse(ast.IfExp(node.test, node.orelse, node.body))


def chosen(count: int, seed: int) -> list[Mutant]:
    """So many changes, each file as likely as it has places; the same for the same text."""
    every = [mutant for path in files() for mutant in mutants(path)]
    return Random(f"mutants {seed}").sample(every, min(count, len(every)))

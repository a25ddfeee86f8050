"""The mutations: another comparison, sign or constant, and an inverted condition."""

from __future__ import annotations

import ast
from collections import Counter
from collections.abc import Iterator, Mapping
from functools import cache
from hashlib import sha256
from pathlib import Path
from typing import NamedTuple

ROOT = Path(__file__).parents[2]
PACKAGE = ROOT / "motionlang"
EXPLORE = ROOT / "extras" / "explore"

_COMPARED: dict[type[ast.cmpop], type[ast.cmpop]] = {
    ast.Lt: ast.LtE, ast.LtE: ast.Lt, ast.Gt: ast.GtE, ast.GtE: ast.Gt, ast.Eq: ast.NotEq, ast.NotEq: ast.Eq,
    ast.Is: ast.IsNot, ast.IsNot: ast.Is, ast.In: ast.NotIn, ast.NotIn: ast.In,
}  # fmt: skip
_WORKED: dict[type[ast.operator], type[ast.operator]] = {
    ast.Add: ast.Sub, ast.Sub: ast.Add, ast.Mult: ast.Div, ast.Div: ast.Mult, ast.BitAnd: ast.BitOr,
    ast.BitOr: ast.BitAnd, ast.LShift: ast.RShift, ast.RShift: ast.LShift, ast.FloorDiv: ast.Mult,
}  # fmt: skip

# Most nodes of a tree are names and operators, which are skipped. So are messages and assertions.
_UNCHANGED = frozenset(
    {
        *(ast.Name, ast.Load, ast.Store, ast.Del, ast.And, ast.Or, ast.Not, ast.USub, ast.alias, ast.Pass),
        *(*_COMPARED, *_WORKED, ast.JoinedStr, ast.Assert, ast.Raise),
    }
)
_MUTABLE = frozenset({ast.Compare, ast.BinOp, ast.BoolOp, ast.UnaryOp, ast.Constant, ast.IfExp})


class Mutant(NamedTuple):
    """One change: the index of its position in a file, a stable name, and the change.

    The name does not depend on line numbers. `imported` is true if the position is reached while its module is
    imported.
    """

    path: Path
    ordinal: int
    name: str
    line: int
    before: str
    after: str
    imported: bool

    def __str__(self) -> str:
        return f"{self.path.relative_to(ROOT)}:{self.line}: {self.before} -> {self.after}"

    @property
    def package(self) -> str:
        """The top-level package of the mutant; "root" for files outside the packages."""
        package = EXPLORE if EXPLORE in self.path.parents else PACKAGE
        components = self.path.relative_to(package).parts
        in_house = len(components) > 2 and components[0] in ("kernel", "commands", "lab", "ide")
        return components[1] if in_house else components[0] if len(components) > 1 else "root"


# Derived files: their writers are mutated instead.
GENERATED = (
    "mccl/syntax/tables.py",
    "mint/syntax/tables.py",
    "kernel/mccl/keywords/index.py",
    "kernel/mint/keywords/index.py",
    "kernel/assumptions/tables.py",
)


def files() -> list[Path]:
    """Return all hand-written source files of motionlang and motionlang-explore."""
    explore = (EXPLORE / "motionlang_explore").rglob("*.py")
    return sorted({*PACKAGE.rglob("*.py"), *explore} - {PACKAGE / name for name in GENERATED})


@cache
def every() -> tuple[Mutant, ...]:
    """Return all possible changes of the package."""
    return tuple(mutant for path in files() for mutant in mutants(path))


def mutants(path: Path) -> Iterator[Mutant]:
    """Yield the changes of a file in order, except in types, messages and assertions."""
    times: Counter[str] = Counter()
    file = path.relative_to(ROOT)
    for ordinal, (where, node, after) in enumerate(_changes(ast.parse(path.read_bytes()), "")):
        before = ast.unparse(node)
        name = f"{file}: {where}{before} -> {after}"
        times[name] += 1
        name += f" #{times[name]}" if times[name] > 1 else ""
        imported = not any(
            component.isidentifier() and component.islower() for component in where.split(": ")
        )
        yield Mutant(path, ordinal, name, node.lineno, before, after, imported)


def woven(path: Path, numbers: Mapping[int, int]) -> str:
    """Return the text of a file with changes, each switched on by `__mutant__`.

    Every function calls `__seen__` with the path of the file.
    """
    tree = ast.parse(path.read_bytes())
    chosen = {
        id(node): (numbers[ordinal], after)
        for ordinal, (_, node, after) in enumerate(_changes(tree, ""))
        if ordinal in numbers
    }

    class Weaver(ast.NodeTransformer):
        def visit(self, node: ast.AST) -> ast.AST:
            found = chosen.get(id(node))
            node = self.generic_visit(node)
            if isinstance(node, ast.FunctionDef | ast.AsyncFunctionDef):
                has_docstring = ast.get_docstring(node, clean=False) is not None
                node.body.insert(
                    int(has_docstring), *ast.parse(f"__seen__({path.relative_to(ROOT).as_posix()!r})").body
                )
            if found is None:
                return node
            assert isinstance(node, ast.expr)
            condition = ast.parse(f"__mutant__({found[0]})", mode="eval").body
            return ast.IfExp(condition, ast.parse(found[1], mode="eval").body, node)

    return ast.unparse(ast.fix_missing_locations(Weaver().visit(tree)))


def _changes(tree: ast.AST, where: str) -> Iterator[tuple[str, ast.expr, str]]:
    """Yield the name of each position, its expression, and the replacement."""
    for node in ast.iter_child_nodes(tree):
        if type(node) in _UNCHANGED or _is_for_types(node) or _asserts_length(node):
            continue
        if isinstance(node, ast.AnnAssign):
            yield from _changes(ast.Expression(node.value), where) if node.value is not None else ()
            continue
        if isinstance(node, ast.Expr) and isinstance(node.value, ast.Constant):
            continue
        if type(node) in _MUTABLE:
            for changed, after in _of(node):
                yield where, changed, after
        if isinstance(node, ast.FunctionDef | ast.AsyncFunctionDef):
            for statement in node.body:
                yield from _changes(ast.Module([statement], []), f"{where}{node.name}: ")
        else:
            yield from _changes(node, f"{where}{node.name}: " if isinstance(node, ast.ClassDef) else where)


def _is_for_types(node: ast.AST) -> bool:
    what = (
        node.test if isinstance(node, ast.If) else node.targets[0] if isinstance(node, ast.Assign) else None
    )
    return what is not None and "TYPE_CHECKING" in ast.unparse(what)


def _asserts_length(node: ast.AST) -> bool:
    """True for the `strict=True` of a zip: different lengths are an internal error."""
    return isinstance(node, ast.keyword) and node.arg == "strict"


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
    """Return `count` random changes, ranked by seed and name.

    A draw changes little if changes are added to the package or removed from it.
    """

    def rank(mutant: Mutant) -> bytes:
        return sha256(f"{seed} {mutant.name}".encode()).digest()

    return sorted(every(), key=rank)[:count]

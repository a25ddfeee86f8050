"""Single changes to the arithmetic of planners: list, apply and remove them.

Each changes one expression of one function. The text of its module is compiled with the change, and the
function gets the new code. Nothing is imported again, so thousands can be tried in one process.
"""

from __future__ import annotations

import ast
import importlib
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from types import CodeType, FunctionType
from typing import NamedTuple

ROOT = Path(__file__).parents[2]
PACKAGE = ROOT / "motionlang"
# The modules that compute motion.
_MODULES = {
    "kernel/planners": (
        "ramps shapes target transition ramp_down stop segment_speed lookahead reparametrised curve "
        "cubics arc table_motion superposition dwell pieces sequence crossing"
    ),
    "commands/plan": "solve reach",
    "kernel/controller": "settings",
    "kernel/controller/queue": "plan life stop track",
    "kernel/controller/motion": "jog follow offset profile_playback takeup",
    "kernel/controller/moves": "cam course entries geometry path path_run",
}
FILES = tuple(f"{folder}/{name}.py" for folder, names in _MODULES.items() for name in names.split())
# Settings that are easily confused.
_OTHERS = {
    "accel": "decel", "decel": "accel", "accel_jerk": "decel_jerk", "decel_jerk": "accel_jerk", "max_speed": "speed",
    "max_accel": "accel", "max_decel": "decel", "error_decel": "decel", "override": "ramp", "ratio": "locked",
}  # fmt: skip
_WORKED: dict[type[ast.operator], type[ast.operator]] = {
    ast.Add: ast.Sub, ast.Sub: ast.Add, ast.Mult: ast.Div, ast.Div: ast.Mult,
}  # fmt: skip


class Change(NamedTuple):
    """One change: module, function, number of the expression, old and new text."""

    module: str
    function: str
    ordinal: int
    line: int
    before: str
    after: str

    def __str__(self) -> str:
        return f"{self.module}:{self.line} {self.function}: {self.before} -> {self.after}"


def changes(path: str = "") -> list[Change]:
    """Return all changes of a file, or of all files, in the order of the source text."""
    return [each for name in FILES if path in ("", name) for each in _of_file(name)]


def chosen(count: int) -> list[Change]:
    """Return `count` of all changes, evenly spaced."""
    found = changes()
    return [found[k * len(found) // count] for k in range(min(count, len(found)))]


@contextmanager
def forged(change: Change) -> Iterator[None]:
    """Apply a change for the duration of a `with` block."""
    function = _function(change)
    honest = function.__code__
    function.__code__ = _code(change)
    try:
        yield
    finally:
        function.__code__ = honest


def _of_file(path: str) -> Iterator[Change]:
    module = "motionlang." + path.removesuffix(".py").replace("/", ".")
    for name, node in _functions(ast.parse((PACKAGE / path).read_bytes()), ""):
        for ordinal, (expression, after) in enumerate(_expressions(node)):
            yield Change(module, name, ordinal, expression.lineno, ast.unparse(expression), after)


def _functions(tree: ast.AST, prefix: str) -> Iterator[tuple[str, ast.FunctionDef]]:
    """Yield the functions of a module and the methods of its classes."""
    for node in ast.iter_child_nodes(tree):
        if isinstance(node, ast.ClassDef):
            yield from _functions(node, f"{prefix}{node.name}.")
        elif isinstance(node, ast.FunctionDef):
            yield prefix + node.name, node


def _expressions(function: ast.FunctionDef) -> Iterator[tuple[ast.expr, str]]:
    """Yield the expressions of a function that may be changed, and their replacements."""
    for statement in function.body:
        for node in ast.walk(statement):
            if isinstance(node, ast.expr):
                yield from ((node, after) for after in _changed(node))


def _changed(node: ast.expr) -> Iterator[str]:
    if isinstance(node, ast.BinOp) and type(node.op) in _WORKED:
        yield ast.unparse(ast.BinOp(node.left, _WORKED[type(node.op)](), node.right))
        yield ast.unparse(node.left)
    elif isinstance(node, ast.UnaryOp) and isinstance(node.op, ast.USub):
        yield ast.unparse(node.operand)
    elif isinstance(node, ast.Constant) and type(node.value) is float and 0.0 < node.value < 1e9:
        yield repr(1.1 * node.value) if node.value > 1e-3 else repr(node.value)
    elif isinstance(node, ast.Constant) and type(node.value) is int and node.value:
        yield repr(node.value + 1)
    elif isinstance(node, ast.Call) and isinstance(node.func, ast.Name) and len(node.args) > 1:
        if node.func.id in ("min", "max"):
            other = ast.Name("max" if node.func.id == "min" else "min")
            yield ast.unparse(ast.Call(other, node.args, node.keywords))
            yield ast.unparse(node.args[0])
    elif isinstance(node, ast.IfExp):
        yield ast.unparse(ast.IfExp(node.test, node.orelse, node.body))
    elif isinstance(node, ast.Attribute) and node.attr in _OTHERS and isinstance(node.ctx, ast.Load):
        yield ast.unparse(ast.Attribute(node.value, _OTHERS[node.attr], ast.Load()))


def _function(change: Change) -> FunctionType:
    found: object = importlib.import_module(change.module)
    *classes, name = change.function.split(".")
    for each in classes:
        found = getattr(found, each)
    found = vars(found)[name]
    for attribute in ("fget", "__func__", "__wrapped__"):
        found = getattr(found, attribute, None) or found
    assert isinstance(found, FunctionType), change
    return found


def _code(change: Change) -> CodeType:
    """Return the code of the changed function."""
    path = PACKAGE.parent / (change.module.replace(".", "/") + ".py")
    tree = ast.parse(path.read_bytes())
    node = next(node for name, node in _functions(tree, "") if name == change.function)
    target = list(_expressions(node))[change.ordinal][0]
    after = ast.parse(change.after, mode="eval").body

    class Changer(ast.NodeTransformer):
        def visit(self, node: ast.AST) -> ast.AST:
            return after if node is target else self.generic_visit(node)

    changed = ast.fix_missing_locations(Changer().visit(tree))
    assert isinstance(changed, ast.Module)
    code = compile(changed, str(path), "exec")
    return next(each for each in _codes(code) if each.co_qualname == change.function)


def _codes(code: CodeType) -> Iterator[CodeType]:
    for each in code.co_consts:
        if isinstance(each, CodeType):
            yield each
            yield from _codes(each)

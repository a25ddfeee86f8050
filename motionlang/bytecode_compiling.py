"""What a module of the package is compiled to for commands: its code without what no command shows.

That is docstrings, and annotations of functions, a seventh of the code that a start reads. What a module says of the
language (`from __future__`) holds, but is not imported. Everything else, the numbers of its lines too, is as Python
itself makes it.
"""

from __future__ import annotations
import __future__

import ast

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Iterable
    from types import CodeType

# What begins with a docstring.
SAYS_WHAT_IT_IS = ast.Module, ast.ClassDef, ast.FunctionDef, ast.AsyncFunctionDef
# The parts of a statement that statements stand in.
BLOCKS = ("body", "orelse", "finalbody", "handlers", "cases")


def compiled(source: bytes, place: str) -> CodeType:
    """The code of the text of a module that lies at a place; SyntaxError as `compile` raises it."""
    tree = ast.parse(source, place)
    _leave_out(tree)
    code: CodeType = compile(tree, place, "exec", _features(tree), dont_inherit=True)
    return code


def _features(module: ast.Module) -> int:
    """The features of the language that a module asks for, as `compile` takes them, and no longer by an import."""
    flags = 0
    for each in [*module.body]:
        if isinstance(each, ast.ImportFrom) and each.module == "__future__":
            module.body.remove(each)
            for alias in each.names:
                flags |= getattr(__future__, alias.name).compiler_flag
    return flags


def _leave_out(node: ast.AST) -> None:
    """Take the docstrings and the annotations of functions out of a statement and of all that stand in it.

    Annotations of classes stay: what is made of a class, such as a dataclass, goes by them.
    """
    if isinstance(node, ast.FunctionDef | ast.AsyncFunctionDef):
        node.returns = None
        for each in _arguments(node.args):
            each.annotation = None
    if isinstance(node, SAYS_WHAT_IT_IS) and ast.get_docstring(node, clean=False) is not None:
        if len(node.body) == 1 and not isinstance(node, ast.Module):
            node.body.append(ast.copy_location(ast.Pass(), node.body[0]))
        del node.body[0]
    for name in BLOCKS:
        block = getattr(node, name, None)
        if isinstance(block, list):  # that of a lambda is an expression
            for each in block:
                _leave_out(each)


def _arguments(given: ast.arguments) -> Iterable[ast.arg]:
    every = (*given.posonlyargs, *given.args, *given.kwonlyargs, given.vararg, given.kwarg)
    return (each for each in every if each is not None)

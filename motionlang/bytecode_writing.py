"""What a command missed in the file of the package's bytecode, made and put there as the command ends.

A module is compiled from its source without what no command shows: docstrings, and annotations of functions, which are
a seventh of the code that a start reads. What it says of the language (`from __future__`) holds, but is not imported.
Everything else, the numbers of its lines too, is as Python itself makes it.
"""

from __future__ import annotations
import __future__

import ast
import sys
from importlib.machinery import SourceFileLoader
from marshal import dumps

from motionlang.bytecode import holds
from motionlang.kept_file_writing import add
from motionlang.user_cache import state
from motionlang.user_cache_writing import writable

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Iterable
    from types import ModuleType

    from motionlang.bytecode import Finder, Note

# What begins with a docstring.
SAYS_WHAT_IT_IS = ast.Module, ast.ClassDef, ast.FunctionDef, ast.AsyncFunctionDef
# The parts of a statement that statements stand in.
BLOCKS = ("body", "orelse", "finalbody", "handlers", "cases")


def keep(finder: Finder) -> None:
    """Put what was missed into the file, beside what stands there and still holds."""
    if sys.dont_write_bytecode or not writable():
        return
    new: dict[str, tuple[Note | None, bytes]] = {name: (None, part) for name, part in finder.made.items()}
    for name in finder.missed:
        compiled = _compiled(sys.modules.get(name))
        if compiled is not None:
            new[name] = compiled
    if new:
        add(finder.file.name, new, holds)


def _compiled(module: ModuleType | None) -> tuple[Note, bytes] | None:
    """A module's source and code; None for one that Python did not load from a source."""
    spec = getattr(module, "__spec__", None)
    if spec is None or spec.origin is None or not isinstance(spec.loader, SourceFileLoader):
        return None
    before = state(spec.origin)
    try:
        tree = ast.parse(spec.loader.get_data(spec.origin), spec.origin)
        _leave_out(tree)
        code = compile(tree, spec.origin, "exec", _features(tree), dont_inherit=True)
    except (OSError, SyntaxError):  # the source is another one by now
        return None
    if before is None or state(spec.origin) != before:
        return None
    return (spec.origin, spec.cached, before), dumps(code)


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

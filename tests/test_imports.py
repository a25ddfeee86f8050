"""Lazy imports of modules within a package: only those listed here.

An import inside a function crosses packages or loads a heavy library. Imports within a package are at the
top, where a reader looks for them.
"""

from __future__ import annotations

import ast
from functools import cache
from importlib import import_module
from pathlib import Path

import pytest

import motionlang
from tests.trees import nodes_of, tree_of

pytestmark = pytest.mark.slow

PACKAGE = Path(motionlang.__file__).parent
# Libraries that take longer to import than most programs run, or may be missing.
HEAVY = {"lark", "matplotlib", "numpy", "prompt_toolkit", "rich"}
# Importer and lazily imported modules, both without the name of their package. A line may leave this list or
# become shorter; none may grow or be added.
LAZY = {
    # Lazy packages: each opens a family of modules; most programs need few. That of the command line
    # is the table of its commands.
    # Commands that show findings need no rules.
    "commands/check/__init__.py": "linter",
    "kernel/mccl/__init__.py": "keywords keywords.row keywords.switchable models",
    "kernel/mint/__init__.py": "keywords keywords.latches keywords.machine_readings keywords.switchable models "
    "resolve.aliases runtime.task",
    "kernel/mccl/keywords/__init__.py": "keywords.index",
    "kernel/mint/keywords/__init__.py": "keywords.index",
    "kernel/mint/runtime/environment.py": "runtime.errors runtime.events runtime.power_up",
    "commands/run/command.py": "keyboard",
    # Questions about a program that a run does not ask.
    "kernel/mccl/runtime/program.py": "resolve.board resolve.chosen_rates resolve.definitions resolve.errors "
    "runtime.structure",
    "kernel/mint/program.py": "check.port resolve.definitions steps.structure syntax.extent syntax.layout",
    # Those that need one another.
    "kernel/planners/curve.py": "cubics",
    # Modules that few programs, or few commands, need.
    "hosts/client/client.py": "client.virtual",
    "hosts/client/mint.py": "client.virtual",
    "kernel/mint/runtime/task.py": "runtime.errors",
    "processes/parallel.py": "workers",
}


def path_of(name: str) -> Path | None:
    """Return the file of a module of the package, or None."""
    base = PACKAGE.parent.joinpath(*name.split("."))
    files = (base.with_suffix(".py"), base / "__init__.py")
    return next((file for file in files if file.exists()), None)


@cache
def homes(package: str) -> dict[str, str]:
    """Return the module of each name that a package of the kernel imports on first use."""
    lists = getattr(import_module(package), "PUBLIC", {}) if package.startswith("motionlang.kernel") else {}
    return {name: f"{package}.{module}" for module, names in lists.items() for name in names.split()}


def module_of(node: ast.ImportFrom, name: str) -> str:
    """Return the module that an import of `name` loads: the name itself, its home, or its owner."""
    owner, whole = str(node.module), f"{node.module}.{name}"
    return whole if path_of(whole) is not None else homes(owner).get(name, owner)


def is_for_types(node: ast.stmt) -> bool:
    return isinstance(node, ast.If) and ast.unparse(node.test) == "TYPE_CHECKING"


@cache
def on_top(path: Path) -> frozenset[str]:
    """Return the modules and libraries that a file imports at its top level."""
    found: set[str] = set()
    left: list[ast.AST] = [node for node in tree_of(path).body if not is_for_types(node)]
    while left:
        node = left.pop()
        if isinstance(node, ast.Import):
            found |= {alias.name for alias in node.names}
        elif isinstance(node, ast.ImportFrom):
            found |= {module_of(node, alias.name) for alias in node.names}
        elif not isinstance(node, ast.FunctionDef | ast.AsyncFunctionDef | ast.Lambda):
            left += ast.iter_child_nodes(node)
    return frozenset(found)


@cache
def loaded_with(module: str) -> frozenset[str]:
    """Return the modules and libraries that importing a module loads, and itself."""
    seen: set[str] = set()
    left = [module]
    while left:
        name = left.pop()
        path = path_of(name)
        if name not in seen and path is not None:
            left += on_top(path)
        seen.add(name)
    return frozenset(seen)


def heavy(module: str) -> frozenset[str]:
    """Return the heavy libraries that importing a module loads."""
    return frozenset({name.partition(".")[0] for name in loaded_with(module)} & HEAVY)


def brought_in(path: Path) -> set[str]:
    """Return the modules of its own package that a file imports lazily.

    Modules that load a heavy library are left out.
    """
    components = path.relative_to(PACKAGE).with_suffix("").parts
    # A package holds subpackages.
    package = ".".join(
        ("motionlang", *components[: 2 if components[0] in ("kernel", "commands", "lab", "ide") else 1], "")
    )
    already = heavy(".".join(("motionlang", *components)).removesuffix(".__init__"))
    functions = (node for node in nodes_of(path) if isinstance(node, ast.FunctionDef | ast.AsyncFunctionDef))
    modules = {
        module_of(node, alias.name)
        for function in functions
        for node in ast.walk(function)
        if isinstance(node, ast.ImportFrom) and f"{node.module}.".startswith(package)
        for alias in node.names
    }
    return {module.removeprefix(package) for module in modules if not heavy(module) - already}


def test_imports_inside_functions_cross_packages_load_what_is_heavy_or_are_listed() -> None:
    found = {path.relative_to(PACKAGE).as_posix(): brought_in(path) for path in sorted(PACKAGE.rglob("*.py"))}
    assert {name: modules for name, modules in found.items() if modules} == {
        name: set(modules.split()) for name, modules in LAZY.items()
    }

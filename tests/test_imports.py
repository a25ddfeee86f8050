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
HEAVY = {"can", "canopen", "lark", "matplotlib", "numpy", "prompt_toolkit", "rich"}
# Importer and lazily imported modules, both without the name of their package. A line may leave this list or
# become shorter; none may grow or be added.
LAZY = {
    # Lazy packages: each opens a family of modules; most programs need few. That of the command line
    # is the table of its commands.
    "kernel/mccl/__init__.py": "keywords keywords.row keywords.switchable models",
    "kernel/mint/__init__.py": "keywords keywords.latches keywords.machine_readings keywords.switchable models "
    "resolve.aliases runtime.task runtime.wait_sources",
    "kernel/mccl/keywords/__init__.py": "keywords.index",
    "kernel/mint/keywords/__init__.py": "keywords.index",
    "kernel/mint/runtime/environment.py": "runtime.errors runtime.events runtime.power_up",
    "commands/run/command.py": "keyboard",
    # Questions about a program that a run does not ask.
    "kernel/mccl/runtime/program.py": "resolve.board resolve.chosen_rates resolve.definitions resolve.errors "
    "runtime.structure",
    "kernel/mint/program.py": "check.port resolve.definitions steps.structure syntax.extent syntax.layout",
    # Those that need one another.
    "kernel/planners/curve.py": "sequence",
    # Modules that few programs, or few commands, need.
    "hosts/client/client.py": "client.virtual",
    "hosts/client/mint.py": "client.virtual",
    "kernel/mint/runtime/task.py": "runtime.errors",
    "processes/parallel.py": "workers",
    "ide/lsp/command.py": "server workers",
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


def for_types(path: Path) -> list[ast.stmt]:
    """Return the statements of a file that are executed for types alone."""
    return [node for each in tree_of(path).body if is_for_types(each) for node in each.body]  # type: ignore[attr-defined]


@cache
def named_for_types(module: str) -> frozenset[str]:
    """Return the names that a module defines for types alone."""
    path = path_of(module)
    nodes = [] if path is None else for_types(path)
    assigned = [node for node in nodes if isinstance(node, ast.Assign | ast.AnnAssign)]
    names = {each.id for node in assigned for each in ast.walk(node) if isinstance(each, ast.Name)}
    return frozenset(names | {node.name for node in nodes if isinstance(node, ast.ClassDef)})


def needs_no_block(path: Path) -> bool:
    """True if a file imports for types alone what it could import at no cost."""
    nodes, own = for_types(path), ".".join(path.relative_to(PACKAGE.parent).with_suffix("").parts)
    imports = [
        (node, alias.name) for node in nodes if isinstance(node, ast.ImportFrom) for alias in node.names
    ]
    modules = {module_of(*each) for each in imports} - {"collections.abc"}
    return (
        bool(nodes)
        and not any(isinstance(node, ast.ClassDef) for node in nodes)
        and modules <= loaded_with(own.removesuffix(".__init__"))
        and not any(own in loaded_with(module) for module in modules)
        and not any(name in named_for_types(module_of(node, name)) for node, name in imports)
    )


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


def test_what_is_loaded_anyway_is_not_imported_for_types_alone() -> None:
    """A block of imports for types spares a run some modules, or points up."""
    files = sorted(PACKAGE.rglob("*.py"))
    assert [each.relative_to(PACKAGE).as_posix() for each in files if needs_no_block(each)] == []

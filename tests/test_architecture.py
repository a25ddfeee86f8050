"""The architecture rules that a machine can check, in addition to the layers in `pyproject.toml`."""

from __future__ import annotations

import ast
import re
from collections.abc import Iterable, Iterator, Sequence
from functools import cache
from pathlib import Path

import grimp
import pytest

from tests.cases import cases
from tests.trees import nodes_of, tree_of

pytestmark = pytest.mark.usefixtures("package_trees")

ROOT = Path(__file__).parent.parent
PACKAGE = ROOT / "motionlang"
EXPLORE = ROOT / "extras" / "explore" / "motionlang_explore"
PAGES = [
    (ROOT / "docs" / "contributing" / name).read_text(encoding="utf-8")
    for name in ("architecture.md", "kernel.md")
]

# A library, and the only modules that may import it.
HOMES: dict[str, tuple[str, ...]] = {
    "lark": ("kernel/lang/syntax", "kernel/mccl/syntax", "kernel/mint/syntax"),
    "rich": ("views",),
    "prompt_toolkit": ("repl",),
    "matplotlib": ("views/figure_matplotlib.py",),
    "pyarrow": ("commands/recording", "commands/trace", "commands/sweep"),
    "polars": ("kernel/rows.py",),
    "pandas": ("kernel/rows.py",),
    "pygments": ("views",),
    "serial": ("hosts",),
    "shtab": ("cli",),
}
# Files whose sums are of integers, although their text does not show it.
WHOLE_SUMS = {
    "panel/state.py",
    "kernel/log/cycle.py",
    "kernel/log/log.py",
    "kernel/log/stream.py",
    "kernel/controller/feedback.py",
    "commands/check/rules/mixed_operators.py",
    "commands/check/rules/never_started.py",
    "init/recorded/judging.py",
    "kernel/mint/runtime/environment.py",
    "views/table.py",
}
FILES = [*sorted(PACKAGE.rglob("*.py")), *sorted(EXPLORE.rglob("*.py"))]


def within(path: Path) -> str:
    """Return the path of a file within its package."""
    return path.relative_to(EXPLORE if EXPLORE in path.parents else PACKAGE).as_posix()


@cache
def imports(path: Path) -> set[str]:
    """Return every module that a file imports anywhere, including imports for types."""
    found: set[str] = set()
    for node in nodes_of(path):
        if isinstance(node, ast.Import):
            found.update(alias.name for alias in node.names)
        elif isinstance(node, ast.ImportFrom) and node.module:
            found.add(node.module)
            if node.module == "motionlang":
                found.update(f"motionlang.{alias.name}" for alias in node.names)
    return found


# Methods that change a list, a set or a dictionary.
CHANGES = frozenset(
    ("append", "extend", "insert", "remove", "pop", "clear", "update", "setdefault", "add", "discard")
)
# Results of these on an axis or a controller still belong to it.
VIEWS = frozenset(("items", "values", "encoder"))
CONTROLLERS = frozenset(("controller", "_controller"))
OF_THE_CONTROLLER = frozenset(("Axis", "Controller", "ControllerState", "Feedback", "Limit", "Move", "Scale"))


def is_of_controller(node: ast.AST, names: set[str]) -> bool:
    """True if an expression is the controller, an axis, or a component of one.

    `names` are the names bound to such objects.
    """
    while True:
        if isinstance(node, ast.Name):
            return node.id in names or node.id in CONTROLLERS
        if isinstance(node, ast.Attribute) and node.attr in CONTROLLERS:
            return True
        if isinstance(node, ast.IfExp):
            return is_of_controller(node.body, names) or is_of_controller(node.orelse, names)
        if isinstance(node, ast.Attribute | ast.Subscript):
            node = node.value
        elif isinstance(node, ast.Call) and isinstance(node.func, ast.Attribute) and node.func.attr in VIEWS:
            node = node.func.value
        else:
            return isinstance(node, ast.Call) and ast.unparse(node.func) == "scale_of"


def bindings(nodes: Iterable[ast.AST]) -> Iterator[tuple[ast.AST, ast.AST]]:
    """Yield each binding of a name in nodes of a function: the target and its value."""
    for node in nodes:
        if isinstance(node, ast.For | ast.comprehension):
            yield node.target, node.iter
        elif isinstance(node, ast.Assign):
            for target in node.targets:
                if isinstance(target, ast.Tuple) and isinstance(node.value, ast.Tuple):
                    yield from zip(target.elts, node.value.elts, strict=False)
                else:
                    yield target, node.value


def reaches_into_the_controller(tree: ast.AST) -> Iterator[str]:
    """Yield writes to an axis or the controller, and uses of their private attributes.

    `listeners` may be used.
    """
    for function in (node for node in ast.walk(tree) if isinstance(node, ast.FunctionDef | ast.Lambda)):
        arguments = [*function.args.args, *function.args.kwonlyargs]
        names = {
            a.arg
            for a in arguments
            if a.annotation and ast.unparse(a.annotation).split(" |")[0] in OF_THE_CONTROLLER
        }
        nodes = list(ast.walk(function))
        bound = list(bindings(nodes))
        for _ in range(3):
            for target, given in bound:
                if is_of_controller(given, names):
                    elements = target.elts if isinstance(target, ast.Tuple) else [target]
                    names.update(each.id for each in elements if isinstance(each, ast.Name))
        for node in nodes:
            found = False
            if isinstance(node, ast.Attribute | ast.Subscript):
                private = (
                    isinstance(node, ast.Attribute)
                    and node.attr.startswith("_")
                    and not node.attr.endswith("__")
                    and node.attr != "_replace"  # that of a named tuple, such as the lint's own Axis
                )
                found = (private or not isinstance(node.ctx, ast.Load)) and is_of_controller(
                    node.value, names
                )
            elif isinstance(node, ast.Call) and isinstance(node.func, ast.Attribute):
                of = node.func.value
                if node.func.attr in CHANGES and isinstance(of, ast.Attribute | ast.Subscript):
                    found = "listeners" not in ast.unparse(of) and is_of_controller(of.value, names)
            elif isinstance(node, ast.Call) and isinstance(node.func, ast.Name):
                found = node.func.id in ("setattr", "delattr") and is_of_controller(node.args[0], names)
            if found:
                yield f"{node.lineno}: {ast.unparse(node)}"  # type: ignore[attr-defined]


@pytest.mark.slow
def test_no_dialect_reaches_into_the_controller() -> None:
    """A language changes an axis only through verbs (`tests/operations.py`).

    It reads an axis only through bound readers.
    """
    found = {
        f"{path.relative_to(PACKAGE).as_posix()}:{each}"
        for package in (
            "kernel/mint",
            "kernel/mccl",
            "kernel/lang",
            "commands/check",
            "lab/pvt",
            "hosts",
            "repl",
        )
        for path in sorted((PACKAGE / package).rglob("*.py"))
        for each in reaches_into_the_controller(tree_of(path))
        if not each.endswith("clock.now") and path.name != "input.py"  # its moves are rows of a table
    }
    assert found == set()


def test_the_homes_of_libraries_exist() -> None:
    for home in (each for homes in HOMES.values() for each in homes):
        assert (PACKAGE / home).exists(), home


@cases("path", FILES, ids=within)
def test_heavy_libraries_stay_at_home(path: Path) -> None:
    relative = within(path)
    for module in imports(path):
        homes = HOMES.get(module.split(".")[0])
        assert homes is None or relative.startswith(homes), f"{relative} imports {module}"


def test_no_private_module_of_python_is_imported() -> None:
    """`_thread` is documented; `__future__` is public; `_typeshed` is for types only."""
    allowed = {"_thread", "_typeshed"}
    private = {
        f"{within(path)}: {name}"
        for path in FILES
        for name in imports(path)
        if name.startswith("_") and not name.startswith("__") and name not in allowed
    }
    assert private == set()


@cache
def roots() -> tuple[Path, ...]:
    packages = (PACKAGE, EXPLORE)
    return (
        ROOT,
        ROOT / "tests",
        *(path for each in packages for path in (each, *each.rglob("*")) if path.is_dir()),
    )


@cases("named", sorted(set(re.findall(r"`([\w/.]+(?:\.py|\.md|/))`", "\n".join(PAGES)))))
def test_the_pages_about_the_architecture_name_what_there_is(named: str) -> None:
    assert any((root / named).exists() for root in roots()), f"the pages about the architecture name {named}"


def test_the_page_of_the_architecture_says_what_each_package_uses() -> None:
    page = (ROOT / "docs" / "contributing" / "architecture.md").read_text(encoding="utf-8")
    rows = re.findall(
        r"^\| `(\w+)(?:/|\.py)` \| [^|]* \| ([^|]*) \|", page.partition("## Inside")[0], re.MULTILINE
    )
    graph = grimp.build_graph("motionlang", exclude_type_checking_imports=True)
    used: dict[str, set[str]] = {name: set() for name, _ in rows}
    for module in graph.modules:
        for other in graph.find_modules_directly_imported_by(module):
            here, there = (each.split(".")[1] if "." in each else "" for each in (module, other))
            if here in used and there not in ("", here):
                used[here].add(there)
    assert {name: set() if text == "–" else set(text.split(", ")) for name, text in rows} == used


def is_whole(node: ast.expr) -> bool:
    """True if an expression can only be an integer.

    Such are a constant integer, a bit shift, a comparison, a length, and a sum, difference or product of
    these.
    """
    if isinstance(node, ast.Constant):
        return isinstance(node.value, int)
    if isinstance(node, ast.BinOp):
        return isinstance(node.op, ast.LShift) or (
            isinstance(node.op, ast.Add | ast.Sub | ast.Mult) and is_whole(node.left) and is_whole(node.right)
        )
    is_length = isinstance(node, ast.Call) and isinstance(node.func, ast.Name) and node.func.id == "len"
    return is_length or isinstance(node, ast.Compare)


def float_sums(nodes: Sequence[ast.AST]) -> list[int]:
    """Return the lines that use the builtin `sum` on anything but certain integers."""
    counting = set()
    for node in nodes:
        if isinstance(node, ast.Call) and isinstance(node.func, ast.Name) and len(node.args) == 1:
            (of,) = node.args
            lengths = isinstance(of, ast.Call) and ast.unparse(of).startswith("map(len, ")
            if lengths or (isinstance(of, ast.GeneratorExp | ast.ListComp) and is_whole(of.elt)):
                counting.add(node.func)
    names = (node for node in nodes if isinstance(node, ast.Name) and node.id == "sum")
    return [node.lineno for node in names if node not in counting]


@cases("path", FILES, ids=within)
def test_no_figure_comes_from_the_builtin_sum(path: Path) -> None:
    """From Python 3.12 on, `sum` rounds floats differently than before.

    `tools.total`, `math.fsum` and plain additions give the same result in every version.
    """
    found = float_sums(nodes_of(path))
    assert bool(found) is (within(path) in WHOLE_SUMS), f"sum() on lines {found}"

"""The lists of names that other packages import from the kernel."""

from __future__ import annotations

import ast
import re
import tomllib
from importlib import import_module
from importlib.util import find_spec
from pathlib import Path

import pytest

from tests.trees import nodes_of, tree_of
from tools.kernel_names import PACKAGE, packages

ROOT = PACKAGE.parent


def contract() -> tuple[list[re.Pattern[str]], list[re.Pattern[str]]]:
    """Return the modules that other packages may not import, and the exceptions, as patterns of "module -> module"."""
    contracts = tomllib.loads((ROOT / "pyproject.toml").read_text(encoding="utf-8"))["tool"]["importlinter"]
    (found,) = [each for each in contracts["contracts"] if each["name"] == "names of the kernel"]
    protected = [f"** -> {each}" for each in found["protected_modules"]]
    below = [f"{each}.**" for each in protected]
    return [_pattern(each) for each in (*protected, *below)], [
        _pattern(each) for each in found["ignore_imports"]
    ]


def _pattern(expression: str) -> re.Pattern[str]:
    """Return the pattern of an expression of import-linter: `*` is one name, `**` one or more."""
    parts = (re.escape(each) for each in re.split(r"(\*\*?)", expression))
    signs = {r"\*": "[^. ]+", r"\*\*": "[^ ]+"}
    return re.compile("".join(signs.get(each, each) for each in parts))


def imported(path: Path) -> set[str]:
    """Return the modules of the kernel that a file imports, those for types, too."""
    found = set()
    for node in nodes_of(path):
        if isinstance(node, ast.ImportFrom) and str(node.module).startswith("motionlang.kernel"):
            names = (f"{node.module}.{each.name}" for each in node.names)
            found |= {each if is_module(each) else str(node.module) for each in names}
    return found


def is_module(name: str) -> bool:
    """True if the package has a module of this name."""
    path = ROOT.joinpath(*name.split("."))
    return path.is_dir() or path.with_suffix(".py").exists()


@pytest.mark.slow
def test_houses_import_names_of_the_kernel_from_its_lists_for_types_too() -> None:
    refused, excused = contract()
    files = [path for path in sorted(PACKAGE.rglob("*.py")) if PACKAGE / "kernel" not in path.parents]
    files += sorted((ROOT / "extras" / "explore" / "motionlang_explore").rglob("*.py"))
    assert len(files) > 100
    edges = {
        f"{'.'.join(path.relative_to(ROOT).with_suffix('').parts).removesuffix('.__init__')} -> {module}"
        for path in files
        for module in imported(path)
    }
    deep = {each for each in edges if any(pattern.fullmatch(each) for pattern in refused)}
    assert deep
    assert {each for each in deep if not any(pattern.fullmatch(each) for pattern in excused)} == set()


@pytest.mark.parametrize("package", packages())
def test_a_list_is_what_type_checkers_see_and_hides_no_module(package: str) -> None:
    module = import_module(package)
    listed = {f"{package}.{each}": set(names.split()) for each, names in module.PUBLIC.items()}
    seen: dict[str, set[str]] = {}
    for block in tree_of(Path(str(module.__file__))).body:
        if isinstance(block, ast.If) and ast.unparse(block.test) == "TYPE_CHECKING":
            for node in block.body:
                assert isinstance(node, ast.ImportFrom)
                names = {each.name for each in node.names if each.asname == each.name}
                seen.setdefault(str(node.module), set()).update(names)
    assert {each: names for each, names in seen.items() if names} == listed
    assert [name for names in listed.values() for name in names if find_spec(f"{package}.{name}")] == []


@pytest.mark.parametrize("package", packages())
def test_a_name_that_no_list_has_is_an_error(package: str) -> None:
    with pytest.raises(AttributeError, match=f"module '{package}' has no attribute 'nothing'"):
        _ = import_module(package).nothing

"""Writer of the names in docs/contributing/kernel.md, which other packages import from the kernel.

`PUBLIC` of the kernel and of each of its subpackages lists the names. The text of a name is the first sentence of its
docstring, or for a constant that of the comment above or beside it. Only the section of the page between
`<!-- names -->` and `<!-- end -->` is generated.
"""

from __future__ import annotations

import ast
import re
from collections.abc import Iterator
from importlib import import_module
from pathlib import Path
from pkgutil import iter_modules

import motionlang.kernel

ROOT = Path(__file__).parents[1]
PACKAGE = ROOT / "motionlang"
PAGE = ROOT / "docs" / "contributing" / "kernel.md"
_SECTION = re.compile(r"(<!-- names -->\n).*?(<!-- end -->)", re.DOTALL)


def packages() -> list[str]:
    """Return the packages that have a list: the kernel, then its subpackages."""
    kernel = motionlang.kernel.__name__
    below = [f"{kernel}.{each.name}" for each in iter_modules(motionlang.kernel.__path__) if each.ispkg]
    return [kernel, *(each for each in below if hasattr(import_module(each), "PUBLIC"))]


def texts(path: Path) -> dict[str, str]:
    """Return the first sentence about each class, function and constant of a module."""
    source = path.read_text(encoding="utf-8")
    lines, body = source.splitlines(), ast.parse(source).body
    found = {}
    for node, after in zip(body, [*body[1:], None], strict=True):
        if isinstance(node, ast.ClassDef | ast.FunctionDef):
            found[node.name] = _sentence(ast.get_docstring(node) or "")
        elif isinstance(node, ast.Assign | ast.AnnAssign):
            targets = node.targets if isinstance(node, ast.Assign) else [node.target]
            is_text = isinstance(after, ast.Expr) and isinstance(after.value, ast.Constant)
            text = lines[after.lineno - 1].strip('"') if after and is_text else _comment(lines, node)
            names = [each.id for target in targets for each in ast.walk(target) if isinstance(each, ast.Name)]
            found.update(dict.fromkeys(names, _sentence(text)))
    return found


def _comment(lines: list[str], node: ast.stmt) -> str:
    """Return the comment beside an assignment, or the one above it and its neighbours."""
    _, mark, beside = lines[node.lineno - 1].partition("  # ")
    above: list[str] = []
    for line in reversed(lines[: node.lineno - 1]):
        if line.startswith("# "):
            above.insert(0, line[2:])
        elif above or not line or line[0] in " )}]":
            break
    return beside if mark else " ".join(above)


def _sentence(text: str) -> str:
    first = re.split(r"(?<=[.!?])\s+(?=[^a-z0-9])|\n\n", text, maxsplit=1)[0]
    sentence = " ".join(first.split()).rstrip(".")
    return sentence[:1].upper() + sentence[1:]


def rows(package: str) -> Iterator[str]:
    """Yield the row of each name of a package."""
    lists: dict[str, str] = import_module(package).PUBLIC
    for module, names in lists.items():
        path = Path(str(import_module(f"{package}.{module}").__file__))
        home, known = path.relative_to(PACKAGE).as_posix(), texts(path)
        for name in names.split():
            assert known.get(name), f"{path}: {name} has no docstring and no comment"
            text = known[name].replace("|", "\\|")
            yield f"| `{name}` | {text} | `{home}` |\n"


def section() -> str:
    """Return the generated section."""
    body = ""
    for package in packages():
        found = list(rows(package))
        body += f"\n### {package}\n\n| {len(found)} names | | |\n|---|---|---|\n{''.join(found)}"
    return f"{body}\n"


def files() -> dict[Path, str]:
    text = PAGE.read_text(encoding="utf-8")
    return {PAGE: _SECTION.sub(lambda found: f"{found[1]}{section()}{found[2]}", text)}

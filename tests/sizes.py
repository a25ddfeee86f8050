"""Size of the package: `python -m tests.sizes [COMMIT]`, compared with a commit.

* Lines of each package by kind. *Data* are assignments of a module that take several lines, such as rows of
  keywords. *Logic* is everything except data, docstrings, comments, blank lines and imports. Generated files
  count separately.
* Fields of `Axis` and `Scheduler`, including their base classes and the objects of the package that only they
  create.
* Functions of more than `LONG` lines.
* Files of the package that one statement enters, without imports: from the start of its task on, and while
  the statement runs.
"""

from __future__ import annotations

import ast
import io
import os
import subprocess
import sys
import tempfile
import tokenize
from collections import Counter
from collections.abc import Iterator
from pathlib import Path
from typing import NamedTuple

from tests.commits import unpacked

ROOT = Path(__file__).parent.parent
KINDS = ("logic", "blank", "docstring", "import", "data", "comment", "generated")
LONG = 70
# The docstring of a generated file has one of these.
GENERATED = ("not by hand.", "do not edit")
CLASSES = {"Axis": "kernel/controller/axis.py", "Scheduler": "kernel/lang/scheduler.py"}
# Each statement with its file and the lines that it needs before it.
STATEMENTS = {
    "SPEED(0) = 1": ("a.mnt", ""),
    "GO(0)": ("a.mnt", "MOVER(0) = 1"),
    "p = POS(0)": ("a.mnt", "Dim p As Float"),
    "1MR40000": ("a.mcl", "1MN"),
}
# Runs in the tree that is counted; prints the number of files from the start of the task on, and while it
# runs.
TRACE = r"""
import json, sys
from motionlang.kernel.execution import run
from motionlang.kernel.source import Source
name, text = sys.argv[1:]
whole, running, active = set(), set(), [False]
def called(frame, event, argument):
    code = frame.f_code
    if "/motionlang/" not in code.co_filename or event not in ("call", "return"):
        return
    outer = frame
    while outer is not None:
        if outer.f_code.co_name == "<module>" and "/motionlang/" in outer.f_code.co_filename:
            return
        outer = outer.f_back
    file = code.co_filename.rpartition("/motionlang/")[2]
    if file.startswith("kernel/lang/scheduler") and code.co_name == "run":
        active[0] = event == "call"
    whole.add(file)
    if active[0]:
        running.add(file)
run(Source(name, text), begun=lambda machine: sys.setprofile(called))
sys.setprofile(None)
print(len(whole), len(running))
"""


class Sizes(NamedTuple):
    """The figures of one tree."""

    lines: dict[str, Counter[str]]
    fields: dict[str, int]
    owned: dict[str, int]
    long: dict[str, int]
    entered: dict[str, tuple[int, ...]]


def kinds(text: str) -> Counter[str]:
    """Return the number of lines of each kind in the text of a file."""
    tree, kind = ast.parse(text), dict.fromkeys(range(1, text.count("\n") + 1), "logic")
    for number, line in enumerate(text.split("\n")[:-1], 1):
        if not line.strip():
            kind[number] = "blank"
    for token in tokenize.generate_tokens(io.StringIO(text).readline):
        if token.type == tokenize.COMMENT and token.line.lstrip().startswith("#"):
            kind[token.start[0]] = "comment"
    for node, name in _not_logic(tree):
        for number in range(node.lineno, (node.end_lineno or node.lineno) + 1):
            if kind[number] != "blank" or name == "docstring":
                kind[number] = name
    if _is_generated(tree):
        return Counter(generated=len(kind))
    return Counter(kind.values())


def _is_generated(tree: ast.Module) -> bool:
    head = ast.get_docstring(tree) or ""
    return any(sign in head for sign in GENERATED)


def _not_logic(node: ast.AST) -> Iterator[tuple[ast.stmt, str]]:
    body: list[ast.stmt] = getattr(node, "body", [])
    for index, each in enumerate(body if isinstance(body, list) else []):
        is_text = isinstance(each, ast.Expr) and isinstance(each.value, ast.Constant)
        if is_text and index == 0 and not isinstance(node, ast.If):
            yield each, "docstring"
        elif isinstance(each, ast.Import | ast.ImportFrom):
            yield each, "import"
        elif (
            isinstance(each, ast.Assign | ast.AnnAssign)
            and isinstance(node, ast.Module)
            and (each.end_lineno or 0) > each.lineno
        ):
            yield each, "data"
    for child in ast.iter_child_nodes(node):
        yield from _not_logic(child)


class Classes:
    """The classes of a source tree by name."""

    def __init__(self, trees: dict[str, ast.Module]) -> None:
        self._found: dict[str, list[tuple[str, ast.ClassDef]]] = {}
        self._makers: dict[str, set[str]] = {}
        for path, tree in trees.items():
            for node in ast.walk(tree):
                if isinstance(node, ast.ClassDef):
                    self._found.setdefault(node.name, []).append((path, node))
                elif isinstance(node, ast.Call) and isinstance(node.func, ast.Name):
                    self._makers.setdefault(node.func.id, set()).add(path)

    def fields(self, name: str, path: str = "") -> dict[str, ast.expr | None]:
        """Return the fields of a class and its bases, each with its first assigned value."""
        found: dict[str, ast.expr | None] = {}
        for where, node in self._found.get(name, []):
            if path and where != path:
                continue
            for base in node.bases:
                found.update(self.fields(ast.unparse(base).partition("[")[0]))
            found.update(_own_fields(node))
            break
        return found

    def with_owned(self, name: str, path: str, without: frozenset[str] = frozenset()) -> int:
        """Return the number of fields of a class and of the objects that only it creates.

        Only objects with a class of the package count, except those of the classes `without`.
        """
        fields = self.fields(name, path)
        count = len(fields)
        for value in fields.values():
            made = value.func.id if isinstance(value, ast.Call) and isinstance(value.func, ast.Name) else ""
            if made in self._found.keys() - without and self._makers.get(made) == {path}:
                count += len(self.fields(made))
        return count


def _own_fields(node: ast.ClassDef) -> dict[str, ast.expr | None]:
    found: dict[str, ast.expr | None] = {}
    for each in node.body:
        if isinstance(each, ast.AnnAssign) and isinstance(each.target, ast.Name):
            if "ClassVar" not in ast.unparse(each.annotation):
                found.setdefault(each.target.id, each.value)
        elif isinstance(each, ast.Assign) and ast.unparse(each.targets[0]) == "__slots__":
            found.update(dict.fromkeys(ast.literal_eval(each.value)))
    properties = {
        each.name for each in node.body if isinstance(each, ast.FunctionDef) and each.decorator_list
    }
    for method in (each for each in node.body if isinstance(each, ast.FunctionDef)):
        for child in ast.walk(method):
            targets, value = _assigned(child)
            for target in targets:
                if (
                    isinstance(target, ast.Attribute)
                    and ast.unparse(target.value) == "self"
                    and target.attr not in properties
                    and found.get(target.attr) is None
                ):
                    found[target.attr] = value
    return found


def _assigned(node: ast.AST) -> tuple[list[ast.expr], ast.expr | None]:
    if isinstance(node, ast.AnnAssign):
        return [node.target], node.value
    if not isinstance(node, ast.Assign):
        return [], None
    targets = [
        element for each in node.targets for element in (each.elts if isinstance(each, ast.Tuple) else [each])
    ]
    return targets, node.value


def sizes(root: Path) -> Sizes:
    """Return every figure of the tree in a folder."""
    package = root / "motionlang"
    texts = {path.relative_to(package).as_posix(): path.read_text("utf-8") for path in package.rglob("*.py")}
    trees = {name: ast.parse(text) for name, text in sorted(texts.items())}
    lines: dict[str, Counter[str]] = {}
    long: dict[str, int] = {}
    for name, tree in trees.items():
        folder = name.partition("/")[0] if "/" in name else "top"
        lines.setdefault(folder, Counter()).update(kinds(texts[name]))
        for node in ast.walk(tree) if not _is_generated(tree) else ():
            if isinstance(node, ast.FunctionDef) and (node.end_lineno or 0) - node.lineno >= LONG:
                long[f"{name} {node.name}"] = (node.end_lineno or 0) - node.lineno + 1
    classes = Classes(trees)
    return Sizes(
        lines,
        {name: len(classes.fields(name, path)) for name, path in CLASSES.items()},
        {name: classes.with_owned(name, path) for name, path in CLASSES.items()},
        long,
        {statement: entered(root, statement) for statement in STATEMENTS},
    )


def entered(root: Path, statement: str) -> tuple[int, ...]:
    """Return how many files of the package a statement enters.

    One number counts from the start of the task on, the other only while the statement runs.
    """
    name, before = STATEMENTS[statement]
    command = [sys.executable, "-c", TRACE, name, f"{before}\n{statement}\n"]
    environment = {**os.environ, "PYTHONPATH": str(root)}
    done = subprocess.run(command, cwd=root, env=environment, check=True, capture_output=True, text=True)
    return tuple(int(number) for number in done.stdout.split())


def table(now: Sizes, then: Sizes | None) -> Iterator[str]:
    """Yield the lines of the table; two trees are shown as `then -> now`."""

    def pair(old: object, new: object) -> str:
        return f"{new}" if then is None else f"{old} -> {new}"

    before = then or now
    yield f"{'lines':<12}" + "".join(f"{kind:>18}" for kind in KINDS)
    every = {*now.lines, *before.lines}
    sums = {
        "sum": (sum(before.lines.values(), Counter[str]()), sum(now.lines.values(), Counter[str]())),
    }
    rows = {
        name: (before.lines.get(name, Counter()), now.lines.get(name, Counter())) for name in sorted(every)
    }
    for name, (old, new) in {**rows, **sums}.items():
        yield f"{name:<12}" + "".join(f"{pair(old[kind], new[kind]):>18}" for kind in KINDS)
    yield ""
    for name in CLASSES:
        fields, owned = pair(before.fields[name], now.fields[name]), pair(before.owned[name], now.owned[name])
        yield f"fields of {name}: {fields}; with what only it owns: {owned}"
    yield f"functions over {LONG} lines: {pair(len(before.long), len(now.long))}"
    yield from (f"  {count:>4} {name}" for name, count in sorted(now.long.items(), key=lambda each: -each[1]))
    yield "files entered, from the start of the task; as it runs"
    for statement in STATEMENTS:
        (old_all, old_run), (all_, run) = before.entered[statement], now.entered[statement]
        yield f"  {statement:<14} {pair(old_all, all_):>12} {pair(old_run, run):>12}"


def main(arguments: list[str]) -> int:
    """Print the table of this tree, compared with a commit if one is given."""
    with tempfile.TemporaryDirectory() as folder:
        then = sizes(unpacked(arguments[0], Path(folder), "motionlang")) if arguments else None
        print(*table(sizes(ROOT), then), sep="\n")
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))

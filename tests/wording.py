"""Counts of words that this project avoids, and random samples of its texts.

    python -m tests.wording [COMMIT]       the counts by package, compared with a commit
    python -m tests.wording --draw DATE    30 docstrings, 30 names, 20 messages and 10 passages of docs

A tool for whoever changes texts; no test fails for a word. A text is a docstring, a comment, a paragraph of a page, or
a message, which is a string of the package with more than one word. Names and quotations do not count. They
are recognised by rule: code in backticks and blocks, texts in double quotes, words in capitals, and the
target of a link.
"""

from __future__ import annotations

import argparse
import ast
import io
import re
import sys
import tempfile
import tokenize
from collections import Counter
from collections.abc import Iterable, Iterator
from functools import cache
from inspect import cleandoc
from pathlib import Path
from random import Random
from typing import NamedTuple

from tests.commits import unpacked
from tests.trees import nodes_of, text_of, tree_of

ROOT = Path(__file__).parent.parent
FOLDERS = ("motionlang", "benchmarks", "tests")
# Pages that quote programs, and pages of the manuals, which are derived.
DERIVED = ("docs/keywords", "docs/contributing/assumptions.md")
MAX_FIRST_LINE = 80
# Docstrings may not begin with these.
FIRST_WORDS = re.compile(r"(What|Whether|Where|Whoever|The same)\b")
# Each pattern, and the words to use instead.
BANNED = {
    r"nobody|somebody|whoever": "no task, a user, the caller",
    r"in vain": "unsatisfied, without effect",
    r"left alone|leaves? alone": "unchecked, unchanged",
    r"at all(?! \w+s\b)": "leave it out",
    r"tells?|told|telling": "report, notify, state, distinguish",
    r"said": "states, reports, prints",
    r"kept": "stored, cached, retained",
    r"(?:stands?|stood)(?! for\b|-in)": "is, is at rest",
    r"of which": "whose, of these",
    r"borne|bears?": "allows, has",
    r"besides?": "in addition, next to",
    r"anew": "again, from scratch",
    r"mend(?:s|ed)?": "fix, fixed",
    r"(?:is|are|was|were|be|nothing|something|anything) otherwise": "differs, no difference",
    r"under way": "in progress, in motion",
    r"mishaps?": "run-time fault",
    r"judges?|judged": "checker, check",
    r"(?:a|the|each|every|one|its|this|that|half a|next|last|of|per) turns?(?! (?:on|off|out|into|to))": (
        "iteration, time slice, revolution, wrap, extremum"
    ),
    r"turns? (?:round|over)": "reverse, wrap",
    r"which way|whichever way|the way (?:back|there|on)|on (?:the|its) way(?! (?:to|from|out)\b)": (
        "direction, distance, path, in between"
    ),
    r"open readings?": "assumption, unconfirmed behaviour",
    r"asked for": "commanded, requested, required",
    r"wall clock|the wall": "real time",
    r"goes by|went by": "depends on, uses",
    r"looked at|looks? at|looking at": "checked, read",
    r"words? of (?:Mint|MCCL|a language|the language|both languages)": "keyword",
    r"(?:the|its|their) begin": "start",
    r"no matter": "does not affect",
    r"as golden files say|golden files say": "match the golden files",
}
# Of lower-case text: a pattern without regard to case takes five times as long.
PATTERN = re.compile(rf"\b(?:{'|'.join(BANNED)})\b")
_EXEMPT = re.compile(r"`[^`]*`|\"[^\"\n]{1,80}\"|\]\([^)]*\)|\*[^*\n]+\*|\b[A-Z]{2,}[A-Z0-9]*\b")
_FENCE = re.compile(r"^(```|~~~).*?^\1", re.MULTILINE | re.DOTALL)
_SPECIAL = re.compile(r"#\s*(?:type:|noqa|pragma|fmt:|mypy:|ruff:|!)")


class Text(NamedTuple):
    """A text with its kind, its file relative to the project, and its line."""

    kind: str
    file: str
    line: int
    text: str

    @property
    def package(self) -> str:
        """Return the subpackage or the folder that has the text."""
        first, _, rest = self.file.partition("/")
        return f"{first}/{rest.partition('/')[0]}" if first == "motionlang" and "/" in rest else first

    def found(self) -> list[str]:
        """Return the banned words in the text, in lower case."""
        text = self.text
        if self.file.startswith("motionlang/kernel/mccl/keywords/"):
            text = text.removeprefix("Tell ")  # TP is PMC's "Tell Position"
        if not PATTERN.search(text.lower()):
            return []
        return PATTERN.findall(_EXEMPT.sub(" ", text).lower())


def instead(word: str) -> str:
    """Return the replacements of a banned word."""
    return next(text for pattern, text in BANNED.items() if re.match(pattern, word))


def statements(body: Iterable[ast.stmt]) -> Iterator[ast.stmt]:
    """Yield statements and all nested statements, but no expressions."""
    for each in body:
        yield each
        for name in ("body", "orelse", "finalbody"):
            yield from statements(getattr(each, name, ()))
        for handler in getattr(each, "handlers", ()):
            yield from statements(handler.body)


def docstrings(path: Path, file: str) -> Iterator[Text]:
    """Yield the docstrings of a file, including those of attributes."""
    module = tree_of(path)
    definitions = (ast.ClassDef, ast.FunctionDef)
    for node in (module, *(each for each in statements(module.body) if isinstance(each, definitions))):
        assert isinstance(node, ast.Module | ast.ClassDef | ast.FunctionDef)
        for before, each in zip([None, *node.body], node.body, strict=False):
            value = each.value if isinstance(each, ast.Expr) else None
            is_first = before is None or isinstance(before, ast.Assign | ast.AnnAssign)
            if is_first and isinstance(value, ast.Constant) and isinstance(value.value, str):
                yield Text("docstring", file, each.lineno, cleandoc(value.value))


def comments(path: Path, file: str) -> Iterator[Text]:
    """Yield the comments of a file, each block of lines as one."""
    text = text_of(path)
    block: list[str] = []
    last = 0
    for token in tokenize.generate_tokens(io.StringIO(text).readline):
        if token.type != tokenize.COMMENT or _SPECIAL.match(token.string):
            continue
        if block and token.start[0] != last + 1:
            yield Text("comment", file, last - len(block) + 1, " ".join(block))
            block = []
        block.append(token.string.lstrip("# "))
        last = token.start[0]
    if block:
        yield Text("comment", file, last - len(block) + 1, " ".join(block))


def messages(path: Path, file: str) -> Iterator[Text]:
    """Yield the strings of a file with more than one word, except docstrings."""
    lines = {each.line for each in docstrings(path, file)}
    for node in nodes_of(path):
        if isinstance(node, ast.Constant) and isinstance(node.value, str) and node.lineno not in lines:
            text = node.value
            if " " in text.strip() and "\n" not in text.strip() and re.search(r"[a-z]{2} [a-z]{2}", text):
                yield Text("message", file, node.lineno, text)


def passages(path: Path, file: str) -> Iterator[Text]:
    """Yield the paragraphs of a page, except code blocks."""
    text = _FENCE.sub(lambda match: "\n" * match[0].count("\n"), text_of(path))
    line = 1
    for paragraph in text.split("\n\n"):
        if paragraph.strip():
            yield Text("passage", file, line, paragraph.strip("\n"))
        line += paragraph.count("\n") + 2


def texts(root: Path = ROOT, *, quick: bool = False) -> Iterator[Text]:
    """Yield every text of a project.

    If `quick`, leave out the comments and messages of files that have no banned word.
    """
    for folder in FOLDERS:
        for path in sorted((root / folder).rglob("*.py")):
            file = path.relative_to(root).as_posix()
            yield from docstrings(path, file)
            lower = text_of(path).lower()
            if not quick or any(PATTERN.search(line) for line in re.findall("#.*", lower)):
                yield from comments(path, file)
            if folder == "motionlang" and (not quick or PATTERN.search(lower)):
                yield from messages(path, file)
    for path in [root / "README.md", root / "CONTRIBUTING.md", *sorted((root / "docs").rglob("*.md"))]:
        file = path.relative_to(root).as_posix()
        if path.exists() and not file.startswith(DERIVED):
            yield from passages(path, file)


@cache
def public_names(root: Path = ROOT) -> tuple[tuple[str, str], ...]:
    """Return the public names of the package with their files."""
    return tuple(each for each in names(root) if not each[0].startswith("_"))


def names(root: Path = ROOT) -> Iterator[tuple[str, str]]:
    """Yield the names of the package with their files, except `TYPE_CHECKING`."""
    for path in sorted((root / "motionlang").rglob("*.py")):
        file = path.relative_to(root).as_posix()
        yield path.stem, file
        for node in tree_of(path).body:
            if isinstance(node, ast.FunctionDef | ast.ClassDef):
                yield node.name, file
                yield from ((each.name, file) for each in ast.walk(node) if isinstance(each, ast.FunctionDef))
            elif isinstance(node, ast.Assign):
                targets = [each.id for each in node.targets if isinstance(each, ast.Name)]
                yield from ((each, file) for each in targets if each != "TYPE_CHECKING")


class Counts(NamedTuple):
    """Banned words of one tree by package and kind, and docstrings that break a rule."""

    banned: Counter[tuple[str, str]]
    docstrings: int
    first_words: int
    long: int


def counted(root: Path) -> Counts:
    """Count the banned words in the texts of a tree."""
    banned: Counter[tuple[str, str]] = Counter()
    number = first_words = long = 0
    for each in texts(root, quick=True):
        banned[each.package, each.kind] += len(each.found())
        if each.kind == "docstring":
            first = each.text.partition("\n")[0]
            number += 1
            first_words += FIRST_WORDS.match(first) is not None
            long += len(first) > MAX_FIRST_LINE
    return Counts(banned, number, first_words, long)


def table(now: Counts, then: Counts | None) -> Iterator[str]:
    """Yield the lines of the table; two trees are shown as `then -> now`."""

    def pair(old: int, new: int) -> str:
        return f"{new}" if then is None else f"{old} -> {new}"

    before = then or now
    kinds = ("docstring", "comment", "message", "passage")
    yield f"{'banned words':<28}" + "".join(f"{kind:>16}" for kind in kinds)
    packages = sorted({package for package, _ in (*now.banned, *before.banned)})
    for package in packages:
        cells = [pair(before.banned[package, kind], now.banned[package, kind]) for kind in kinds]
        yield f"{package:<28}" + "".join(f"{cell:>16}" for cell in cells)
    sums = [
        pair(
            sum(before.banned[each, kind] for each in packages),
            sum(now.banned[each, kind] for each in packages),
        )
        for kind in kinds
    ]
    yield f"{'sum':<28}" + "".join(f"{cell:>16}" for cell in sums)
    yield ""
    yield f"docstrings: {pair(before.docstrings, now.docstrings)}"
    yield f"beginning with a forbidden word: {pair(before.first_words, now.first_words)}"
    yield f"first line over {MAX_FIRST_LINE} characters: {pair(before.long, now.long)}"


def drawn(date: str) -> Iterator[str]:
    """Yield the lines of a random sample, with the date as its seed."""
    random = Random(date)
    every = list(texts())
    for kind, count in (("docstring", 30), ("message", 20), ("passage", 10)):
        some = [each for each in every if each.kind == kind]
        yield f"{count} of {len(some)} {kind}s"
        for each in random.sample(some, count):
            yield f"{each.file}:{each.line}\n    " + each.text.strip().replace("\n", "\n    ")
        yield ""
    public = public_names()
    yield f"30 of {len(public)} names"
    yield from (f"{name}  ({file})" for name, file in random.sample(public, 30))


def main(arguments: Iterable[str]) -> int:
    """Print the counts, compared with a commit if one is given, or a sample."""
    parser = argparse.ArgumentParser(prog="python -m tests.wording")
    parser.add_argument("commit", nargs="?", help="compare with this commit")
    parser.add_argument("--draw", metavar="DATE", help="print a sample with this seed instead")
    given = parser.parse_args(list(arguments))
    if given.draw:
        print(*drawn(given.draw), sep="\n")
        return 0
    with tempfile.TemporaryDirectory() as folder:
        then = counted(unpacked(given.commit, Path(folder))) if given.commit else None
        print(*table(counted(ROOT), then), sep="\n")
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))

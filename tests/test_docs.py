"""The documents match the program: their code blocks are run.

` ```console ` blocks hold `$ motionlang …` and `$ python -m tests.lab.notes.scripts.…` lines, each followed by its
exact output; `…` alone on a line stands for omitted lines. `$ cat FILE` shows a file, and creates one that does not
exist. `< FILE` is standard input. `--update` writes what differs. ` ```mint ` and ` ```mccl ` blocks are programs
that run without a diagnostic, ` ```toml ` blocks are machine files, ` ```python ` blocks are executed.
` ```editor ` blocks show a program in an editor, which `test_documented_session.py` of `extras/lsp` compares. Blocks of
other kinds, such as `sh` for set-up, are not run.
"""

from __future__ import annotations

import io
import os
import re
import shlex
import shutil
from collections.abc import Iterator
from contextlib import suppress
from pathlib import Path

import pytest
from _pytest.mark import ParameterSet

from motionlang.cli import commands, main
from motionlang.kernel import Source, read_machine, run
from tests.cli.programs import parser_of
from tests.extras import INSTALLED, MISSING
from tests.lab.notes.examples import printed

ROOT = Path(__file__).parent.parent
# The examples of the keyword pages are those of the tables, which have their own tests.
PAGES = [
    ROOT / "README.md",
    *sorted((ROOT / "docs").glob("*.md")),
    *sorted((ROOT / "docs" / "commands").glob("*.md")),
    *sorted((ROOT / "docs" / "contributing").glob("*.md")),
    *(page for each in INSTALLED for page in sorted(each.glob("docs/**/*.md"))),
]
# The pages whose text names commands in passing.
NAMING = [*PAGES, ROOT / "CONTRIBUTING.md", *sorted((ROOT / "docs" / "keywords").rglob("*.md"))]
_INLINE = re.compile(r"`motionlang ([a-z][^`]*)`")
_IMAGE = re.compile(r"(--plot|motionlang plot \S+) \S+\.(png|svg)")
_BLOCK = re.compile(r"^```(\w+)\n(.*?)^```$", re.MULTILINE | re.DOTALL)

# A search makes hundreds of runs, and so does a sweep that finds the least of a quantity.
SEARCHES = (
    "motionlang improve",
    "motionlang init old/packer.prg",
    "motionlang map",
    "--explore",
    "--suggest",
    "minimise =",
)


def needs_absent(words: list[str]) -> bool:
    """True if a command needs a distribution that is not installed; `diff` needs one for `--explore` alone."""
    return words[0] in MISSING and (words[0] not in commands.COMMANDS or "--explore" in words)


def blocks(*kinds: str) -> list[ParameterSet]:
    found = []
    for page in PAGES:
        text = page.read_text(encoding="utf-8")
        for match in _BLOCK.finditer(text):
            if match[1] in kinds:
                line = text.count("\n", 0, match.start()) + 1
                marks = [pytest.mark.slow] if any(each in match[2] for each in SEARCHES) else []
                lines = re.findall(r"^\$ motionlang (.+)", match[2], re.MULTILINE)
                if any(needs_absent(line.split()) for line in lines):
                    marks.append(pytest.mark.skip(reason="it needs a distribution that is not installed"))
                name = f"{page.relative_to(ROOT)}:{line}"
                found.append(pytest.param(match[1], match[2], id=name, marks=marks))
    return found


def commands_of(block: str) -> Iterator[tuple[str, str]]:
    """Yield each command of a console block with the output shown below it."""
    chunks = re.split(r"^\$ ", block, flags=re.MULTILINE)
    for chunk in filter(None, chunks):
        command, _, output = chunk.partition("\n")
        yield command, output


def matches(shown: str, output: str) -> bool:
    """True if `output` equals the shown text, where a line `…` matches any lines."""
    pattern = re.escape(shown.rstrip("\n") + "\n").replace(re.escape("\n…\n"), r"\n(?:.*\n)*")
    return re.fullmatch(pattern, output.rstrip("\n") + "\n") is not None


@pytest.fixture
def at_root(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> None:
    """Run commands in the checkout with the gallery; output goes to a scratch folder."""
    monkeypatch.chdir(tmp_path)
    for name in ("scripts", "docs", "examples", "extras"):
        os.symlink(ROOT / name, tmp_path / name)
    shutil.copytree(ROOT / "examples" / "old", tmp_path / "old")
    monkeypatch.setenv("COLUMNS", "100")
    monkeypatch.setattr(commands, "build_parser", parser_of)


@pytest.mark.usefixtures("at_root")
@pytest.mark.parametrize(("kind", "text"), blocks("console"))
def test_console(
    kind: str,
    text: str,
    capsys: pytest.CaptureFixture[str],
    monkeypatch: pytest.MonkeyPatch,
    request: pytest.FixtureRequest,
) -> None:
    if _IMAGE.search(text):
        request.getfixturevalue("unrendered")
    now = ""
    for command, shown in commands_of(text):
        words = shlex.split(command, comments=True)
        if words[0] == "cat" and not Path(words[1]).exists():
            Path(words[1]).parent.mkdir(exist_ok=True)
            Path(words[1]).write_text(shown, encoding="utf-8")
        if "<" in words:
            *words, _, given = words
            monkeypatch.setattr("sys.stdin", io.StringIO(Path(given).read_text(encoding="utf-8")))
        output, errors = answer(words, capsys)
        # On a terminal, messages may come before or after the printed output.
        found = matches(shown, output + errors) or matches(shown, errors + output)
        assert found or request.config.getoption("--update"), f"$ {command}\n{output}{errors}"
        now += f"$ {command}\n" + (shown if found else output + errors)
    if now != text:
        for page in PAGES:
            page.write_text(
                page.read_text(encoding="utf-8").replace(text, now), encoding="utf-8", newline="\n"
            )


def answer(words: list[str], capsys: pytest.CaptureFixture[str]) -> tuple[str, str]:
    """Return output and errors of one command of a console block.

    The commands other than `motionlang` are `cat`, `cp`, `sed s/OLD/NEW/ FILE > OTHER`, and `python` for a script of
    `tests/lab/notes/scripts`.
    """
    if words[0] == "python":
        return printed(words[2].rpartition(".")[2], *words[3:]), ""
    if words[0] == "cp":
        shutil.copy(words[1], words[2])
        return "", ""
    if words[0] == "sed":
        _, before, after, _ = words[1].split("/")
        text = Path(words[2]).read_text(encoding="utf-8")
        Path(words[4]).write_text(text.replace(before, after, 1), encoding="utf-8")
        return "", ""
    if words[0] == "cat":
        return Path(words[1]).read_text(encoding="utf-8"), ""
    assert words[0] == "motionlang", words
    try:
        main(words[1:])
    except SystemExit:
        pass  # argparse ends --help and errors that way
    captured = capsys.readouterr()
    return captured.out, captured.err


@pytest.mark.parametrize("page", NAMING, ids=lambda page: str(page.relative_to(ROOT)))
def test_commands_in_the_text_exist_with_their_options(
    page: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    """No command is run; one without arguments only mentions its name."""
    text = _BLOCK.sub("", page.read_text(encoding="utf-8"))
    for command in {" ".join(each.split()) for each in _INLINE.findall(text)}:
        words = shlex.split(re.split(r" [<>|] ", command.replace("\\|", "|"))[0])
        if needs_absent(words) or any(
            re.fullmatch(r"COMMAND|SHELL|NAME|HOST:PORT", word) for word in words[:3]
        ):
            continue
        with suppress(SystemExit):
            parser_of(words[0]).parse_args(words)
        error = capsys.readouterr().err
        assert not error or "are required" in error or "expected one argument" in error, error


@pytest.mark.parametrize(("kind", "text"), blocks("mint", "mccl"))
def test_programs(kind: str, text: str) -> None:
    result = run(Source("block", text), dialect=kind)
    assert result.diagnostics == []


@pytest.mark.parametrize(("kind", "text"), blocks("toml"))
def test_machine_files(kind: str, text: str) -> None:
    assert read_machine(Source("block", text))


@pytest.mark.usefixtures("at_root")
@pytest.mark.parametrize(("kind", "text"), blocks("python"))
def test_python(kind: str, text: str) -> None:
    exec(compile(text, "block", "exec"), {})

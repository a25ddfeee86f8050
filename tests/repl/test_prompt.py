"""The prompt as a person uses it: keys are sent, the screen is not checked."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import AbstractContextManager, nullcontext
from pathlib import Path
from types import SimpleNamespace
from typing import Any

import pytest
from prompt_toolkit.application import create_app_session
from prompt_toolkit.completion import CompleteEvent
from prompt_toolkit.document import Document
from prompt_toolkit.input import PipeInput, create_pipe_input
from prompt_toolkit.output import ColorDepth, DummyOutput

from motionlang.kernel import dialect, dialects
from motionlang.repl import prompt
from motionlang.repl.complete import WordCompleter, candidates
from motionlang.repl.live import Live
from motionlang.repl.prompt import WordLexer, _asker, banner, converse, styled
from motionlang.repl.session import Session

CTRL_C, CTRL_D, ENTER = "\x03", "\x04", "\r"


@pytest.fixture(autouse=True)
def _no_history(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("MOTIONLANG_HISTORY", "")


@pytest.fixture
def keys() -> Iterator[PipeInput]:
    with create_pipe_input() as keys, create_app_session(input=keys, output=DummyOutput()):
        yield keys


@pytest.mark.parametrize("language", dialects())
def test_the_banner_fits_in_80_columns(language: str) -> None:
    assert len(banner(Session(dialect(language)))) <= 80


def test_lines_are_executed_until_ctrl_d(keys: PipeInput) -> None:
    shown: list[str] = []
    session = Session(dialect("mccl"), show=shown.append)
    keys.send_text(f"1DH42{ENTER}1TP{ENTER}{CTRL_D}")
    assert converse(session) == 0
    assert shown == ["01 42\n"]


def test_quit_leaves_too(keys: PipeInput) -> None:
    session = Session(dialect("mccl"))
    keys.send_text(f".quit{ENTER}")
    assert converse(session) == 0
    assert session.over


def test_the_prompt_switches_its_language(keys: PipeInput) -> None:
    shown: list[str] = []
    session = Session(dialect("mint"), show=shown.append)
    keys.send_text(f"PRINT 1{ENTER}.mccl{ENTER}1TP{ENTER}{CTRL_D}")
    assert converse(session) == 0
    assert shown == ["1\n", "-- MCCL, on a new machine at 0 s\n", "01 0\n"]


def test_ctrl_c_at_the_prompt_drops_the_line_only(keys: PipeInput) -> None:
    shown: list[str] = []
    session = Session(dialect("mccl"), show=shown.append)
    keys.send_text(f"1DH42{CTRL_C}1TP{ENTER}{CTRL_D}")
    converse(session)
    assert shown == ["01 0\n"]


def test_live_mode_is_a_matter_of_the_terminal(keys: PipeInput) -> None:
    session = Session(dialect("mccl"))
    keys.send_text(f".live on{ENTER}.live off{ENTER}{CTRL_D}")
    converse(session)
    assert not session.failed
    assert session.live is False
    assert session.machine.controller.clock.now < 1.0


def test_completion_offers_keywords_with_their_help() -> None:
    mccl = dialect("mccl")
    assert [word for word, _, _ in candidates(mccl, "1MN,2W")][:3] == ["WA", "WB", "WD"]
    row = mccl.table().get("MR")
    assert row is not None
    assert candidates(mccl, "1MR") == [("MR", 2, row.help)]
    assert candidates(mccl, "1mr") == [("mr", 2, row.help)]
    assert candidates(mccl, "") == candidates(mccl, "1MN; go") == []


def test_completion_knows_the_prompts_own_commands() -> None:
    assert [word for word, _, _ in candidates(dialect("mccl"), ".r")] == ["reset", "run", "report", "reverse"]


@pytest.mark.parametrize("text", ["", "1MR100, 9XX MD1 @5\n;x", ".run 3", "\0\x1b\n\n", "é" * 300, '"'])
def test_highlighting_leaves_nothing_out(text: str) -> None:
    assert "".join(piece[1] for piece in styled(dialect("mccl"), text)) == text


def test_each_line_of_a_block_is_highlighted() -> None:
    lines = WordLexer(dialect("mint")).lex_document(Document("Loop\n  SPEED(0) = 5 ' up\nEnd Loop"))
    assert [[(style, text) for style, text, *_ in lines(number) if text.strip()] for number in range(4)] == [
        [("class:control", "Loop")],
        [
            ("class:keyword", "SPEED"), ("", "("), ("class:number", "0"), ("", ")"), ("", "="),
            ("class:number", "5"), ("class:comment", "' up"),
        ],
        [("class:control", "End"), ("class:control", "Loop")],
        [],
    ]  # fmt: skip
    assert styled(dialect("mint"), ".run 5") == [("class:dotted", ".run 5")]


def test_a_completion_replaces_what_was_typed() -> None:
    completer = WordCompleter(dialect("mccl"))
    (found,) = completer.get_completions(Document("1MN,1mr"), CompleteEvent())
    assert (found.text, found.start_position) == ("mr", -2)
    (command,) = completer.get_completions(Document(".loa"), CompleteEvent())
    assert (command.text, command.start_position) == ("load", -3)


def test_enter_executes_a_complete_text_and_extends_a_block(keys: PipeInput) -> None:
    """Escape and Enter begin a new line in any text."""
    shown: list[str] = []
    session = Session(dialect("mint"), show=shown.append)
    block = f"For i = 1 To 2{ENTER}  PRINT 2{ENTER}NEXT{ENTER}"
    keys.send_text(f"{block}PRINT 3\x1b{ENTER}PRINT 4{ENTER}{CTRL_D}")
    assert converse(session) == 0
    assert "".join(shown) == "2\n2\n3\n4\n"


@pytest.mark.parametrize(("value", "depth"), [("", None), ("1", ColorDepth.DEPTH_1_BIT)])
def test_no_color_has_no_colours(
    value: str, depth: ColorDepth | None, keys: PipeInput, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setenv("NO_COLOR", value)
    session = Session(dialect("mint"))
    asker: Any = _asker(session, Live(session))
    assert asker.color_depth == depth
    assert asker.prompt_continuation == [("class:prompt", "....> ")]


def test_the_bar_is_refreshed_in_live_mode_only(monkeypatch: pytest.MonkeyPatch) -> None:
    """Output is written as it is, with its colours."""
    lines, refreshed, raw = iter([".live on", ".live off", ".quit"]), [], []

    def ask(refresh_interval: float) -> str:
        refreshed.append(refresh_interval)
        return next(lines)

    def patched(**given: bool) -> AbstractContextManager[None]:
        raw.append(given)
        return nullcontext()

    monkeypatch.setattr(prompt, "_asker", lambda session, live: SimpleNamespace(prompt=ask))
    monkeypatch.setattr(prompt, "patch_stdout", patched)
    assert converse(Session(dialect("mint"))) == 0
    assert refreshed == [0, 0.1, 0]
    assert raw == [{"raw": True}] * 3


def test_completion_of_files_belongs_to_load(tmp_path: Path) -> None:
    (tmp_path / "pick.mcl").touch()
    completer = WordCompleter(dialect("mccl"))
    for typed, found in ((f".load {tmp_path}/pi", ["ck.mcl"]), (f".help {tmp_path}/pi", [])):
        assert [each.text for each in completer.get_completions(Document(typed), CompleteEvent())] == found


@pytest.mark.parametrize("is_live", [True, False])
def test_the_bar_below_the_prompt_shows_if_machine_time_follows_real_time(
    keys: PipeInput, is_live: bool
) -> None:
    session = Session(dialect("mint"))
    bar: Any = _asker(session, Live(session)).bottom_toolbar
    session.live = is_live
    ((_, text),) = bar()
    assert text.endswith("   live") == is_live

"""`runner.py`: the page gets the same output of a run as the command line."""

from __future__ import annotations

import contextlib
import importlib.util
import io
import signal
import sys
from collections.abc import Callable, Sequence
from pathlib import Path
from typing import Any

import pytest

from motionlang.cli import main
from tests.built import ROOT
from tests.cases import one_in

Message = dict[str, Any]
GALLERY = sorted(path for path in (ROOT / "scripts").glob("*/*") if path.suffix in (".mnt", ".mcl"))


def module(name: str) -> Any:
    spec = importlib.util.spec_from_file_location(f"playground_{name}", ROOT / "playground" / f"{name}.py")
    assert spec is not None
    assert spec.loader is not None
    made = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(made)
    return made


runner = module("runner")


def messages(
    program: str,
    *answers: str,
    machine: str = "",
    name: str = "program.mnt",
    inputs: Sequence[int] = (),
    alarm: Callable[[bool], object] = bool,
) -> list[Message]:
    found: list[Message] = []
    dialect = "mccl" if name.endswith(".mcl") else "mint"
    request = {
        "name": name,
        "dialect": dialect,
        "program": program,
        "machine": machine,
        "answers": list(answers),
        "inputs": list(inputs),
    }
    runner.start(request, found.append, alarm)
    return found


def printed(found: list[Message]) -> str:
    return "".join(each["text"] for each in found if each["type"] == "output")


def of_type(found: list[Message], kind: str) -> Message:
    (message,) = (each for each in found if each["type"] == kind)
    return message


def command(*arguments: str) -> str:
    """Return the output of a command into a pipe."""
    out = io.BytesIO()
    text = io.TextIOWrapper(out, encoding="utf-8", newline="", write_through=True)
    with contextlib.redirect_stdout(text):
        main(arguments)
    return out.getvalue().decode()


@pytest.mark.parametrize("path", one_in(14, GALLERY), ids=lambda path: path.name)
def test_output_and_table_are_those_of_the_command_line(path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    machine_file = path.with_suffix(".machine.toml")
    machine = machine_file.read_text(encoding="utf-8") if machine_file.exists() else ""
    found = messages(path.read_text(encoding="utf-8"), machine=machine, name=path.name)
    monkeypatch.setattr(sys, "stdin", io.StringIO(""))
    outputs = [printed(found), of_type(found, "result")["table"]]
    assert "\n".join(filter(None, outputs)) == command("run", str(path))


def test_input_asks_until_it_has_every_answer() -> None:
    program = 'Dim a, b\nINPUT "first "; a\nINPUT "second "; b\nPRINT a * b\n'
    assert messages(program)[-1] == {"type": "asks", "question": "first "}
    assert messages(program, "6")[-1] == {"type": "asks", "question": "second "}
    found = messages(program, "6", "7")
    assert of_type(found, "result")["status"] == "ended"
    assert printed(found).splitlines()[-1].split() == ["42.0000"]


def test_mistakes_are_marked_in_the_file_that_has_them() -> None:
    (mark,) = of_type(messages("PRINT 1\nSPED(0) = 5\n"), "result")["marks"]
    assert [mark[each] for each in ("tab", "line", "column", "length")] == ["program", 2, 1, 4]
    assert mark["hint"] == "did you mean SPEED?"
    (mark,) = of_type(messages("PRINT 1\n", machine="[axis.0]\nscal = 5\n"), "result")["marks"]
    assert [mark["tab"], mark["line"]] == ["machine", 2]


def test_the_hint_on_the_other_language_is_the_list_of_the_page() -> None:
    (mark,) = of_type(messages("1MN,1SV1000\n1MR100,1WS\n"), "result")["marks"]
    assert (mark["code"], mark["hint"]) == ("language", "choose MCCL above")
    result = of_type(messages("SPEED(0) = 5\nMOVER(0) = 3\nGO(0)\n", name="a.mcl"), "result")
    assert result["diagnostics"].endswith("hint: choose Mint above\n")


@pytest.mark.parametrize(
    ("program", "machine", "hint"),
    [
        ("PAUSE INX(2)\n", "", "switch input 2 on, or add [[input]] to the machine file"),
        (
            "PAUSE IN = 5\n",
            "",
            "switch inputs 0, 2 on, or add [[input]] to the machine file",
        ),
        ("PAUSE INX(2) = 0\n", "input = [{ channel = 2, at = 0.0 }]\n", "add [[input]] to the machine file"),
        ("PAUSE ADC(2) > 5\n", "", "add [[analogue]] to the machine file"),
    ],
)
def test_a_wait_names_the_switches_of_the_page(program: str, machine: str, hint: str) -> None:
    (mark,) = of_type(messages(program, machine=machine), "result")["marks"]
    assert (mark["code"], mark["hint"]) == ("never", hint)


def test_the_inputs_that_a_program_reads_have_switches() -> None:
    program = "PAUSE INX(2)\nIF INX(5) = 0 THEN PRINT 7\n"
    result = of_type(messages(program, inputs=[2]), "result")
    assert (result["status"], result["inputs"]) == ("ended", [2, 5])
    assert printed(messages(program, inputs=[2, 5])) == ""
    assert of_type(messages("PAUSE INX(\n"), "result")["inputs"] == []


def test_a_loop_without_end_shows_what_it_has_done_and_where_it_is() -> None:
    program = "Dim n\nPRINT 7\nLoop\nn = n + 1\nIf n > 1000 Then n = 0\nEnd Loop\n"

    def alarm(on: bool) -> None:
        signal.setitimer(signal.ITIMER_REAL, 0.2 if on else 0.0)

    before = signal.signal(signal.SIGALRM, lambda *_: signal.raise_signal(signal.SIGINT))
    try:
        found = messages(program, alarm=alarm)
    finally:
        signal.signal(signal.SIGALRM, before)
    result = of_type(found, "result")
    assert (result["status"], printed(found)) == ("interrupted", "7\n")
    (mark,) = result["marks"]
    assert mark["line"] in (3, 4, 5)
    assert mark["message"] == "the run was ended after 20 s of processor time"
    assert mark["hint"] == "run.until in the machine file ends it at a machine time"


def test_the_scope_page_and_the_lines_follow_the_table() -> None:
    # 100 uu at 50 uu/s with 500 uu/s2: 100/50 + 50/500 = 2.1 s, all of them at the line of the move.
    program = "SPEED(0) = 50\nACCEL(0) = 500\nDECEL(0) = 500\nMOVER(0) = 100\nGO(0)\nPAUSE IDLE(0)\n"
    found = messages(program)
    assert [each["type"] for each in found] == ["result", "details"]
    details = of_type(found, "details")
    assert details["scope"].startswith("<!DOCTYPE html>")
    first = details["lines"][0]
    assert (first["line"], first["text"]) == (4, "MOVER(0) = 100")
    assert first["seconds"] == pytest.approx(2.1)


def test_an_event_has_its_line() -> None:
    program = "SPEED(0) = 50\nMOVER(0) = 100\nGO(0)\nPAUSE IDLE(0)\n"
    result = of_type(messages(program, machine="[axis.0]\ntravel = [-10.0, 20.0]\n"), "result")
    assert [each["line"] for each in result["events"]][:1] == [4]
    assert result["event_count"] == len(result["events"])
    assert result["complaints"]


def test_a_long_output_is_cut(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(runner, "MAX_OUTPUT", 10)
    found = messages("Dim n\nFor n = 1 To 5\nPRINT 1234\nNext\n")
    assert len(printed(found)) == 10
    assert of_type(found, "result")["dropped"] == 5 * len("1234\n") - 10


def test_without_numpy_a_motor_is_refused(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(
        runner, "run", lambda *_, **__: (_ for _ in ()).throw(ImportError("none", name="numpy"))
    )
    result = of_type(messages("PRINT 1\n"), "result")
    assert "this run needs numpy" in result["diagnostics"]
    assert "install motionlang" in result["diagnostics"]

"""Requests of the debug adapter."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import pytest

from tests.ide.dap.client import Client
from tests.ide.debug.test_debugger import CALLS, MOVE

PROGRAM = """\
Dim a(3) As Integer, n As Integer
SPEED(0) = 50 : MOVEA(0) = 100 : GO(0)
OUTX(2) = 1
a(2) = 7
n = n + 1
PAUSE IDLE(0)
Print n
"""


@pytest.fixture
def stopped(client: Client, tmp_path: Path) -> tuple[Client, dict[str, Any]]:
    """A session at line 5 of the program, with an input that is on, and its stop."""
    path = tmp_path / "a.mnt"
    path.write_text(PROGRAM)
    client.launch(path, input=["5=1"], analog=["0=25"])
    client.ask("setBreakpoints", source={"path": str(path)}, breakpoints=[{"line": 5}])
    return client, client.begin()


# -------------------------------------------------------------------------------------------------- variables


def reference(client: Client, stop: dict[str, Any], scope: str) -> int:
    frame = client.ask("stackTrace", threadId=stop["body"]["threadId"])["stackFrames"][0]["id"]
    scopes = client.ask("scopes", frameId=frame)["scopes"]
    (found,) = [int(each["variablesReference"]) for each in scopes if each["name"] == scope]
    return found


def test_elements_and_their_sections(stopped: tuple[Client, dict[str, Any]]) -> None:
    """`start` and `count` select elements; an element is set by its name."""
    client, stop = stopped
    (array,) = [
        each
        for each in client.ask("variables", variablesReference=reference(client, stop, "Variables"))[
            "variables"
        ]
        if each["name"] == "a"
    ]
    assert (array["evaluateName"], array["type"]) == ("a", "Integer")
    number = array["variablesReference"]
    for how, wanted in (
        ({}, ["0", "7", "0"]),
        ({"start": 1}, ["7", "0"]),
        ({"start": 1, "count": 1}, ["7"]),
        ({"start": -1, "count": 2}, ["0", "7"]),
        ({"count": 0}, ["0", "7", "0"]),
    ):
        found = client.ask("variables", variablesReference=number, **how)["variables"]
        assert [each["value"] for each in found] == wanted
    assert client.ask("setVariable", variablesReference=number, name="a(3)", value="n + 4")["value"] == "4"
    found = client.ask("variables", variablesReference=number)["variables"]
    assert [each["value"] for each in found] == ["0", "7", "4"]


@pytest.mark.parametrize(
    ("scope", "name", "value", "message"),
    [
        ("Axes", "axis 0", "1", "only variables and inputs can be changed"),
        ("Outputs", "output 2", "0", "only variables and inputs can be changed"),
        ("Variables", "b", "1", "there is no variable b here"),
        ("Inputs", "axis 5", "1", "axis 5 is no input"),
        ("Inputs", "input x", "1", "input x is no input"),
        ("Variables", "a", "1", "a cannot be set; set one of its elements"),
    ],
)
def test_what_cannot_be_set(
    stopped: tuple[Client, dict[str, Any]], scope: str, name: str, value: str, message: str
) -> None:
    client, stop = stopped
    number = reference(client, stop, scope)
    assert message in client.refused("setVariable", variablesReference=number, name=name, value=value)


def test_an_input_is_set_at_a_stop(stopped: tuple[Client, dict[str, Any]]) -> None:
    client, stop = stopped
    number = reference(client, stop, "Inputs")
    for name, value in (("input 5", " 0 "), ("analogue input 0", "50")):
        answer = client.ask("setVariable", variablesReference=number, name=name, value=value)
        assert answer == {"value": value.strip(), "variablesReference": 0}
    client.go("next")
    assert client.ask("evaluate", expression="input(5)")["result"] == "0"


@pytest.mark.parametrize(
    ("name", "data"),
    [
        ("n", "variable module/n"),
        ("axis 0", "variable machine/axis 0"),
        ("output 2", "variable machine/output 2"),
        ("nothing", None),
    ],
)
def test_what_can_be_watched(stopped: tuple[Client, dict[str, Any]], name: str, data: str | None) -> None:
    client, _ = stopped
    found = client.ask("dataBreakpointInfo", name=name)
    assert found["dataId"] == data
    assert found["description"] == (
        f"{name} changes" if data else f"{name} cannot be watched; use a motion breakpoint"
    )
    assert found.get("accessTypes") == (["write"] if data else None)


@pytest.mark.parametrize(
    ("scope", "name", "data"),
    [
        ("Variables", "n", "variable module/n"),
        ("Axes", "axis 0", "variable machine/axis 0"),
        ("Inputs", "input 5", "input 5"),
        ("Outputs", "output 2", "output 2"),
        ("Inputs", "analogue input 0", None),
    ],
)
def test_what_can_be_watched_in_a_scope(
    stopped: tuple[Client, dict[str, Any]], scope: str, name: str, data: str | None
) -> None:
    client, stop = stopped
    number = reference(client, stop, scope)
    assert client.ask("dataBreakpointInfo", variablesReference=number, name=name)["dataId"] == data


def test_watches_that_are_none(stopped: tuple[Client, dict[str, Any]]) -> None:
    client, _ = stopped
    wanted = ["output 2", "input 5", "variable module/n", "output x", "variable ", "axis 0"]
    found = client.ask("setDataBreakpoints", breakpoints=[{"dataId": each} for each in wanted])["breakpoints"]
    assert [each["verified"] for each in found] == [True, True, True, False, False, False]
    stop = client.go("continue")
    assert stop["body"]["text"].startswith("n changes from 0 to 1")


# ------------------------------------------------------------------------------------- lines, frames, phases


@pytest.mark.parametrize("first", [0, 1])
def test_a_client_that_counts_from_0_or_1(client: Client, tmp_path: Path, first: int) -> None:
    """Statements are in lines 4, 5, 8, 9 and 11, counted from 1."""
    path, shift = tmp_path / "a.mnt", first - 1
    path.write_text(CALLS)
    client.ask("initialize", adapterID="motionlang", linesStartAt1=bool(first), columnsStartAt1=bool(first))
    client.ask("launch", program=str(path))
    source = {"path": str(path)}
    lines = client.ask("breakpointLocations", source=source, line=4 + shift, endLine=9 + shift)["breakpoints"]
    assert [each["line"] - shift for each in lines] == [4, 5, 8, 9]
    lines = client.ask("breakpointLocations", source=source, line=5 + shift)["breakpoints"]
    assert [each["line"] - shift for each in lines] == [5]
    lines = client.ask("breakpointLocations", source=source, line=8 + shift)["breakpoints"]
    assert [each["line"] - shift for each in lines] == [8]
    points = client.ask(
        "setBreakpoints",
        source=source,
        breakpoints=[{"line": 2 + shift}, {"line": 12 + shift}, {"line": 9 + shift, "condition": "1 +"}],
    )["breakpoints"]
    assert [each["verified"] for each in points] == [True, False, False]
    assert points[0]["line"] == 4 + shift
    assert "message" not in points[0]
    stop = client.begin()
    (frame, caller) = client.ask("stackTrace", threadId=stop["body"]["threadId"])["stackFrames"]
    assert (frame["line"], frame["column"]) == (4 + shift, 3 + shift)
    assert (frame["endLine"], frame["endColumn"]) == (4 + shift, 8 + shift)
    assert caller["line"] == 9 + shift
    target = client.ask("gotoTargets", source=source, line=10 + shift)["targets"][0]
    assert (target["line"], target["label"]) == (11 + shift, "the next time that line 11 begins")


def test_breakpoints_of_another_file(client: Client, tmp_path: Path) -> None:
    path = tmp_path / "a.mnt"
    path.write_text(CALLS)
    client.launch(path)
    for source in ({"path": str(tmp_path / "b.mnt")}, {}, {"path": ""}):
        (point,) = client.ask("setBreakpoints", source=source, breakpoints=[{"line": 5}])["breakpoints"]
        assert (point["verified"], point["message"]) == (
            False, "this file is not the program that is debugged",
        )  # fmt: skip
        assert client.ask("breakpointLocations", source=source, line=5)["breakpoints"] == []


def test_some_frames_of_a_stack(client: Client, tmp_path: Path) -> None:
    path = tmp_path / "a.mnt"
    path.write_text(CALLS)
    client.launch(path)
    client.ask("setBreakpoints", source={"path": str(path)}, breakpoints=[{"line": 4}])
    thread = client.begin()["body"]["threadId"]
    for how, names in (
        ({}, ["Add", "main"]),
        ({"startFrame": 1}, ["main"]),
        ({"startFrame": 1, "levels": 1}, ["main"]),
        ({"levels": 1}, ["Add"]),
        ({"startFrame": -3, "levels": 1}, ["Add"]),
        ({"startFrame": 2, "levels": 5}, []),
    ):
        found = client.ask("stackTrace", threadId=thread, **how)
        assert ([each["name"] for each in found["stackFrames"]], found["totalFrames"]) == (names, 2)
    assert "there is no thread 99" in client.refused("stackTrace", threadId=99)
    assert "there is no frame 999 at this stop" in client.refused("scopes", frameId=999)
    assert "there is no frame 0 at this stop" in client.refused("scopes", frameId=0)


@pytest.mark.parametrize(
    ("line", "message"),
    [
        (".input", "there is no command .input with these values"),
        (".changed", "there is no command .changed with these values"),
        (".quit", "there is no command .quit with these values; .help lists the commands"),
        (".goto", "is no time, such as 2.5"),
        (".changed nothing", "there is no variable nothing here"),
    ],
)
def test_a_command_of_the_console_that_is_none(
    stopped: tuple[Client, dict[str, Any]], line: str, message: str
) -> None:
    client, _ = stopped
    assert message in client.refused("evaluate", expression=line, context="repl")


def test_a_line_of_the_console_changes_a_variable_or_compares(stopped: tuple[Client, dict[str, Any]]) -> None:
    client, _ = stopped

    def typed(line: str, context: str = "repl") -> str:
        return str(client.ask("evaluate", expression=line, context=context)["result"])

    lines = ("n = 2 * 3", "n", "n == 6", "a(2) = n + 1", "a(2)")
    assert [typed(line) for line in lines] == ["6", "6", "1", "7", "7"]
    assert typed("n = 7", "watch") == "0"
    for line, message in (
        ("bags = 100", "there is no variable bags here"),
        ("a(9) = 1", "there is no a(9)"),
        ("a = 1", "a cannot be set; set one of its elements"),
        ("n = ", "' ' is not an expression such as position(0) > 120"),
        ("n = n +", "'n +' is not an expression such as position(0) > 120"),
        ("position(0) = 3", "there is no variable position(0) here"),
    ):
        assert client.refused("evaluate", expression=line, context="repl") == message
    assert typed("n") == "6"


def test_commands_of_the_console(stopped: tuple[Client, dict[str, Any]]) -> None:
    client, _ = stopped
    assert ".goto" in client.ask("evaluate", expression=".help", context="repl")["result"]
    none = {"result": "", "variablesReference": 0}
    assert client.ask("evaluate", expression=".input 6=1", context="repl") == none
    client.go("next")
    assert client.ask("evaluate", expression="input(6)")["result"] == "1"
    client.ask("evaluate", expression=".changed a", context="repl")
    assert client.frames(client.wait("stopped"))[0] == ("main", 4)
    client.ask("evaluate", expression=".changed input 9", context="repl")
    assert client.wait("stopped")["body"]["text"] == "nothing has changed input 9 yet"


def test_an_internal_error_in_a_command_ends_the_session_with_its_text(
    client: Client, tmp_path: Path
) -> None:
    path = tmp_path / "a.mnt"
    path.write_text(MOVE)
    client.launch(path, stopOnEntry=True)
    client.begin()

    def fail() -> None:
        raise KeyError("broken")

    client.adapter._debugger.next = fail  # type: ignore[method-assign]
    client.ask("next")
    output = client.wait("output")
    assert output["body"] == {"category": "stderr", "output": "internal error: KeyError: 'broken'\n"}
    client.wait("terminated")


@pytest.mark.parametrize(
    ("text", "status", "last"),
    [("Print 1\n", 0, "ended after "), ("Print 1\nDim a(2)\na(n + 9) = 1\n", 1, "fault after ")],
)
def test_the_end_of_a_program(client: Client, tmp_path: Path, text: str, status: int, last: str) -> None:
    """The exit status is that of the command line."""
    path = tmp_path / "a.mnt"
    path.write_text("Dim n As Integer\n" + text)
    client.launch(path)
    client.ask("configurationDone")
    texts = []
    while (event := client.wait("output", "exited"))["event"] == "output":
        texts.append(event["body"])
    assert event["body"] == {"exitCode": status}
    assert texts[0] == {"category": "stdout", "output": "1\n"}
    assert (texts[-1]["category"], texts[-1]["output"].startswith(last)) == ("console", True)


def test_requests_in_the_wrong_phase(client: Client, tmp_path: Path) -> None:
    path = tmp_path / "a.mnt"
    path.write_text(MOVE)
    assert client.refused("launch", program=str(path)) == "launch is not possible now: the session is new"
    assert client.refused("fly") == "there is no request 'fly'"
    client.launch(path, stopOnEntry=True)
    assert client.refused("next") == "next is not possible now: the session is configuring"
    client.begin()
    assert client.refused("initialize") == "initialize is not possible now: the session is stopped"


def test_an_error_has_a_number_and_is_shown_for_requests_of_the_user(client: Client) -> None:
    """Braces would be variables of the text."""
    error = client.request("fly{me}")["body"]["error"]
    assert error == {"id": 1, "format": "there is no request 'fly(me)'", "showUser": True}


def test_filters_by_name(client: Client, tmp_path: Path) -> None:
    path = tmp_path / "a.mnt"
    path.write_text(MOVE)
    client.launch(path)
    found = client.ask("setExceptionBreakpoints", filters=["error", "limit", "rain"])["breakpoints"]
    assert [each["verified"] for each in found] == [True, True, False]
    assert found[2]["message"] == "there is no filter 'rain'"


@pytest.mark.parametrize("first", [0, 1])
def test_completions_of_a_client_that_counts_columns_from_0_or_1(
    client: Client, tmp_path: Path, first: int
) -> None:
    path = tmp_path / "a.mnt"
    path.write_text(CALLS)
    client.ask("initialize", adapterID="motionlang", columnsStartAt1=bool(first))
    client.ask("launch", program=str(path), stopOnEntry=True)
    client.begin()
    found = client.ask("completions", text="1 + to", column=6 + first)["targets"]
    assert [(each["label"], each["start"], each["length"]) for each in found] == [("total", 4 + first, 2)]


def test_the_console_is_free_again_after_an_answer(client: Client, tmp_path: Path) -> None:
    """The first line answers INPUT; the next one is an expression."""
    path = tmp_path / "a.mnt"
    path.write_text("Dim n As Integer\nINPUT n\nPrint n\n")
    client.launch(path)
    client.ask("setBreakpoints", source={"path": str(path)}, breakpoints=[{"line": 3}])
    client.ask("configurationDone")
    while "waits for a line" not in client.wait("output")["body"]["output"]:
        pass
    none = {"result": "", "variablesReference": 0}
    assert client.ask("evaluate", expression="21", context="repl") == none
    client.wait("stopped")
    assert client.ask("evaluate", expression="n * 2", context="repl")["result"] == "42"

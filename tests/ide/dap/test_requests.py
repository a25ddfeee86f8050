"""Requests of the debug adapter."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import pytest

from tests.ide.dap.client import Client
from tests.ide.debug.test_debugger import MOVE

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


def reference(client: Client, stop: dict[str, Any], scope: str) -> int:
    frame = client.ask("stackTrace", threadId=stop["body"]["threadId"])["stackFrames"][0]["id"]
    scopes = client.ask("scopes", frameId=frame)["scopes"]
    (found,) = [int(each["variablesReference"]) for each in scopes if each["name"] == scope]
    return found


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

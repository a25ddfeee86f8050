"""A session of the debugger from launch to disconnect, message by message."""

from __future__ import annotations

from pathlib import Path

import pytest

from tests.ide.dap.client import Client
from tests.ide.dap.schema import is_installed
from tests.ide.debug.test_debugger import CALLS, MACROS, MOVE


@pytest.fixture
def program(tmp_path: Path) -> Path:
    path = tmp_path / "calls.mnt"
    path.write_text(CALLS)
    return path


def test_the_protocol_can_be_checked() -> None:
    if not is_installed():
        pytest.skip("debugpy, whose description of the protocol is used, is not installed")


def test_breakpoints_stack_scopes_and_steps_in_both_directions(client: Client, program: Path) -> None:
    client.launch(program)
    (point,) = client.ask("setBreakpoints", source={"path": str(program)}, breakpoints=[{"line": 4}])[
        "breakpoints"
    ]
    assert (point["verified"], point["line"]) == (True, 4)
    stop = client.begin()
    assert stop["body"]["reason"] == "breakpoint"
    assert client.frames(stop) == [("Add", 4), ("main", 9)]
    assert client.scopes(stop)["Local"] == {"n": "1", "twice": "0"}
    assert client.scopes(stop)["Variables"]["total"] == "0"
    stop = client.go("next")
    assert client.scopes(stop)["Local"]["twice"] == "2"
    stop = client.go("stepBack")
    assert (stop["body"]["reason"], client.frames(stop)[0]) == ("step", ("Add", 4))
    assert client.scopes(stop)["Local"]["twice"] == "0"
    assert client.frames(client.go("continue"))[0] == ("Add", 4)
    assert client.scopes(stop)["Variables"]["total"] == "2"
    assert client.frames(client.go("reverseContinue"))[0] == ("Add", 4)
    assert client.scopes(stop)["Variables"]["total"] == "0"


def test_references_of_an_earlier_stop_are_refused_without_a_message_box(
    client: Client, program: Path
) -> None:
    """VS Code requests the scopes of a frame while the next step already runs."""
    client.launch(program, stopOnEntry=True)
    stop = client.begin()
    thread = stop["body"]["threadId"]
    old = client.ask("stackTrace", threadId=thread)["stackFrames"][0]["id"]
    variables = client.ask("scopes", frameId=old)["scopes"][0]["variablesReference"]
    client.go("next")
    new = client.ask("stackTrace", threadId=thread)["stackFrames"][0]["id"]
    assert new != old
    assert client.ask("scopes", frameId=new)["scopes"][0]["variablesReference"] != variables
    for request, number in (("scopes", {"frameId": old}), ("variables", {"variablesReference": variables})):
        error = client.request(request, **number)["body"]["error"]
        assert "at this stop" in error["format"]
        assert not error["showUser"]


def test_output_comes_once_and_the_end_is_reported(client: Client, program: Path) -> None:
    client.launch(program, stopAtEnd=True)
    stop = client.begin()
    assert "ended" in stop["body"]["text"]
    assert client.frames(stop) == [("end of the program", 11)]
    client.go("stepBack")
    client.go("next")
    texts = [each["body"]["output"] for each in client.events if each["event"] == "output"]
    client.ask("continue")
    client.wait("terminated")
    assert "12\n" not in texts
    assert client.refused("next") == "next is not possible now: the session is ended"


def test_values_are_set_and_conditions_hold(client: Client, program: Path) -> None:
    client.launch(program, stopOnEntry=True)
    stop = client.begin()
    assert stop["body"]["reason"] == "entry"
    frame = client.ask("stackTrace", threadId=stop["body"]["threadId"])["stackFrames"][0]["id"]
    variables = client.ask("scopes", frameId=frame)["scopes"][0]["variablesReference"]
    assert (
        client.ask("setVariable", variablesReference=variables, name="total", value="40 + 2")["value"] == "42"
    )
    assert client.ask("setExpression", expression="i", value="2")["value"] == "2"
    assert client.ask("evaluate", expression="total / 4")["result"] == "10.5"
    assert client.ask("evaluate", expression="total")["result"] == "42"
    assert "range" in client.refused("setExpression", expression="total", value="1e12")
    assert "neither" in client.refused("evaluate", expression="nothing + 1")
    client.ask(
        "setBreakpoints", source={"path": str(program)}, breakpoints=[{"line": 5, "condition": "n = 3"}]
    )
    stop = client.go("continue")
    assert client.scopes(stop)["Variables"]["total"] == "48"  # 42, and 2 and 4 were added


def test_motion_is_a_function_breakpoint(client: Client, tmp_path: Path) -> None:
    program = tmp_path / "move.mnt"
    program.write_text(MOVE)
    client.launch(program, input=["5=1@1.5"])
    names = ["position(0) > 20", "input 5 rises", "whenever it rains", "axis 9 starts"]
    points = client.ask("setFunctionBreakpoints", breakpoints=[{"name": each} for each in names])[
        "breakpoints"
    ]
    assert [point["verified"] for point in points] == [True, True, False, False]
    assert points[3]["message"] == "there is no axis 9; this controller has axes 0 to 7"
    stop = client.begin()
    assert stop["body"]["reason"] == "function breakpoint"
    assert stop["body"]["text"].startswith("position(0) > 20 holds at 0.45")
    assert client.scopes(stop)["Axes"]["axis 0"].startswith("position 100")
    assert client.go("continue")["body"]["text"].startswith("input 5 rises at 1.5")
    stop = client.go("reverseContinue")
    assert stop["body"]["reason"] in ("function breakpoint", "entry")


def test_error_is_an_exception_with_its_location(client: Client, tmp_path: Path) -> None:
    program = tmp_path / "fails.mnt"
    program.write_text("Dim a(2) As Integer, i As Integer\nFor i = 1 To 3\n  a(i) = i\nNext\n")
    client.launch(program)
    client.ask("setExceptionBreakpoints", filters=["error", "limit"])
    stop = client.begin()
    assert client.frames(stop)[0] == ("main", 3)
    assert client.ask("exceptionInfo", threadId=1)["breakMode"] == "always"
    assert client.go("continue")["event"] == "terminated"


TRAVEL = "[axis.0]\ntravel = [-10.0, 60.0]\n"
ABORTED = MOVE.replace("PAUSE", "WAIT(500)\nABORT\nPAUSE")


@pytest.mark.parametrize(
    ("name", "text", "machine", "found"),
    [
        ("limit", MOVE, TRAVEL, "limit of axis 0: forward limit, abort at 1.25005 s in line 5"),
        ("fault", ABORTED, "", "abort of axis 0 at 0.50007 s in line 6"),
        ("clamp", f"MAXSPEED(0) = 20\n{MOVE}", "", "clamp of axis 0: speed"),
    ],
)
def test_each_filter_stops_with_an_exception(
    client: Client, tmp_path: Path, name: str, text: str, machine: str, found: str
) -> None:
    """The limit at 60 uu is reached 1.25 s after GO; the abort comes after 0.5 s."""
    program = tmp_path / "move.mnt"
    program.write_text(text)
    (tmp_path / "move.machine.toml").write_text(machine)
    client.launch(program)
    client.ask("setExceptionBreakpoints", filters=[name])
    stop = client.begin()
    assert (stop["event"], stop["body"]["reason"]) == ("stopped", "exception")
    assert stop["body"]["allThreadsStopped"] is True
    assert found in stop["body"]["text"]
    assert found in client.ask("exceptionInfo", threadId=1)["description"]


def test_hit_counts_and_log_points(client: Client, program: Path) -> None:
    client.launch(program)
    points = [{"line": 9, "hitCondition": "% 3"}, {"line": 5, "logMessage": "{n} gives {twice}"}]
    client.ask("setBreakpoints", source={"path": str(program)}, breakpoints=points)
    client.ask("configurationDone")
    texts = []
    while (event := client.wait("output", "stopped"))["event"] == "output":
        texts.append(event["body"]["output"])
    assert texts == ["1 gives 2\n", "2 gives 4\n"]
    assert client.scopes(event)["Variables"]["i"] == "3"


def test_a_breakpoint_by_a_link_or_a_uri_is_one_of_the_program(client: Client, program: Path) -> None:
    folder = program.parent / "a folder"
    folder.mkdir()
    (folder / "link.mnt").symlink_to(program)
    client.launch(program)
    for path in (
        str(folder / "link.mnt"),
        program.as_uri(),
        (folder / "link.mnt").as_uri(),
        str(folder / ".." / program.name),
    ):
        found = client.ask("setBreakpoints", source={"path": path}, breakpoints=[{"line": 9}])["breakpoints"]
        assert found[0]["verified"], path
    found = client.ask(
        "setBreakpoints", source={"path": str(folder / "other.mnt")}, breakpoints=[{"line": 9}]
    )
    assert not found["breakpoints"][0]["verified"]


def test_data_breakpoints_and_the_last_change(client: Client, program: Path) -> None:
    client.launch(program, stopOnEntry=True)
    client.begin()
    data = client.ask("dataBreakpointInfo", name="total")["dataId"]
    client.ask("setDataBreakpoints", breakpoints=[{"dataId": data}])
    stop = client.go("continue")
    assert stop["body"]["reason"] == "data breakpoint"
    assert stop["body"]["text"].startswith("total changes from 0 to 2")
    stop = client.go("evaluate", expression=".changed total", context="repl")
    assert client.frames(stop)[0] == ("Add", 5)


def test_goto_offers_a_line_forward_and_back(client: Client, program: Path) -> None:
    client.launch(program, stopOnEntry=True)
    client.begin()
    client.go("next")
    forward, back = client.ask("gotoTargets", source={"path": str(program)}, line=5)["targets"]
    assert (forward["label"], forward["line"]) == ("the next time that line 5 begins", 5)
    assert back["label"] == "back to the last time that line 5 began"
    thread = 1
    totals = []
    for target in (forward, forward, back):
        stop = client.go("goto", threadId=thread, targetId=target["id"])
        assert (stop["body"]["reason"], client.frames(stop)[0]) == ("goto", ("Add", 5))
        totals.append(client.scopes(stop)["Variables"]["total"])
    assert totals == ["0", "2", "0"]
    assert client.ask("gotoTargets", source={"path": str(program)}, line=99)["targets"] == []
    assert "no target" in client.refused("goto", threadId=thread, targetId=999)
    client.ask("evaluate", expression=".goto line 11", context="repl")
    assert client.frames(client.wait("stopped"))[0] == ("main", 11)


def test_the_console_completes_names_and_commands(client: Client, program: Path) -> None:
    client.launch(program, stopOnEntry=True)
    client.begin()

    def offered(text: str, column: int | None = None) -> list[tuple[str, int, int]]:
        column = len(text) + 1 if column is None else column
        found = client.ask("completions", text=text, column=column)["targets"]
        return [(each["label"], each["start"], each["length"]) for each in found]

    assert offered("1 + to") == [("total", 5, 2)]
    assert offered(".go") == [(".goto", 1, 3)]
    assert offered(".changed to") == [("total", 10, 2)]
    assert offered("to + 1", 3) == [("total", 1, 2)]
    assert ("position", 1, 3) in offered("pos")
    assert offered("nothing") == []


def test_an_axis_is_watched_and_its_last_change_is_found(client: Client, tmp_path: Path) -> None:
    """Line 3 loads the target, and GO in line 4 begins the move."""
    program = tmp_path / "move.mnt"
    program.write_text(MOVE)
    client.launch(program, stopOnEntry=True)
    stop = client.begin()
    data = client.ask("dataBreakpointInfo", name="axis 0")["dataId"]
    client.ask("setDataBreakpoints", breakpoints=[{"dataId": data}])
    stop = client.go("continue")
    assert "axis 0 changes before line" in stop["body"]["text"]
    client.ask("setDataBreakpoints", breakpoints=[])
    client.ask("evaluate", expression=".goto line 6", context="repl")
    client.wait("stopped")
    client.ask("evaluate", expression=".changed output 2", context="repl")
    assert client.frames(client.wait("stopped"))[0] == ("main", 2)


def test_an_input_is_answered_in_the_console(client: Client, tmp_path: Path) -> None:
    program = tmp_path / "asks.mnt"
    program.write_text("Dim n As Integer\nINPUT n\nPrint n * 2\n")
    client.launch(program)
    client.ask("configurationDone")
    while "waits for a line" not in client.wait("output")["body"]["output"]:
        pass
    assert client.request("stackTrace", threadId=1)["message"] == "notStopped"
    client.ask("evaluate", expression="21", context="repl")
    output = ""
    while (event := client.wait("output", "terminated"))["event"] == "output":
        output += event["body"]["output"]
    assert "42" in output


def test_a_restart_runs_the_new_text_to_the_same_time(client: Client, tmp_path: Path) -> None:
    program = tmp_path / "move.mnt"
    program.write_text(MOVE)
    client.launch(program, stopOnEntry=True)
    client.begin()
    client.go("evaluate", expression=".goto 2", context="repl")
    program.write_text(MOVE.replace("= 100", "= 40"))
    stop = client.go("restart")
    assert client.scopes(stop)["Axes"]["axis 0"].startswith("position 40")
    program.write_text("Dim\n")
    assert client.refused("restart").startswith("line 1:")


def test_a_program_that_never_ends_is_paused_and_left(client: Client, tmp_path: Path) -> None:
    program = tmp_path / "endless.mnt"
    program.write_text("Dim n As Integer\nLoop\n  n = n + 1\n  If n > 99 Then n = 0\nEnd Loop\n")
    client.launch(program)
    client.ask("configurationDone")
    assert client.ask("threads")["threads"]
    client.ask("pause", threadId=1)
    stop = client.wait("stopped")
    assert stop["body"]["reason"] == "pause"
    client.go("stepBack")
    client.ask("continue")  # and disconnect while it runs


def test_registers_and_macros_of_mccl(client: Client, tmp_path: Path) -> None:
    program = tmp_path / "macros.mcl"
    program.write_text(MACROS)
    client.launch(program)
    client.ask("setBreakpoints", source={"path": str(program)}, breakpoints=[{"line": 1}])
    client.begin()
    client.go("continue")
    stop = client.go("continue")
    assert client.frames(stop) == [("macro 1", 1), ("main", 4)]
    assert client.scopes(stop)["Registers"] == {"R10": "1"}
    assert client.ask("evaluate", expression="@10 + 1")["result"] == "2"


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        ({}, "program must be a text"),
        ({"program": "/nowhere/a.mnt"}, "cannot be read"),
        ({"program": __file__}, "unknown file extension"),
        ({"program": __file__, "lang": "basic"}, "there is no language"),
        ({"program": __file__, "lang": "mint"}, "line "),
        ({"program": __file__, "until": "soon"}, "until must be a time in seconds"),
        ({"program": "a\0b.mnt"}, "NUL"),
    ],
)
def test_a_launch_that_is_wrong_is_refused(
    client: Client, arguments: dict[str, object], message: str
) -> None:
    client.ask("initialize", adapterID="motionlang")
    assert message in client.refused("launch", **arguments)

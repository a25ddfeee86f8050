"""Complete answers of the debug adapter at one stop.

Statements take 10 µs. GO is the third one, at 20 µs, and the stop is at line 5, at 50 µs: with the preset rate of
100,000 uu/s² the axis has 3 uu/s and has gone 45 nm after 30 µs.
"""

from __future__ import annotations

import threading
from pathlib import Path
from typing import Any

import pytest

from tests.ide.dap.client import COMMANDS, PATIENCE, Client
from tests.ide.dap.test_requests import PROGRAM
from tests.ide.debug.test_debugger import CALLS
from tests.ide.debug.test_state import READINGS

# The requests that a client may send because of a capability.
REQUESTS = {
    "supportsConfigurationDoneRequest": ["configurationDone"],
    "supportsFunctionBreakpoints": ["setFunctionBreakpoints"],
    "supportsStepBack": ["stepBack", "reverseContinue"],
    "supportsSetVariable": ["setVariable"],
    "supportsSetExpression": ["setExpression"],
    "supportsRestartRequest": ["restart"],
    "supportsDataBreakpoints": ["dataBreakpointInfo", "setDataBreakpoints"],
    "supportsBreakpointLocationsRequest": ["breakpointLocations"],
    "supportsExceptionInfoRequest": ["exceptionInfo"],
    "supportsGotoTargetsRequest": ["gotoTargets", "goto"],
    "supportsCompletionsRequest": ["completions"],
    "supportsTerminateRequest": ["terminate"],
    "supportsCancelRequest": ["cancel"],
}
# Arguments of setBreakpoints, and the context "hover" of evaluate.
ARGUMENTS = (
    "supportsConditionalBreakpoints",
    "supportsHitConditionalBreakpoints",
    "supportsLogPoints",
    "supportsEvaluateForHovers",
)


def test_the_capabilities_are_those_of_the_requests(client: Client) -> None:
    found = client.ask("initialize", adapterID="x")
    assert {name for name in found if name.startswith("supports")} == {*REQUESTS, *ARGUMENTS}
    assert [name for name in found if name.startswith("supports") and found[name] is not True] == []
    assert {each for names in REQUESTS.values() for each in names} < set(COMMANDS)
    assert found["completionTriggerCharacters"] == ["."]
    assert [(each["filter"], each["default"]) for each in found["exceptionBreakpointFilters"]] == [
        ("error", True), ("fault", False), ("limit", False), ("clamp", False),
    ]  # fmt: skip


def variable(name: str, value: str, kind: str = "", reference: int = 0, **more: str) -> dict[str, object]:
    return {"name": name, "value": value, "type": kind, "variablesReference": reference, **more}


def scope(name: str, reference: int, **more: str) -> dict[str, object]:
    return {"name": name, "variablesReference": reference, "expensive": False, **more}


SKIPPED = "iterations of a polling loop that are skipped do not count"


@pytest.mark.parametrize("counts", [{"linesStartAt1": False, "columnsStartAt1": False}, {}])
def test_all_answers_at_a_stop(client: Client, tmp_path: Path, counts: dict[str, bool]) -> None:
    """The client counts lines and columns from 0, or from 1, as is usual."""
    first = 0 if counts else 1
    path = tmp_path / "a.mnt"
    path.write_text(PROGRAM)
    source = {"name": "a.mnt", "path": str(path)}
    client.ask("initialize", adapterID="x", **counts)
    client.ask("launch", program=str(path), input=["5=1"], analog=["0=25"])
    points = [
        {"line": 4 + first, "hitCondition": "1"},
        {"line": 30},
        {"line": 3, "condition": "1 +"},
        {"line": first, "logMessage": "{n}"},
    ]
    assert client.ask("setBreakpoints", source=source, breakpoints=points)["breakpoints"] == [
        {"verified": True, "line": 4 + first, "message": SKIPPED},
        {"verified": False, "message": "there is no statement here or below"},
        {"verified": False, "message": "'1 +' is not an expression such as position(0) > 120"},
        {"verified": True, "line": 1 + first},
    ]
    assert client.begin()["body"] == {"reason": "breakpoint", "threadId": 1, "allThreadsStopped": True}
    assert client.ask("threads") == {"threads": [{"id": 1, "name": "ParentTask"}]}
    assert client.ask("stackTrace", threadId=1) == {
        "stackFrames": [
            {
                "id": 1, "name": "main", "source": source, "line": 4 + first, "column": first,
                "endLine": 4 + first, "endColumn": 1 + first,
            }
        ],
        "totalFrames": 1,
    }  # fmt: skip
    assert client.ask("scopes", frameId=1)["scopes"] == [
        scope("Variables", 1), scope("Axes", 2), scope("Inputs", 3), scope("Outputs", 4),
    ]  # fmt: skip

    def variables(reference: int, **arguments: int) -> list[dict[str, Any]]:
        found: list[dict[str, Any]] = client.ask("variables", variablesReference=reference, **arguments)[
            "variables"
        ]
        return found

    assert variables(1) == [
        variable("a", "3 elements", "Integer", 5, evaluateName="a"),
        variable("n", "0", "Integer", evaluateName="n"),
    ]
    assert variables(5) == [
        variable(f"a({number})", value, "Integer", evaluateName=f"a({number})")
        for number, value in ((1, "0"), (2, "7"), (3, "0"))
    ]
    assert variables(5, start=1, count=1) == variables(5)[1:2]
    axis, other = variables(2, count=2)
    assert axis == variable("axis 0", "position 4.5e-05, velocity 3", "axis", 6)
    assert other == variable("axis 1", "position 0, velocity 0", "axis", 7)
    assert variables(6) == [
        variable("position", "4.5e-05 uu", "uu"),
        variable("velocity", "3 uu/s", "uu/s"),
        variable("target", "100 uu", "uu"),
        variable("state", "moving"),
        variable("faults", "none"),
        variable("buffer", "0 elements", "", 8),
    ]
    assert variables(8) == []
    assert variables(3) == [variable("input 5", "1"), variable("analogue input 0", "25")]
    assert variables(4) == [variable("output 2", "1")]
    assert client.ask("evaluate", expression="n") == {
        "result": "0",
        "type": "Integer",
        "variablesReference": 0,
    }
    assert client.ask("evaluate", expression="n + 1") == {"result": "1", "variablesReference": 0}
    assert client.ask("evaluate", expression="a") == {
        "result": "3 elements",
        "type": "Integer",
        "variablesReference": 9,
    }
    changed = {"value": "3", "type": "Integer", "variablesReference": 0}
    assert client.ask("setExpression", expression="n", value="1 + 2") == changed
    assert client.ask("setVariable", variablesReference=5, name="a(1)", value="3") == changed
    line = 5 + first - 1
    assert client.ask("gotoTargets", source=source, line=line)["targets"] == [
        {"id": 10, "label": "the next time that line 5 begins", "line": line},
        {"id": 11, "label": "back to the last time that line 5 began", "line": line},
    ]
    none = {"exceptionId": "none", "description": "", "breakMode": "always"}
    assert client.ask("exceptionInfo", threadId=1) == none
    client.go("next")
    # References are not used again.
    assert client.ask("stackTrace", threadId=1)["stackFrames"][0]["id"] == 2
    assert client.ask("scopes", frameId=2)["scopes"][0] == scope("Variables", 10)
    for request, number in (("variables", 9), ("variables", 14)):
        text = f"there is no variablesReference {number} at this stop"
        assert client.refused(request, variablesReference=number) == text
    for number in (1, 3):
        assert client.refused("scopes", frameId=number) == f"there is no frame {number} at this stop"


def test_the_local_variables_of_two_calls(client: Client, tmp_path: Path) -> None:
    """Only a call has local variables; those of the main program are all global."""
    path = tmp_path / "a.mnt"
    path.write_text(CALLS.replace("twice = 2 * n", "twice = 2 * n\n  If n = 1 Then Add(2)"))
    client.launch(path)
    client.ask("setBreakpoints", source={"path": str(path)}, breakpoints=[{"line": 4}])
    client.begin()
    client.go("continue")
    frames = client.ask("stackTrace", threadId=1)["stackFrames"]
    assert [(each["id"], each["name"], each["line"]) for each in frames] == [
        (1, "Add", 4),
        (2, "Add", 5),
        (3, "main", 10),
    ]
    inner, outer, main = (client.ask("scopes", frameId=number)["scopes"] for number in (1, 2, 3))
    assert inner[:2] == [scope("Local", 1, presentationHint="locals"), scope("Variables", 2)]
    assert outer[:2] == [scope("Local", 6, presentationHint="locals"), scope("Variables", 7)]
    assert main[0] == scope("Variables", 11)
    local = [client.ask("variables", variablesReference=number)["variables"] for number in (1, 6)]
    assert [[(each["name"], each["value"]) for each in one] for one in local] == [
        [("n", "2"), ("twice", "0")],
        [("n", "1"), ("twice", "2")],
    ]
    assert client.ask("setVariable", variablesReference=6, name="twice", value="n + 9")["value"] == "11"
    assert (
        client.refused("setVariable", variablesReference=6, name="total", value="1")
        == "there is no variable total here"
    )
    assert client.ask("dataBreakpointInfo", variablesReference=6, name="twice") == {
        "dataId": "variable local1/twice", "description": "twice changes", "accessTypes": ["write"],
    }  # fmt: skip
    assert client.ask("variables", variablesReference=6)["variables"][1]["value"] == "11"


@pytest.mark.parametrize(
    ("name", "value", "answer"),
    [
        ("input 6", " 1 ", {"value": "1", "variablesReference": 0}),
        ("Analogue Input 1", "12.5", {"value": "12.5", "variablesReference": 0}),
        ("axis 0", "3", "the program and the machine set this; only variables and inputs can be changed"),
        ("output 2", "0", "the program and the machine set this; only variables and inputs can be changed"),
        ("nothing", "0", "there is no variable nothing here"),
    ],
)
def test_a_channel_is_set_by_its_name(
    client: Client, tmp_path: Path, name: str, value: str, answer: dict[str, object] | str
) -> None:
    path = tmp_path / "a.mnt"
    path.write_text(PROGRAM)
    client.launch(path, stopOnEntry=True)
    client.begin()
    client.ask("evaluate", expression=".goto line 7", context="repl")
    client.wait("stopped")
    if isinstance(answer, str):
        assert client.refused("setExpression", expression=name, value=value) == answer
    else:
        assert client.ask("setExpression", expression=name, value=value) == answer


# ---------------------------------------------------------------------------------------------------- sessions


@pytest.mark.parametrize("reports", [False, True])
def test_progress_of_a_search_is_reported_to_clients_that_show_it(
    client: Client, tmp_path: Path, reports: bool
) -> None:
    """Each hit of line 5 takes so long that progress is reported; a search from the end passes some of them."""
    path = tmp_path / "a.mnt"
    path.write_text(CALLS.replace("To 3", "To 5"))
    client.ask("initialize", adapterID="x", supportsProgressReporting=reports)
    client.ask("launch", program=str(path), stopAtEnd=True)
    client.ask("setBreakpoints", source={"path": str(path)}, breakpoints=[{"line": 5}])
    debugger = client.adapter._debugger

    def tick(state: object) -> float:
        debugger._meanwhile()
        return 0.0

    debugger.breakpoints[0].condition = tick
    client.begin()
    for number in (1, 2):
        client.ask("reverseContinue")
        found = []
        while (event := client.wait("progressStart", "progressUpdate", "progressEnd", "stopped"))[
            "event"
        ] != "stopped":
            found.append((event["event"].removeprefix("progress"), event["body"]))
        if not reports:
            assert found == []
            continue
        name = {"progressId": f"replay {number}"}
        assert found[0] == ("Start", {**name, "title": "Running again", "cancellable": True})
        assert found[-1] == ("End", name)
        percentages = [body["percentage"] for _, body in found[1:-1]]
        assert percentages
        assert all(0 < each <= 100 for each in percentages)
        assert {kind for kind, _ in found[1:-1]} == {"Update"}
        client.go("continue")


def test_requests_that_are_none(client: Client) -> None:
    """A response has the number of its request, or 0."""
    adapter = client.adapter
    adapter.handle({"type": "response", "seq": 1, "command": "threads"})
    assert client.taken() == []
    for seq, command, number, name in (
        (True, "fly", 0, "fly"),
        ("7", 5, 0, ""),
        (7, "threads", 7, "threads"),
    ):
        adapter.handle({"type": "request", "seq": seq, "command": command})
        (response,) = client.taken()
        assert (response["request_seq"], response["command"], response["success"]) == (number, name, False)
    texts = [f"there is no request {'x' * 60!r}", "threads is not possible now: the session is new"]
    for command, text in zip(("x" * 70, "threads"), texts, strict=True):
        adapter.handle({"type": "request", "seq": 8, "command": command})
        error = client.taken()[0]["body"]["error"]
        assert (error["format"], error["showUser"]) == (text, command != "threads")
    assert not adapter.is_over
    adapter.handle({"type": "request", "seq": 9, "command": "disconnect"})
    assert adapter.is_over
    adapter.handle({"type": "request", "seq": 10, "command": "initialize"})
    assert [(each["seq"], each.get("message")) for each in client.taken()] == [
        (6, None),
        (7, "the session is over"),
    ]


def test_terminate_ends_a_program_and_reports_it_once(client: Client, tmp_path: Path) -> None:
    """It has no effect before the launch."""
    path = tmp_path / "a.mnt"
    path.write_text(CALLS)
    client.ask("terminate")
    client.launch(path, stopOnEntry=True)
    client.begin()
    client.ask("terminate")
    client.ask("terminate")
    client.ask("cancel")
    assert client.refused("next") == "next is not possible now: the session is ended"
    assert [each["event"] for each in client.events].count("terminated") == 1
    client.close()
    worker = client.adapter._worker
    assert worker is not None
    worker.join(PATIENCE)
    assert not worker.is_alive()
    assert worker.daemon


def test_terminate_ends_the_thread_of_a_program_that_runs(client: Client, tmp_path: Path) -> None:
    path = tmp_path / "a.mnt"
    path.write_text("Dim n As Integer\nLoop\n  n = 1 - n\nEnd Loop\n")
    before = set(threading.enumerate())
    client.launch(path)
    client.ask("configurationDone")
    client.ask("terminate")
    client.wait("terminated")
    for thread in set(threading.enumerate()) - before:
        if thread.name == "program":
            thread.join(PATIENCE)
            assert not thread.is_alive()


@pytest.mark.parametrize("command", ["cancel", "pause"])
def test_a_stopped_program_is_not_paused(client: Client, tmp_path: Path, command: str) -> None:
    path = tmp_path / "a.mnt"
    path.write_text(CALLS)
    client.launch(path, stopOnEntry=True)
    client.begin()
    client.ask(command)
    assert client.ask("continue") == {"allThreadsContinued": True}
    assert client.wait("stopped", "terminated")["event"] == "terminated"


def test_a_request_that_is_cancelled_does_not_pause_the_program(
    client: Client, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """An editor cancels its request for variables when the program continues."""
    path = tmp_path / "a.mnt"
    path.write_text("Dim n As Integer\nLoop\n  n = 1 - n\nEnd Loop\n")
    client.launch(path)
    client.ask("configurationDone")
    debugger, pauses = client.adapter._debugger, list[str]()
    pause = debugger.pause

    def counted() -> None:
        pauses.append("pause")
        pause()

    monkeypatch.setattr(debugger, "pause", counted)
    client.ask("cancel", requestId=3)
    assert pauses == []
    client.ask("cancel")
    assert pauses == ["pause"]
    assert client.wait("stopped")["body"]["reason"] == "pause"


def test_a_filter_alone_does_not_stop_at_other_errors(client: Client, tmp_path: Path) -> None:
    path = tmp_path / "a.mnt"
    path.write_text("Dim b(2) As Integer\nb(1) = 9\nb(b(1)) = 1\n")
    client.launch(path)
    client.ask("setExceptionBreakpoints", filters=["limit"])
    assert client.begin()["event"] == "terminated"


def test_arrays_of_one_and_two_elements(client: Client, tmp_path: Path) -> None:
    path = tmp_path / "a.mnt"
    path.write_text("Dim b(1) As Integer, c(2) As Integer\nPrint 1\n")
    client.launch(path, stopOnEntry=True)
    client.begin()
    found = [client.ask("evaluate", expression=each)["result"] for each in ("b", "c")]
    assert found == ["1 element", "2 elements"]


@pytest.mark.parametrize("column", [0, 1])
def test_completions_before_a_word(client: Client, tmp_path: Path, column: int) -> None:
    """The cursor is at the start of the line, or outside, so every name is offered."""
    path = tmp_path / "a.mnt"
    path.write_text("Dim total As Integer\nPrint 1\n")
    client.launch(path, stopOnEntry=True)
    client.begin()
    found = client.ask("completions", text="to", column=column)["targets"]
    assert [each["label"] for each in found] == ["total", *READINGS]
    assert {(each["start"], each["length"]) for each in found} == {(column, 0)}


@pytest.mark.parametrize(
    ("text", "arguments", "status", "end"),
    [
        ("WAIT = 500\n", {}, 0, "ended after 0.50001 s\n"),
        ("WAIT = 500\n", {"until": 0.25}, 0, "still running after 0.25 s\n"),
        ("Dim b(2) As Integer\nb(1) = 9\nWAIT = 500\nb(b(1)) = 1\n", {}, 1, "fault after 0.50002 s\n"),
    ],
)
def test_how_a_program_has_ended(
    client: Client, tmp_path: Path, text: str, arguments: dict[str, float], status: int, end: str
) -> None:
    """A statement takes 10 µs, also before a fault."""
    path = tmp_path / "a.mnt"
    path.write_text(text)
    client.launch(path, **arguments)
    client.ask("configurationDone")
    output = None
    while (event := client.wait("output", "exited"))["event"] == "output":
        output = event["body"]
    assert output == {"category": "console", "output": end}
    assert event["body"] == {"exitCode": status}
    client.wait("terminated")


@pytest.mark.parametrize("command", ["continue", "next", "stepIn", "stepOut"])
def test_a_stop_at_the_end_is_left_by_any_step_forward(client: Client, tmp_path: Path, command: str) -> None:
    path = tmp_path / "a.mnt"
    path.write_text("Dim n As Integer\nn = 1\n")
    client.launch(path, stopAtEnd=True)
    stop = client.begin()
    text = "the program has ended; step back, or continue to finish"
    assert stop["body"] == {
        "reason": "step", "threadId": 1, "allThreadsStopped": True, "description": text, "text": text,
    }  # fmt: skip
    assert client.ask("threads")["threads"] == [{"id": 1, "name": "program, ended"}]
    scopes = client.scopes(stop)
    assert list(scopes) == ["Variables", "Axes", "Inputs", "Outputs"]
    assert client.go(command)["event"] == "terminated"


def test_variables_of_a_task_that_waits_cannot_be_set(client: Client, tmp_path: Path) -> None:
    """The program is in `Add`, and the task `Blink` waits in `Work`."""
    path = tmp_path / "a.mnt"
    task = "Task Blink\n  Work\nEnd Task\nSub Work\n  Dim k As Integer\n  k = 5\n  PAUSE INX(1)\nEnd Sub\n"
    path.write_text(f"Run Blink\nWAIT(100)\n{CALLS}End\n{task}")
    client.launch(path)
    client.ask("setBreakpoints", source={"path": str(path)}, breakpoints=[{"line": 6}])
    client.begin()
    assert [each["name"] for each in client.ask("threads")["threads"]] == [
        "ParentTask",
        "blink (waits until INX(1))",
    ]
    ours, theirs = (client.ask("stackTrace", threadId=number)["stackFrames"] for number in (1, 2))
    assert [(each["id"], each["name"], each["line"]) for each in ours + theirs] == [
        (1, "Add", 6), (2, "main", 11), (3, "Work", 21), (4, "Blink", 16),
    ]  # fmt: skip
    found = {}
    for number in (1, 3):
        local = client.ask("scopes", frameId=number)["scopes"][0]
        assert local["name"] == "Local"
        found[number] = local["variablesReference"]
    assert client.ask("variables", variablesReference=found[3])["variables"] == [
        variable("k", "5", "Integer", evaluateName="k")
    ]
    text = "only variables of the task that is stopped can be changed"
    assert client.refused("setVariable", variablesReference=found[3], name="k", value="1") == text
    assert client.ask("setVariable", variablesReference=found[1], name="n", value="7")["value"] == "7"


def test_references_have_a_largest_number(
    client: Client, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """A variable without a reference cannot be opened; 0 means that."""
    monkeypatch.setattr("motionlang.ide.dap.showing.MAX_REFERENCES", 3)
    path = tmp_path / "a.mnt"
    path.write_text(CALLS)
    client.launch(path, stopOnEntry=True)
    client.begin()
    client.ask("stackTrace", threadId=1)
    scopes = client.ask("scopes", frameId=1)["scopes"]
    assert [each["variablesReference"] for each in scopes] == [1, 2, 3, 0]


@pytest.mark.parametrize(("count", "shown"), [(2, 2), (10, 10), (12, 10)])
def test_a_launch_reports_ten_mistakes(client: Client, tmp_path: Path, count: int, shown: int) -> None:
    path = tmp_path / "a.mnt"
    path.write_text("Dim\n" * count)
    client.ask("initialize", adapterID="x")
    texts = client.refused("launch", program=str(path)).split("; line ")
    assert [each.removeprefix("line ").partition(":")[0] for each in texts] == [
        str(number) for number in range(1, shown + 1)
    ]


@pytest.mark.parametrize(("count", "offered"), [(150, 150), (199, 199), (200, 200), (230, 200)])
def test_completions_have_a_largest_number(client: Client, tmp_path: Path, count: int, offered: int) -> None:
    path = tmp_path / "a.mnt"
    path.write_text("".join(f"Dim total{number} As Integer\n" for number in range(count)) + "Print 1\n")
    client.launch(path, stopOnEntry=True)
    client.begin()
    assert len(client.ask("completions", text="total", column=6)["targets"]) == offered

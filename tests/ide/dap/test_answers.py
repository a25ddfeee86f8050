"""Answers of the debug adapter that a session of `sessions.txt` cannot show: events, threads, limits."""

from __future__ import annotations

import threading
from pathlib import Path

import pytest

from tests.ide.dap.client import COMMANDS, PATIENCE, Client
from tests.ide.debug.test_debugger import CALLS

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


@pytest.mark.parametrize(("count", "offered"), [(150, 150), (199, 199), (200, 200), (230, 200)])
def test_completions_have_a_largest_number(client: Client, tmp_path: Path, count: int, offered: int) -> None:
    path = tmp_path / "a.mnt"
    path.write_text("".join(f"Dim total{number} As Integer\n" for number in range(count)) + "Print 1\n")
    client.launch(path, stopOnEntry=True)
    client.begin()
    assert len(client.ask("completions", text="total", column=6)["targets"]) == offered


@pytest.fixture
def program(tmp_path: Path) -> Path:
    path = tmp_path / "calls.mnt"
    path.write_text(CALLS)
    return path


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

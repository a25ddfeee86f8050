"""Random messages in any order, in each phase: one response each, no traceback.

python -m tests.ide.dap.test_disorder 10000
"""

from __future__ import annotations

import sys
import tempfile
from pathlib import Path
from random import Random
from typing import Any

import pytest

from tests.ide.dap.client import COMMANDS, Client
from tests.ide.debug.test_debugger import CALLS, MACROS, MOVE

PROGRAMS = {
    "calls.mnt": CALLS,
    "move.mnt": MOVE,
    "macros.mcl": MACROS,
    "fails.mnt": "Dim a(2) As Integer\na(3) = 1\n",
    "asks.mnt": "Dim n As Integer\nINPUT n\n",
    "never.mnt": "Loop\nEnd Loop\n",
    "empty.mnt": "",
    "wrong.mnt": "Dim\n",
}
# A slice for every run, and how many sessions have 10 000 messages.
SESSIONS, LONG, MESSAGES = 12, 250, 40
VALUES: list[Any] = [
    None, True, -1, 0, 1, 2, 7, 2**60, 1.5, float("1e300"), "", "total", "R10", "position(0) > 1", "((((", "é\ud800",
    [], [1], [{}], {}, {"path": "x"}, [{"line": 4}], [{"line": -5, "hitCondition": "%0"}], [{"name": "axis 0 starts"}],
    [{"dataId": "variable module/total"}], ["error", "limit"], ["\0"], "x" * 3000, "1/0", ".goto 0.5", ".input 1=1",
]  # fmt: skip
NAMES = (
    "program", "threadId", "frameId", "variablesReference", "name", "value", "expression", "context", "breakpoints",
    "filters", "source", "line", "time", "stopOnEntry", "stopAtEnd", "startFrame", "levels", "start", "count",
)  # fmt: skip


def session(seed: int, folder: Path) -> int:
    """Run a session of random messages; return how many got a response."""
    draw, client = Random(seed), Client()
    name = draw.choice(sorted(PROGRAMS))
    path = folder / name
    path.write_text(PROGRAMS[name])
    orderly = draw.random() < 0.8
    if orderly:
        client.request("initialize", adapterID="x")
        client.request("launch", program=str(path), stopOnEntry=True, stopAtEnd=draw.random() < 0.5)
        if draw.random() < 0.9:
            client.request("configurationDone")
    count = 0
    for _ in range(MESSAGES):
        command = draw.choice([*COMMANDS, *COMMANDS, "nonsense", ""])
        if command in ("disconnect", "terminate", "restart") and draw.random() < 0.8:
            continue
        arguments = {draw.choice(NAMES): draw.choice(VALUES) for _ in range(draw.randrange(6))}
        if command == "launch" and draw.random() < 0.5:
            arguments["program"] = str(path)
        if draw.random() < 0.5 and command.startswith("set"):
            arguments["source"] = {"path": str(path)}
        response = client.request(command, **arguments)
        assert "Traceback" not in str(response)
        assert "internal error" not in str(response), (seed, command, arguments, response)
        count += 1
        if client.adapter.is_over:
            assert client.refused("threads") == "the session is over"
            break
        if (
            draw.random() < 0.3
            and client.adapter.phase == "running"
            and name not in ("never.mnt", "asks.mnt")
        ):
            client.wait("stopped", "terminated")
    client.adapter.close()
    assert not any("internal error" in str(event) for event in client.events)
    return count


@pytest.mark.parametrize("seed", range(SESSIONS))
def test_disorder_gets_responses(seed: int, tmp_path: Path) -> None:
    assert session(seed, tmp_path) > 0


@pytest.mark.long
def test_much_disorder_gets_responses(tmp_path: Path) -> None:
    assert sum(session(seed, tmp_path) for seed in range(LONG, 2 * LONG)) > 0


def test_messages_that_are_no_requests_are_ignored() -> None:
    client = Client()
    messages: list[dict[str, Any]] = [
        {},
        {"type": "response"},
        {"type": 5, "seq": []},
        {"type": "event", "event": "x"},
    ]
    for message in messages:
        client.adapter.handle(message)
    assert client.refused("threads").startswith("threads is not possible now")
    client.adapter.handle({"type": "request", "seq": "x", "command": ["a"], "arguments": 5})


if __name__ == "__main__":
    wanted, done, number = int(sys.argv[1]) if len(sys.argv) > 1 else 10_000, 0, 0
    with tempfile.TemporaryDirectory() as folder:
        while done < wanted:
            done += session(number, Path(folder))
            number += 1
    print(f"{done} messages, each with a response")

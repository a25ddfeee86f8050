"""A client of the adapter in this process, which checks every message it gets."""

from __future__ import annotations

import json
from pathlib import Path
from queue import Empty, SimpleQueue
from typing import Any

from motionlang.ide.dap.adapter import Adapter
from tests.ide.dap.schema import is_installed, problems

# The requests that the adapter knows, and further ones of the protocol that it adds.
COMMANDS = [
    "initialize",
    "launch",
    "configurationDone",
    "setBreakpoints",
    "setFunctionBreakpoints",
    "setExceptionBreakpoints",
    "setDataBreakpoints",
    "dataBreakpointInfo",
    "breakpointLocations",
    "threads",
    "stackTrace",
    "scopes",
    "variables",
    "setVariable",
    "setExpression",
    "evaluate",
    "completions",
    "exceptionInfo",
    "gotoTargets",
    "goto",
    "continue",
    "next",
    "stepIn",
    "stepOut",
    "stepBack",
    "reverseContinue",
    "pause",
    "restart",
    "cancel",
    "terminate",
    "disconnect",
]
# More than any test needs, s.
PATIENCE = 60.0


class Client:
    """A session with an adapter; `events` are those received, in order."""

    def __init__(self) -> None:
        self._messages: SimpleQueue[dict[str, Any]] = SimpleQueue()
        self.adapter = Adapter(self._receive)
        self.events: list[dict[str, Any]] = []
        self._seq = 0

    def _receive(self, message: dict[str, Any]) -> None:
        again = json.loads(json.dumps(message, allow_nan=False))
        if is_installed():
            assert problems(again) == []
        self._messages.put(again)

    def taken(self) -> list[dict[str, Any]]:
        """Return the messages that have arrived and were not read."""
        return [self._messages.get() for _ in range(self._messages.qsize())]

    def request(self, command: str, **arguments: object) -> dict[str, Any]:
        """Send a request and return its response."""
        self._seq += 1
        self.adapter.handle({"seq": self._seq, "type": "request", "command": command, "arguments": arguments})
        while True:
            message = self._messages.get(timeout=PATIENCE)
            if message["type"] == "response":
                assert message["request_seq"] == self._seq
                return message
            self.events.append(message)

    def ask(self, command: str, **arguments: object) -> Any:
        """Send a request that must succeed, and return the body of its response."""
        response = self.request(command, **arguments)
        assert response["success"], response
        return response.get("body")

    def refused(self, command: str, **arguments: object) -> str:
        """Send a request that must fail, and return the message for the user."""
        response = self.request(command, **arguments)
        assert not response["success"], response
        text: str = response["body"]["error"]["format"]
        return text

    def wait(self, *names: str) -> dict[str, Any]:
        """Return the next event with one of these names; earlier events are dropped."""
        while True:
            for number, event in enumerate(self.events):
                if event["event"] in names:
                    del self.events[: number + 1]
                    return event
            self.events.append(self._next())

    def _next(self) -> dict[str, Any]:
        try:
            return self._messages.get(timeout=PATIENCE)
        except Empty:
            raise AssertionError(f"no event within {PATIENCE:g} s") from None

    # ------------------------------------------------------------------------------------------------ sessions

    def launch(self, program: Path, **arguments: object) -> None:
        """Initialise and launch, up to the start of the configuration."""
        self.ask("initialize", adapterID="motionlang", linesStartAt1=True, columnsStartAt1=True)
        self.ask("launch", program=str(program), **arguments)
        self.wait("initialized")

    def begin(self) -> dict[str, Any]:
        """Complete the configuration and return the first stop, or the end."""
        self.ask("configurationDone")
        return self.wait("stopped", "terminated")

    def go(self, command: str, **arguments: object) -> dict[str, Any]:
        """Continue the program by a command, and return the next stop or the end."""
        self.ask(command, **arguments)
        return self.wait("stopped", "terminated")

    def frames(self, stop: dict[str, Any]) -> list[tuple[str, int]]:
        """Return the names and lines of the frames of a stop."""
        body = self.ask("stackTrace", threadId=stop["body"]["threadId"])
        return [(frame["name"], frame["line"]) for frame in body["stackFrames"]]

    def scopes(self, stop: dict[str, Any]) -> dict[str, dict[str, str]]:
        """Return the variables of each scope as text."""
        frame = self.ask("stackTrace", threadId=stop["body"]["threadId"])["stackFrames"][0]["id"]
        return {
            scope["name"]: {
                each["name"]: each["value"]
                for each in self.ask("variables", variablesReference=scope["variablesReference"])["variables"]
            }
            for scope in self.ask("scopes", frameId=frame)["scopes"]
        }

    def close(self) -> None:
        """Disconnect."""
        self.request("disconnect")

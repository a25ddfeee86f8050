"""Sessions of the debugger, message by message: `sessions.txt`.

`== title` begins a session, `again` the next one of a title, and `; ` a comment. `file` writes a program, whose lines
follow. A line is a request with its arguments, and behind `->` the body of the response, or the error of a refusal.
`wait` is for an event with one of some names. `{folder}` is the folder of the programs. `pytest --update` rewrites what
is answered.
"""

from __future__ import annotations

import json
from functools import partial
from pathlib import Path
from typing import Any

from tests.cases import repeat, sessions
from tests.ide.dap.client import Client

FILE = Path(__file__).with_name("sessions.txt")


def answer(client: Client, command: str, text: str) -> str:
    """Return the answer to a line, as its words behind `->`."""
    body: Any
    if command == "wait":
        event = client.wait(*text.split())
        body, prefix = event.get("body"), f" {event['event']}"
    else:
        response = client.request(command, **json.loads(text or "{}"))
        # The capabilities are the same for all sessions; `test_answers.py` has them.
        body, prefix = None if command == "initialize" else response.get("body"), ""
        if not response["success"]:
            body = response["body"]
            body, prefix = body["error"], " refused"
    return prefix + (f" {json.dumps(body, ensure_ascii=False)}" if body else "")


def replayed(session: str, folder: Path) -> str:
    """Return a session with what is answered now."""
    shown: list[str] = []
    files: dict[str, str] = {}
    client, name = Client(), ""
    try:
        for line in session.splitlines():
            command, _, text = line.partition(" ->")[0].partition(" ")
            if command == "file":
                name, files[text] = text, ""
            elif command == ":":
                files[name] += line[2:] + "\n"
                (folder / name).write_text(files[name], encoding="utf-8")
            elif command == "again":
                client.close()
                client = Client()
            elif command not in ("==", ";"):
                found = answer(client, command, text.replace("{folder}", str(folder)))
                line = f"{line.partition(' ->')[0]} ->{found}".replace(str(folder), "{folder}")
            shown.append(line)
    finally:
        client.close()
    return "\n".join(shown) + "\n"


@sessions(FILE)
def test_requests_are_answered_as_written(path: Path, session: str, tmp_path: Path, update: bool) -> None:
    repeat(path, session, partial(replayed, folder=tmp_path), update)

"""The server of the panel: whom it answers, what it sends, and two pages of one machine."""

from __future__ import annotations

import json
import threading
from collections.abc import Generator, Iterator
from contextlib import contextmanager
from http.client import HTTPConnection
from pathlib import Path
from typing import Any

import pytest

from motionlang_explore.panel.server import PanelServer
from test_explore.panel.hands import PRESS, Explore, Hand, operated


class Page:
    """A page of a panel, without a browser."""

    def __init__(self, server: PanelServer) -> None:
        self.port, self.begin = server.server_port, f"/{server.secret}/"

    def ask(
        self, path: str, body: object = None, method: str = "", **headers: str
    ) -> tuple[int, dict[str, str], bytes]:
        """Return status, headers and body of an answer."""
        connection = HTTPConnection("127.0.0.1", self.port, timeout=30)
        sent = None if body is None else json.dumps(body).encode()
        kind = {} if body is None else {"Content-Type": "application/json"}
        named = {name.replace("_", "-"): value for name, value in headers.items()}
        try:
            connection.request(method or ("GET" if body is None else "POST"), path, sent, {**kind, **named})
            answer = connection.getresponse()
            return answer.status, dict(answer.getheaders()), answer.read()
        finally:
            connection.close()

    def act(self, **request: object) -> tuple[int, Any]:
        """Ask for an action; return status and answer."""
        status, _, body = self.ask(f"{self.begin}act", request)
        return status, json.loads(body)

    def events(self, name: str = "") -> Generator[Any, None, None]:
        """Yield what the server sends."""
        connection = HTTPConnection("127.0.0.1", self.port, timeout=30)
        connection.request("GET", f"{self.begin}events?page={name}")
        answer = connection.getresponse()
        try:
            while line := answer.readline():
                if line.startswith(b"data: "):
                    yield json.loads(line[6:])
        finally:
            answer.close()
            connection.close()


@contextmanager
def served(
    path: Path, text: str = PRESS, explore: Explore | None = None
) -> Iterator[tuple[Hand, PanelServer]]:
    with operated(path, text, explore=explore) as hand:
        server = PanelServer(hand.session)
        thread = threading.Thread(target=server.serve, daemon=True)
        thread.start()
        try:
            yield hand, server
        finally:
            server.stop()
            thread.join()


def test_the_page_loads_nothing_from_elsewhere(tmp_path: Path) -> None:
    with served(tmp_path / "press.mnt") as (_, server):
        page = Page(server)
        for name in ("", "style.css", "panel.js"):
            status, headers, body = page.ask(page.begin + name)
            assert status == 200
            assert headers["Content-Security-Policy"].startswith("default-src 'none'; script-src 'self';")
            assert b"http://" not in body
            assert b"https://" not in body


@pytest.mark.parametrize(
    ("path", "headers"),
    [
        ("/", {}),
        ("/another/", {}),
        ("/{}/", {"Host": "example.com"}),
        ("/{}/", {"Host": "example.com:{}"}),
        ("/{}/", {"Origin": "http://example.com"}),
        ("/{}/", {"Origin": "null"}),
        ("/{}/events", {"Origin": "https://127.0.0.1:{}"}),
    ],
)
def test_another_host_origin_or_secret_is_refused(tmp_path: Path, path: str, headers: dict[str, str]) -> None:
    with served(tmp_path / "press.mnt") as (_, server):
        sent = {name: value.format(server.server_port) for name, value in headers.items()}
        assert Page(server).ask(path.format(server.secret), **sent)[0] == 403


def test_an_action_of_a_foreign_page_is_refused(tmp_path: Path) -> None:
    with served(tmp_path / "press.mnt") as (hand, server):
        page = Page(server)
        request = {"do": "change", "table": "input", "number": 1, "value": 1}
        assert page.ask(f"{page.begin}act", request, Origin="http://example.com")[0] == 403
        assert page.ask(f"{page.begin}act", request, Content_Type="text/plain")[0] == 400
        assert page.act(**request) == (200, {})
        hand.sees(lambda state: state["inputs"] == {1: 1})
        assert [words for _, words in hand.record] == ["input 1 on"]


def test_what_cannot_be_done_is_answered_with_the_reason(tmp_path: Path) -> None:
    with served(tmp_path / "press.mnt") as (_, server):
        page = Page(server)
        assert page.act(do="fly") == (400, {"error": "unknown action"})
        assert page.ask(f"{page.begin}act", [1])[0] == 400
        assert page.ask(f"{page.begin}act", "x" * 20_000)[0] == 400
        assert page.ask(f"{page.begin}other")[0] == 404
        assert page.ask(page.begin, method="DELETE")[0] == 501


def test_two_pages_see_what_either_does(tmp_path: Path) -> None:
    with served(tmp_path / "press.mnt") as (_, server):
        one, other = Page(server), Page(server)
        first, second = one.events(), other.events()
        assert next(first)["contents"]["file"] == next(second)["contents"]["file"] == "press.mnt"
        one.act(do="change", table="input", number=1, value=1)
        for events in (first, second):
            assert next(each for each in events if each["state"]["inputs"] == {"1": 1})
        other.act(do="change", table="input", number=1, value=0)
        for events in (first, second):
            assert next(each for each in events if each["state"]["inputs"] == {})
        first.close()
        second.close()


def test_a_page_too_many_is_refused(tmp_path: Path) -> None:
    with served(tmp_path / "press.mnt") as (_, server):
        server.pages = threading.BoundedSemaphore(1)
        page = Page(server)
        events = page.events()
        assert next(events)["contents"]["file"] == "press.mnt"
        assert page.ask(f"{page.begin}events")[0] == 503
        events.close()


def test_a_port_in_use(tmp_path: Path) -> None:
    with served(tmp_path / "press.mnt") as (hand, server), pytest.raises(OSError, match="in use"):
        PanelServer(hand.session, server.server_port)


def test_a_page_that_is_closed_releases_what_it_presses(tmp_path: Path) -> None:
    with served(tmp_path / "press.mnt") as (hand, server):
        page = Page(server)
        hand("run")
        events = page.events("a")
        next(events)
        page.act(do="press", page="a", message=1, numbers=[1])
        page.act(do="change", table="input", number=3, value=1)
        hand.sees(lambda state: state["inputs"] == {1: 1, 3: 1})
        events.close()
        hand.sees(lambda state: state["inputs"] == {3: 1})


def test_a_page_that_falls_silent_releases_what_it_presses(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr("motionlang_explore.panel.presses.PATIENCE", 0.1)
    with served(tmp_path / "press.mnt") as (hand, server):
        hand("run")
        Page(server).act(do="press", page="a", message=1, numbers=[1])
        hand.sees(lambda state: state["inputs"] == {1: 1})
        hand.sees(lambda state: state["inputs"] == {})

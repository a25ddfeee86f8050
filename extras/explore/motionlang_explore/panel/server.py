"""The server of a panel: its page, its state as server-sent events, and the actions of the pages.

Only this computer reaches it, and only a page that has the secret of its address: another Host or Origin, or another
path, is refused, so that no other page of the browser can operate the machine.
"""

from __future__ import annotations

import json
import sys
import threading
from collections.abc import Mapping
from http import HTTPStatus
from http.server import BaseHTTPRequestHandler, ThreadingHTTPServer
from importlib.resources import files
from secrets import token_urlsafe
from select import select
from socketserver import TCPServer
from time import monotonic, sleep
from typing import Any

from motionlang.hosts.address import LOOPBACK
from motionlang_explore.panel.session import Cursor, PanelSession, WrongAction

# The files of the page, by the last part of the address.
FILES = {
    "": ("page.html", "text/html; charset=utf-8"),
    "style.css": ("style.css", "text/css; charset=utf-8"),
    "panel.js": ("panel.js", "text/javascript; charset=utf-8"),
}
HEADERS = {
    "Content-Security-Policy": "default-src 'none'; script-src 'self'; style-src 'self'; connect-src 'self'; "
    "img-src data:; base-uri 'none'; form-action 'none'; frame-ancestors 'none'",
    "Cache-Control": "no-store",
    "Cross-Origin-Resource-Policy": "same-origin",
    "Referrer-Policy": "no-referrer",
    "X-Content-Type-Options": "nosniff",
}
# Real time between two states of a page, and without a state, s; after either its connection is tested.
BETWEEN, SILENCE = 1 / 25, 0.5
# Pages that are visible at the same time: a browser has six connections, and one of them is for actions.
MAX_PAGES, MAX_BYTES = 5, 10_000


class PanelServer(ThreadingHTTPServer):
    """Serves a session on a port of this computer; 0 is any free one. Raises OSError if the port is in use."""

    daemon_threads = True
    block_on_close = False
    # On Windows two servers could have one port otherwise.
    allow_reuse_address = sys.platform != "win32"

    def __init__(self, session: PanelSession, port: int = 0) -> None:
        self.session, self.secret = session, token_urlsafe(12)
        self.over = threading.Event()
        self.pages = threading.BoundedSemaphore(MAX_PAGES)
        super().__init__((LOOPBACK, port), Handler)

    def server_bind(self) -> None:
        TCPServer.server_bind(self)  # without asking the network for a name
        self.server_name, self.server_port = self.server_address[:2]  # type: ignore[assignment]

    def handle_error(self, request: object, client_address: object) -> None:
        """Write nothing: a page that is closed breaks its connection."""

    @property
    def address(self) -> str:
        """The address of the page, with its secret."""
        return f"http://{LOOPBACK}:{self.server_port}/{self.secret}/"

    @property
    def hosts(self) -> tuple[str, str]:
        """The names by which a page may reach it."""
        return f"{LOOPBACK}:{self.server_port}", f"localhost:{self.server_port}"

    def serve(self) -> None:
        """Serve until `stop`, in the present thread."""
        threading.Thread(target=self.session.watch, args=(self.over,), daemon=True).start()
        self.serve_forever()

    def stop(self) -> None:
        """End `serve`, the pages and the run."""
        self.over.set()
        self.shutdown()
        self.server_close()
        self.session.close()


class Handler(BaseHTTPRequestHandler):
    """A request of a page."""

    server: PanelServer
    protocol_version = "HTTP/1.1"

    def log_message(self, *_: object) -> None:
        """Write no log."""

    def version_string(self) -> str:
        return "motionlang"

    def do_GET(self) -> None:
        name = self._name()
        if name is None:
            return
        name, _, page = name.partition("?page=")
        if name == "events":
            self._send_events(page)
        elif name in FILES:
            file, kind = FILES[name]
            self._send(HTTPStatus.OK, files(__package__).joinpath(file).read_bytes(), kind)
        else:
            self._refuse(HTTPStatus.NOT_FOUND, "there is no such page")

    def do_POST(self) -> None:
        name = self._name()
        if name is None:
            return
        length = self.headers.get("Content-Length", "")
        is_json = self.headers.get("Content-Type", "").partition(";")[0].strip() == "application/json"
        if name != "act" or not is_json or not length.isdecimal() or int(length) > MAX_BYTES:
            self._refuse(HTTPStatus.BAD_REQUEST, "POST act takes a small JSON document")
            return
        try:
            request = json.loads(self.rfile.read(int(length)))
            if not isinstance(request, dict):
                raise WrongAction("an action is an object")
            self.server.session.act(request)
        except ValueError as error:
            self._refuse(HTTPStatus.BAD_REQUEST, str(error))
        else:
            self._send(HTTPStatus.OK, b"{}", "application/json")

    def _name(self) -> str | None:
        """Return what a request that may be answered is for; a refused one has its answer already."""
        host, origin = self.headers.get("Host", ""), self.headers.get("Origin")
        begin = f"/{self.server.secret}/"
        is_known = host in self.server.hosts and origin in (None, f"http://{host}")
        if is_known and self.path.startswith(begin):
            return self.path.removeprefix(begin)
        self._refuse(HTTPStatus.FORBIDDEN, "open the address that motionlang panel has printed")
        return None

    def _refuse(self, status: HTTPStatus, reason: str) -> None:
        self.close_connection = True  # a body that is not read would be the next request
        self._send(status, json.dumps({"error": reason}).encode(), "application/json")

    def _send(self, status: HTTPStatus, body: bytes, kind: str) -> None:
        self._begin(status, {"Content-Type": kind, "Content-Length": str(len(body))})
        self.wfile.write(body)

    def _begin(self, status: HTTPStatus, headers: Mapping[str, str]) -> None:
        self.send_response(status)
        for name, value in {**HEADERS, **headers}.items():
            self.send_header(name, value)
        if self.close_connection:
            self.send_header("Connection", "close")
        self.end_headers()

    def _send_events(self, page: str) -> None:
        """Send the state whenever it changes, until the page or the server ends; then the page presses nothing."""
        server, cursor = self.server, Cursor()
        if not server.pages.acquire(blocking=False):
            self._refuse(
                HTTPStatus.SERVICE_UNAVAILABLE, f"{MAX_PAGES} pages are visible already: close or hide one"
            )
            return
        self.close_connection = True
        try:
            self._begin(HTTPStatus.OK, {"Content-Type": "text/event-stream"})
            while not server.over.is_set() and not select([self.connection], [], [], 0.0)[0]:
                sent = monotonic()
                found = server.session.updates(cursor, SILENCE)
                self.wfile.write(_event(found) if found is not None else b": \n\n")
                sleep(max(0.0, sent + BETWEEN - monotonic()))
        except OSError:
            pass  # the page is closed
        finally:
            server.session.presses.gone(page)
            server.pages.release()


def _event(data: dict[str, Any]) -> bytes:
    return f"data: {json.dumps(data, separators=(',', ':'))}\n\n".encode()

"""The language server of the playground: messages in, messages out, in the worker of the page.

It is the server of `motionlang lsp`. The browser has neither processes nor streams, so each message is passed
on by a call, and checks are done between two messages.
"""

from __future__ import annotations

import json
from typing import TYPE_CHECKING

from pygls.exceptions import JsonRpcException

from motionlang_lsp.server import EditorServer, prepare
from motionlang_lsp.workers import Inline

if TYPE_CHECKING:
    from collections.abc import Callable


class Writer:
    """Passes each message of the server on."""

    def __init__(self, send: Callable[[str], object]) -> None:
        self._send = send

    def write(self, message: bytes) -> None:
        """Pass a message on."""
        self._send(message.decode())

    def close(self) -> None:
        """Do nothing: the page ends the worker."""


def serve(send: Callable[[str], object]) -> Callable[[str], None]:
    """Start a server whose messages `send` gets; return a function that gives it one.

    Needs a running event loop, which a worker of Pyodide always has.
    """
    prepare()
    server = EditorServer(Inline())
    server.protocol.set_writer(Writer(send), include_headers=False)

    def take(message: str) -> None:
        try:
            found = json.loads(message, object_hook=server.protocol.structure_message)
            server.protocol.handle_message(found)
        except Exception as error:
            server.report_server_error(error, JsonRpcException)

    return take

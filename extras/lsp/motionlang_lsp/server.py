"""The server: its connection, and the messages that it sends on its own."""

from __future__ import annotations

import asyncio
import logging
import os
import re
import socket
import sys
from typing import Any, BinaryIO

from lsprotocol import types
from pygls.exceptions import FeatureRequestError, JsonRpcException
from pygls.io_ import run_async
from pygls.lsp.server import LanguageServer

from motionlang.kernel import Diagnostic
from motionlang.kernel.version import __version__
from motionlang_lsp.convert import diagnostic
from motionlang_lsp.documents import OpenDocument
from motionlang_lsp.features import register
from motionlang_lsp.protocol import Protocol
from motionlang_lsp.session import OpenTexts, Worker

# The largest message accepted, in bytes; four times the largest program.
MAX_MESSAGE = 1 << 28
# The longest line of a message's header.
_MAX_HEADER = 4096
_CHUNK = 1 << 16
_LENGTH = re.compile(rb"[ \t]*content-length[ \t]*:[ \t]*(\d+)[ \t]*\r?\n", re.IGNORECASE)


class EditorServer(LanguageServer):
    """A language server for one editor; `worker` does its checks and runs."""

    protocol: Protocol

    def __init__(self, worker: Worker) -> None:
        super().__init__("motionlang", __version__, protocol_cls=Protocol)
        self.session = OpenTexts(worker, self._publish, self._log)
        register(self)
        # Standard error is a window of the editor, which is not the place for a log.
        logging.getLogger("pygls").setLevel(logging.CRITICAL + 1)

    @property
    def capabilities(self) -> types.ClientCapabilities:
        """The capabilities of the editor."""
        return self.protocol.client_capabilities

    def _publish(self, document: OpenDocument, found: list[Diagnostic]) -> None:
        shown = [diagnostic(document, each) for each in found]
        self.text_document_publish_diagnostics(
            types.PublishDiagnosticsParams(document.uri, shown, version=document.version)
        )

    def report_server_error(self, error: Exception, source: Any) -> None:
        """Answer bytes that are not a message; failed requests are answered elsewhere."""
        if source is JsonRpcException:
            self.protocol.report_broken(error)
        elif source is not FeatureRequestError:
            self._log(f"internal error: {error}")

    def _log(self, text: str) -> None:
        message = f"motionlang lsp: {text}"
        self.window_log_message(types.LogMessageParams(types.MessageType.Error, message))

    def serve_streams(self) -> int:
        """Serve the editor on standard input and output; return the exit status."""
        prepare()
        output = os.fdopen(os.dup(sys.stdout.fileno()), "wb")
        sys.stdout = sys.stderr  # nothing else may write where the messages go
        try:
            self.start_io(MessageStream(sys.stdin.buffer), output)  # type: ignore[arg-type]
        except (BrokenPipeError, ValueError):
            pass  # the editor has gone
        finally:
            self.session.stop()
        return 0 if self.protocol._shutdown else 1

    def serve_socket(self, listener: socket.socket) -> int:
        """Serve the first editor that connects to a socket, until it disconnects."""
        prepare()
        try:
            asyncio.run(self._serve_one(listener))
        except SystemExit:
            pass  # by the notification `exit`
        finally:
            self.session.stop()
        return 0

    async def _serve_one(self, listener: socket.socket) -> None:
        import threading

        loop = asyncio.get_running_loop()
        connection, _ = await loop.sock_accept(listener)
        listener.close()
        reader, writer = await asyncio.open_connection(sock=connection)
        self.protocol.set_writer(writer)
        self._stop_event = threading.Event()
        try:
            await run_async(self._stop_event, _Limited(reader), self.protocol, None, self.report_server_error)
        except (ConnectionError, asyncio.IncompleteReadError):
            pass  # the editor has gone
        finally:
            writer.close()


def _header(line: bytes) -> bytes:
    """Return a line of a header; the length is in the only form that pygls reads, without blanks and in this case."""
    found = _LENGTH.fullmatch(line)
    return line if found is None else b"Content-Length: %b\r\n" % found[1]


class MessageStream:
    """A stream of messages that limits their size."""

    def __init__(self, stream: BinaryIO) -> None:
        self._stream = stream

    def readline(self) -> bytes:
        """Return a line of a header, truncated to the limit."""
        return _header(self._stream.readline(_MAX_HEADER))

    def read(self, count: int) -> bytes:
        """Return the body of a message.

        A body that is too large is skipped, and an empty object is returned.
        """
        if count <= MAX_MESSAGE:
            return self._stream.read(count)
        while count > 0 and (chunk := self._stream.read(min(count, _CHUNK))):
            count -= len(chunk)
        return b"{}"


class _Limited:
    """Like `MessageStream`, for a connection."""

    def __init__(self, reader: asyncio.StreamReader) -> None:
        self._reader = reader

    async def readline(self) -> bytes:
        try:
            return _header(await self._reader.readline())
        except ValueError:  # longer than the reader's limit
            return b"\r"

    async def readexactly(self, count: int) -> bytes:
        if count <= MAX_MESSAGE:
            return await self._reader.readexactly(count)
        while count > 0:
            chunk = await self._reader.read(min(count, _CHUNK))
            if not chunk:
                return b""
            count -= len(chunk)
        return b"{}"


def prepare() -> None:
    """Load the keywords."""
    from motionlang.kernel import dialect, dialects

    for name in dialects():
        len(dialect(name).table().rows)

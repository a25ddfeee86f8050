"""The protocol of pygls, with answers to messages that pygls ignores or prints.

Each request gets exactly one answer. This includes a malformed request, one before `initialize` or after `shutdown`,
and one that fails. Errors have one sentence, and no traceback leaves the process.
"""

from __future__ import annotations

from collections.abc import Generator
from concurrent.futures import Future
from typing import TYPE_CHECKING, Any

from lsprotocol import types
from pygls.exceptions import JsonRpcException
from pygls.protocol import LanguageServerProtocol
from pygls.protocol.language_server import lsp_method

if TYPE_CHECKING:
    from motionlang_lsp.server import EditorServer

NOT_INITIALIZED = -32002
INVALID_REQUEST = -32600
INVALID_PARAMETERS = -32602
PARSE_ERROR = -32700
REQUEST_FAILED = -32803


class Malformed:
    """A malformed message: the `id` for the answer, None if it has none."""

    def __init__(self, number: int | str | None, code: int, message: str, method: str = "") -> None:
        self.id, self.code, self.message, self.method = number, code, message, method


class Protocol(LanguageServerProtocol):
    """The protocol of one connection; it uses the server's own documents."""

    _server: EditorServer

    def __init__(self, *arguments: Any) -> None:
        super().__init__(*arguments)
        self._is_initialized = False

    # ----------------------------------------------------------------------------------------- messages

    def structure_message(self, data: dict[str, Any]) -> Any:
        """Convert a JSON object to a message."""
        try:
            return super().structure_message(data)
        except Exception:
            number = data.get("id")
            if "method" in data and isinstance(number, int | str) and not isinstance(number, bool):
                method = str(data["method"])
                return Malformed(number, INVALID_PARAMETERS, f"invalid parameters of {method}", method)
            # A notification has no answer.
            return Malformed(None, INVALID_REQUEST, "the message is malformed" if "id" in data else "")

    def handle_message(self, message: Any) -> None:
        """Answer a message, or pass it to its handler."""
        method, number = getattr(message, "method", None), getattr(message, "id", None)
        if isinstance(message, Malformed):
            refused = self._out_of_order(method) if number is not None else None
            code, text = refused or (message.code, message.message)
            if text:
                self._refuse(number, code, text)
        elif isinstance(message, dict) or getattr(message, "jsonrpc", None) != self.VERSION:
            self._refuse(None, INVALID_REQUEST, "the message is not JSON-RPC 2.0")
        else:
            refused = self._out_of_order(method) if method is not None else None
            if refused is None:
                super().handle_message(message)
            elif number is not None:
                self._refuse(number, *refused)

    def _out_of_order(self, method: str | None) -> tuple[int, str] | None:
        """Return error code and text for a message at the wrong time, or None."""
        if method == types.EXIT:
            return None
        if self._shutdown:
            return INVALID_REQUEST, "the server is shut down"
        if method == types.INITIALIZE:
            return (INVALID_REQUEST, "the server is initialized already") if self._is_initialized else None
        return None if self._is_initialized else (NOT_INITIALIZED, "the server is not initialized")

    def _refuse(self, number: int | str | None, code: int, text: str) -> None:
        self._send_data({"jsonrpc": self.VERSION, "id": number, "error": {"code": code, "message": text}})

    def _run_generator(
        self, future: Future[Any] | None, *, gen: Generator[Any, Any, Any], result_future: Future[Any]
    ) -> None:
        """Continue a handler; forget what it has waited for, which pygls would store for ever."""
        for number in [number for number, each in self._request_futures.items() if each is future]:
            del self._request_futures[number]
        super()._run_generator(future, gen=gen, result_future=result_future)

    def _send_response(
        self, msg_id: int | str, result: Any | None = None, error: types.ResponseError | None = None
    ) -> None:
        """Send the answer to a request; an error is reduced to its message."""
        if error is not None:
            error.data = None
        super()._send_response(msg_id, result, error)

    def report_broken(self, error: Exception) -> None:
        """Answer bytes that are not a message."""
        text = "the message is not valid JSON" if not isinstance(error, JsonRpcException) else str(error)
        self._refuse(None, PARSE_ERROR, text)

    # ---------------------------------------------------------------------------------------- documents

    @lsp_method(types.INITIALIZE)
    def lsp_initialize(self, params: types.InitializeParams) -> Generator[Any, Any, types.InitializeResult]:
        """Negotiate the features; positions are in UTF-16, which all clients support."""
        general = params.capabilities.general
        if general is not None:
            general.position_encodings = [types.PositionEncodingKind.Utf16]
        self._is_initialized = True
        return (yield from super().lsp_initialize(params))

    @lsp_method(types.TEXT_DOCUMENT_DID_OPEN)
    def lsp_text_document__did_open(self, params: types.DidOpenTextDocumentParams) -> None:
        """Store an opened text."""
        self._server.session.open(params.text_document)

    @lsp_method(types.TEXT_DOCUMENT_DID_CHANGE)
    def lsp_text_document__did_change(self, params: types.DidChangeTextDocumentParams) -> None:
        self._server.session.change(params)

    @lsp_method(types.TEXT_DOCUMENT_DID_CLOSE)
    def lsp_text_document__did_close(self, params: types.DidCloseTextDocumentParams) -> None:
        """Remove a closed text."""
        self._server.session.close(params.text_document.uri)

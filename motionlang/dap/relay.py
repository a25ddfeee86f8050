"""The front of a session: passes messages between a client and the engine.

The engine, a separate process, contains the adapter and the program. To step back in a slow run, the session continues
in a copy of the engine (`debug/checkpoints.py`), and the engine ends. The front has the channels of all copies.
Requests without a response so far are sent to the copy, too. When the client or the engine dies, the front closes all
channels, and every process of the session ends. If the front dies, the operating system closes them.
"""

from __future__ import annotations

import base64
import os
import socket
import sys
import threading
from collections.abc import Callable

from motionlang.dap.framing import Message, WrongMessage, read, written
from motionlang.debug.checkpoints import send

# Longer packets are not sent: a word and the number of a copy, or several.
MAX_PACKET = 4096
# How long a copy may take to be announced, and a message to be written, s.
PATIENCE = 10.0
END = "the debugger has ended unexpectedly"


class Relay:
    """The front, with the methods of an `Adapter`.

    `send` writes a message to the client.
    """

    def __init__(self, send: Callable[[Message], None], close: Callable[[], None]) -> None:
        """Fork the engine; `close` is called there to close the streams of the client."""
        self._send, self.is_over = send, False
        self._lock, self._sending, self._is_answered = threading.Lock(), threading.Lock(), threading.Event()
        self._seq = 0
        # Requests without a response, by their number.
        self._open: dict[int, Message] = {}
        self._copies: dict[int, socket.socket] = {}
        self._announced = threading.Condition()
        self._channel, far = socket.socketpair()
        control, announcements = socket.socketpair(socket.AF_UNIX, socket.SOCK_SEQPACKET)
        sys.stdout.flush()
        sys.stderr.flush()
        if os.fork() == 0:
            from motionlang.dap.engine import main

            self._channel.close()
            control.close()
            close()
            main(far, announcements)
        far.close()
        announcements.close()
        self._control = control
        self._passing = threading.Thread(target=self._pass_on, daemon=True)
        self._passing.start()
        threading.Thread(target=self._maintain_copies, daemon=True).start()

    # --------------------------------------------------------------------------------------- to the engine

    def handle(self, message: Message) -> None:
        """Pass a message from the client to the engine."""
        with self._lock:
            if self.is_over:
                self._refuse(message)
                return
            seq = message.get("seq")
            if message.get("type") == "request" and isinstance(seq, int):
                self._open[seq] = message
            self._to_engine(message)
        if message.get("command") == "disconnect":
            self._is_answered.wait(PATIENCE)

    def _to_engine(self, message: Message) -> None:
        try:
            self._channel.sendall(written(message))
        except OSError:
            pass  # it has ended, which the other thread reports

    def output(self, text: str, category: str = "stdout") -> None:
        """Send text for the client's console."""
        self._to_client({"type": "event", "event": "output", "body": {"category": category, "output": text}})

    def close(self) -> None:
        """End the engine and all copies, and write no more to the client."""
        self.is_over = True
        _close(self._channel)
        with self._announced:
            for channel in self._copies.values():
                _close(channel)
            self._copies.clear()
        if threading.current_thread() is not self._passing:
            self._passing.join(PATIENCE)  # Python aborts if a thread writes to standard output while it ends

    # --------------------------------------------------------------------------------------- to the client

    def _to_client(self, message: Message) -> None:
        with self._sending:
            self._seq += 1
            self._send({**message, "seq": self._seq})

    def _pass_on(self) -> None:
        """Pass messages from the engine to the client, until the engine ends."""
        while not self.is_over:
            stream = self._channel.makefile("rb")
            try:
                while (message := read(stream)) is not None and message.get("type") != "handover":
                    self._to_client(message)
                    self._answered(message)
            except (OSError, WrongMessage):
                message = None
            stream.close()
            if message is None:
                break
            self._continue_in(message)
        self._ended()

    def _answered(self, message: Message) -> None:
        if message.get("type") == "response":
            with self._lock:
                number = message["request_seq"]
                assert isinstance(number, int)
                self._open.pop(number, None)
            if message.get("command") == "disconnect":
                self.is_over = True
                self._is_answered.set()

    def _continue_in(self, message: Message) -> None:
        """Continue the session in a copy."""
        number, state = message["key"], message["state"]
        assert isinstance(number, int)
        assert isinstance(state, str)
        with self._announced:
            self._announced.wait_for(lambda: number in self._copies, PATIENCE)
            copy = self._copies.pop(number)
        with self._lock:
            _close(self._channel)
            self._channel = copy
            send(copy, base64.b64decode(state))
            for each in self._open.values():
                self._to_engine(each)

    def _ended(self) -> None:
        """Report the end of the engine, unless the client has been informed."""
        with self._lock:
            if self.is_over:
                return
            self.is_over = True
            waiting = list(self._open.values())
        self._is_answered.set()
        self.output(f"{END}\n", "stderr")
        for each in waiting:
            self._refuse(each)
        self._to_client({"type": "event", "event": "terminated"})
        self.close()

    def _refuse(self, message: Message) -> None:
        if message.get("type") == "request":
            error = {"id": 1, "format": END, "showUser": True}
            self._to_client(
                {
                    "type": "response", "request_seq": message.get("seq"), "command": message.get("command"),
                    "success": False, "message": END, "body": {"error": error},
                }
            )  # fmt: skip

    # -------------------------------------------------------------------------------------------- copies

    def _maintain_copies(self) -> None:
        """Store the channels of new copies, and close those of dropped ones."""
        while True:
            try:
                packet, found, _, _ = socket.recv_fds(self._control, MAX_PACKET, 1)
            except OSError:
                return
            if not packet:
                return
            word, *numbers = packet.decode().split()
            with self._announced:
                if word == "copy":
                    self._copies[int(numbers[0])] = socket.socket(fileno=found[0])
                else:
                    for number in numbers:
                        copy = self._copies.pop(int(number), None)
                        if copy is not None:
                            _close(copy)
                self._announced.notify_all()


def _close(channel: socket.socket) -> None:
    """Close a channel, and wake a thread that is reading from it."""
    try:
        channel.shutdown(socket.SHUT_RDWR)
    except OSError:
        pass  # the other end has gone
    channel.close()

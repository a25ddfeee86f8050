"""Chromium for the tests of the panel, without a window: real presses by its debugging pipe."""

from __future__ import annotations

import fcntl
import json
import os
import shutil
import subprocess
import tempfile
import threading
from collections.abc import Iterator
from contextlib import contextmanager
from itertools import count
from time import monotonic, sleep
from typing import Any

import pytest

CHROMIUM = shutil.which("chromium")
needs_chromium = pytest.mark.skipif(CHROMIUM is None, reason="no chromium")
# Seconds after which a test gives up.
PATIENCE = 20.0
OPTIONS = (
    "--headless=new",
    "--no-sandbox",
    "--disable-gpu",
    "--disable-dev-shm-usage",
    "--no-first-run",
    "--remote-debugging-pipe",
)
# The shell gives Chromium the ends of the pipe as 3 and 4, which it expects.
SHELL = 'exec 3<&"$0" 4>&"$1"; shift; exec "$@"'
Point = tuple[float, float]


class Browser:
    """A browser with a profile of its own."""

    def __init__(self, home: str) -> None:
        ends = [fcntl.fcntl(end, fcntl.F_DUPFD, 30) for end in (*os.pipe(), *os.pipe())]
        reads, self._to, self._from, writes = ends
        command = ["bash", "-c", SHELL, str(reads), str(writes), str(CHROMIUM), *OPTIONS]
        self._process = subprocess.Popen(
            [*command, f"--user-data-dir={home}"], pass_fds=(reads, writes), stderr=subprocess.DEVNULL
        )
        os.close(reads)
        os.close(writes)
        self._numbers = count(1)
        self._answers: dict[int, Any] = {}
        self._came = threading.Condition()
        self._thread = threading.Thread(target=self._read, daemon=True)
        self._thread.start()

    def _read(self) -> None:
        rest = b""
        while data := os.read(self._from, 65536):
            *whole, rest = (rest + data).split(b"\0")
            with self._came:
                self._answers |= {each["id"]: each for each in map(json.loads, whole) if "id" in each}
                self._came.notify_all()

    def do(self, method: str, session: str | None = None, **sent: object) -> Any:
        """Return the result of a command, for a tab if its session is given."""
        number = next(self._numbers)
        to = {} if session is None else {"sessionId": session}
        os.write(
            self._to, json.dumps({"id": number, "method": method, "params": sent, **to}).encode() + b"\0"
        )
        with self._came:
            assert self._came.wait_for(lambda: number in self._answers, PATIENCE), method
            answer = self._answers.pop(number)
        assert "result" in answer, answer
        return answer["result"]

    def tab(self, url: str) -> Tab:
        """Open an address in a new tab, which hides the others."""
        return Tab(self, url)

    def end(self) -> None:
        self._process.terminate()
        self._process.wait(PATIENCE)
        self._thread.join(PATIENCE)
        os.close(self._to)
        os.close(self._from)


class Tab:
    """A tab of a browser, with a mouse, fingers and a keyboard."""

    def __init__(self, browser: Browser, url: str) -> None:
        self._browser = browser
        self._target = browser.do("Target.createTarget", url="about:blank")["targetId"]
        attached = browser.do("Target.attachToTarget", targetId=self._target, flatten=True)
        self._session = attached["sessionId"]
        self._at: Point = 0, 0
        self.do("Page.navigate", url=url)

    def do(self, method: str, **sent: object) -> Any:
        return self._browser.do(method, self._session, **sent)

    def js(self, text: str) -> Any:
        """Return the value of an expression, when it is known."""
        found = self.do("Runtime.evaluate", expression=text, awaitPromise=True, returnByValue=True)
        return found["result"].get("value")

    def until(self, text: str) -> Any:
        """Wait until an expression is true, and return its value."""
        end = monotonic() + PATIENCE
        while not (found := self.js(text)):
            assert monotonic() < end, f"{text}\n{self.js('document.body.innerText')}"
            sleep(0.05)
        return found

    def middle(self, words: str) -> Point:
        """Return the middle of the button with these words or this label."""
        found = self.until(
            f"""(() => {{
            const found = [...document.querySelectorAll("button")].find((each) =>
              [each.textContent.trim(), each.getAttribute("aria-label")].includes({json.dumps(words)}));
            found?.scrollIntoView({{ block: "center" }});
            const box = found?.getBoundingClientRect();
            return box && [box.x + box.width / 2, box.y + box.height / 2];
            }})()"""
        )
        return found[0], found[1]

    def mouse(self, kind: str, at: Point | None = None, clicks: int = 1) -> None:
        """Let the mouse act: "Moved", "Pressed" or "Released"; it stays where it is."""
        self._at = at or self._at
        x, y = self._at
        button = {"button": "left", "buttons": 1, "clickCount": clicks} if kind != "Moved" else {}
        self.do("Input.dispatchMouseEvent", type=f"mouse{kind}", x=x, y=y, **button)

    def press(self, words: str) -> None:
        """Press a button with the mouse."""
        self.mouse("Moved", self.middle(words))
        self.mouse("Pressed")

    def click(self, words: str) -> None:
        self.press(words)
        self.mouse("Released")

    def touch(self, kind: str, *fingers: Point) -> None:
        """Let fingers be on the page: "Start", "Move", "End" and "Cancel" are of all."""
        points = [{"x": x, "y": y, "id": k} for k, (x, y) in enumerate(fingers)]
        self.do("Input.dispatchTouchEvent", type=f"touch{kind}", touchPoints=points)

    def key(self, kind: str, name: str = " ") -> None:
        """Let a key go "Down" or "Up"."""
        self.do("Input.dispatchKeyEvent", type=f"key{kind}", key=name, text=name if kind == "Down" else "")

    def close(self) -> None:
        self._browser.do("Target.closeTarget", targetId=self._target)


@contextmanager
def browsing() -> Iterator[Browser]:
    """Run a browser."""
    with tempfile.TemporaryDirectory(ignore_cleanup_errors=True) as home:
        browser = Browser(home)
        try:
            yield browser
        finally:
            browser.end()

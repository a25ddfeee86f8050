"""The processes of a language server, and the limits of what it reads."""

from __future__ import annotations

import asyncio
import io
import signal
import threading
from collections.abc import Callable
from concurrent.futures import BrokenExecutor, Future
from types import SimpleNamespace
from typing import Any

import pytest

from motionlang.kernel import Diagnostic
from motionlang_lsp import features, server, session, workers
from motionlang_lsp.editor.times import NO_TIMES, Times
from motionlang_lsp.jobs import CHECK, TIMES, Job
from motionlang_lsp.server import MessageStream, _Limited
from motionlang_lsp.workers import WorkerProcess
from test_lsp.test_answers import MACHINE, ask, at, span
from test_lsp.test_session import Timed, opened
from test_lsp.wire import URI
from tests.cases import cases


@pytest.mark.parametrize("limit", [-1, 0])
def test_a_text_has_a_largest_size(limit: int, monkeypatch: pytest.MonkeyPatch) -> None:
    """A text of the largest size is examined, and one with a character more is not."""
    text = "Dim n\nn = 1\nPrint n, 1 1\n"
    for module in (session, features):
        monkeypatch.setattr(module, "MAX_TEXT", len(text) + limit)
    found = ask(text)
    names = [each["name"] for each in ask(text, "documentSymbol")]
    if limit < 0:
        message = "the text is too large to be checked as you type\nhint: motionlang check a.mnt checks it"
        assert found == [
            {
                "range": span(0, 0, 1),
                "message": message,
                "severity": 2,
                "code": "limit",
                "source": "motionlang",
            }
        ]
        assert names == []
    else:
        assert [each["code"] for each in found] == ["syntax"]
        assert names == ["n"]


@pytest.mark.parametrize("limit", [-1, 0])
def test_a_machine_file_has_a_largest_size(limit: int, monkeypatch: pytest.MonkeyPatch) -> None:
    text = "[axis.1]\nmotor = "
    for module in (session, features):
        monkeypatch.setattr(module, "MAX_TEXT", len(text) + limit)
    hovered = ask(text, "hover", MACHINE, position=at(1, 2))
    completed = ask(text, "completion", MACHINE, position=at(1, 8))["items"]
    assert (hovered is None, len(completed)) == ((True, 0) if limit < 0 else (False, 2))


@pytest.mark.parametrize("limit", [-1, 0])
def test_a_text_that_is_too_large_has_no_times(limit: int, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(session, "MAX_TEXT", 5 + limit)

    async def whole() -> Any:
        wire = opened("a = 1", Timed())
        area = {"start": at(0, 0), "end": at(0, 0)}
        wire.request(1, "textDocument/inlayHint", {"textDocument": {"uri": URI}, "range": area})
        await wire.settled()
        return wire.answers()[1][0]["result"]

    assert len(asyncio.run(whole())) == 1 + limit


@cases(
    "name, is_one",
    [("a.machine.toml", True), ("machine.toml", True), ("amachine.toml", False), ("a.toml", False)],
)
def test_names_of_machine_files(name: str, is_one: bool) -> None:
    assert session.is_machine_file(name) is is_one


@pytest.mark.parametrize("count", [9, 10, 11, 13, 16])
def test_a_message_that_is_too_large_is_skipped(count: int, monkeypatch: pytest.MonkeyPatch) -> None:
    """Messages have up to 10 bytes here, and larger ones are skipped in chunks of 4."""
    monkeypatch.setattr(server, "MAX_MESSAGE", 10)
    monkeypatch.setattr(server, "_CHUNK", 4)
    body, rest = b"x" * count, b"the next message"
    wanted = body if count <= 10 else b"{}"

    async def limited(data: bytes) -> list[bytes]:
        reader = asyncio.StreamReader(limit=20)
        reader.feed_data(data)
        reader.feed_eof()
        stream = _Limited(reader)
        return [await stream.readexactly(count), await reader.read()]

    stream = io.BytesIO(body + rest)
    assert [MessageStream(stream).read(count), stream.read()] == [wanted, rest]
    assert asyncio.run(limited(body + rest)) == [wanted, rest]
    if count > 10:
        assert MessageStream(io.BytesIO(b"short")).read(count) == b"{}"
        assert asyncio.run(limited(b"short")) == [b"", b""]


JOB = Job(CHECK, "a.mnt", "x = 1\n", "mint", None, "a.machine.toml")


RUN = Job(TIMES, "a.mnt", "WAIT = 500\n", "mint", None, "a.machine.toml")


def test_a_process_does_one_job_after_another_and_is_replaced_if_it_dies(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    """The second job breaks its process, and the fourth takes too long."""
    made: list[int] = []
    ended: list[int] = []
    results: list[Any] = [[], BrokenExecutor(), [], None, []]

    class Workers:
        def __init__(self, count: int) -> None:
            made.append(count)

        def submit(self, action: object, job: Job, limit: float) -> Future[Any]:
            assert (action, job, limit) == (workers._limited, JOB, 3.0)
            future: Future[Any] = Future()
            result = results.pop(0)
            if isinstance(result, Exception):
                future.set_exception(result)
            elif result is not None:
                future.set_result(result)
            return future

        def stop(self) -> None:
            ended.append(len(made))

    async def whole() -> list[Any]:
        process = WorkerProcess(0.0 if not results else 0.01, 3.0)
        found = [await process.do(JOB) for _ in range(5)]
        process.stop()
        process.stop()
        return found

    monkeypatch.setattr("motionlang.processes.workers.Workers", Workers)
    assert asyncio.run(whole()) == [[], None, [], None, []]
    assert (made, ended) == ([1, 1, 1], [1, 2, 3])


def test_a_run_is_interrupted_after_a_while_and_a_check_is_not(monkeypatch: pytest.MonkeyPatch) -> None:
    timers: list[Any] = []
    handlers: list[tuple[int, object]] = []

    def timer(limit: float, action: Callable[[], None]) -> Any:
        timers.append(SimpleNamespace(limit=limit, calls=[]))
        made = timers[-1]
        for name in ("start", "cancel", "join"):
            setattr(made, name, lambda name=name: made.calls.append(name))
        return made

    monkeypatch.setattr(workers, "_silence", lambda: None)
    monkeypatch.setattr(threading, "Timer", timer)
    monkeypatch.setattr(signal, "signal", lambda *given: handlers.append(given))
    found = workers._limited(JOB, 2.5)
    assert isinstance(found, list)
    assert ([each.code for each in found], timers) == (["unused-variable"], [])
    found = workers._limited(RUN, 2.5)
    assert isinstance(found, Times)
    assert [each.line for each in found.lines] == [1]
    monkeypatch.setattr(workers, "work", interrupted)
    assert workers._limited(RUN, 2.5) is NO_TIMES
    for each in timers:
        assert (each.limit, each.daemon, each.calls) == (2.5, True, ["start", "cancel", "join"])
    assert handlers == [(signal.SIGINT, signal.default_int_handler), (signal.SIGINT, signal.SIG_IGN)] * 2


def interrupted(job: Job) -> list[Diagnostic]:
    raise KeyboardInterrupt


def test_a_process_is_detached_from_the_streams_once(monkeypatch: pytest.MonkeyPatch) -> None:
    replaced: list[int] = []
    fake = SimpleNamespace()
    monkeypatch.setattr(workers, "sys", fake)
    monkeypatch.setattr("os.dup2", lambda null, number: replaced.append(number))
    for _ in range(2):
        workers._silence()
    assert (replaced, fake._motionlang_silent) == ([0, 1], True)

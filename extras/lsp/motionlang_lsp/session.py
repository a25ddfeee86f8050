"""The open texts of one editor, with their names, diagnostics and times.

Typing costs little: the worker finds names and checks the text when the user pauses. It does one job at a time. The
result of a check or a run is dropped if the text has changed in the meantime.

A request that a user waits for while typing is answered at once, by `page`: from the latest names, with their positions
moved by the changes since. `named` waits for the names of the present text.
"""

from __future__ import annotations

import asyncio
import os
from collections.abc import Callable, Coroutine
from typing import Any, Protocol

from lsprotocol import types
from pygls.exceptions import JsonRpcContentModified
from pygls.uris import to_fs_path

from motionlang.kernel import MACHINE_SUFFIX, Diagnostic, Dialect, Source, dialect, dialect_of, dialects
from motionlang.kernel.lang import NO_NAMES, Changes, Names
from motionlang_lsp.documents import OpenDocument
from motionlang_lsp.editor.diagnostics import settings_of
from motionlang_lsp.editor.page import Page
from motionlang_lsp.editor.times import NO_TIMES, Times
from motionlang_lsp.jobs import CHECK, NAMES, TIMES, Job, Result


class Worker(Protocol):
    """Carries out the jobs of a server."""

    async def do(self, job: Job) -> Result | None: ...
    def stop(self) -> None: ...


# Seconds without a key after which typing has paused.
PAUSE = 0.2
# Characters of the largest text that is examined; a program of 10 000 lines has about 300 000.
MAX_TEXT = 2_000_000


class Known:
    """The state of one open text; `checked` is the version of `found`."""

    __slots__ = (
        "changes", "checked", "document", "found", "language", "names", "naming", "page", "pause", "since", "times",
    )  # fmt: skip

    def __init__(self, document: OpenDocument, language: Dialect | None) -> None:
        self.document, self.language = document, language
        self.page: Page | None = None
        # The names of the latest text in which they were found, and its changes since.
        self.names, self.changes = NO_NAMES, Changes(len(document.text))
        # The changes of each text since the search for its names began, until they are found.
        self.since: list[Changes] = []
        # The search for the names of the present text.
        self.naming: asyncio.Task[None] | None = None
        self.found: list[Diagnostic] = []
        self.checked = -1
        self.times: asyncio.Task[Times | None] | None = None
        self.pause: asyncio.TimerHandle | None = None


class OpenTexts:
    """All open texts.

    `publish` is called with the diagnostics of a text, and `log` with a message for the editor's log.
    """

    def __init__(
        self,
        worker: Worker,
        publish: Callable[[OpenDocument, list[Diagnostic]], None],
        log: Callable[[str], None],
    ) -> None:
        self._worker, self._publish, self._log = worker, publish, log
        self._known: dict[str, Known] = {}
        self._lock: asyncio.Lock | None = None
        self._tasks: set[asyncio.Task[Any]] = set()

    # ---------------------------------------------------------------------------------------- documents

    def open(self, item: types.TextDocumentItem) -> None:
        """Store an opened text; an earlier one with the same URI is replaced."""
        self.close(item.uri)
        document = OpenDocument(item.uri, item.text, item.version)
        name = document.name
        language = dialect_of(name)
        if language is None and item.language_id in dialects():
            language = dialect(item.language_id)
        if language is None and not is_machine_file(name):
            return
        self._known[item.uri] = Known(document, language)
        self._changed(self._known[item.uri], 0.0)

    def change(self, params: types.DidChangeTextDocumentParams) -> None:
        """Change an open text; ignore changes of any other."""
        known = self._known.get(params.text_document.uri)
        if known is not None:
            made = known.document.change(params.content_changes, params.text_document.version)
            for at, removed, added in made:
                for changes in (known.changes, *known.since):
                    changes.add(at, removed, added)
            self._changed(known, PAUSE)

    def close(self, uri: str) -> None:
        """Remove a text and withdraw its diagnostics."""
        known = self._known.pop(uri, None)
        if known is None:
            return
        if known.pause is not None:
            known.pause.cancel()
        if known.times is not None:
            known.times.cancel()
        self._publish(known.document, [])

    def stop(self) -> None:
        """Remove all texts and end the worker."""
        for known in self._known.values():
            if known.pause is not None:
                known.pause.cancel()
        for task in self._tasks:
            task.cancel()
        self._known.clear()
        self._worker.stop()

    def known(self, uri: str) -> Known | None:
        """Return the state of a text, None if it is not open."""
        return self._known.get(uri)

    def page(self, known: Known) -> Page | None:
        """Return the page of a text, None for a machine file or a very large text.

        Its names are the latest ones, with positions in the present text.
        """
        if known.language is None or len(known.document.text) > MAX_TEXT:
            return None
        if known.page is None or known.page.source is not known.document.source:
            name, text = self._machine_of(known.document.uri)
            settings = settings_of(Source(name, text), known.language)[0] if text is not None else {}
            names = known.names.shifted(known.changes) if known.changes else known.names
            known.page = Page(known.document.source, known.language, settings, names)
        return known.page

    async def named(self, known: Known, source: Source) -> Page | None:
        """Return the page of a text with its own names, None for a machine file or a very large text.

        Raises JsonRpcContentModified if `source` is no longer the text, now or when its names are found.
        """
        if self._is_current(known, source) and self.page(known) is not None:
            if known.naming is None:
                known.naming = self._start(self._find_names(known))
            await asyncio.shield(known.naming)
        if not self._is_current(known, source):
            raise JsonRpcContentModified("the text has changed")
        return self.page(known)

    async def _find_names(self, known: Known) -> None:
        since = Changes(len(known.document.text))
        known.since.append(since)
        found = await self._do(NAMES, known)
        known.since.remove(since)
        if isinstance(found, Names):
            known.names, known.changes, known.page = found, since, None

    def machine_changed(self) -> None:
        """Check all programs again, because a machine file has changed."""
        for known in self._known.values():
            if known.language is not None:
                known.page = None
                self._changed(known, PAUSE)

    # ---------------------------------------------------------------------------------------- the worker

    def _changed(self, known: Known, delay: float) -> None:
        known.checked, known.naming = -1, None
        if known.times is not None:
            known.times.cancel()
            known.times = None
        if known.pause is not None:
            known.pause.cancel()
        known.pause = asyncio.get_running_loop().call_later(delay, self._paused, known)
        if known.language is None and delay:
            self.machine_changed()

    def _paused(self, known: Known) -> None:
        known.pause = None
        if known.naming is None and self.page(known) is not None:
            known.naming = self._start(self._find_names(known))
        self._start(self._check(known))

    def _start(self, coroutine: Coroutine[Any, Any, Any]) -> asyncio.Task[Any]:
        task = asyncio.get_running_loop().create_task(coroutine)
        self._tasks.add(task)
        task.add_done_callback(self._tasks.discard)
        return task

    async def _check(self, known: Known) -> None:
        source = known.document.source
        result: Result | None = None
        if len(source.text) <= MAX_TEXT:
            # A worker that died has no result; the next one may have.
            result = await self._do(CHECK, known)
            if result is None and self._is_current(known, source):
                result = await self._do(CHECK, known)
        if not self._is_current(known, source):
            return
        if not isinstance(result, list):
            message = "the text is too large to be checked as you type"
            hint = f"motionlang check {known.document.name} checks it"
            result = [Diagnostic("limit", message, 1, 1, hint=hint, severity="warning")]
        known.found, known.checked = result, known.document.version
        self._publish(known.document, result)

    async def times(self, known: Known) -> Times | None:
        """Return the times of the lines of the present text, None if it has changed."""
        if known.language is None or len(known.document.text) > MAX_TEXT:
            return None
        if known.times is None:
            known.times = self._start(self._times(known))
        return await asyncio.shield(known.times)

    async def _times(self, known: Known) -> Times | None:
        source = known.document.source
        result = await self._do(TIMES, known)
        return result if isinstance(result, Times) and self._is_current(known, source) else None

    async def _do(self, what: str, known: Known) -> Result | None:
        """Carry out a job on the current text and return its result.

        None if the text changes before the job begins.
        """
        source = known.document.source
        if self._lock is None:
            self._lock = asyncio.Lock()
        async with self._lock:
            if not self._is_current(known, source):
                return None
            name, text = self._machine_of(known.document.uri)
            language = known.language.name if known.language is not None else ""
            job = Job(what, source.name, source.text, language, text, name)
            try:
                return await self._worker.do(job)
            except Exception as error:  # of the check or of the run, not of this server
                return self._failed(job, error)

    def _failed(self, job: Job, error: Exception) -> Result:
        """Return the result of a job with an internal error: a diagnostic, or no names or times."""
        why = f"internal error: {type(error).__name__}: {error}".partition("\n")[0]
        if job.what == CHECK:
            message = f"{job.name} cannot be checked: {why}"
            return [Diagnostic("crash", message, 1, 1, hint=f"motionlang check {job.name} shows the details")]
        if job.what == NAMES:
            self._log(f"{job.name} has no names: {why}; motionlang check {job.name} shows the details")
            return NO_NAMES
        self._log(f"{job.name} has no time hints: {why}; motionlang run {job.name} shows the details")
        return NO_TIMES

    def _is_current(self, known: Known, source: Source) -> bool:
        return self._known.get(known.document.uri) is known and known.document.source is source

    # ------------------------------------------------------------------------------------ machine files

    def _machine_of(self, uri: str) -> tuple[str, str | None]:
        """Return name and text of the machine file next to a program.

        The text is None if there is no such file.
        """
        machine = os.path.splitext(uri)[0] + MACHINE_SUFFIX
        name = machine.rpartition("/")[2]
        known = self._known.get(machine)
        if known is not None:
            return name, known.document.source.text
        path = to_fs_path(machine)
        if path is None or not os.path.isfile(path):
            return name, None
        try:
            return name, Source.read(path).text
        except OSError:
            return name, None


def is_machine_file(name: str) -> bool:
    """True if a file name is that of a machine file."""
    return name.endswith(MACHINE_SUFFIX) or name == MACHINE_SUFFIX[1:]

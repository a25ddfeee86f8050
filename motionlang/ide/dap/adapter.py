"""The adapter: one session of one client, its requests, responses and events.

Requests are handled one after another in the thread that reads them. Commands that let the program run are passed to
a worker thread, so that `pause` and `disconnect` can be handled in the meantime; the phase is RUNNING until the worker
reports a stop. `tables.py` lists in which phase each request is valid. Every request gets a response, even an invalid
one.
"""

from __future__ import annotations

import threading
from collections.abc import Callable
from queue import SimpleQueue

from motionlang.ide.dap import tables
from motionlang.ide.dap.arguments import Arguments, RequestRefused
from motionlang.ide.dap.breaking import Breaking
from motionlang.ide.dap.framing import Message
from motionlang.ide.dap.launch import Launch, problems
from motionlang.ide.dap.showing import Showing
from motionlang.ide.dap.tables import (
    CONFIGURING,
    ENDED,
    NEED_A_STOP,
    NEW,
    PHASES,
    READS,
    READY,
    RUNNING,
    STOPPED,
)
from motionlang.ide.debug.debugger import Debugger, NotStopped, Stop
from motionlang.ide.debug.destinations import destination
from motionlang.ide.debug.expressions import WrongExpression
from motionlang.kernel import ProgramError, WrongEntry, entries

Body = dict[str, object]

# What the protocol calls our reasons for a stop.
_REASONS = {"moment": "function breakpoint", "change": "data breakpoint", "start": "entry", "end": "step"}
# How long the end of a session waits for the program, s.
PATIENCE = 5.0
_CONSOLE_HELP = """\
.input 5=1    an input, as in --input       .goto 2.5      go to a time, s
.analog 0=25  an analogue input             .goto line 12  go to the next time that a line begins
.keys R       keys of the operator          .changed NAME  go back to the last change of a variable,
.help         this list                                    of output 2, input 5 or axis 0
n = 5         change a variable             n == 5         compare; any other expression shows its value
"""
_COMMANDS = (".input", ".analog", ".keys", ".goto", ".changed", ".help")


class Adapter:
    """One session; `send` writes a message to the client."""

    def __init__(self, send: Callable[[Message], None]) -> None:
        self._write = send
        self._lock = threading.Lock()
        self._seq = 0
        self.phase = NEW
        self.is_over = False
        self._reports_progress = False
        # The progress report that is open, and how many there have been.
        self._progress_id, self._reports = "", 0
        self._launch: Launch
        self._debugger: Debugger
        self._breaking: Breaking
        self._showing: Showing
        self._work: SimpleQueue[Callable[[], Stop | None] | None] = SimpleQueue()
        self._worker: threading.Thread | None = None
        self._idle = threading.Event()
        self._idle.set()
        # The answers to INPUT, and a flag that is set while the program waits for one.
        self._answers: SimpleQueue[str | None] = SimpleQueue()
        self._asking = False
        self._after: list[Callable[[], None]] = []

    # ---------------------------------------------------------------------------------------------- messages

    def _send(self, message: Message) -> None:
        with self._lock:
            self._seq += 1
            self._write({"seq": self._seq, **message})

    def event(self, name: str, body: Body | None = None) -> None:
        """Send an event."""
        self._send({"type": "event", "event": name, **({} if body is None else {"body": body})})

    def output(self, text: str, category: str = "stdout") -> None:
        """Send text for the client's console."""
        self.event("output", {"category": category, "output": text})

    def handle(self, message: Message) -> None:
        """Handle one message; every request gets one response."""
        if message.get("type") != "request":
            return  # the adapter sends no requests, so no response can be for it
        command, seq = message.get("command"), message.get("seq")
        number = seq if isinstance(seq, int) and not isinstance(seq, bool) else 0
        name = command if isinstance(command, str) else ""
        response: Message = {"type": "response", "request_seq": number, "command": name, "success": True}
        try:
            body = self._dispatch(name, message.get("arguments"))
            if body is not None:
                response["body"] = body
        except RequestRefused as refused:
            response |= _failure(name, str(refused), refused.code)
        except NotStopped:
            response |= _failure(name, "the program is not stopped", "notStopped")
        except ProgramError as error:
            response |= _failure(name, problems(error))
        except (WrongExpression, WrongEntry, ValueError) as error:
            response |= _failure(name, str(error))
        except Exception as error:  # a client must not end the session of the user
            response |= _failure(name, f"internal error: {type(error).__name__}: {error}")
        self._send(response)
        self._start_after()

    def _start_after(self) -> None:
        """Do the work that must follow the response."""
        after, self._after = self._after, []
        for each in after:
            each()

    def _dispatch(self, name: str, given: object) -> Body | None:
        phases = PHASES.get(name)
        if phases is None:
            raise RequestRefused(f"there is no request {name[:60]!r}")
        if self.is_over:
            raise RequestRefused("the session is over")
        if self.phase not in phases:
            if name in NEED_A_STOP and self.phase == RUNNING:
                raise NotStopped
            raise RequestRefused(f"{name} is not possible now: the session is {self.phase}")
        handler: Callable[[Arguments], Body | None] = getattr(self, f"_do_{name}")
        return handler(Arguments(given))

    # ----------------------------------------------------------------------------------------------- session

    def _do_initialize(self, given: Arguments) -> Body:
        self._lines_at_1 = given.flag("linesStartAt1", True)
        self._columns_at_1 = given.flag("columnsStartAt1", True)
        self._reports_progress = given.flag("supportsProgressReporting")
        self.phase = READY
        return dict(tables.CAPABILITIES)

    def _do_launch(self, given: Arguments) -> None:
        launch = Launch(given)
        source, language, settings = launch.read()
        debugger = Debugger(
            source, language, settings,
            overrides=launch.overrides, until=launch.until,
            show=self.output, log_message=lambda text: self.output(f"{text}\n", "console"), ask=self._ask,
        )  # fmt: skip
        debugger.progress = self._progress
        self._launch, self._debugger = launch, debugger
        self._breaking = Breaking(debugger, launch.path, int(self._lines_at_1))
        self._showing = Showing(debugger, launch.path, int(self._lines_at_1), int(self._columns_at_1))
        self.phase = CONFIGURING
        self._after.append(lambda: self.event("initialized"))

    def _do_configurationDone(self, given: Arguments) -> None:  # noqa: N802 - a name of the protocol
        launch = self._launch
        stops = launch.stop_on_entry
        self._go(lambda: self._debugger.start(stops))

    def _do_restart(self, given: Arguments) -> None:
        debugger = self._debugger
        source = self._launch.read()[0]
        # Checked before the response, so that errors are its text.
        debugger.language.program(source, self._launch.settings, is_debug=True).require()
        self._go(lambda: debugger.restart(source))

    def _do_terminate(self, given: Arguments) -> None:
        if self.phase in (NEW, READY):
            return
        self._end()
        self._after.append(self._finished)

    def _finished(self) -> None:
        if self.phase != ENDED:
            self.phase = ENDED
            self.event("terminated")

    def _do_disconnect(self, given: Arguments) -> None:
        self.close()

    def _do_cancel(self, given: Arguments) -> None:
        """Pause what runs, unless a request is cancelled: all have been answered.

        An editor cancels requests that it no longer needs, such as `variables` when the program continues.
        """
        if self.phase == RUNNING and not given.number("requestId", 0):
            self._debugger.pause()

    def close(self) -> None:
        """End the session, even during a run."""
        self.is_over = True
        if self.phase not in (NEW, READY):
            self._end()
        if self._worker is not None:
            self._work.put(None)

    def _end(self) -> None:
        self._answers.put(None)
        if self.phase == RUNNING:
            self._debugger.pause()
            if not self._idle.wait(PATIENCE):
                return  # its thread ends with the process
        self._debugger.abandon()

    # -------------------------------------------------------------------------------------------------- runs

    def _go(self, command: Callable[[], Stop | None]) -> None:
        """Let the worker carry out a command after the response has been sent."""
        self.phase = RUNNING
        self._showing.forget()
        self._idle.clear()
        if self._worker is None:
            self._worker = threading.Thread(target=self._run, name="worker", daemon=True)
            self._worker.start()
        self._after.append(lambda: self._work.put(command))

    def _run(self) -> None:
        """Carry out commands, one after another, in the worker thread."""
        while (command := self._work.get()) is not None:
            try:
                stop = command()
            except Exception as error:
                self._idle.set()
                if not self.is_over:
                    self.output(f"internal error: {type(error).__name__}: {error}\n", "stderr")
                    self._finished()
                continue
            self._end_progress()
            self._idle.set()
            if not self.is_over:
                self._report(stop)

    # ---------------------------------------------------------------------------------------------- progress

    def _progress(self, fraction: float) -> None:
        """Report the completed fraction of a replay."""
        if not self._reports_progress or self.phase != RUNNING:
            return
        if not self._progress_id:
            self._reports += 1
            self._progress_id = f"replay {self._reports}"
            body: Body = {"progressId": self._progress_id, "title": "Running again", "cancellable": True}
            self.event("progressStart", body)
        self.event("progressUpdate", {"progressId": self._progress_id, "percentage": round(100 * fraction)})

    def _end_progress(self) -> None:
        if self._progress_id:
            ended, self._progress_id = self._progress_id, ""
            self.event("progressEnd", {"progressId": ended})

    def _report(self, stop: Stop | None) -> None:
        if self.phase == ENDED:
            return
        for text in self._debugger.problems():
            self.output(f"{text}\n", "stderr")
        if stop is None:
            self._report_end()
            return
        self._report_stop(_REASONS.get(stop.reason, stop.reason), self._showing.number(stop.task), stop.text)

    def _report_stop(self, reason: str, thread: int, text: str) -> None:
        self.phase = STOPPED
        body: Body = {"reason": reason, "threadId": thread, "allThreadsStopped": True}
        if text:
            body |= {"description": text, "text": text}
        self.event("stopped", body)

    def _report_end(self) -> None:
        for text in self._launch.summary(self._debugger):
            self.output(text, "console")
        if self._launch.stop_at_end:
            self._report_stop("step", 1, "the program has ended; step back, or continue to finish")
            return
        run = self._debugger.run
        self.phase = ENDED
        self.event(
            "exited",
            {"exitCode": 0 if run is not None and run.status in ("ended", "until", "stopped") else 1},
        )
        self.event("terminated")

    def _ask(self, prompt: str) -> str | None:
        """Return the line that the user types in the console for an INPUT."""
        if self.is_over:
            return None
        self._asking = True
        self.output("INPUT waits for a line: type it in the debug console\n", "console")
        try:
            return self._answers.get()
        finally:
            self._asking = False

    def _do_continue(self, given: Arguments) -> Body:
        if self._debugger.run is not None:
            self._after.append(self._finished)
        else:
            self._go(self._debugger.go_on)
        return {"allThreadsContinued": True}

    def _step(self, command: Callable[[], Stop | None]) -> None:
        if self._debugger.run is not None:
            self._after.append(self._finished)
        else:
            self._go(command)

    def _do_next(self, given: Arguments) -> None:
        self._step(self._debugger.next)

    def _do_stepIn(self, given: Arguments) -> None:  # noqa: N802 - a name of the protocol
        self._step(self._debugger.step_in)

    def _do_stepOut(self, given: Arguments) -> None:  # noqa: N802 - a name of the protocol
        self._step(self._debugger.step_out)

    def _do_stepBack(self, given: Arguments) -> None:  # noqa: N802 - a name of the protocol
        self._go(self._debugger.step_back)

    def _do_reverseContinue(self, given: Arguments) -> None:  # noqa: N802 - a name of the protocol
        self._go(self._debugger.reverse)

    def _do_gotoTargets(self, given: Arguments) -> Body:  # noqa: N802 - a name of the protocol
        return {"targets": self._breaking.targets(given)}

    def _do_goto(self, given: Arguments) -> None:
        line, goes_back = divmod(given.number("targetId"), 2)
        if self._debugger.line_for(line) != line:
            raise RequestRefused(f"there is no target {given.number('targetId')}")
        debugger = self._debugger
        self._go(lambda: debugger.go_back_to_line(line) if goes_back else debugger.go_to_line(line))

    def _do_completions(self, given: Arguments) -> Body:
        found = [] if self.phase == RUNNING else self._showing.completions(given, _COMMANDS)
        return {"targets": found}

    def _do_pause(self, given: Arguments) -> None:
        if self.phase == RUNNING:
            self._debugger.pause()

    # ------------------------------------------------------------------------------------------- breakpoints

    def _do_setBreakpoints(self, given: Arguments) -> Body:  # noqa: N802 - a name of the protocol
        return {"breakpoints": self._breaking.lines(given)}

    def _do_setFunctionBreakpoints(self, given: Arguments) -> Body:  # noqa: N802 - a name of the protocol
        return {"breakpoints": self._breaking.motion(given)}

    def _do_setExceptionBreakpoints(self, given: Arguments) -> Body:  # noqa: N802 - a name of the protocol
        return {"breakpoints": self._breaking.filters(given)}

    def _do_setDataBreakpoints(self, given: Arguments) -> Body:  # noqa: N802 - a name of the protocol
        return {"breakpoints": self._breaking.data(given)}

    def _do_dataBreakpointInfo(self, given: Arguments) -> Body:  # noqa: N802 - a name of the protocol
        return self._showing.data_of(given)

    def _do_breakpointLocations(self, given: Arguments) -> Body:  # noqa: N802 - a name of the protocol
        return {"breakpoints": self._breaking.locations(given)}

    # ------------------------------------------------------------------------------------------------- state

    def _do_threads(self, given: Arguments) -> Body:
        return {"threads": self._showing.threads(self.phase == STOPPED)}

    def _do_stackTrace(self, given: Arguments) -> Body:  # noqa: N802 - a name of the protocol
        return self._showing.stack(given)

    def _do_scopes(self, given: Arguments) -> Body:
        return {"scopes": self._showing.scopes(given)}

    def _do_variables(self, given: Arguments) -> Body:
        return {"variables": self._showing.variables(given)}

    def _do_setVariable(self, given: Arguments) -> Body:  # noqa: N802 - a name of the protocol
        return self._showing.set_variable(given)

    def _do_setExpression(self, given: Arguments) -> Body:  # noqa: N802 - a name of the protocol
        return self._showing.set_expression(given)

    def _do_exceptionInfo(self, given: Arguments) -> Body:  # noqa: N802 - a name of the protocol
        stop = self._debugger.stop
        text = "" if stop is None else stop.text
        return {"exceptionId": text or "none", "description": text, "breakMode": "always"}

    def _do_evaluate(self, given: Arguments) -> Body:
        text = given.text("expression")
        in_console = given.text("context", "") == "repl"
        if self._asking and in_console:
            self._answers.put(text)
            return {"result": "", "variablesReference": 0}
        if self.phase == RUNNING:
            raise NotStopped
        if text.lstrip().startswith("."):
            return {"result": self._obey(text.strip()), "variablesReference": 0}
        return self._showing.carry_out(text) if in_console else self._showing.evaluate(text)

    def _obey(self, line: str) -> str:
        """Carry out a dot command of the console."""
        word, _, rest = line[1:].partition(" ")
        names = {"input": "inputs", "analog": "analog", "keys": "keys"}
        if word in names and rest.strip():
            self._debugger.enter(entries(self._launch.settings, **{names[word]: rest.strip()}))
            return ""
        if word == "goto":
            self._go(destination(self._debugger, rest))
            return ""
        if word == "changed" and rest.strip():
            path = self._showing.path_of(rest.strip())
            self._go(lambda: self._debugger.last_change(path))
            return ""
        if word == "help":
            return _CONSOLE_HELP
        raise RequestRefused(f"there is no command .{word[:40]} with these values; .help lists the commands")


def _failure(command: str, text: str, code: str = "") -> Message:
    """Return the fields of an error response.

    Requests that the client makes on its own open no message box.
    """
    plain = text.replace("{", "(").replace("}", ")")
    error = {"id": 1, "format": plain, "showUser": command not in READS}
    return {"success": False, "message": code or text, "body": {"error": error}}

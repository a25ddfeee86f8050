"""The capabilities of the adapter, and the phases in which each request is valid.

new            before initialize
ready          initialized, no program
configuring    launched; breakpoints are set, the program has not begun
running        the program or a replay runs
stopped        before a statement, or at the end of the program
ended          the program has ended and the client has been informed
"""

from __future__ import annotations

from motionlang.ide.debug.moments import FILTERS

CAPABILITIES: dict[str, object] = {
    "supportsConfigurationDoneRequest": True,
    "supportsFunctionBreakpoints": True,
    "supportsConditionalBreakpoints": True,
    "supportsHitConditionalBreakpoints": True,
    "supportsLogPoints": True,
    "supportsEvaluateForHovers": True,
    "supportsStepBack": True,
    "supportsSetVariable": True,
    "supportsSetExpression": True,
    "supportsRestartRequest": True,
    "supportsDataBreakpoints": True,
    "supportsBreakpointLocationsRequest": True,
    "supportsExceptionInfoRequest": True,
    "supportsGotoTargetsRequest": True,
    "supportsCompletionsRequest": True,
    "completionTriggerCharacters": ["."],
    "supportsTerminateRequest": True,
    "supportsCancelRequest": True,
    "exceptionBreakpointFilters": [
        {"filter": name, "label": label, "default": name == "error"} for name, (label, _) in FILTERS.items()
    ],
}

NEW, READY, CONFIGURING = "new", "ready", "configuring"
RUNNING, STOPPED, ENDED = "running", "stopped", "ended"
_LOADED = frozenset((CONFIGURING, RUNNING, STOPPED, ENDED))
_STOPPED = frozenset((STOPPED,))
_ALWAYS = frozenset((NEW, READY)) | _LOADED
# The phases in which each request is valid; all others are unknown.
PHASES: dict[str, frozenset[str]] = {
    "initialize": frozenset((NEW,)),
    "launch": frozenset((READY,)),
    "configurationDone": frozenset((CONFIGURING,)),
    "setBreakpoints": _LOADED,
    "setFunctionBreakpoints": _LOADED,
    "setExceptionBreakpoints": _LOADED,
    "setDataBreakpoints": _LOADED,
    "dataBreakpointInfo": _STOPPED,
    "breakpointLocations": _LOADED,
    "threads": _LOADED,
    "stackTrace": _STOPPED,
    "scopes": _STOPPED,
    "variables": _STOPPED,
    "setVariable": _STOPPED,
    "setExpression": _STOPPED,
    "evaluate": frozenset((RUNNING, STOPPED)),
    "completions": frozenset((RUNNING, STOPPED)),
    "exceptionInfo": _STOPPED,
    "gotoTargets": _STOPPED,
    "goto": _STOPPED,
    "continue": _STOPPED,
    "next": _STOPPED,
    "stepIn": _STOPPED,
    "stepOut": _STOPPED,
    "stepBack": _STOPPED,
    "reverseContinue": _STOPPED,
    "pause": frozenset((RUNNING, STOPPED)),
    "restart": _STOPPED,
    "cancel": _ALWAYS,
    "terminate": _ALWAYS,
    "disconnect": _ALWAYS,
}
# Requests that need a stop; in other phases the protocol has a code for that.
NEED_A_STOP = frozenset(name for name, phases in PHASES.items() if phases == _STOPPED)
# Requests that a client makes on its own to show the state; it may send one just when the program goes on.
READS = frozenset(
    (
        "threads",
        "stackTrace",
        "scopes",
        "variables",
        "evaluate",
        "exceptionInfo",
        "breakpointLocations",
        "completions",
    )
)

"""A host that calls every method of PMC's Python binding.

It is run by `motionlang mcapi run` and prints a JSON object: the result of each method, or the name of its
exception.
"""

from __future__ import annotations

import inspect
import json
from ctypes import c_double, c_uint, create_string_buffer
from typing import Any

from yaqd_pmc import mcapi  # type: ignore[import-untyped]

host: Any = mcapi.Mcapi()
assert host.Open(0, mcapi.MC_OPEN_BINARY) > 0

# An argument for each name, and for some methods their own.
BY_NAME: dict[str, Any] = {
    "axis": 1,
    "axiscfg": mcapi.MCAXISCONFIG(),
    "commutation": mcapi.MCCOMMUTATION(),
    "contour": mcapi.MCCONTOUR(),
    "filter": mcapi.MCFILTEREX(),
    "jog": mcapi.MCJOGEX(),
    "motion": mcapi.MCMOTIONEX(),
    "param": mcapi.MCPARAMEX(),
    "scale": mcapi.MCSCALE(),
    "status": 8,
    "type": mcapi.MC_TYPE_LONG,
    "arg_type": mcapi.MC_TYPE_LONG,
    "rpy_type": mcapi.MC_TYPE_LONG,
    "buffer": create_string_buffer(64),
    "values": (c_double * 2)(),
    "coeff": (c_double * 2)(),
    "varname": b"STATUS",
    "address": c_uint(0),
}
OWN: dict[str, tuple[Any, ...]] = {
    "ArcCenter": (1, 0, 5.0),
    "BlockBegin": (mcapi.MC_BLOCK_CANCEL, 0),
    "CaptureData": (1, 20, 0.001, 0.0),
    "DecodeStatusEx": (mcapi.MCSTATUSEX(), 3),
    "GetCaptureData": (1, mcapi.MC_CAPTURE_ACTUAL, 0, 1),
    "GoEx": (1, 0.0),
    "GetCount": (1, mcapi.MC_COUNT_CONTOUR),
    "GetStatusEx": (1, mcapi.MCSTATUSEX()),
    "EnableBacklash": (1, 0.0, 0),
    "EnableGearing": (2, 1, 1.0, 0),
    "LearnPoint": (1, 1, 1),
    "SetModuleOutputMode": (1, 0),
    "SetOperatingMode": (1, 0, mcapi.MC_MODE_POSITION),
    "SetProfile": (1, mcapi.MC_PROF_TRAPEZOID),
    "SetVelocityOverride": (1, 1.0),
    "WaitForDigitalIO": (1, 0),
    "WaitForEdge": (1, 0),
    "pmccmdex": (0, 253, 0, mcapi.MC_TYPE_NONE),
    "pmcputs": (b"1TP\r",),
}
# They wait for what never comes, so they give up; and the board is left as it was.
WAITS = ("FindAuxEncIdx", "FindEdge", "FindIndex", "WaitForIndex", "WaitForPosition", "WaitForRelative")
LAST = ("Reset", "Reopen", "Close")


def called(name: str) -> Any:
    """Return the result of a method, or the name of the exception that it raises."""
    method = getattr(host, name)
    names = list(inspect.signature(method).parameters)
    given = OWN.get(name) or tuple(BY_NAME.get(each, 1) for each in names)
    try:
        return method(*given)
    except mcapi.McapiException as error:
        host.GetError()
        return f"error {error.msg}"
    except Exception as error:
        return f"{type(error).__name__}"


results = {}
host.EnableAxis(1, True)
methods = [name for name, _ in inspect.getmembers(host, inspect.ismethod) if not name.startswith("_")]
for name in [each for each in methods if each not in (*WAITS, *LAST, "Open", "ProcessException")]:
    results[name] = called(name)
host.SetTimeoutEx(0.01)
for name in (*WAITS, *LAST):
    results[name] = called(name)
    results[name] = results[name] if isinstance(results[name], (int, float, str, list, tuple)) else None
print(
    json.dumps(
        {name: value if isinstance(value, (int, float, str)) else None for name, value in results.items()}
    )
)

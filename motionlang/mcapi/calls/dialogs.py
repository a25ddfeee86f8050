"""Save and restore an axis, download a file: MCDLG's functions without dialogs.

The file has a section for each axis, such as `[Axis 1]`, with lines of `name = value`. Numbers are written so
that they are read back exactly. The host's library reads and writes the file; here it is a text.
"""

from __future__ import annotations

from motionlang.mcapi import constants as mc
from motionlang.mcapi.calls.motion import PROFILES
from motionlang.mcapi.calls.settings import (
    LIMITS,
    SETTINGS,
    get_limits,
    only_known,
    profile,
    put_limits,
    scale,
    set_scale,
)
from motionlang.mcapi.command import command, lacks
from motionlang.mcapi.errors import Refused
from motionlang.mcapi.registry import at_once, commands, query
from motionlang.mcapi.table import STRUCTURES
from motionlang.mccl.resolve.line import Line, lines_of
from motionlang.source import Source

TYPE_CHECKING = False
if TYPE_CHECKING:
    from motionlang.mcapi.call import Call
    from motionlang.mcapi.interface import Interface
    from motionlang.mcapi.session import Session
    from motionlang.mccl.resolve.command import Command

# Flags that leave a group out.
NO_MOTION, NO_FILTER, NO_PHASE, NO_POSITION, NO_SCALE, NO_PROFILE = 2, 4, 8, 16, 32, 512
_SCALE = [field.name for field in STRUCTURES["MCSCALE"].values]
_MOTION = [field.name for field in STRUCTURES["MCMOTIONEX"].values if field.name not in LIMITS]
_FILTER = [
    field.name
    for field in STRUCTURES["MCFILTEREX"].values
    if field.name not in ("PositionDeadband", "DelayAtTarget")
]


@query("MCDLG_SaveAxis")
def save(interface: Interface, axis: int, iFlags: int) -> str:  # noqa: N803
    """Return the settings of an axis, or of all, as a text."""
    board = interface.board
    return "\n".join(_section(interface, number, iFlags) for number in ([axis] if axis else board.numbers))


def _section(interface: Interface, axis: int, flags: int) -> str:
    """Return the settings of an axis."""
    board, state = interface.board, interface.board.axis(axis)
    found: dict[str, float] = {}
    if not flags & NO_SCALE:
        found |= zip(_SCALE, scale(interface, axis), strict=True)
    if not flags & NO_MOTION:
        found |= {name: SETTINGS[name][0](board, state) for name in _MOTION}
        found |= zip(LIMITS, get_limits(board, state), strict=True)
    if not flags & NO_FILTER:
        found |= {name: SETTINGS[name][0](board, state) for name in _FILTER}
    if not flags & NO_PHASE:
        found["Phase"] = int(state.reversed_phase)
    if not flags & NO_PROFILE:
        found["Profile"] = profile(interface, axis)
    if not flags & NO_POSITION:
        found["Position"] = state.reported(board.controller.position(axis) + state.shift)
    return f"[Axis {axis}]\n" + "".join(f"{name} = {value!r}\n" for name, value in found.items())


@commands("MCDLG_RestoreAxis")
def restore(interface: Interface, axis: int, iFlags: int, PrivateIniFile: str) -> list[Command]:  # noqa: N803
    """Return the commands that set the saved values."""
    sections = _sections(PrivateIniFile)
    found: list[Command] = []
    for number in [axis] if axis else interface.board.numbers:
        if number not in sections:
            raise Refused(mc.MCERR_NOT_FOUND)
        found += _restored(interface, number, iFlags, sections[number])
    return only_known(interface, found)


def _restored(interface: Interface, axis: int, flags: int, saved: dict[str, float]) -> list[Command]:
    """Return the commands that restore one axis.

    Units come first. They take effect when the axis is next switched on, so it is switched on and off.
    """
    board = interface.board
    found: list[Command] = []
    if not flags & NO_SCALE and all(name in saved for name in _SCALE) and not lacks(board.model, "US"):
        units = tuple(saved[name] for name in _SCALE)
        if units != scale(interface, axis):
            found += set_scale(interface, axis, units)
            found += [command("MN", axis), command("MF", axis)]
            if board.controller.is_enabled(axis):
                found.append(command("MN", axis))
    names = ([] if flags & NO_MOTION else _MOTION) + ([] if flags & NO_FILTER else _FILTER)
    for name in names:
        if name in saved:
            found += SETTINGS[name][1](board, axis, saved[name])
    if not flags & NO_MOTION and all(name in saved for name in LIMITS):
        found += put_limits(axis, *(saved[name] for name in LIMITS))
    if not flags & NO_PHASE and "Phase" in saved:
        found.append(command("PH", axis, int(saved["Phase"])))
    if not flags & NO_PROFILE and int(saved.get("Profile", 0)) in PROFILES:
        found.append(command(PROFILES[int(saved["Profile"])], axis))
    if not flags & NO_POSITION and "Position" in saved:
        found.append(command("DH", axis, saved["Position"]))
    return found


def _sections(text: str) -> dict[int, dict[str, float]]:
    """Return the numbers of a file by axis and name.

    Raises Refused for a line that is neither a section nor a number.
    """
    found: dict[int, dict[str, float]] = {}
    section: dict[str, float] = {}
    for line in text.splitlines():
        name, equals, value = (item.strip() for item in line.partition("="))
        if name.startswith("[Axis ") and name.endswith("]") and name[6:-1].isdecimal():
            section = found.setdefault(int(name[6:-1]), {})
        elif equals:
            try:
                section[name] = float(value)
            except ValueError:
                raise Refused(mc.MCERR_RANGE) from None
            if not abs(section[name]) < 1e300:
                raise Refused(mc.MCERR_RANGE)
    return found


@at_once("MCDLG_DownloadFile")
def download(session: Session, call: Call, hWnd: int, iFlags: int, szFileName: str) -> bool | None:  # noqa: N803
    """Carry out the lines of a file; a rejected command ends it."""
    lines: list[Line] = []
    for each in lines_of(Source("download", szFileName)):
        if not isinstance(each, Line):
            raise each[0]
        lines.append(each)
    if not lines:
        return None
    call.line, call.more = lines[0], lines[1:]
    return True

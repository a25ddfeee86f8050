"""Figures and outcomes in the words that every view uses."""

from __future__ import annotations

TYPE_CHECKING = False
if TYPE_CHECKING:
    from motionlang.result import Run

DIALECTS = {"mint": "Mint", "mccl": "MCCL"}
_OUTCOMES = {
    "ended": "ended after {}",
    "until": "still running at {}, where its time was up",
    "fault": "stopped by an error at {}",
    "interrupted": "interrupted at {}",
    "open": "{} so far",  # a session, which has no end before its user leaves
}


def outcome(run: Run) -> str:
    """How the run ended, and when by the machine's own clock."""
    return _OUTCOMES[run.status].format(clock_time(run.time))


def dialect_name(name: str) -> str:
    """A dialect as its makers write it."""
    return DIALECTS.get(name, name)


def clock_time(seconds: float) -> str:
    """A machine time for a person: hours and minutes once there are any, never a digit that says nothing."""
    if seconds < 60.0:
        return f"{_plain(seconds, 6)} s"
    minutes, rest = divmod(round(seconds, 3 if seconds < 3600.0 else 0), 60.0)
    if minutes < 60.0:
        return f"{int(minutes)} min {_plain(rest, 3)} s"
    return f"{int(minutes // 60)} h {int(minutes % 60):02d} min {_plain(rest, 0)} s"


def figure(value: float, decimals: int = 3) -> str:
    """A number of a column that has `decimals`; by powers of ten where that would be too long, or show nothing."""
    size = abs(value)
    if size >= 1e9 or 0.0 < size < 0.5 * 10.0**-decimals:
        return f"{value:.6g}"
    return f"{value + 0.0:.{decimals}f}"


def peak_of(value: float) -> str:
    """A single figure beside a curve: six digits."""
    return f"{value:.6g}"


def _plain(value: float, decimals: int) -> str:
    text = f"{value:.{decimals}f}"
    return text.rstrip("0").rstrip(".") if "." in text else text

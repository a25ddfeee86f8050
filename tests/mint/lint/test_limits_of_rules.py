"""Diagnostics of Mint at the limits of their rules: code, line and column, or none."""

from __future__ import annotations

from motionlang.mint import DIALECT as MINT
from motionlang.source import Source
from tests.cases import cases


def on(model: str, text: str) -> list[tuple[int, str, str]]:
    """Return line, message and hint of what does not fit the controller model."""
    found = MINT.check(Source("limits.mnt", text), {"controller.model": model})
    return [(each.line, each.message, each.hint) for each in found if each.code == "model"]


@cases(
    "text, brackets, hint",
    [
        ("SPEED(1) = 5", "SPEED(1)", "write SPEED.1"),
        ("SPEED(n) = 5", "SPEED(n)", "write SPEED.n"),
        ("SPEED(a(1)) = 5", "SPEED(…)", "write SPEED.…"),
        ("SPEED(n + 1) = 5", "SPEED(…)", "write SPEED.…"),
        ("SPEED(0, n) = 5", "SPEED(0, n)", "write SPEED[0, n]"),
        ("SPEED(-1) = 5", "SPEED(…)", "write SPEED.…"),
    ],
)
def test_brackets_that_mint_v4_writes_with_a_dot(text: str, brackets: str, hint: str) -> None:
    """The message repeats numbers and names; anything longer is an ellipsis."""
    found = on("mint4", f"n = 1\nDim a(3)\n{text}")
    assert found == [(3, f"{brackets} is MintMT: it does not compile on Mint v4", hint)]


EVENTS = ("COMMS0", "COMMS1", "COMMS5", "COMMS6", "COMMS10", "COMMS11", "NETDATA0", "NETDATA31", "NETDATA32")


@cases(
    "model, comms, netdata",
    [
        ("NextMove ESB-2", "those of 1 to 5 do", "it has no NETDATA events"),
        ("MicroFlex e150", "it has no COMMS events", "those of 0 to 31 do"),
        ("NextMove e100", "those of 1 to 10 do", "those of 0 to 31 do"),
    ],
)
def test_handlers_of_host_writes_that_a_product_never_reports(model: str, comms: str, netdata: str) -> None:
    """A handler is reported if its number is outside the range that the hint states."""
    known = {"COMMS": comms, "NETDATA": netdata}
    expected = []
    for line, event in enumerate(EVENTS, 2):
        kind = event.rstrip("0123456789")
        words = known[kind].split()
        reported = range(int(words[2]), int(words[4]) + 1) if words[0] == "those" else range(0)
        if int(event.removeprefix(kind)) not in reported:
            expected.append((line, f"{event} never comes on the {model}", known[kind]))
    handlers = "".join(f"Event {event} : End Event\n" for event in EVENTS)
    assert on(model, f"WAIT = 1 : End\n{handlers}") == expected

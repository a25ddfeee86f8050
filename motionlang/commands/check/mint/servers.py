"""The check for Modbus servers and registers that are not in the machine file.

Only requests whose server and register are literal numbers are checked.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping

from motionlang.kernel.mint.keywords.modbus import LAST
from motionlang.kernel.mint.syntax import nodes
from motionlang.kernel.mint.syntax.nodes import Module
from motionlang.kernel.mint.syntax.traversal import walk

# The client keywords, and how many registers each accesses.
_REACHED = {"modbustcp16": 1, "modbustcp32": 2, "modbustcpfloat": 2}
_WHERE = 2  # the number of arguments: server and register


def check_servers(module: Module, settings: Mapping[str, object], add: Callable[..., None]) -> None:
    """Report every request that no server of the machine file answers."""
    spans = _spans(settings)
    for name, server, register in _requests(module) if spans else ():
        span = spans.get(server)
        if span is None:
            known = ", ".join(map(str, spans))
            add(
                "no-connection",
                f"the machine file has no Modbus server {server}",
                name.start,
                f"it has {known}",
            )
        elif not span[0] <= register <= register + _REACHED[name.name.lower()] - 1 <= span[1]:
            limits = f"its registers are {span[0]} to {span[1]}"
            add("no-connection", f"Modbus server {server} rejects register {register}", name.start, limits)


def _spans(settings: Mapping[str, object]) -> dict[int, tuple[int, int]]:
    """Map each server to its first and last register."""
    spans = {
        entry["id"]: (entry.get("first", 0), entry.get("last", LAST))
        for entry in settings.get("modbus.server", ())  # type: ignore[attr-defined]
    }
    for entry in settings.get("modbus.register", ()):  # type: ignore[attr-defined]
        spans.setdefault(entry["server"], (0, LAST))
    return spans


def _requests(module: Module) -> Iterator[tuple[nodes.Name, int, int]]:
    """Yield each client keyword whose server and register are literals, with both."""
    blocks = module.everything
    for node in walk(blocks):
        if type(node) is not nodes.Name or node.name.lower() not in _REACHED:
            continue
        if node.args is not None and len(node.args) == _WHERE:
            server, register = node.args
            if type(server) is nodes.Number and type(register) is nodes.Number:
                yield node, int(server.value), int(register.value)

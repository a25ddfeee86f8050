"""A request goes to a Modbus server or a register that is not in the machine file.

Only requests whose server and register are literal numbers are checked.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from typing import TYPE_CHECKING

from motionlang.commands.check.rule import Rule, RuleCase, Warn
from motionlang.kernel.mint.syntax import nodes
from motionlang.kernel.mint.syntax.traversal import walk

if TYPE_CHECKING:
    from motionlang.commands.check.mint.mint_facts import MintFacts

# The client keywords, and how many registers each accesses.
_REACHED = {"modbustcp16": 1, "modbustcp32": 2, "modbustcpfloat": 2}
_WHERE = 2  # the number of arguments: server and register


def check(facts: MintFacts, warn: Warn) -> None:
    spans = _spans(facts.settings)
    for name, server, register in _requests(facts) if spans else ():
        span = spans.get(server)
        if span is None:
            message = f"the machine file has no Modbus server {server}"
            warn(message, name.start, f"it has {', '.join(map(str, spans))}")
        elif not span[0] <= register <= register + _REACHED[name.name.lower()] - 1 <= span[1]:
            message = f"Modbus server {server} rejects register {register}"
            warn(message, name.start, f"its registers are {span[0]} to {span[1]}")


def _spans(settings: Mapping[str, object]) -> dict[int, tuple[int, int]]:
    """Map each server to its first and last register."""
    # Here, since it loads the keywords of Mint, which programs in MCCL do not need.
    from motionlang.kernel.mint.keywords.modbus import LAST

    spans = {
        entry["id"]: (entry.get("first", 0), entry.get("last", LAST))
        for entry in settings.get("modbus.server", ())  # type: ignore[attr-defined]
    }
    for entry in settings.get("modbus.register", ()):  # type: ignore[attr-defined]
        spans.setdefault(entry["server"], (0, LAST))
    return spans


def _requests(facts: MintFacts) -> Iterator[tuple[nodes.Name, int, int]]:
    """Yield each client keyword whose server and register are literals, with both."""
    for node in walk(facts.module.everything):
        if type(node) is not nodes.Name or node.name.lower() not in _REACHED:
            continue
        if node.args is not None and len(node.args) == _WHERE:
            server, register = node.args
            if type(server) is nodes.Number and type(register) is nodes.Number:
                yield node, int(server.value), int(register.value)


RULE = Rule(
    code="no-connection",
    text="""\
A keyword of the Modbus client uses a server, or a register of it, that the machine file does not have. In a run it gets
error 41 or 4. The warning appears only if the file has `[[modbus.server]]` or `[[modbus.register]]` and the numbers are
constants in the program.
""",
    fix="add the node or server to the machine file, or correct its number",
    mint=RuleCase(
        check,
        wrong="PRINT MODBUSTCP16(5, 6)\n",
        right="PRINT MODBUSTCP16(4, 6)\n",
        machine="[[modbus.server]]\nid = 4\n",
    ),
)

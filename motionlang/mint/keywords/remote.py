"""Remote nodes on a bus."""

from __future__ import annotations

from motionlang.lang.keyword import Keyword


def _word(name: str, access: str, index: str, unit: str, verb: str, help: str, example: str,
          driven: str = "") -> Keyword:  # fmt: skip
    kind = "setting" if "W" in access else "reading"
    low, high = (-100.0, 100.0) if unit == "%" and "W" in access else (None, None)
    return Keyword(name, "", kind, access, index, unit, verb, help, example, default=0.0, low=low, high=high,
                   group="remote", driven=driven)  # fmt: skip


ROWS = (
    _word("REMOTEIN", "R", "bus, node", "bits", "remote.bits.inputs", "The inputs of a remote node as bits.",
          "PRINT REMOTEIN(1, 2)", "remote"),
    _word("REMOTEINX", "R", "bus, node, input", "bool", "remote.bit.inputs", "One input of a remote node.",
          "PRINT REMOTEINX(1, 2, 0)", "remote"),
    _word("REMOTEINBANK", "R", "bus, node, bank", "bits", "remote.bits.inputs", "A bank of inputs of a remote node.",
          "PRINT REMOTEINBANK(1, 2, 0)", "remote"),
    _word("REMOTEOUT", "RW", "bus, node", "bits", "remote.bits.outputs", "The outputs of a remote node as bits.",
          "REMOTEOUT(1, 2) = 255\nPRINT REMOTEOUT(1, 2)"),
    _word("REMOTEOUTX", "RW", "bus, node, output", "bool", "remote.bit.outputs", "One output of a remote node.",
          "REMOTEOUTX(1, 2, 3) = 1\nPRINT REMOTEOUTX(1, 2, 3)"),
    _word("REMOTEOUTBANK", "RW", "bus, node, bank", "bits", "remote.bits.outputs",
          "A bank of outputs of a remote node.", "REMOTEOUTBANK(1, 2, 0) = 7\nPRINT REMOTEOUTBANK(1, 2, 0)"),
    _word("REMOTEADC", "R", "bus, node, channel", "%", "remote.percent.analogue_inputs",
          "An analogue input of a remote node in percent.", "PRINT REMOTEADC(1, 2, 0)", "remote"),
    _word("REMOTEDAC", "RW", "bus, node, channel", "%", "remote.percent.analogue_outputs",
          "An analogue output of a remote node in percent.", "REMOTEDAC(1, 2, 3) = 100\nPRINT REMOTEDAC(1, 2, 3)"),
    _word("NODELIVE", "R", "bus, node", "bool", "remote.live",
          "1 for a node that the machine file speaks of, while it lives.", "PRINT NODELIVE(1, 2)"),
)  # fmt: skip

"""The boards: what one model does otherwise than another, as switches that the rest of the dialect reads.

Facts are those of docs/fidelity.md; where nothing is known, an older board behaves as the MultiFlex does.
"""

from __future__ import annotations


class Model:
    """One board.

    `prompt`, `echo` and `line_end` are how it talks; `rounds` whether parameters become whole counts before a scale
    is set; `separate_decel` whether DS is its own setting; `shapes` whether PS and PP exist; `tasks` whether GT does;
    `macros` the highest macro number; `registers` how many there are; `words` whether TS has its four status words;
    `at_target` whether status bit 2 means that; `outputs` the channels that are outputs at power-up;
    `whole_gains` whether gains are integers; `update` the servo period in seconds.
    """

    __slots__ = (
        "at_target",
        "echo",
        "line_end",
        "macros",
        "name",
        "outputs",
        "prompt",
        "registers",
        "rounds",
        "separate_decel",
        "shapes",
        "tasks",
        "title",
        "update",
        "whole_gains",
        "words",
    )

    def __init__(
        self,
        name: str,
        title: str,
        *,
        prompt: str = ">",
        echo: bool = True,
        line_end: str = "\n",
        rounds: bool = True,
        separate_decel: bool = True,
        shapes: bool = True,
        tasks: bool = True,
        macros: int = 1000,
        registers: int = 256,
        words: bool = True,
        at_target: bool = True,
        outputs: range = range(9, 17),
        whole_gains: bool = False,
        update: float = 0.00025,
    ) -> None:
        self.name, self.title, self.prompt, self.echo, self.line_end = name, title, prompt, echo, line_end
        self.rounds, self.separate_decel, self.shapes, self.tasks = rounds, separate_decel, shapes, tasks
        self.macros, self.registers, self.words = macros, registers, words
        self.whole_gains, self.update = whole_gains, update
        self.at_target, self.outputs = at_target, outputs


_MODELS = (
    Model("multiflex", "MultiFlex PCI 1000 series", outputs=range(33, 49)),
    Model("dcx-pci300", "DCX-PCI300, DSP based modular controller", words=False, update=0.00025),
    Model("dcx-pci100", "DCX-PCI100 modular controller", shapes=False, separate_decel=False, words=False,
          at_target=False, whole_gains=True, update=0.000341),
    Model("dcx-at200", "DCX-AT200 advanced modular controller", line_end="\r", words=False,
          at_target=False, update=0.001),
    Model("dcx-pc100", "DCX-PC100 modular controller", prompt="", echo=False, line_end="\r", shapes=False,
          separate_decel=False, tasks=False, macros=255, words=False, at_target=False, whole_gains=True, update=0.001),
)  # fmt: skip

MODELS: dict[str, Model] = {model.name: model for model in _MODELS}
DEFAULT = "multiflex"

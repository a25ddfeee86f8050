"""The jobs of the worker: a text, with the machine file next to it."""

from __future__ import annotations

from motionlang.kernel import Diagnostic
from motionlang_lsp.jobs import CHECK, Job, work


def checked(text: str, machine: str | None = None, language: str = "mint") -> list[tuple[str, int, int]]:
    """Return code, line and column of the diagnostics of a text."""
    found = work(Job(CHECK, "a.mnt", text, language, machine, "a.machine.toml"))
    assert isinstance(found, list)
    return [(each.code, each.line, each.column) for each in found]


def test_an_invalid_machine_file_is_reported_at_the_begin_of_the_program() -> None:
    """The program is then checked without it, and its own diagnostics follow."""
    machine = "[axis.0]\ntravel = [0, 100]\n"
    far = "\nMOVEA(0) = 500 : GO(0)\n"
    assert checked(far, machine) == [("beyond-travel", 2, 1)]
    assert checked(far, machine.replace("travel", "travvel")) == [("machine-file", 1, 1)]
    unused = "\nDim spare\n"
    assert checked(unused, "[axis.0]\ntravvel = 1\n") == [("machine-file", 1, 1), ("unused-variable", 2, 5)]


def test_the_report_of_an_invalid_machine_file_names_it_and_its_first_mistake() -> None:
    found = work(Job(CHECK, "a.mnt", "\n", "mint", "[axis.0]\ntravvel = 1\nspeeed = 2\n", "a.machine.toml"))
    assert isinstance(found, list)
    (only,) = found
    assert isinstance(only, Diagnostic)
    assert only.severity == "warning"
    begin = "a.machine.toml is invalid, and the program is checked without it: "
    assert only.message.startswith(begin)
    assert "travvel" in only.message


def test_a_machine_file_is_checked_alone() -> None:
    assert checked("[axis.0]\ntravvel = 1\n", language="") == [("machine-file", 2, 1)]
    assert checked("[axis.0]\ntravel = [0, 100]\n", language="") == []

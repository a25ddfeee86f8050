"""Very many errors: limited output, linear time, and equal errors reported once.

An error that occurs several times is shown with its count.
"""

from __future__ import annotations

import motionlang
from motionlang.commands.check import check
from motionlang.kernel import Diagnostic, Machine, Source, dialect
from motionlang.views.diagnostics import MAX_SHOWN, render, render_all

BAD = "".join(f"1XX{number}\n" for number in range(3000))


class Counting(str):
    """A text that counts how often it is searched."""

    scans = 0

    def count(self, *given: object) -> int:
        Counting.scans += 1
        return super().count(*given)  # type: ignore[arg-type]

    def rfind(self, *given: object) -> int:
        Counting.scans += 1
        return super().rfind(*given)  # type: ignore[arg-type]


def test_locations_of_many_mistakes_cost_one_scan_of_the_text() -> None:
    source = Source("bad.mcl", BAD)
    source.text = Counting(BAD)
    found = check(dialect("mccl").program(source))
    assert [each.line for each in found] == list(range(1, 3001))
    assert Counting.scans < 10


def test_a_file_full_of_mistakes_is_shown_in_bounds() -> None:
    source = Source("bad.mcl", BAD)
    text = render_all(check(dialect("mccl").program(source)), source)
    assert text.count("error[") == MAX_SHOWN
    assert text.endswith("\nand 2900 errors more in the JSON report\n")
    assert (
        len(render_all(check(dialect("mccl").program(source))[:MAX_SHOWN], source))
        == len(text) - len(text.rpartition("\nand ")[2]) - 5
    )


def test_a_hundred_are_shown_and_more_are_counted() -> None:
    found = [Diagnostic("unknown-word", f"message {k}") for k in range(102)]
    for count, end in ((100, "message 99\n"), (101, "and 1 error more in the JSON report\n")):
        assert render_all(found[:count]).endswith(end)
    assert render_all(found).endswith("\nand 2 errors more in the JSON report\n")


def test_equal_diagnostics_of_a_run_are_one() -> None:
    """A warning in a loop is shown once."""
    program = Source(
        "home.mnt", "Dim i As Integer\nFor i = 1 To 50\n HOME(0) = 0\n CANCEL(0)\n WAIT = 100\nNext\n"
    )
    ran = motionlang.run(program, machine={"controller.axes": 1}, until=10.0)
    (diagnostic,) = [each for each in ran.diagnostics if each.code == "never"]
    assert (diagnostic.count, diagnostic.line) == (50, 3)
    assert 0.0 < diagnostic.first < 0.001
    assert 4.9 < diagnostic.last < 4.92
    shown = diagnostic.as_dict()
    assert (shown["count"], shown["first_time"], shown["last_time"]) == (
        50,
        diagnostic.first,
        diagnostic.last,
    )
    assert f"note: 50 times, from 0.00001 s to {diagnostic.last:.6g} s" in render(diagnostic, program)


def test_a_command_that_is_refused_again_and_again_is_counted() -> None:
    ran = motionlang.run(Source("w.mcl", "2MR1,WA0.1,RP9\n"), until=10.0)
    (diagnostic,) = [each for each in ran.diagnostics if each.code == "disabled-axis"]
    assert diagnostic.count == 10
    assert 0.9 < diagnostic.last < 0.91
    assert diagnostic.first < 0.001


def test_different_diagnostics_of_a_run_are_bounded() -> None:
    machine = Machine()
    for number in range(400):
        machine.complain(Diagnostic("never", f"complaint {number}"))
        machine.complain(Diagnostic("never", f"complaint {number}"))
    assert len(machine.diagnostics) == 200
    assert {each.count for each in machine.diagnostics} == {2}

"""The tests that a polling loop makes on each value it reads."""

from __future__ import annotations

from itertools import pairwise

from motionlang.mccl.resolve.line import line_of
from motionlang.mccl.runtime.loop_tests import Reading, levels, readings_of
from motionlang.mccl.runtime.loop_tests import tests_of as find_tests
from tests.cases import cases


@cases(
    "text, governs, expected",
    [
        ("1RL@20,IB300,JR-2", 2, {0: ["IB300"]}),
        ("NO,1RL@20,IS3,NO,IC4,JR-5", 2, {1: ["IS3", "IC4"]}),
        ("RA5,IE3,IG7,IU8,RP", 2, {0: ["IE3", "IG7", "IU8"]}),
        ("1RD@20,IB2.5,RP", 2, {0: ["IB2.5"]}),
        ("1RB@20,IS3,RP", 2, {0: ["IS3"]}),
        ("1RW@20,IS3,RP", 2, {0: ["IS3"]}),
        ("GA3,IB2,RP", 2, {0: ["IB2"]}),
        ("IN5,NO,NO,AL1,IB2,CN33,RP", 2, {3: ["IB2"]}),
        ("1RL@20,RP", 2, {0: []}),
        # A second value ends the use of the first one, unless a condition or a jump may leave it out.
        ("1RL@20,IB300,NO,NO,1RV@21,IS3,RP", 2, {0: ["IB300"], 4: ["IS3"]}),
        ("1RL@20,IB300,NO,1RV@21,IS3,RP", 2, {0: None, 3: ["IS3"]}),
        ("1RL@20,IB300,NO,1RV@21,IS3,RP", 1, {0: ["IB300"], 3: ["IS3"]}),
        ("1RL@20,IB300,NO,NO,1RV@21,IS3,RP", 3, {0: None, 4: ["IS3"]}),
        ("1RL@20,IN5,NO,1RV@21,IS3,RP", 2, {0: None, 3: ["IS3"]}),
        ("1RL@20,JR2,NO,NO,1RV@21,IS3,RP", 2, {0: None, 4: ["IS3"]}),
        ("1RL@20,IB300,NO,NO,1RV@21,IS3,JR-6", 2, {0: ["IB300"], 4: ["IS3"]}),
        # Any other use of the value.
        ("1RL@20,AA5,IB300,RP", 2, {0: None}),
        ("1RL@20,AR5,IB300,RP", 2, {0: None}),
        ("1RL@20,IB@0,RP", 2, {0: None}),
        ("1RL@20,IB@5,RP", 2, {0: ["IB@5"]}),
        ('LU"STATUS",1RL@0,IC3,RP', 2, {0: None, 1: ["IC3"]}),
        # Commands with an effect are skipped by a condition, and a wait leaves the accumulator alone.
        ("1RL@20,IB300,1MR5,RP", 2, {0: ["IB300"]}),
        ("IN5,1ST,NO,1RL@20,IB300,RP", 2, {3: ["IB300"]}),
        ("WA1,1RL@20,IB300,WA1,RP", 2, {1: ["IB300"]}),
        # The low bits of a value pass a number each time they wrap.
        ("1RB@20,IB3,RP", 2, {0: None}),
        ("1RW@20,IS3,IE3,RP", 2, {0: None}),
        # The accumulator of the iteration before, or an effect.
        ("IB300,1RL@20,RP", 2, None),
        ("1RL@0,IB300,RP", 2, None),
        ("RA0,IB300,RP", 2, None),
        ("RA@0,IB300,RP", 2, None),
        ("AA1,IB300,RP", 2, None),
        ("NO,NO,RP", 2, None),
        ("IN@0,NO,NO,1RL@20,RP", 2, None),
        ("WA@0,1RL@20,IB300,RP", 2, None),
        ("IN5,AL1,IB2,RP", 2, None),
        ("1RL@20,IB300,BK,RP", 2, None),
        ("1RL@20,IB300,MC1,RP", 2, None),
        ("1RL@20,IB300,MJ1", 2, {0: None}),
    ],
)
def test_the_tests_of_a_loop(text: str, governs: int, expected: dict[int, list[str] | None] | None) -> None:
    """By the index of the command that reads.

    None if the value is used for more than tests.
    """
    line = line_of(text)
    assert line is not None
    found = find_tests(line.commands, governs)
    assert (found is None) is (expected is None)
    texts = {
        k: None if tests is None else [each.text for each in tests] for k, tests in (found or {}).items()
    }
    assert texts == (expected or {})


def cut_off(test: str, value: float, limit: float) -> bool:
    """Return the result of a comparison with the whole number that RL reads."""
    whole = int(value)
    return {"IG": whole > limit, "IB": whole < limit, "IE": whole == limit, "IU": whole != limit}[test]


@cases("test", ["IG", "IB", "IE", "IU"])
def test_a_comparison_with_a_whole_number_changes_only_at_its_levels(test: str) -> None:
    """Values are compared in steps of 1/8."""
    for limit in (-3, -1, 0, 1, 2, 5, -1.5, -0.5, 0.5, 1.5):
        line = line_of(f"{test}{limit}")
        assert line is not None
        found = levels(line.commands[0], limit, "read_long")
        values = [k / 8 for k in range(-48, 57)]
        changes = {
            level
            for low, high in pairwise(values)
            if cut_off(test, low, limit) is not cut_off(test, high, limit)
            for level in (low, high)
        }
        assert all(level in changes for level in found)
        assert len(changes) == 2 * len(found)
        assert levels(line.commands[0], limit, "read_float") == (limit,)


@cases(
    "text, expected",
    [
        ("1RL@20,IS3,IC12,RP", {0: Reading("read_long", (3, 12), None, ())}),
        ("1RL@20,IG5,IB9,IG5,RP", {0: Reading("read_long", None, (6.0, 9.0), ())}),
        ("1RD@20,IG5,RP", {0: Reading("read_double", None, (5.0,), ())}),
        ("1RL@20,RP", {0: Reading("read_long", (), (), ())}),
        ("1RL@20,IG5,IS3,RP", {0: Reading("read_long", None, None, ())}),
        ("1RL@20,AA5,IG5,RP", {0: None}),
        ("AA5,IG5,RP", None),
    ],
)
def test_the_bits_and_levels_of_a_reading(text: str, expected: dict[int, Reading | None] | None) -> None:
    line = line_of(text)
    assert line is not None
    found = readings_of(line.commands, 2)
    assert (found is None) is (expected is None)
    for k, each in (expected or {}).items():
        reading = (found or {})[k]
        assert (reading is None) is (each is None)
        if reading is not None and each is not None:
            fields = ("verb", "bits", "levels", "by_register")
            assert [getattr(reading, name) for name in fields] == [getattr(each, name) for name in fields]


def test_a_comparison_with_a_register_is_listed() -> None:
    line = line_of("1RL@20,IG@5,IB9,RP")
    assert line is not None
    reading = (readings_of(line.commands, 2) or {})[0]
    assert reading is not None
    assert (reading.levels, [each.text for each in reading.by_register]) == ((9.0,), ["IG@5"])

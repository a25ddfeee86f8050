"""The machine file with any value for any key either runs or is rejected."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import suppress

import pytest

import motionlang
from motionlang.kernel import ProgramError, Source, read_machine
from motionlang.kernel.lang import KEYS, REQUIRED, TABLES
from motionlang.kernel.servo import KEYS as SERVO_KEYS
from tests.fuzz.guard import MAX_SECONDS, bounded

DIGITS = "1" + "0" * 400
WRONG = [
    "inf",
    "-inf",
    "nan",
    "-1",
    "0",
    "0.5",
    "1e308",
    "7",
    "true",
    "1979-05-27",
    "07:32:00",
    "[]",
    "[1]",
    "[[1],[2]]",
    "[nan,nan]",
    "{}",
    "{a=1}",
    "[{}]",
    '""',
    '"x"',
    '["a","b"]',
    '{"0"=1}',
    '{"²"=1}',
    DIGITS,
    f"-{DIGITS}",
    f"[1, {DIGITS}]",
    f'{{ "0" = {DIGITS} }}',
    f'{{ "{DIGITS * 11}" = 1 }}',
    DIGITS * 11,
    f"0x{'f' * 5000}",
    f"[0x{'f' * 5000}]",
    "[" * 200 + "]" * 200,
    "[" * 2000,
    "{a=" * 2000,
]
# A valid value of each kind.
RIGHT = {
    "text": '"a"',
    "pair": "[1, 2]",
    "registers": "{}",
    "times": "2",
    "bit": "0",
    "width": '"word"',
    "node event": '"live"',
    "bus event": '"off"',
    "view": '"float"',
    "fault": '"drive"',
}
# What an entry needs in addition to the requirements of its table.
FURTHER = {
    "fault": {"axis": "1"},
    "comms": {"value": "1"},
    "netdata": {"value": "1"},
    "remote": {"channel": "1"},
    "encoder": {"channel": "1"},
    "expect": {"time": "1"},
}


def messages(text: str) -> list[str]:
    """Return the errors of a machine file with location and hint; if none, run it."""
    try:
        settings = read_machine(Source("machine.toml", text))
    except ProgramError as error:
        for each in error.diagnostics:
            assert each.line, f"{each.message}: no place in {text[:200]}"
            assert each.hint, f"{each.message}: no hint in {text[:200]}"
        return [each.message for each in error.diagnostics]
    for name, program in (("a.mnt", "PRINT 1\n"), ("a.mcl", "0\n")):
        with suppress(ProgramError):  # an axis that does not exist
            motionlang.run(Source(name, program), machine=settings, until=2.0)
    return []


def entry(table: str, values: dict[str, str]) -> str:
    """Return the text of an entry of a table."""
    return f"[[{table}]]\n" + "".join(f"{key} = {value}\n" for key, value in values.items())


def right(table: str, key: str) -> str:
    return RIGHT.get(TABLES[table][key][0], "1")


def least(table: str) -> dict[str, str]:
    """Return the required keys of an entry of a table, with valid values."""
    return {key: right(table, key) for key in REQUIRED[table]} | FURTHER.get(table, {})


@pytest.mark.parametrize(
    "key", [*KEYS, *SERVO_KEYS, *TABLES, "controller", "axis", "axis.N", "axis.N.plant", "mint"]
)
def test_any_value_of_a_key(key: str) -> None:
    written = key.replace(".N", ".1").replace("WORD", "DRIVEBUSVOLTS")
    assert any(messages(f"{written} = {value}\n") for value in WRONG)


def entries(table: str) -> Iterator[str]:
    """Yield entries with every value for every key, every two keys, and a key missing.

    The missing key is a required one.
    """
    for key in TABLES[table]:
        for value in WRONG:
            yield entry(table, {**least(table), key: value})
        for other in TABLES[table]:
            yield entry(table, {**least(table), key: right(table, key), other: right(table, other)})
        for other in least(table):
            left = {**least(table), key: right(table, key)}
            del left[other]
            yield entry(table, left)


@pytest.mark.parametrize("table", TABLES)
def test_any_value_in_a_table(table: str) -> None:
    assert messages(entry(table, least(table))) == []
    assert any(messages(text) for text in entries(table))


@pytest.mark.parametrize(
    ("text", "line", "column", "message"),
    [
        (
            f"[axis.1.plant]\ninertia = {DIGITS}\n",
            2,
            1,
            f"axis.1.plant.inertia must be no larger than 1e+12, not {DIGITS[:60]}…",
        ),
        (f"[controller]\naxes = {DIGITS * 11}\n", 2, 8, "a number has too many digits"),
        ("[controller]\naxes = " + "[" * 2000 + "\n", 2, 2007, "values are nested too deeply"),
        (f"{'a.' * 300}b = 1\n", 1, 1, "there is no key a.a.a.a.a.a"),
        (f"[controller]\n {'a.' * 20_000}b = 1\n", 2, 2, "a key has too many parts"),
        ("[a" + '. "b c"' * 20_000 + "]\n", 1, 2, "a key has too many parts"),
        ("x = { y" + " .'z'" * 20_000 + " = 1 }\n", 1, 7, "a key has too many parts"),
        (
            f"axis.0.travel = [{'1.5, ' * 20_000}]\n",
            1,
            1,
            "axis.0.travel must be two numbers, the lower first",
        ),
        (
            f"[[comms]]\nelement = 0x{'f' * 5000}\nvalue = 1\n",
            2,
            1,
            "element of [[comms]] must be a whole number",
        ),
    ],
    ids=lambda value: str(value)[:40].split("\n")[0],
)
def test_misspelt_key_is_located(text: str, line: int, column: int, message: str) -> None:
    with pytest.raises(ProgramError) as error:
        read_machine(Source("machine.toml", text))
    first = error.value.diagnostics[0]
    assert first.hint
    assert (first.line, first.column, first.message[: len(message)]) == (line, column, message)


@pytest.mark.parametrize("index", ["²", "9" * 5000])
def test_value_at_a_missing_index_is_reported(index: str) -> None:
    settings = read_machine(Source("machine.toml", f'[mint.values]\nTEMPERATURE = {{ "{index}" = 3 }}\n'))
    ran = motionlang.run(Source("a.mnt", "PRINT TEMPERATURE(0)\n"), machine=settings)
    assert [each.code for each in ran.diagnostics] == ["not-simulated"]


@pytest.mark.parametrize("value", ["1e308", "1e100", "1e30", "-1e308", "1e-300", "1e12", "1e-12"])
def test_no_figure_of_a_motor_leaves_what_its_equations_can_hold(value: str) -> None:
    """The values become literals of generated code, which has no nan or infinity."""
    for key in SERVO_KEYS:
        text = f"{key.replace('.N', '.0')} = {value}\n"
        if ".servo." in key:
            text += "[axis.0.plant]\n"
        try:
            settings = read_machine(Source("machine.toml", text))
        except ProgramError:
            continue
        assert abs(float(value)) in (1e12, 1e-12)
        with bounded(MAX_SECONDS):
            ran = motionlang.run(Source("a.mnt", "MOVER(0) = 10\nGO(0)\n"), machine=settings, until=0.02)
        assert "overflow" not in [each.code for each in ran.diagnostics]

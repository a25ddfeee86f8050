"""Every kind of value of a machine file at its bounds, and whole diagnostics."""

from __future__ import annotations

from motionlang.kernel import Diagnostic, ProgramError, Source, check_setting, read_machine
from motionlang.kernel.lang import KEYS, TABLES, first_mistake, generic, read_toml
from tests.cases import cases


def found(text: str, is_layer: bool = False) -> list[Diagnostic]:
    """Return the mistakes of a machine file, or of a scenario if it `is_layer`."""
    try:
        read_machine(Source("machine.toml", text), is_layer=is_layer)
    except ProgramError as error:
        return list(error.diagnostics)
    return []


# Kind: what is accepted and what is not, as in a file, and the rule.
KINDS: dict[str, tuple[str, str, str]] = {
    "text": ('"" "a"', "1 true [1]", "must be a text"),
    "flag": ("true false", '1 0 "true"', "must be true or false"),
    "count": ("1 64", "1.0 true", "must be a whole number"),
    "channel": ("0 1 999", "-1 1000 1.5 true", "must be a whole number from 0 to 999"),
    "number": ("-1e299 0 2.5 9e299", '1e300 -1e300 inf nan true "1"', "must be a number"),
    "time": ("0 0.5 9e299", "-1e-9 1e300 true", "must be a time, 0 or more"),
    "percentage": ("-100 0 12.5 100", "-100.1 101 true", "must be a percentage, -100 to 100"),
    "positive": ("1e-9 9e299", "0 -1 1e300 true", "must be a number above 0"),
    "times": ("1 10000", "0 10001 1.5", "must be a whole number from 1 to 10000"),
    "pair": (
        "[1,1] [-1.5,2]",
        '[2,1] [1] [1,2,3] ["1",2] [1,true] 1',
        "must be two numbers, the lower first",
    ),
    "line": ("1 99999999", "0 100000000 1.5", "must be the number of a line"),
    "register": ("0 65535", "-1 65536 1.5", "must be 0 to 65535, whole"),
    "registers": (
        '{} {"0"=-32768} {"65535"=65535}',
        '{"65536"=0} {"1"=65536} {"1"=-32769} {"1"=1.5} {"01"=1} {"x"=1} {"0000001"=1} 5',
        'must be registers with 16-bit values, such as { "6" = 1234 }',
    ),
    "bus": ("1 2", "0 3 1.5", "must be 1 or 2"),
    "node": ("0 255", "-1 256", "must be a whole number from 0 to 255"),
    "bit": ("0 1", "-1 2", "must be 0 or 1"),
    "terminal": ("1 128", "0 3 256", "must be 1, 2, 4, 8, 16, 32, 64 or 128"),
    "width": ('"word" "float"', '"byte" 1', "must be one of word, integer, float"),
    "node event": ('"live"', '"off"', "must be one of live, dead, emergency"),
    "bus event": (
        '"off"',
        '"live"',
        "must be one of operational, passive, off, receive-overrun, transmit-overrun",
    ),
    "view": ('"integer"', '"word"', "must be one of integer, float"),
    "outcome": ('"until"', '"over"', "must be one of ended, until, stopped, fault"),
    "motor": ('"servo" "stepper"', '"linear"', "must be servo or stepper"),
    "fault": (
        '"drive"',
        '"fire"',
        "must be one of following-error, error-input, forward-limit, reverse-limit, drive, controller",
    ),
    "event": ('"limit"', '"fire"', ""),
}


def key_of(kind: str) -> tuple[str, str]:
    """Return the header and the name of a key of a kind, in a table if there is one."""
    for table, rows in TABLES.items():
        for name in rows:
            if rows[name][0] == kind:
                return f"[[{table}]]", name
    return next(("", key.replace("N", "0")) for key in KEYS if KEYS[key][0] == kind)


@cases("kind", KINDS)
def test_the_values_of_a_kind(kind: str) -> None:
    """A key of the kind is tested by itself; other keys of its entry are missing."""
    accepted, rejected, rule = KINDS[kind]
    head, name = key_of(kind)
    start = f"{name} of {head} must be" if head else f"{name} must be"
    for value in accepted.split(" "):
        text = f"{head}\n{name} = {value}\n"
        assert [each.message for each in found(text) if each.message.startswith(start)] == [], value
    for value in rejected.split(" "):
        text = f"{head}\n{name} = {value}\n"
        wrong = [
            each for each in found(text) if each.message.startswith(start.removesuffix("must be") + rule)
        ]
        assert [(each.line, each.column, each.length) for each in wrong] == [(2, 1, len(name))], value


@cases(
    "text, diagnostic",
    [
        ("x = " + "9" * 5000, (1, 5, 1, "a number has too many digits", "1e6 is a million")),
        (
            "x = " + "[" * 101 + "]" * 101,
            (
                *(1, 105, 1, "values are nested too deeply"),
                "the values of a machine file are at most lists of numbers",
            ),
        ),
        ("x" + ".a" * 1000 + " = 1", (1, 1, 1, "a key has too many parts", "no key has more than 6")),
    ],
)
def test_the_whole_diagnostic_of_a_mistake(text: str, diagnostic: tuple[object, ...]) -> None:
    (one,) = found(text)
    assert (one.code, one.line, one.column, one.length, one.message, one.hint) == (
        "machine-file",
        *diagnostic,
    )


def test_long_keys_and_brackets_within_the_bounds_are_read() -> None:
    """Brackets in strings and comments do not count, and dots of numbers make no key."""
    deep = "[" * 100 + "]" * 100
    assert read_toml(Source("a", f'x = {deep}\ny = "{"[" * 200}" # {"{" * 200}'))["y"] == "[" * 200
    numbers = ", ".join(["1.5"] * 1001)
    assert read_toml(Source("a", f"x = [{numbers}]"))["x"] == [1.5] * 1001
    assert found("x" + ".a" * 999 + " = 1")[0].message == "there is no key x.a.a.a.a.a"


def test_a_scenario_may_name_an_input() -> None:
    """Only a table whose channels have names accepts the name alone."""
    named = '[[input]]\nname = "door"\nat = 1\n'
    assert found(named, is_layer=True) == []
    assert [each.message for each in found(named)] == ["[[input]] needs channel"]
    other = '[[comms]]\nname = "door"\nvalue = 1\n'
    assert [each.message for each in found(other, is_layer=True)] == [
        "[[comms]] needs element",
        "[[comms]] has no key name",
    ]
    assert [each.message for each in found("input = 5", is_layer=True)] == ["input is a table of entries"]


@cases(
    "key, spelling",
    [
        ("axis.3.travel", "axis.N.travel"),
        ("axis.0.limits.speed", "axis.N.limits.speed"),
        ("axis.03.travel", "axis.03.travel"),
        ("axis.1234567.travel", "axis.1234567.travel"),
        ("axis.3", "axis.3"),
        ("mint.values.SPEED", "mint.values.KEYWORD"),
        ("mint.values.SPEED.0", "mint.values.KEYWORD"),
        ("mint.values", "mint.values"),
        ("mccl.codes.TP", "mccl.codes.COMMAND"),
        ("mccl.codes", "mccl.codes"),
        ("assumptions.mint.x", "assumptions.NAME"),
        ("assumptions", "assumptions"),
        ("controller.axes", "controller.axes"),
    ],
)
def test_the_key_of_the_vocabulary(key: str, spelling: str) -> None:
    assert generic(key) == spelling


def test_settings_of_a_caller() -> None:
    assert first_mistake({"controller.axes": 4, "run.until": 5}) == ""
    assert first_mistake({"controller.axes": 4, "input": [{}]}) == (
        "[[input]] needs channel (the digital input)"
    )
    assert check_setting("run.until", -1) == (
        "run.until must be a time, 0 or more, not -1",
        "the time limit of the run, in seconds of machine time; the scenario ends there too",
    )
    assert check_setting("run.until", 1) is None

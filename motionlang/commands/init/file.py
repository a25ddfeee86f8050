"""Text of a draft machine file: guesses, and limits to fill in.

Each guess is preceded by the line of the program that needs it.
"""

from __future__ import annotations

import json
import os
from collections.abc import Mapping
from math import ceil, floor, isclose

from motionlang.commands.init import Guesses, answer_entry
from motionlang.commands.init.ending import ending
from motionlang.commands.map.program_map import channels_of
from motionlang.commands.quantities import quantity
from motionlang.commands.scenarios import FOLDER_SUFFIX
from motionlang.commands.worlds import Entry, entries
from motionlang.kernel import Dialect, Program, Run, Source
from motionlang.kernel.lang import InputRead, Target
from motionlang.kernel.report import moves

# Lines of the program that a comment quotes, and characters of one.
MAX_LINES = 3
MAX_TEXT = 60
# Limits of positions have at most so many decimal places; positions within `SAME` are equal.
MAX_PLACES = 3
SAME = 1e-6
# The fraction of the last place by which a limit may be too narrow: rounding of a profile is no motion.
SLACK = 1e-3
HEAD = """\
# The machine around {program}, written by motionlang init.
#
# A line with `guess = true` is a guess. Correct it and remove `guess = true`; until then, a run that depends on it
# reports it. docs/machine-file.md explains every key.

{model}run.until = {until:.10g}    # {limit}
{stop}"""
# The comments of a time limit, and of what ends the run before it.
LIMIT = "the run ends here if the program does not"
ASKS = "the program asks again, and there is no further answer"
REPEATS = "the program has no end: this is what a run of it shows"
SCENARIO = """\
# {choices}: a path through the menus of {program}, written by motionlang init.
# It adds to the machine file next to the program. docs/scenarios.md explains scenarios.

run.until = {until:.10g}    # {limit}
{stop}"""
INPUTS = """
# Digital inputs. `at` is a time in seconds, `output` the output that the input follows after `delay`; `every` repeats
# it, `value = 0` inverts an input.
"""
ANALOGUE = """
# Analogue inputs, in percent.
"""
ANSWERS = """
# Lines that the operator types when the program asks.
"""
KEYS = """
# Keys that the operator presses.
"""
LIMITS = """\
# Limits to fill in; the figures are those of this run. `motionlang certify` compares them with a run.
"""
UNKNOWN = """
# Digital inputs whose channels are only known while the program runs.
{lines}"""
EXPECT = """
# Expectations that `motionlang verify` checks. A scenario, another world for the same program, is a file of its own
# in the folder {folder}: docs/scenarios.md."""
STATUS = """
[[expect]]
status = "{status}"
"""
FAULT = """
# The program stops with an error in this machine, so there is no [[expect]] for `motionlang verify` yet.
"""


def machine_text(
    program: Program,
    guesses: Guesses,
    reads: list[InputRead],
    result: Run,
    until: float,
    target: Target,
) -> str:
    """Return the text of the machine file; `result` is the run with all guesses."""
    source, fixed = program.source, guesses.fixed
    name = os.path.basename(source.name)
    answers = [answer_entry(each, text) for each, texts in guesses.answers.items() for text in texts]
    sections = [
        HEAD.format(program=name, model=_model(target), **_end(result, until)),
        *_table("input", INPUTS, _inputs(program.on(fixed), result.dialect, guesses, reads)),
        *_unknown(source, reads),
        *_table("analogue", ANALOGUE, [_guess(each) for each in guesses.analogue.values()]),
        *_table("answer", ANSWERS, _lines(fixed, "answer") + [_guess(each) for each in answers]),
        *_table("key", KEYS, _lines(fixed, "key") + [_guess(each) for each in guesses.keys]),
    ]
    for number in sorted({move.axis for move in result.machine.log.moves} | guesses.axes.keys()):
        sections.append(_axis(number, guesses, result))
    if result.status in ("ended", "until", "stopped"):
        folder = f"{os.path.splitext(name)[0]}{FOLDER_SUFFIX}"
        sections.append(EXPECT.format(folder=folder) + _status(result))
    else:
        sections.append(FAULT)
    return "".join(sections)


def _model(target: Target) -> str:
    """Return the line of the controller model, with the reasons for it; "" if there is none."""
    if not target.model:
        return ""
    also = f"# {also_fitting(target)}\n" if target.others else ""
    return (
        f"controller.model = {toml_value(target.model)}    # {'; '.join(target.reasons[:MAX_LINES])}\n{also}"
    )


def also_fitting(target: Target) -> str:
    """Return which other models a program fits."""
    *most, last = target.others
    names = f"{', '.join(most)} and {last}" if most else last
    return f"{names} {'fits' if len(target.others) == 1 else 'fit'} the program as well"


def scenario_text(source: Source, guesses: Guesses, result: Run, until: float, below: Guesses) -> str:
    """Return the text of a scenario: one path through the menus, above a machine file with the guesses `below`."""
    assert guesses.path is not None
    choices = ", ".join(f'"{question or "INPUT"}" {choice}' for question, choice in guesses.path.items())
    others = [channel for channel in sorted(below.inputs) if channel not in guesses.inputs]
    inputs = [guesses.inputs[each] for each in sorted(guesses.inputs) if _differs(each, guesses, below)]
    inputs += [{"channel": each, "at": 0.0, "value": 0} for each in others]
    analogue = [each for each in guesses.analogue.values() if each not in below.analogue.values()]
    answers = [answer_entry(each, text) for each, texts in guesses.answers.items() for text in texts]
    keys = [] if guesses.keys == below.keys else guesses.keys
    sections = [
        SCENARIO.format(choices=choices, program=os.path.basename(source.name), **_end(result, until)),
        *_table("input", "\n", [_guess(each) for each in inputs]),
        *_table("analogue", "\n", [_guess(each) for each in analogue]),
        *_table("answer", "\n", [_guess(each) for each in answers]),
        *_table("key", "\n", [_guess(each) for each in keys]),
    ]
    for number, settings in sorted(guesses.axes.items()):
        if settings != below.axes.get(number):
            sections.append(f"\n[axis.{number}]\n{_switches(settings)}")
    sections.append(_status(result))
    return "".join(sections)


def scenario_name(guesses: Guesses) -> str:
    """Return the name of the scenario of a path, such as `choice-2-1`."""
    choices = guesses.path.values() if guesses.path is not None else ()
    return "-".join(["choice", *(each.replace("-", "minus") for each in choices)])


def _end(result: Run, until: float) -> dict[str, object]:
    """Return the time limit, and the line about what ends the run before it."""
    stop = _stop(result)
    text = f"run.stop = {inline(stop)}    # {ASKS if 'event' in stop else REPEATS}\n" if stop else ""
    return {"until": until, "limit": LIMIT, "stop": text}


def _stop(result: Run) -> dict[str, object]:
    return {"event": "input"} if result.status == "stopped" else ending(result)


def _status(result: Run) -> str:
    """Return the expected outcome of a run."""
    if _stop(result):
        return STATUS.format(status="stopped")
    return STATUS.format(status=result.status) if result.status in ("ended", "until") else FAULT


def _differs(channel: int, guesses: Guesses, below: Guesses) -> bool:
    return not below.is_fixed(channel) and guesses.inputs[channel] != below.inputs.get(channel)


def _inputs(program: Program, language: Dialect, guesses: Guesses, reads: list[InputRead]) -> list[str]:
    """Return an entry for each input of the program.

    Comments above an entry quote the lines that read the input, or assign it to a function.
    """
    read_at: dict[int, dict[int, None]] = {}
    for read in reads:
        if read.is_input and read.channel is not None:
            read_at.setdefault(read.channel, {})[read.line] = None
    for each in channels_of(program, language):
        if each.kind == "input" and each.number.isdecimal() and each.set_up:
            read_at.setdefault(int(each.number), {}).update(dict.fromkeys(each.set_up))
    found: list[str] = []
    for channel in sorted(read_at.keys() | guesses.inputs.keys()):
        for line in list(read_at.get(channel, ()))[:MAX_LINES]:
            found.append(f"  # line {line}: {_quoted(program.source.line(line))}")
        if channel in guesses.inputs:
            found.append(_guess(guesses.inputs[channel]))
        elif guesses.is_fixed(channel):
            found += [
                line
                for line in _lines(guesses.fixed, "input")
                if line.startswith(f"  {{ channel = {channel},")
            ]
        else:
            found.append(
                f"  # {inline({'channel': channel, 'at': 0.0})},    # take the first # away to switch it on"
            )
    return found


def _unknown(source: Source, reads: list[InputRead]) -> list[str]:
    """Return the comment about lines that read inputs of unknown channels; empty if there are none."""
    lines = dict.fromkeys(each.line for each in reads if each.is_input and each.channel is None)
    quoted = "".join(f"# line {line}: {_quoted(source.line(line))}\n" for line in lines)
    return [UNKNOWN.format(lines=quoted)] if quoted else []


def _lines(settings: Mapping[str, object], table: str) -> list[str]:
    """Return the lines of the entries that a person has given."""
    return [f"  {inline(each)}," for each in entries(settings, table)]


def _guess(entry: Entry) -> str:
    return f"  {inline({**entry, 'guess': True})},"


def _table(name: str, head: str, lines: list[str]) -> list[str]:
    return [head, f"{name} = [\n", *(f"{line}\n" for line in lines), "]\n"] if lines else []


def _axis(number: int, guesses: Guesses, result: Run) -> str:
    scale = result.controller.axes[number].scale.counts
    text = f"\n[axis.{number}]    # {scale:.10g} {'count' if scale == 1 else 'counts'} per user unit\n"
    keys = guesses.axes.get(number, {})
    text += _switches(keys) if keys else ""
    low, high, speed, rate = (
        _figure(f"{name}.{number}", result) for name in ("lowest", "highest", "peak", "accel")
    )
    places = _places(number, result)
    if places is not None:
        low = floor(low * 10**places + SLACK) / 10**places
        high = ceil(high * 10**places - SLACK) / 10**places
    digits = ".6g" if places is None else ".10g"
    text += f"{LIMITS}# limits.position = [{low:{digits}}, {high:{digits}}]\n"
    text += f"# limits.speed = {speed:.6g}\n# limits.acceleration = {rate:.6g}\n"
    return text


def _places(number: int, result: Run) -> int | None:
    """Return the decimal places of the positions to which a program moves an axis.

    Jogs and moves that were cut short do not count. Returns None if there are no others, or if they have more than
    `MAX_PLACES`.
    """
    ends = [
        end
        for row in moves(result)
        if row["axis"] == number and row["profile"] != "jog" and "ended" not in row
        if isinstance(end := row["end"], float)
    ]
    exact = (
        places
        for places in range(MAX_PLACES + 1)
        if all(isclose(each, round(each, places), abs_tol=SAME) for each in ends)
    )
    return next(exact, None) if ends else None


def _switches(keys: dict[str, object]) -> str:
    lines = [f"{key} = {toml_value(value)}\n" for key, value in keys.items()]
    return "".join([*lines, "guess = true    # the switches\n"])


def _figure(name: str, result: Run) -> float:
    row, number = quantity(name)
    value = row.read(result, number)
    return float(value) if isinstance(value, (int, float)) else 0.0


def inline(entry: Entry) -> str:
    """Return an entry as an inline table of TOML."""
    return f"{{ {', '.join(f'{key} = {toml_value(value)}' for key, value in entry.items())} }}"


def toml_value(value: object) -> str:
    """Return a value as TOML has it."""
    if isinstance(value, list):
        return f"[{', '.join(map(toml_value, value))}]"
    text = json.dumps(value, ensure_ascii=False)  # the numbers, truth values and texts of TOML
    return text.replace("\x7f", "\\u007f")


def _quoted(line: str) -> str:
    text = " ".join(line.split())
    return text if len(text) <= MAX_TEXT else f"{text[:MAX_TEXT].rstrip()} …"

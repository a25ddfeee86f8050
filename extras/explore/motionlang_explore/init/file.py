"""Text of a draft machine file: guesses, and limits to fill in.

Each guess is preceded by the line of the program that needs it.
"""

from __future__ import annotations

import os
from math import ceil, floor, inf, isclose

from motionlang.commands.channels import channels_of
from motionlang.commands.quantities import quantity
from motionlang.commands.scenarios import scenario_folder
from motionlang.kernel import Run
from motionlang.kernel.lang import Structure, Target
from motionlang.kernel.report import moves
from motionlang.kernel.tools import count_of, listed
from motionlang_explore.exploration import Entry, Exploration, RestState, Transition, entries
from motionlang_explore.init import Choice, Draft, at_last_move, cycle_text, ending
from motionlang_explore.scenario_text import inline, scenario_text, toml_value

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
#{cut}
# A line with `guess = true` is a guess. Correct it and remove `guess = true`; until then, a run that depends on it
# reports it. docs/machine-file.md explains every key.
{cycles}
{model}run.until = {until:.10g}    # {limit}
{stop}"""
CUT = "\n# It was cut off before the world of its cycle was found.\n#"
# The comments of a time limit, and of what ends the run before it.
LIMIT = "the run ends here if the program does not"
ASKS = "the program asks again, and there is no further answer"
REPEATS = "the program has no end: this is what a run of it shows"
SCENARIO = """\
{choices}: a path through the menus of {program}, written by motionlang init. It adds to the machine file next to the \
program. docs/scenarios.md explains scenarios."""
INPUTS = """
# Digital inputs. `at` is a time in seconds, `output` the output that the input follows after `delay`, `asked` the time
# after which it changes once the program waits for it; `value = 0` inverts an input.
"""
ANALOGUE = """
# Analogue inputs, in percent.
"""
ANSWERS = """
# Lines that the operator types when the program asks.
"""
ENCODERS = """
# Encoders that something outside the controller turns, in counts per second.
"""
KEYS = """
# Keys that the operator presses.
"""
COMMS = """
# Elements of the comms array that the host writes.
"""
NETDATA = """
# Elements of NetData that the host writes.
"""
REGISTERS = """
# Registers of Modbus servers that the program reads.
"""
HEADS = {
    "input": INPUTS,
    "analogue": ANALOGUE,
    "comms": COMMS,
    "netdata": NETDATA,
    "modbus.register": REGISTERS,
    "answer": ANSWERS,
    "key": KEYS,
}
LIMITS = """\
# Limits to fill in; the figures are those of this run. `motionlang certify` compares them with a run.
"""
UNKNOWN = """
# Digital inputs whose channels are only known while the program runs.
{lines}"""
EXPECT = """
# Expectations that `motionlang verify` checks. A scenario, another world for the same program, is a file of its own
# in the folder {folder}: docs/scenarios.md."""
FAULT = """
# The program stops with an error in this machine, so there is no [[expect]] for `motionlang verify` yet.
"""


def machine_text(draft: Draft, until: float, target: Target) -> str:
    """Return the text of the machine file of a draft."""
    exploration, result, switches = draft.exploration, draft.run, draft.exploration.switches.axes
    source = exploration.program.source
    name = os.path.basename(source.name)
    stop = _stop(result)
    why = ASKS if "event" in stop else standstill(result) or REPEATS
    ends = f"run.stop = {inline(stop)}    # {why}\n" if stop else ""
    head = HEAD.format(
        program=name,
        cut=CUT if exploration.interrupted is not None else "",
        model=_model(target),
        cycles=_cycles(draft),
        until=until,
        limit=LIMIT,
        stop=ends,
    )
    sections = [head, *_table("input", INPUTS, _inputs(draft)), *_unknown(exploration.program.structure)]
    for table in (each for each in HEADS if each != "input"):
        guessed = [_guess(each, draft) for each in draft.entries(table)]
        sections += _table(table, HEADS[table], _lines(draft, table) + guessed)
    encoders = [_guess(each, draft) for each in exploration.switches.encoders]
    sections += _table("encoder", ENCODERS, encoders)
    for number in sorted({move.axis for move in result.machine.log.moves} | switches.keys()):
        sections.append(_axis(number, _switches(draft, number), result))
    expected = _expected(result)
    if exploration.fault_of(result):  # a line of trouble is nothing to expect
        expected = [each for each in expected if "prints" not in each]
    if exploration.interrupted is None:
        sections.append(EXPECT.format(folder=scenario_folder(name)) if expected else FAULT)
    for each in expected if exploration.interrupted is None else ():
        sections += ["\n[[expect]]\n", *(f"{key} = {toml_value(value)}\n" for key, value in each.items())]
    return "".join(sections)


def _cycles(draft: Draft) -> str:
    """Return the comment about the cycle, and the next two."""
    exploration, cycle = draft.exploration, draft.run.cycle
    found = [(number, each) for number, each in enumerate(exploration.cycles, start=1) if each.work]
    if not found:
        return ""
    chosen = draft.world.cycle
    lines = [f"# cycle: {cycle_text(exploration, chosen, None if cycle is None else cycle.period)}"]
    for number, each in found:
        if each is not chosen and len(lines) < MAX_LINES:
            said = dict.fromkeys(each.said[-MAX_LINES:])
            prints = f", prints {', '.join(said)}" if said else ""
            lines.append(f"#   --cycle {number}: {cycle_text(exploration, each)}{prints}")
    return "".join(["#\n", *(f"{line}\n" for line in lines)])


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
    return f"{listed(target.others)} {'fits' if len(target.others) == 1 else 'fit'} the program as well"


def path_text(choice: Choice, draft: Draft, below: Draft, until: float) -> str:
    """Return the text of a scenario: a way through the menus, on top of the machine file of the draft below."""
    name = os.path.basename(draft.exploration.program.source.name)
    stop = _stop(draft.run) or (at_last_move(draft.run) if _stop(below.run) else {})
    settings: dict[str, object] = {"run.until": until}
    settings |= {f"run.stop.{key}": value for key, value in stop.items()}
    for table in HEADS:
        mine, others = draft.entries(table), below.entries(table)
        if table == "input":
            used = {each["channel"] for each in mine}
            off = dict.fromkeys(each["channel"] for each in others if each["channel"] not in used)
            changed = [each for each in mine if _about(each, mine) != _about(each, others)]
            mine = [*changed, *({"channel": each, "at": 0.0, "value": 0} for each in off)]
        elif mine == others:
            continue
        if mine:
            settings[table] = [{**each, "guess": True} for each in mine]
    expected: list[Entry] = [{"status": "stopped"}] if stop else _expected(draft.run)
    return scenario_text(SCENARIO.format(choices=choice, program=name), settings, expected)


def _about(entry: Entry, among: list[Entry]) -> list[Entry]:
    """Return the entries of the same channel."""
    return [each for each in among if each["channel"] == entry["channel"]]


def standstill(result: Run) -> str:
    """Return where a run with a cycle waits for ever behind it, in words; "" if it goes on to its end."""
    cycle, log = result.cycle, result.machine.log
    if cycle is None or result.status not in ("until", "fault") or not log.moves:
        return ""
    last = max(each.start_time for each in log.moves)
    waits = [text for text in result.wait_notes if text.startswith("line ")]
    if 2.0 * last >= result.time or not waits:
        return ""
    line = waits[0].partition(":")[0]
    return f"it waits for ever in {line} after {count_of(cycle.count, 'cycle')}: its world has no more"


def _stop(result: Run) -> dict[str, object]:
    return {"event": "input"} if result.status == "stopped" else ending(result)


def _expected(result: Run) -> list[Entry]:
    """Return the expected outcome of a run: how it ends, and what it prints in each cycle; empty after an error."""
    stop = _stop(result)
    if stop:
        return [{"status": "stopped"}, *([{"prints": stop["prints"]}] if "prints" in stop else ())]
    return [{"status": result.status}] if result.status in ("ended", "until") else []


def _inputs(draft: Draft) -> list[str]:
    """Return an entry for each input of the program, and for those that were measured.

    The comments above it quote the lines of the states that it leads on from, or else those that read it. What the
    cycle does not need is a comment with what it would do.
    """
    exploration = draft.exploration
    program = exploration.program
    read_at: dict[int, dict[int, None]] = {}
    for line, use in program.structure.inputs():
        if use.channel == "input" and use.number.isdecimal():
            read_at.setdefault(int(use.number), {})[line] = None
    for each in channels_of(program, draft.run.dialect):
        if each.kind == "input" and each.number.isdecimal() and each.set_up:
            read_at.setdefault(int(each.number), {}).update(dict.fromkeys(each.set_up))
    leads = leading(exploration)
    mine: dict[int, list[Entry]] = {}
    for entry in draft.entries("input"):
        mine.setdefault(int(str(entry["channel"])), []).append(entry)
    given = {int(str(each["channel"])) for each in entries(draft.given, "input")}
    found: list[str] = []
    for channel in sorted(read_at.keys() | mine.keys() | given | set(exploration.channels)):
        lines = list(leads.get(channel, read_at.get(channel, {})))
        found += [f"  # line {line}: {quoted(program.source.line(line))}" for line in lines[:MAX_LINES]]
        if channel in mine:
            found += [_guess(each, draft) for each in mine[channel]]
        elif channel in given:
            found += [
                line for line in _lines(draft, "input") if line.startswith(f"  {{ channel = {channel},")
            ]
        else:
            does = _does(exploration, channel) or "take the first # away to switch it on"
            found.append(f"  # {inline({'channel': channel, 'at': 0.0})},    # {does}")
    return found


def leading(exploration: Exploration) -> dict[int, dict[int, None]]:
    """Return the lines of the states that each input leads on from, alone or with others that are needed, too."""
    found: dict[int, dict[int, None]] = {}
    for node in exploration.nodes:
        onward = (each for each in node.transitions if each.lines or each.target != node.state)
        ways = [set(each.causes) for each in onward if each.causes and each.source is not None]
        least = [way for way in ways if not any(other < way for other in ways)]
        for channel in sorted({one.number for way in least for one in way if one.table == "input"}):
            line = exploration.read_line(node.state or (), ("input", channel))
            found.setdefault(channel, {})[line] = None
    return found


def _does(exploration: Exploration, channel: int) -> str:
    """Return what happens when an input is switched on: the line of the state, other changes, and the first acts."""
    on = ("input", channel, 1.0)
    found = [
        each for each in _transitions(exploration) if on in [(one[:3]) for one in each.causes] and each.source
    ]
    for each in sorted(found, key=lambda each: len(each.causes)):
        moment = next(one.moment for one in each.causes if one[:3] == on)
        others = " and ".join(str(one) for one in each.causes if one[:3] != on)
        onward = (
            "the program ends" if each.target is None else f"waits in line {_line(exploration, each.target)}"
        )
        acts = ", ".join(map(str, each.acts[:2])) or onward
        return f"line {_line(exploration, each.source)}{moment}{f', with {others}' if others else ''}: {acts}"
    return ""


def _line(exploration: Exploration, state: RestState | None) -> int:
    """Return the first line of a state; 0 at power-up."""
    return min((exploration.line(at) for place in state or () for at in place.statements), default=0)


def _transitions(exploration: Exploration) -> list[Transition]:
    return [each for node in exploration.nodes for each in node.transitions]


def _unknown(structure: Structure) -> list[str]:
    """Return the comment about lines that read inputs of unknown channels; empty if there are none."""
    lines = dict.fromkeys(line for line, use in structure.inputs() if not use.number.isdecimal())
    comments = "".join(f"# line {line}: {quoted(structure.source.line(line))}\n" for line in lines)
    return [UNKNOWN.format(lines=comments)] if comments else []


def _lines(draft: Draft, table: str) -> list[str]:
    """Return the lines of the entries that a person or a recording has given."""
    return [_measured(inline(each), draft) for each in entries(draft.given, table)]


def _guess(entry: Entry, draft: Draft) -> str:
    return _measured(inline({**entry, "guess": True}), draft)


def _measured(text: str, draft: Draft) -> str:
    """Return the line of an entry, with what was measured."""
    comment = draft.comments.get(text, "")
    return f"  {text}," + (f"    # {comment}" if comment else "")


def _table(name: str, head: str, lines: list[str]) -> list[str]:
    return [head, f"{name} = [\n", *(f"{line}\n" for line in lines), "]\n"] if lines else []


def _axis(number: int, switches: str, result: Run) -> str:
    scale = result.controller.axes[number].scale.counts
    text = f"\n[axis.{number}]    # {scale:.10g} {'count' if scale == 1 else 'counts'} per user unit\n"
    text += switches
    low, high, speed, rate = (
        _figure(f"{name}.{number}", result) for name in ("lowest", "highest", "peak", "accel")
    )
    places = _places(number, result)
    if places is not None:
        low = floor(low * 10**places + SLACK) / 10**places
        high = ceil(high * 10**places - SLACK) / 10**places
    digits = ".6g" if places is None else ".10g"
    text += f"{LIMITS}# limits.position = [{low:{digits}}, {high:{digits}}]\n"
    text += f"# limits.speed = {speed:.6g}\n"
    return text + (f"# limits.acceleration = {rate:.6g}\n" if rate < inf else "")


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


def _switches(draft: Draft, number: int) -> str:
    """Return the lines of the guessed switches of an axis, with what was measured; "" if there are none."""
    keys = draft.exploration.switches.axes.get(number, {})
    lines = []
    for key, guess in keys.items():
        name = f"axis.{number}.{key}"
        comment = draft.comments.get(name, "")
        lines.append(
            f"{key} = {toml_value(draft.given.get(name, guess))}{f'    # {comment}' if comment else ''}\n"
        )
    return "".join([*lines, "guess = true    # the switches\n"]) if lines else ""


def _figure(name: str, result: Run) -> float:
    row, number = quantity(name)
    value = row.read(result, number)
    return float(value) if isinstance(value, (int, float)) else 0.0


def quoted(line: str) -> str:
    """Return a line of the program as a comment or a note quotes it: without its indentation, and cut if it is long."""
    text = " ".join(line.split())
    return text if len(text) <= MAX_TEXT else f"{text[:MAX_TEXT].rstrip()} …"

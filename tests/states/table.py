"""The table of motion commands and states of a language: its text, and what a run shows of each cell.

A file begins with the lines that every program has, then the states, then the commands:

    = moving: MOVEA(0) = 40 : GO(0) : WAIT = 1000
    > JOG(0) = 5
      idle: starts                                   [MN1270 p. 68]
      moving, stopping: replaces it                  [choice]

A line below a command has the states in which the same happens, what happens, and in brackets the source that settles
it. The first line that a state needs of its machine file is written with `|`.
"""

from __future__ import annotations

import re
from dataclasses import dataclass, field
from pathlib import Path

from motionlang import Run, run
from motionlang.kernel import Source, read_machine

CHOICE = "choice"
# Statements take some 10 µs; what takes longer waits.
AT_ONCE = 1e-3
_LINE = re.compile(r"  (.*?): (.*?)\s+\[(.*)\]$")


@dataclass
class Table:
    """A file: its head, the states with their programs, the commands, and the sources by command and outcome."""

    path: Path
    head: list[str] = field(default_factory=list)
    states: dict[str, str] = field(default_factory=dict)
    commands: list[str] = field(default_factory=list)
    sources: dict[tuple[str, str], str] = field(default_factory=dict)
    cells: dict[tuple[str, str], str] = field(default_factory=dict)

    @classmethod
    def read(cls, path: Path) -> Table:
        table = cls(path)
        for line in path.read_text(encoding="utf-8").splitlines():
            if line.startswith("= "):
                name, _, program = line[2:].partition(":")
                table.states[name] = program.strip()
            elif line.startswith("> "):
                table.commands.append(line[2:])
            elif found := _LINE.match(line):
                command = table.commands[-1]
                table.sources[command, found[2]] = found[3]
                table.cells |= {(command, state): found[2] for state in found[1].split(", ")}
            elif not table.commands and not table.states:
                table.head.append(line)
        return table

    def text(self, cells: dict[tuple[str, str], str]) -> str:
        """Return the file with these cells; an outcome that is new is a choice."""
        lines = [*self.head, *(f"= {name}: {program}".rstrip() for name, program in self.states.items())]
        for command in self.commands:
            lines += ["", f"> {command}"]
            outcomes: dict[str, list[str]] = {}
            for state in self.states:
                outcomes.setdefault(cells[command, state], []).append(state)
            for outcome, states in outcomes.items():
                source = self.sources.get((command, outcome), CHOICE)
                lines.append(f"  {', '.join(states)}: {outcome}  [{source}]")
        return "\n".join(lines) + "\n"

    def found(self, command: str) -> dict[tuple[str, str], str]:
        """Return what runs show of a command, by command and state."""
        return {(command, state): self.outcome(command, state) for state in self.states}

    def outcome(self, command: str, state: str) -> str:
        """Run a command in a state, and return in words what happens."""
        before = [line for line in self.head if line and line[0] not in "|'#;"]
        settings = "\n".join(line[2:] for line in self.head if line.startswith("| "))
        machine = read_machine(Source("states.machine.toml", settings))
        marks = ('PRINT "at"', 'PRINT "after"') if self.path.stem == "mint" else ('OT"at"', 'OT"after"')
        lines = [*before, self.states[state], marks[0], command, marks[1]]
        number = len(lines) - 1
        rest = ["WAIT = 20000"] if self.path.stem == "mint" else ["WA20"]
        handler = (
            ["End", "Event ONERROR", '  PRINT "refused "; ERRCODE', "End Event"]
            if state == "in error"
            else []
        )
        suffix = ".mnt" if self.path.stem == "mint" else ".mcl"
        done = run(
            Source(f"states{suffix}", "\n".join([*lines, *rest, *handler])), machine=machine, until=60.0
        )
        lines[number - 1] = ""
        without = run(
            Source(f"states{suffix}", "\n".join([*lines, *rest, *handler])), machine=machine, until=60.0
        )
        return described(done, without, number)


def described(done: Run, without: Run, line: int) -> str:
    """Return what the command of a line did, from its run and the same run without it."""
    locate = done.dialect.locate
    kinds = [
        each.kind
        for each in done.machine.log.events
        if each.kind not in ("handler", "wait") and each.at >= 0 and locate(done.source, each.at)[0] == line
    ]
    events = f"; event {', '.join(dict.fromkeys(kinds))}" if kinds else ""
    texts = [each.text for each in done.machine.log.prints]
    refused = [each.code for each in done.diagnostics if each.line == line and each.severity == "error"]
    refused += [
        each.removeprefix("refused ") for each in texts[texts.index("at") :] if each.startswith("refused")
    ]
    if "never" in refused:
        return f"waits for ever{events}"
    if refused:
        return f"refused: {refused[0]}{events}"
    times = {each.text: each.time for each in done.machine.log.prints}
    after = times.get("after", times["at"])
    waited = "waits, then " if after - times["at"] > AT_ONCE else ""
    return f"{waited}{_motion(done, without, line, after)}{events}"


def _motion(done: Run, without: Run, line: int, after: float) -> str:
    log = done.machine.log
    if moves := [each for each in log.moves if each.line == line]:
        if moves[0].start_time > after + AT_ONCE:
            return "waits in the buffer"
        return "replaces it" if any(each.ended == "retarget" for each in log.moves) else "starts"
    waiting = [each for a in done.controller.axes.values() for each in a.buffer if each.line == line]
    if waiting:
        return "waits in the buffer" if waiting[0].released else "waits for GO"
    if any(each.line == line for each in log.dropped):
        return "is dropped"
    own, other = _states(done, after), _states(without, after)
    if own["velocity"] != other["velocity"]:
        ends = [[each.ended for each in run.machine.log.moves] for run in (done, without)]
        return f"ends it by {ends[0][-1]}" if ends[0] != ends[1] and ends[0][-1] else "changes the motion"
    if own["enabled"] != other["enabled"]:
        return "switches it"
    return "sets the position" if own["position"] != other["position"] else "no motion changes"


def _states(run: Run, after: float) -> dict[str, list[float]]:
    """Return what the axes do after a command."""
    axes, times = run.controller.axes.values(), [after + each for each in (0.05, 0.5, 2.0, 10.0)]
    return {
        "position": [round(a.position(time), 6) for a in axes for time in times],
        "velocity": [round(a.velocity(time), 6) for a in axes for time in times],
        "enabled": [float(a.enabled) for a in axes],
    }

"""The behaviour of a machine, found by playing: rest states of its program, transitions and cycles.

Problem. A control program waits for its world, and its text does not say what the world should do. Conclusions from
the text need a form for each way in which a program can be written.

Idea. Nothing is concluded: the program runs. At rest it is in few states: it waits at a statement, or repeats those of
a loop. From each state each thing that it reads is changed once, and the program runs on to its next rest. What leads
on is a transition. Transitions that return to a state are a cycle.

    power-up ──► waits in 19 ── input 2 on ──► waits in 22 ── input 3 on ──► waits in 44 ──► …
                                                                  ▲                            │
                                                                  └────── input 0 off ─────────┘

Search. The states with the fewest changes come first. A change that leads a state to something new, or moves an axis,
may depend on the other inputs that are read there, so it is tried again together with each of those. A state that was
known with an end of its own, and is found as one that lasts, is tried again with its levels. Levels of analogue inputs,
numbers of a host and keys come from comparisons: an unusual value is played, and both sides of the comparisons that
follow are solved for it (`values.py`).

Without a choice are the switches of an axis that homes for ever, and the answer to a question.

Cost. At most `MAX_TRIALS` trials, and a run from power-up for each state that is left: its trials go on from a snapshot
(`trials.py`), and end soon after the program has come to states that are known to last. The same program gives the same
result.

The world of the likeliest cycle is then described by simple rules (`world.py`).

Not simulated yet: changes in the middle of a move, the joint state of several tasks, menus, and in the world of a cycle
buttons, positions of axes, and the way on where a level is there already.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import NamedTuple

from motionlang.commands.explore.cycles import Cycle, cycles
from motionlang.commands.explore.rests import RestState, TaskRest
from motionlang.commands.explore.search import MAX_TRIALS, Explorer, Node, Transition
from motionlang.commands.explore.world import World, world_of
from motionlang.kernel import Program

__all__ = ["Cycle", "Exploration", "Node", "RestState", "TaskRest", "Transition", "World", "explore"]


class Exploration(NamedTuple):
    """The states of a machine with their transitions, power-up first; its cycles, the likeliest first; the trials.

    `world` is that of the first cycle that repeats when it is played, None without a cycle.
    """

    nodes: Sequence[Node]
    cycles: Sequence[Cycle]
    trials: int
    world: World | None


def explore(
    program: Program, machine: Mapping[str, object] | None = None, *, trials: int = MAX_TRIALS
) -> Exploration:
    """Explore a program, a debug build, in a world with the settings that a person gave, by so many trials."""
    explorer = Explorer(program, machine or {}, trials)
    explorer.explore()
    likeliest, count = cycles(explorer.nodes, explorer.working), explorer.trials.count
    world = world_of(explorer, likeliest)
    return Exploration(list(explorer.nodes.values()), likeliest, count, world)

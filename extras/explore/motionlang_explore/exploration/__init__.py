"""The behaviour of a machine, found by playing: rest states of its program, transitions and cycles.

Problem. A control program waits for its world, and its text does not say what the world should do. Conclusions from
the text need a form for each way in which a program can be written.

Idea. Nothing is concluded: the program runs. At rest it is in few states: it waits at a statement, or repeats those of
a loop. From each state each thing that it reads is changed once, and the program runs on to its next rest. What leads
on is a transition. Transitions that return to a state are a cycle.

    power-up ──► waits in 19 ── input 2 on ──► waits in 22 ── input 3 on ──► waits in 44 ──► …
                                                                  ▲                            │
                                                                  └────── input 0 off ─────────┘

Search. What was read decides: the trial records which statement has read which channel, and what a state asks for is
changed (`questions.py`): one channel, then several that one statement has read, then those that were read on the way. A
number knows of which readings it was worked out (`motionlang.kernel.traced`). A level, a number of a host, a register
and a key come from comparisons: an unusual value is played, and each comparison that follows says at which value it
turns (`values.py`). Of a bank of inputs only those count on which a condition depends.

A state is where the tasks rest (`rests.py`), and what the program remembers there: the variables that decide what it
does later (`memory.py`). At a place that is known already, what led on there is tried first.

An input that is read while an axis moves, or whose change starts a handler, is changed in the middle of the move, too.
If the comparisons of a program count how often an input comes, in a move or at rest, it comes as often as they ask for.

A question is a state, and an answer is a change. Without a choice are the switches of an axis that homes for ever
(`switches.py`). The likeliest cycles (`cycles.py`) are played (`playing.py`), and the world of the first that repeats
is described by simple rules (`world.py`); where it does little, simple worlds are tried (`simple.py`), first those that
names suggest (`likely.py`). A long run in that world shows what only a full layer or the end of a batch brings, and the
search goes on behind it (`further.py`).

Not simulated yet: changes of anything but an input in the middle of a move.

Cost. The statements that all trials begin, and what else they cost, in the work that a core does in some seconds. The
search may take half of it, and the worlds the rest; a trial goes on from a snapshot (`trials.py`). The same program
gives the same result on every machine, unless the user ends the exploration.
"""

from __future__ import annotations

from motionlang_explore.exploration.changes import (
    TABLES,
    TEXTS,
    Change,
    Channel,
    Moment,
    Timeline,
    entries,
    in_words,
    keys_of,
    made_at,
    made_by,
    number_in,
    tables_of,
)
from motionlang_explore.exploration.cycles import MachineCycle
from motionlang_explore.exploration.exploration import Exploration, PlayedTimeline
from motionlang_explore.exploration.exploring import (
    PIECE,
    SECONDS,
    explore,
    explored,
    without_world,
)
from motionlang_explore.exploration.likely import OFF
from motionlang_explore.exploration.rests import (
    SHORTEST_REST,
    Rest,
    RestState,
    TaskRest,
    lines_of,
    statements_of,
    without_memory,
)
from motionlang_explore.exploration.search import Progress
from motionlang_explore.exploration.simple import LENGTH
from motionlang_explore.exploration.states import (
    Effect,
    StateNode,
    Transition,
    Visit,
)
from motionlang_explore.exploration.switches import FoundSwitches
from motionlang_explore.exploration.trials import (
    HORIZON,
    SECOND,
    SHORTEST_MOVE,
    Act,
    Interrupted,
    Trial,
    asks,
)
from motionlang_explore.exploration.values import is_probe, levels
from motionlang_explore.exploration.words import is_pushed, is_reset, is_run, is_wrong, names_alarm
from motionlang_explore.exploration.world import FoundWorld
from motionlang_explore.identification import Entry

__all__ = [
    "HORIZON",
    "LENGTH",
    "OFF",
    "PIECE",
    "SECOND",
    "SECONDS",
    "SHORTEST_MOVE",
    "SHORTEST_REST",
    "TABLES",
    "TEXTS",
    "Act",
    "Change",
    "Channel",
    "Effect",
    "Entry",
    "Exploration",
    "FoundSwitches",
    "FoundWorld",
    "Interrupted",
    "MachineCycle",
    "Moment",
    "PlayedTimeline",
    "Progress",
    "Rest",
    "RestState",
    "StateNode",
    "TaskRest",
    "Timeline",
    "Transition",
    "Trial",
    "Visit",
    "asks",
    "entries",
    "explore",
    "explored",
    "in_words",
    "is_probe",
    "is_pushed",
    "is_reset",
    "is_run",
    "is_wrong",
    "keys_of",
    "levels",
    "lines_of",
    "made_at",
    "made_by",
    "names_alarm",
    "number_in",
    "statements_of",
    "tables_of",
    "without_memory",
    "without_world",
]

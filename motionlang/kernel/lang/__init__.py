"""Common code of the languages: vocabulary, grammars, programs, tasks, scheduler."""

from __future__ import annotations

from typing import TYPE_CHECKING

from motionlang.kernel.lazy import lazy_names

if TYPE_CHECKING:
    from motionlang.kernel.lang.comments import Named as Named
    from motionlang.kernel.lang.comments import comments_of as comments_of
    from motionlang.kernel.lang.comments import names_in_comments as names_in_comments
    from motionlang.kernel.lang.comments import remarks as remarks
    from motionlang.kernel.lang.comments import without_marks as without_marks
    from motionlang.kernel.lang.debugging import Frame as Frame
    from motionlang.kernel.lang.foreign import AT_PROMPT as AT_PROMPT
    from motionlang.kernel.lang.foreign import IN_EDITOR as IN_EDITOR
    from motionlang.kernel.lang.foreign import one_sentence as one_sentence
    from motionlang.kernel.lang.keyword import BANK as BANK
    from motionlang.kernel.lang.keyword import CHANNELS as CHANNELS
    from motionlang.kernel.lang.keyword import HOST_CHANNELS as HOST_CHANNELS
    from motionlang.kernel.lang.keyword import TOPICS as TOPICS
    from motionlang.kernel.lang.literals import Literal as Literal
    from motionlang.kernel.lang.literals import canonical as canonical
    from motionlang.kernel.lang.literals import number as number
    from motionlang.kernel.lang.literals import number_text as number_text
    from motionlang.kernel.lang.literals import replaced as replaced
    from motionlang.kernel.lang.literals import revalued as revalued
    from motionlang.kernel.lang.machine.entries import Given as Given
    from motionlang.kernel.lang.machine.entries import check_inputs_are_read as check_inputs_are_read
    from motionlang.kernel.lang.machine.file import first_mistake as first_mistake
    from motionlang.kernel.lang.machine.file import flat as flat
    from motionlang.kernel.lang.machine.file import generic as generic
    from motionlang.kernel.lang.machine.file import read_toml as read_toml
    from motionlang.kernel.lang.machine.keys import CHOICES as CHOICES
    from motionlang.kernel.lang.machine.keys import DRIVES as DRIVES
    from motionlang.kernel.lang.machine.keys import KEYS as KEYS
    from motionlang.kernel.lang.machine.keys import MAX_AXES as MAX_AXES
    from motionlang.kernel.lang.machine.keys import REQUIRED as REQUIRED
    from motionlang.kernel.lang.machine.keys import TABLES as TABLES
    from motionlang.kernel.lang.machine.layers import is_key_of_entries as is_key_of_entries
    from motionlang.kernel.lang.machine.layers import layered as layered
    from motionlang.kernel.lang.machine.layers import with_key_of_entries as with_key_of_entries
    from motionlang.kernel.lang.machine.machine import CONSOLE as CONSOLE
    from motionlang.kernel.lang.machine.operator import Operator as Operator
    from motionlang.kernel.lang.machine.switch import ASSUMPTIONS as ASSUMPTIONS
    from motionlang.kernel.lang.machine.switch import switch as switch
    from motionlang.kernel.lang.machine.terminal import Terminal as Terminal
    from motionlang.kernel.lang.names import NO_NAMES as NO_NAMES
    from motionlang.kernel.lang.names import Changes as Changes
    from motionlang.kernel.lang.names import Definition as Definition
    from motionlang.kernel.lang.names import Names as Names
    from motionlang.kernel.lang.names import Span as Span
    from motionlang.kernel.lang.program import Target as Target
    from motionlang.kernel.lang.run_errors import explain as explain
    from motionlang.kernel.lang.snapshot import Snapshot as Snapshot
    from motionlang.kernel.lang.step_graph import StepGraph as StepGraph
    from motionlang.kernel.lang.step_list import ListedStep as ListedStep
    from motionlang.kernel.lang.step_list import ListedUnit as ListedUnit
    from motionlang.kernel.lang.step_list import listed_units as listed_units
    from motionlang.kernel.lang.step_task import StepTask as StepTask
    from motionlang.kernel.lang.steps import BACK as BACK
    from motionlang.kernel.lang.steps import BRANCH as BRANCH
    from motionlang.kernel.lang.steps import CALL as CALL
    from motionlang.kernel.lang.steps import END as END
    from motionlang.kernel.lang.steps import ENDLESS as ENDLESS
    from motionlang.kernel.lang.steps import ENTER as ENTER
    from motionlang.kernel.lang.steps import GO as GO
    from motionlang.kernel.lang.steps import HEAD as HEAD
    from motionlang.kernel.lang.steps import NEXT as NEXT
    from motionlang.kernel.lang.steps import RETURN as RETURN
    from motionlang.kernel.lang.steps import STOP as STOP
    from motionlang.kernel.lang.steps import TEST as TEST
    from motionlang.kernel.lang.steps import UNTIL as UNTIL
    from motionlang.kernel.lang.steps import Step as Step
    from motionlang.kernel.lang.steps import Uses as Uses
    from motionlang.kernel.lang.steps import Values as Values
    from motionlang.kernel.lang.steps import conditions as conditions
    from motionlang.kernel.lang.structure import ACTS as ACTS
    from motionlang.kernel.lang.structure import NAME as NAME
    from motionlang.kernel.lang.structure import PRINTS as PRINTS
    from motionlang.kernel.lang.structure import READ as READ
    from motionlang.kernel.lang.structure import SET_UP as SET_UP
    from motionlang.kernel.lang.structure import STARTS as STARTS
    from motionlang.kernel.lang.structure import WRITE as WRITE
    from motionlang.kernel.lang.structure import AxisKey as AxisKey
    from motionlang.kernel.lang.structure import AxisUse as AxisUse
    from motionlang.kernel.lang.structure import ChannelUse as ChannelUse
    from motionlang.kernel.lang.structure import Statement as Statement
    from motionlang.kernel.lang.structure import Structure as Structure
    from motionlang.kernel.lang.structure import Unit as Unit
    from motionlang.kernel.lang.structure import Use as Use
    from motionlang.kernel.lang.vocabulary import Vocabulary as Vocabulary
    from motionlang.kernel.lang.wait_causes import KINDS as KINDS
    from motionlang.kernel.lang.wait_causes import MOVING as MOVING
    from motionlang.kernel.lang.wait_causes import LoopDependencies as LoopDependencies
    from motionlang.kernel.lang.wait_causes import Read as Read
    from motionlang.kernel.lang.wait_hints import what_ends as what_ends
    from motionlang.kernel.lang.wait_hints import what_frees as what_frees
    from motionlang.kernel.lang.waits import ROUNDING as ROUNDING
    from motionlang.kernel.lang.waits import wait_idle as wait_idle
    from motionlang.kernel.lang.waits import wait_until as wait_until

PUBLIC = {
    "names": "Definition Changes Names NO_NAMES Span",
    "vocabulary": "Vocabulary",
    "program": "Target",
    "literals": "Literal canonical number number_text replaced revalued",
    "machine.file": "read_toml first_mistake flat generic",
    "machine.entries": "Given check_inputs_are_read",
    "machine.operator": "Operator",
    "machine.layers": "is_key_of_entries layered with_key_of_entries",
    "machine.switch": "switch ASSUMPTIONS",
    "machine.terminal": "Terminal",
    "structure": "ACTS NAME PRINTS STARTS Structure Unit Statement Use AxisKey AxisUse ChannelUse READ WRITE SET_UP",
    "step_list": "ListedUnit ListedStep listed_units",
    "wait_causes": "Read LoopDependencies KINDS MOVING",
    "steps": "Step Uses Values BACK BRANCH CALL END ENTER GO RETURN TEST UNTIL ENDLESS HEAD NEXT STOP conditions",
    "step_graph": "StepGraph",
    "step_task": "StepTask",
    "comments": "Named comments_of names_in_comments remarks without_marks",
    "debugging": "Frame",
    "snapshot": "Snapshot",
    "waits": "ROUNDING wait_idle wait_until",
    "wait_hints": "what_ends what_frees",
    "run_errors": "explain",
    "foreign": "one_sentence AT_PROMPT IN_EDITOR",
    "keyword": "BANK CHANNELS HOST_CHANNELS TOPICS",
    "machine.keys": "DRIVES KEYS TABLES CHOICES REQUIRED MAX_AXES",
    "machine.machine": "CONSOLE",
}

if not TYPE_CHECKING:
    __getattr__ = lazy_names(__name__, PUBLIC)

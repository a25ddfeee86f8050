"""Keyword facts are in rows: other modules name only the keywords listed here."""

from __future__ import annotations

import ast
from collections import defaultdict
from pathlib import Path

import pytest

import motionlang
from motionlang.kernel.lang.keyword import ROLES, TRAITS
from motionlang.kernel.mccl.keywords import table as commands
from motionlang.kernel.mccl.models import MODELS
from motionlang.kernel.mint.keywords import table
from motionlang.kernel.mint.models import ABSENT, LARGEST, STRINGS
from motionlang.kernel.servo import gains
from tests.trees import nodes_of

pytestmark = pytest.mark.slow

PACKAGE = Path(motionlang.__file__).parent
MINT = {row.name for row in table()}
MCCL = {row.name for row in commands()}
# The keywords that a module names. A line may leave this list or become shorter; none may grow or be added.
NAMED = {
    # The output of PLAN, and commands that the client sends to a board.
    "commands/plan/__init__.py": "DS MR PT SA SV US",
    "commands/plan/command.py": "US",
    # A placeholder of the help.
    "cli/completion.py": "OUT",
    "hosts/client/answer.py": "VE",
    "hosts/client/client.py": "TP TS WS WT",
    # Texts that only look like keywords: a state, an axis of a chart, an access.
    "kernel/controller/triggers/homing.py": "HOME",
    "lab/notes/figures.py": "DAC",
    "commands/probe/keyword_facts.py": "RW",
    "kernel/lang/machine/nonvolatile.py": "NVLONG",
    # Commands of the editor of a controller's prompt, which are no keywords of a program.
    "hosts/client/mint.py": "CON EDIT NEW PROG",
    "hosts/mint/editor.py": "CON EDIT NEW PROG",
    # Commands that the code around them reports to the user, or that open a block.
    "commands/check/mccl/running.py": "WS",
    "kernel/mccl/motion/joystick.py": "JN",
    "kernel/mint/check/access.py": "IDLE VEL",
    "commands/check/mint/buffer.py": "TRIGGERMODE",
    "commands/check/mint/motion.py": "POSWRAP SOFTLIMITFORWARD SOFTLIMITMODE SOFTLIMITREVERSE",
}


def named() -> dict[str, set[str]]:
    """Return the keywords that occur as strings in modules outside the vocabulary.

    Only strings in capitals with two letters or more count.
    """
    found: defaultdict[str, set[str]] = defaultdict(set)
    for path in PACKAGE.rglob("*.py"):
        relative = path.relative_to(PACKAGE)
        # MCAPI is a translation of calls into commands.
        if "keywords" in relative.parts or relative.parts[:2] == ("hosts", "mcapi"):
            continue
        words = {"mint": MINT, "mccl": MCCL}.get(
            ({"mint", "mccl"} & {*relative.parts} or {""}).pop(), MINT | MCCL
        )
        # Placeholders of options.
        apart = {
            each.value for each in nodes_of(path) if isinstance(each, ast.keyword) and each.arg == "metavar"
        } | {
            each.args[0]
            for each in nodes_of(path)
            if isinstance(each, ast.Call)
            and isinstance(each.func, ast.Name)
            and each.func.id in ("option", "argument")
        }
        for node in nodes_of(path):
            text = node.value if isinstance(node, ast.Constant) and node not in apart else None
            if isinstance(text, str) and text in words and text.isupper() and len(text) > 1:
                found[relative.as_posix()].add(text)
    return found


def test_no_module_outside_the_vocabulary_names_a_word_that_is_not_listed() -> None:
    assert named() == {path: set(words.split()) for path, words in NAMED.items()}


def test_no_code_compares_the_name_of_a_row() -> None:
    """Differences between keywords are columns of their rows."""
    compared = [
        f"{path.relative_to(PACKAGE)}: {ast.unparse(node)}"
        for path in PACKAGE.rglob("*.py")
        for node in nodes_of(path)
        if isinstance(node, ast.Compare)
        and isinstance(node.comparators[0], ast.Constant | ast.Tuple | ast.Set)
        if ast.unparse(node.left).endswith("row.name")
    ]
    assert compared == []


def test_effects_are_described_in_the_words_for_them() -> None:
    for row in (*table(), *commands()):
        effects = row.effect.split()
        assert set(effects) <= ROLES.keys() | TRAITS.keys(), row.name
        assert len(ROLES.keys() & set(effects)) <= 1, row.name
        assert not (row.role and row.gives), row.name
        assert row.tunes in {"", *gains.MINT, *gains.MCCL}, row.name
        assert row.changes in ("", "motion", "always"), row.name


def test_a_family_that_a_controller_lacks_or_limits_is_one_of_the_rows() -> None:
    families = {row.family for row in commands()} - {""}
    assert {family for model in MODELS.values() for family in model.lacks} == families
    assert {row.family for row in table()} - {""} == ABSENT.keys() | LARGEST.keys() | {STRINGS}


def test_what_people_mean_by_a_word_of_english_is_no_command() -> None:
    suggested = {word for row in commands() for word in row.meant.split()}
    assert suggested
    assert not {word for word in suggested if commands().get(word)} - {"ON"}


def test_every_kind_of_effect_is_one_of_some_word() -> None:
    assert {effect for row in table() for effect in row.effect.split()} == ROLES.keys() | TRAITS.keys()

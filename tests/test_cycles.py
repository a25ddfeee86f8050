"""Import cycles between the files of a folder: each is listed with its reason.

An import that is only for types counts as well, since a reader follows it all the same.
"""

from __future__ import annotations

import ast
from collections import defaultdict
from pathlib import Path

import pytest

from tests.trees import nodes_of

pytestmark = pytest.mark.slow

PACKAGE = Path(__file__).parent.parent / "motionlang"

# Folder and files of a group, and why they know each other. The table may only become shorter.
GROUPS: dict[tuple[str, str], str] = {
    ("kernel", "moves report report_types result"):
        "a run makes its report on request, and a report is made from a run",
    ("commands/sweep", "command report"): "a command prints its report, which shows what the command asks for",
    ("commands/check", "axis_state reach rule_facts"):
        "the state of the axes is one of the facts, and is worked out from the others",
    ("kernel/controller", "axis feedback motion_listener state watch"):
        "a controller owns its axes, and an axis knows it, its watches and its motor",
    ("kernel/controller/moves", "course path path_run"): "a path belongs to a run of paths, which is made of them",
    ("ide/debug", "debugger state"): "what a debugger shows is a part of it, which asks it for the present stop",
    ("ide/debug", "replay scopes"): "a replay makes the scopes of its stops, which read the replay",
    ("hosts/mcapi", "block call interface session"): "a session has interfaces, which carry out its calls and blocks",
    ("kernel/lang", "structure wait_analysis"):
        "a structure has the analysis of its waits, which reads the structure",
    ("kernel/lang", "dialect literals program"):
        "a dialect makes a program, whose literals have the addresses of a program",
    ("kernel/lang", "debugging loop_log loops step_task"):
        "a task knows its loops and its hook, which are those of a task",
    ("ide/lsp", "features protocol server"): "a server answers requests with its features, which ask it for texts",
    ("kernel/mccl/runtime", "board task writer"): "a board runs tasks, and a task commands its board",
    ("exploration", "questions search"): "the search asks the questions, and a question plays its changes",
    ("hosts/mint", "console port"): "a console has ports, and what a port receives acts on its console",
    ("kernel/mint/keywords", "buffer compensation following_auxiliary following_masters sensing table_motion_cams"):
        "cams and compensation share their tables, followers and triggers their masters",
    ("kernel/mint/runtime", "binding changes environment errors events power_up task waits"):
        "the environment of a program owns its tasks and events; each is handed its environment",
    ("kernel/mint/steps", "blocks calls expressions keywords program statements terminal unit waiting words"):
        "an expression may be a keyword or a call, whose arguments are expressions; a block contains statements",
    ("kernel/mint/syntax", "node nodes"): "each kind of node contains expressions, which are nodes",
    ("kernel/planners", "crossing cubics curve formula sequence"):
        "the kinds of profile are made from each other: a sequence of formulas, the cubics of a curve",
    ("repl", "commands debugging session"): "a command changes the session that runs it",
}  # fmt: skip


def imports_of(path: Path) -> set[Path]:
    """Return the files of the same folder that a file imports anywhere in its code."""
    found = set()
    for node in nodes_of(path):
        if not isinstance(node, ast.ImportFrom) or not (node.module or "").startswith("motionlang"):
            continue
        base = PACKAGE.joinpath(*str(node.module).split(".")[1:])
        for name in node.names:
            choices = (
                base / f"{name.name}.py",
                base / name.name / "__init__.py",
                base.with_suffix(".py"),
                base / "__init__.py",
            )
            found |= {next((file for file in choices if file.exists()), path)}
    return {file for file in found if file.parent == path.parent and file != path}


def groups() -> set[tuple[str, str]]:
    """Return each group of files that import each other: its folder and file names."""
    by_folder = defaultdict(list)
    for path in sorted(PACKAGE.rglob("*.py")):
        by_folder[path.parent].append(path)
    found = set()
    for folder, paths in by_folder.items():
        reached = {path: imports_of(path) for path in paths}
        for middle in paths:
            for path in paths:
                if middle in reached[path]:
                    reached[path] |= reached[middle]
        for path in paths:
            members = sorted(
                other.stem for other in paths if other in reached[path] and path in reached[other]
            )
            if members:
                found.add((folder.relative_to(PACKAGE).as_posix(), " ".join(members)))
    return found


def test_files_that_import_each_other_are_listed_with_a_reason() -> None:
    assert groups() == GROUPS.keys()

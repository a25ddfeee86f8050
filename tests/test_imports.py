"""Where a module of a package is brought in by a function of the same package: nowhere but where this page says so.

An import inside a function crosses packages, or loads a heavy library. Within a package it stands at the top, where a
reader looks for it; but a run is to start as soon as it can, and what it need not have is brought in by who needs it.
"""

from __future__ import annotations

import ast
from pathlib import Path

import motionlang

PACKAGE = Path(motionlang.__file__).parent
# Every command of the command line is a door.
DOORS = ("cli",)
# Importer and what it brings in, both without the name of their package. A line may leave this list or become shorter;
# none may grow or come in.
LAZY = {
    # The doors: each opens a family of modules, of which most programs need few.
    "controller/axis_verbs.py": "motion.jog motion.profile_playback",
    "controller/controller.py": "io.encoder motion.follow motion.offset motion.reference motion.sampled_velocity "
    "moves.cam moves.entries moves.path record.history record.trace triggers.latch triggers.limit",
    "lang/machine/machine.py": "machine.axes machine.nonvolatile machine.operator machine.terminal",
    "mccl/__init__.py": "keywords keywords.switchable lint.check models runtime.program runtime.session syntax.tokens",
    "mint/__init__.py": "interactive keywords keywords.machine_readings keywords.switchable lint models program "
    "runtime.wait_sources syntax.extent syntax.parser",
    "mint/keywords/__init__.py": "keywords.vocabulary",
    "mint/keywords/vocabulary.py": "keywords.all_words keywords.index",
    "mint/lint/__init__.py": "compile.compiler compile.error_recovery lint.model syntax.parser",
    "mint/runtime/environment.py": "runtime.binding runtime.errors runtime.events runtime.formats runtime.functions "
    "runtime.input_values runtime.loop_skipping runtime.power_up runtime.printing",
    "profile/shapes.py": "jerk parabolic scurve",
    "repl/__init__.py": "commands lines prompt session",
    # Those that need one another.
    "controller/moves/cam.py": "motion.halt",
    "controller/moves/path.py": "moves.path_run",
    "mint/compile/body.py": "compile.jumps",
    "mint/compile/expressions.py": "compile.calls compile.keyword_use",
    "mint/compile/keyword_use.py": "compile.path_use",
    "mint/compile/loops.py": "compile.statements",
    "mint/keywords/following_masters.py": "keywords.following_auxiliary keywords.sensing_operations",
    "mint/runtime/task.py": "runtime.errors",
    "profile/curve.py": "chain",
    "profile/formula.py": "chain cubics",
    # What few programs, or few commands, come to.
    "client/client.py": "virtual",
    "controller/io/wiring.py": "servo.feedback",
    "controller/record/extremes.py": "record.history",
    "controller/record/log.py": "record.moves",
    "controller/record/stream.py": "record.records",
    "controller/record/trace.py": "record.history",
    "controller/servo/axis_loop.py": "servo.tuning",
    "controller/servo/servo.py": "servo.trace",
    "controller/servo/stretch.py": "servo.lifted",
    "controller/triggers/latch.py": "triggers.position_zones",
    "lang/machine/file.py": "machine.switch",
    "lang/scheduler.py": "recurrence",
    "mccl/keywords/reports_operations.py": "axis.status",
    "mccl/lint/check.py": "lint.channels lint.checks",
    "mccl/resolve/decode.py": "resolve.nearest syntax.mistakes",
    "mccl/runtime/board.py": "keywords.switchable",
    "mint/compile/compiler.py": "compile.error_recovery compile.line_triggers",
    "mint/keywords/all_words.py": "keywords.no_effect keywords.unsimulated",
    "mint/keywords/buffer_operations.py": "keywords.following_masters",
    "mint/keywords/captures_operations.py": "keywords.captures_levels",
    "mint/keywords/encoder_wrap_operations.py": "keywords.homing_operations",
    "mint/keywords/homing_operations.py": "keywords.limits_switches",
    "mint/keywords/jogging_operations.py": "keywords.drives_operations",
    "mint/keywords/machine_readings.py": "keywords",
    "mint/keywords/switchable.py": "keywords",
    "mint/keywords/tasks_operations.py": "runtime.errors",
    "mint/keywords/terminal_operations.py": "runtime.input_values",
    "mint/keywords/unsimulated_operations.py": "keywords keywords.unsimulated",
    "mint/program.py": "compile.compiler syntax.parser",
    "mint/resolve/names.py": "resolve.flattening",
    "mint/runtime/input_values.py": "runtime.functions",
    "mint/runtime/printing.py": "models",
    "mint/syntax/parser.py": "syntax.errors syntax.nesting",
    "profile/packed.py": "ahead chain composed rate summed",
    "views/plot.py": "path_plot",
    "views/pvt_plot.py": "plot",
    "mint/compile/overrides.py": "keywords",
    "views/export.py": "mcap",
}


def module_of(name: str) -> str:
    """The module that a name stands for, or stands in, without `motionlang` and its package."""
    parts = name.split(".")[1:]
    place = PACKAGE.joinpath(*parts)
    return ".".join(parts[1:] if place.is_dir() or place.with_suffix(".py").exists() else parts[1:-1])


def brought_in(path: Path) -> set[str]:
    """The modules of its own package that functions of a file import."""
    package = path.relative_to(PACKAGE).parts[0]
    functions = (
        node
        for node in ast.walk(ast.parse(path.read_text(encoding="utf-8")))
        if isinstance(node, ast.FunctionDef | ast.AsyncFunctionDef)
    )
    return {
        module_of(f"{node.module}.{alias.name}")
        for function in functions
        for node in ast.walk(function)
        if isinstance(node, ast.ImportFrom) and f"{node.module}.".startswith(f"motionlang.{package}.")
        for alias in node.names
    }


def test_imports_inside_functions_cross_packages_or_are_listed() -> None:
    found: dict[str, set[str]] = {}
    for path in sorted(PACKAGE.rglob("*.py")):
        name = path.relative_to(PACKAGE).as_posix()
        if name.split("/")[0] not in DOORS and (modules := brought_in(path)):
            found[name] = modules
    new = {name: modules - set(LAZY.get(name, "").split()) for name, modules in found.items()}
    assert {name: modules for name, modules in new.items() if modules} == {}
    assert LAZY.keys() <= found.keys(), "a module that brings in nothing any more leaves the list"

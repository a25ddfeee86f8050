"""The cost of events: a shift, run and reported with its events and without.

    python benchmarks/events.py

For the variant without events, the statements that write an event and the checks for one are removed from the
source of the package before it is compiled; nothing else differs. The two variants run alternately in separate
processes; the ratio compares the best CPU time of each. `quiet` is the shift itself, which has no events; in
`busy` each cycle stops every axis once.
"""

from __future__ import annotations

import ast
import gc
import subprocess
import sys
from importlib.machinery import ModuleSpec, PathFinder, SourceFileLoader
from time import process_time

from shift import PROGRAM

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Sequence
    from types import CodeType, ModuleType

ALL, IDLE = "0, 1, 2, 3", "IDLE(0) And IDLE(1) And IDLE(2) And IDLE(3)"
PROGRAMS = {
    "quiet": PROGRAM,
    "busy": PROGRAM.replace("WAIT(5150)\n", f"JOG({ALL}) = 1; : WAIT(4800) : STOP({ALL}) : PAUSE {IDLE}\n"),
}
REPEATS, ROUNDS = 4, 3
# Functions that write events, by their names in modules.
WRITERS = ("clamped", "note")


class Silent(ast.NodeTransformer):
    """Removes statements that write an event, and conditions that guard only these."""

    def visit_Expr(self, node: ast.Expr) -> ast.AST | None:
        """Remove a call that writes an event.

        These are `events.…(…)`, `triggers.events.…(…)`, `clamped(…)`, `note(…)` and `….log.note(…)`.
        """
        call = node.value
        if not isinstance(call, ast.Call):
            return node
        function = call.func
        if isinstance(function, ast.Name):
            return None if function.id in WRITERS else node
        if isinstance(function, ast.Attribute):
            owner = ast.unparse(function.value)
            if owner in ("events", "triggers.events") or (function.attr == "note" and owner.endswith("log")):
                return None
        return node

    def visit_If(self, node: ast.If) -> ast.AST | None:
        """Remove an `if` whose body has become empty and that has no `else`."""
        self.generic_visit(node)
        return node if node.body or node.orelse else None

    def visit_FunctionDef(self, node: ast.FunctionDef) -> ast.AST:
        """Give a function without statements a `pass`."""
        self.generic_visit(node)
        node.body = node.body or [ast.Pass()]
        return node


class Loader(SourceFileLoader):
    """Compiles a module without the statements that write events."""

    def get_code(self, fullname: str) -> CodeType:
        """Compile the module from source, ignoring bytecode files."""
        tree = Silent().visit(ast.parse(self.get_data(self.path)))
        return compile(ast.fix_missing_locations(tree), self.path, "exec", dont_inherit=True)


class Finder:
    """Finds the modules of the package for `Loader`."""

    @staticmethod
    def find_spec(
        name: str, path: Sequence[str] | None = None, target: ModuleType | None = None
    ) -> ModuleSpec | None:
        """Return the spec of a module of the package, None for others."""
        # The functions of events itself stay: they are never called.
        if not name.startswith("motionlang.") or name.endswith(("triggers.events", "record.log")):
            return None
        spec = PathFinder.find_spec(name, path, target)
        if spec is not None and type(spec.loader) is SourceFileLoader:
            spec.loader = Loader(name, spec.loader.path)
        return spec


def measure(kind: str, mode: str) -> None:
    """Print the best CPU time of several rounds, and the number of events."""
    if mode == "without":
        sys.meta_path.insert(0, Finder())
    from motionlang.execution import run
    from motionlang.report import text
    from motionlang.source import Source

    best, events = float("inf"), 0
    for _ in range(ROUNDS):
        gc.collect()
        gc.disable()
        began = process_time()
        ran = run(Source("shift.mnt", PROGRAMS[kind]), cache=False)
        text(ran)
        best = min(best, process_time() - began)
        gc.enable()
        assert ran.status == "ended", ran.diagnostics
        events = len(ran.machine.log.events)
    assert bool(events) is (mode == "with" and kind == "busy"), events
    print(best, events)


def main() -> None:
    """Print `name value unit` lines."""
    for kind in PROGRAMS:
        best = {"with": float("inf"), "without": float("inf")}
        count = 0
        for _ in range(REPEATS):
            for mode in ("with", "without"):
                ran = subprocess.run(
                    [sys.executable, __file__, kind, mode], capture_output=True, text=True, check=True
                )
                seconds, events = ran.stdout.split()
                best[mode] = min(best[mode], float(seconds))
                count = max(count, int(events))
        print(f"events_{kind}_count {count} events")
        print(f"events_{kind} {best['with'] / best['without']:.3f} x")
        if count:
            print(f"events_{kind}_each {(best['with'] - best['without']) / count * 1e6:.1f} us")


if __name__ == "__main__":
    if len(sys.argv) > 1:
        measure(*sys.argv[1:])
    else:
        main()

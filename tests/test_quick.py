"""The quick check chooses the tests for a change, and does not load the proof."""

from __future__ import annotations

import subprocess
import sys
from pathlib import Path

import pytest

from tests.quick import Reach, chosen, importers, nearest

ROOT = Path(__file__).parent.parent
AXIS, CORE, CAM = (
    "motionlang/kernel/controller/axis.py",
    "motionlang/kernel/controller/core.py",
    "motionlang/kernel/mint/cam.py",
)
FILES = [
    "tests/kernel/controller/test_axis.py",
    "tests/kernel/controller/test_core.py",
    "tests/kernel/mint/test_cam.py",
]
TESTS = {
    "tests/kernel/mint/test_cam.py::test_long": Reach(3.0, frozenset((AXIS, CORE, CAM))),
    "tests/kernel/mint/test_cam.py::test_short": Reach(0.5, frozenset((AXIS, CORE, CAM))),
    "tests/kernel/controller/test_core.py::test_core": Reach(0.5, frozenset((AXIS, CORE))),
    "tests/kernel/controller/test_axis.py::test_axis": Reach(0.5, frozenset((AXIS,))),
    "tests/gone/test_gone.py::test_gone": Reach(0.1, frozenset((AXIS,))),
}


def test_tests_that_reach_the_change_run_the_most_specific_first() -> None:
    whole, names = chosen([AXIS], TESTS, FILES, budget=2.0)
    assert whole == []
    assert [name.partition("::")[2] for name in names] == ["test_axis", "test_core", "test_short"]
    assert chosen([CAM], TESTS, FILES, budget=9.0)[1] == [
        "tests/kernel/mint/test_cam.py::test_short",
        "tests/kernel/mint/test_cam.py::test_long",
    ]


def test_a_changed_test_runs_whole_and_a_new_module_has_the_tests_of_its_name_or_folder() -> None:
    assert chosen([FILES[0]], TESTS, FILES) == ([FILES[0]], [])
    assert chosen(["motionlang/new/axis.py"], TESTS, FILES) == ([FILES[0]], [])
    assert chosen(["motionlang/kernel/controller/new.py"], TESTS, FILES) == (FILES[:2], [])
    assert chosen([CORE], {}, FILES) == ([FILES[1]], [])
    assert nearest("motionlang/_core.py", FILES) == [FILES[1]]
    assert nearest("motionlang/kernel/mint/motion.py", FILES) == [FILES[2]]


def test_a_changed_helper_runs_the_tests_that_import_it() -> None:
    here = "tests/test_quick.py"
    assert importers("tests/quick.py", [here]) == [here]
    assert importers("tests/built.py", [here]) == []
    assert importers("extras/mcapi/tests/quick.py", [here]) == [here]
    derived = "tests/test_derived.py"
    assert chosen(["tools/derived.py"], {}, [here, derived]) == ([derived], [])


@pytest.mark.slow
def test_collecting_does_not_load_the_proof() -> None:
    code = (
        "import sys, pytest\n"
        "status = pytest.main(['-p', 'no:xdist', '-p', 'no:cacheprovider', '--collect-only', '-qq', '--prove',"
        " 'tests/kernel/planners'])\n"
        "sys.exit(status or any(name.startswith('tests.proof.') for name in sys.modules))"
    )
    subprocess.run([sys.executable, "-c", code], cwd=ROOT, check=True, capture_output=True)

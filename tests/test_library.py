"""The interface of the package: every name of `__all__` that it has itself.

The tests include the arguments of its functions and the `repr` of its objects. Those of the other names are in
`extras/explore`.
"""

from __future__ import annotations

import contextlib
import importlib
import inspect
import json
import pickle
import pkgutil
import re
import subprocess
import sys
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest

import motionlang
from motionlang import Loop, Motor, Source, Track
from motionlang.extras import NAMES
from motionlang.kernel.tools import MissingExtra

# 200 uu at 100 uu/s with 1000 uu/s²: 0.1 s up, 1.9 s slew, 0.1 s down.
FEED = Source(
    "feed.mnt",
    "SPEED(0) = 100 : ACCEL(0) = 1000 : DECEL(0) = 1000\nMOVER(0) = 200 : GO(0)\nPAUSE IDLE(0)\nPRINT POS(0)\n",
)
STILL = Track([0.0], [motionlang.hold(0.0)])
LIMITS = {"axis.0.limits.speed": 125.0}
# The names of this distribution.
OWN = [name for name in motionlang.__all__ if name not in NAMES]
# A call of each function; a class is checked by what a function returns.
CALLS: dict[str, Callable[[], object]] = {
    "run": lambda: motionlang.run(FEED),
    "check": lambda: motionlang.check(FEED),
    "plan": lambda: motionlang.plan(distance=20, time=0.6, rule="third"),
    "parse": lambda: motionlang.parse(FEED.text, "mint"),
    "profile": lambda: motionlang.profile(FEED),
    "diff": lambda: motionlang.diff(FEED, FEED),
    "compare": lambda: motionlang.compare(
        FEED,
        Source("d.csv", "time_s,axis0_position_uu\n" + "".join(f"{n / 10},{n * 9}\n" for n in range(20))),
    ),
    "certify": lambda: motionlang.certify(motionlang.run(FEED, machine=LIMITS)),
    "dialect": lambda: motionlang.dialect("mint"),
    "hold": lambda: motionlang.hold(0.0),
    "plan_trapezoid": lambda: motionlang.plan_trapezoid(0.0, 200.0, 100.0, 1000.0, 1000.0),
    "simulate": lambda: motionlang.simulate(STILL, Loop(proportional=0.04), Motor(), until=0.01),
    "sweep": lambda: list(motionlang.sweep(FEED, {"axis.0.limits.speed": [125.0]}, jobs=1)),
}
# Functions that raise nothing of their own.
PLAIN = {"hold", "simulate"}
# Modules that need an optional library, or that act when they are imported.
NOT_IMPORTED = ("motionlang.__main__",)


def modules() -> list[str]:
    found = pkgutil.walk_packages(motionlang.__path__, "motionlang.")
    return [each.name for each in found if each.name not in NOT_IMPORTED]


@pytest.mark.slow
def test_no_submodule_hides_a_name() -> None:
    """No module of the package has the name of a function of the library.

    A package `motionlang.profile` would replace the function `profile` when it is imported.
    """
    for name in modules():
        with contextlib.suppress(MissingExtra, ModuleNotFoundError):  # of an optional library
            importlib.import_module(name)
    for name in OWN:
        assert not inspect.ismodule(getattr(motionlang, name)), name
    for name, call in CALLS.items():
        assert callable(getattr(motionlang, name))
        call()


def test_every_function_is_called_here() -> None:
    assert {name for name in OWN if inspect.isfunction(getattr(motionlang, name))} == CALLS.keys()


def test_every_name_has_a_docstring_and_is_in_dir() -> None:
    assert dir(motionlang) == sorted(motionlang.__all__)
    for name in OWN:
        if name != "__version__":
            assert inspect.getdoc(getattr(motionlang, name)), name


def test_the_text_of_a_program_error_has_its_lines() -> None:
    with pytest.raises(motionlang.ProgramError) as raised:
        motionlang.parse("PRINT 1\nIf x\nPRINT )", "mint")
    assert str(raised.value).startswith("line 2: `If` is never closed; ")
    assert "; line 3: " in str(raised.value)


WRONG = Source("wrong.mnt", "PRINT 1\nIf x\nPRINT )\n")
ERRORS = "line 2: `If` is never closed; "


@pytest.mark.parametrize("name", ["certify", "compare", "diff", "profile"])
def test_a_program_with_errors_is_a_program_error_with_its_lines(name: str) -> None:
    call = getattr(motionlang, name)
    others = {"compare": [FEED], "diff": [FEED]}
    with pytest.raises(motionlang.ProgramError, match=ERRORS):
        call(WRONG, *others.get(name, []))


def test_a_run_has_the_errors_of_its_program() -> None:
    result = motionlang.run(WRONG)
    assert {each.line for each in result.diagnostics} == {2, 3}
    assert motionlang.diff(result, result).same
    failed = Source("fails.mnt", "Dim z\nPRINT 1 / z\n")
    assert motionlang.diff(failed, failed).same


@pytest.mark.parametrize("name", sorted(CALLS.keys() - PLAIN))
def test_a_docstring_names_the_errors(name: str) -> None:
    assert "aise" in str(inspect.getdoc(getattr(motionlang, name)))


def test_an_unknown_name_is_an_attribute_error() -> None:
    with pytest.raises(AttributeError, match="module 'motionlang' has no attribute 'rum'"):
        _ = motionlang.rum  # type: ignore[attr-defined]


def test_the_import_loads_no_other_module_of_the_package() -> None:
    code = "import sys, motionlang; print([name for name in sys.modules if name.startswith('motionlang')])"
    done = subprocess.run([sys.executable, "-S", "-c", code], capture_output=True, text=True, check=True,
                          cwd=Path(motionlang.__file__).parent.parent)  # fmt: skip
    assert done.stdout.strip() == "['motionlang']"


def test_internal_parameters_are_not_public() -> None:
    public = set(inspect.signature(motionlang.run).parameters)
    assert not public & {"pace", "outside", "begun", "compiled", "keep_crash"}


@pytest.mark.parametrize(
    ("call", "choices"),
    [
        (lambda: motionlang.run(FEED, dialect="basic"), "mint or mccl"),
        (lambda: motionlang.parse("", "basic"), "mint or mccl"),
        (lambda: motionlang.run(FEED, machine={"controler.axes": 2}), "controller.axes"),
        (lambda: motionlang.run(FEED, until=-1.0), "0 or more"),
        (lambda: motionlang.run(FEED, until=float("nan")), "0 or more"),
        (lambda: motionlang.run("MOVER(0) = 5\nGO(0)\n"), "Source"),
        (lambda: motionlang.check("MOVER(0) = 5\nGO(0)\n"), "Source"),
        (lambda: motionlang.check(FEED, model="plc"), "mint4"),
        (lambda: motionlang.plan(distance=20, time=0.6, rule="half"), "third, quarter or equal"),
        (lambda: motionlang.plan(distance=20, time=0.6, rule="third").program("basic"), "mint or mccl"),
        (lambda: motionlang.diff(FEED, FEED, "time=1kg"), "time=1ms"),
        (lambda: motionlang.compare(FEED, FEED, {"position.0": "a*b"}), "multiply"),
        (lambda: motionlang.certify(FEED), "axis.N.limits with position, speed"),
        (lambda: motionlang.sweep(FEED, {"axis.0.limits.speed": [1.0]}, keep=["tim"]), "time"),
        (lambda: motionlang.run(FEED).trace(axes=[9]), "this controller has 0, 1"),
        (lambda: motionlang.run(FEED).trace(quantities=["speed"]), "position, velocity"),
        (lambda: motionlang.run(FEED).trace(rate=0.0), "above 0"),
    ],
)
def test_a_wrong_argument_is_a_value_error_with_the_choices(call: Callable[[], object], choices: str) -> None:
    with pytest.raises(ValueError, match=re.escape(choices)):
        call()


def test_a_machine_is_a_mapping_or_the_path_of_a_machine_file(tmp_path: Path) -> None:
    path = tmp_path / "machine.toml"
    path.write_text("run.until = 0.01\n")
    expected = motionlang.run(FEED, machine={"run.until": 0.01})
    for machine in (path, str(path)):
        made = motionlang.run(FEED, machine=machine)
        assert (made.time, made.status) == (expected.time, expected.status) == (0.01, "until")
    path.write_text("controler.axes = 2\n")
    with pytest.raises(motionlang.ProgramError, match="controler"):
        motionlang.run(FEED, machine=path)


def test_each_object_prints_itself() -> None:
    run = motionlang.run(FEED)
    assert repr(run).startswith("<Run of feed.mnt: ended at 2.1")
    assert repr(run).endswith("1 move>")
    assert repr(run.report).startswith("<Report of feed.mnt: ended at 2.1")
    assert repr(run.trace).startswith("<Trace of axis 0: 0 to 2.1")
    assert repr(run.moves) == "<Moves: 1 of feed.mnt>"
    assert repr(run.moves[0]).startswith("<Move: MOVER of axis 0, line 2, 0 to 200 uu in 2.1 s from ")
    assert "speed=50" in repr(motionlang.plan(distance=20, time=0.6, rule="third"))


def test_a_notebook_shows_the_curve() -> None:
    run = motionlang.run(FEED)
    for shown in (run, run.report, run.trace, run.moves, run.moves[0]):
        page = shown._repr_html_()
        assert page.count("<svg") == page.count("</svg>") == 1
        assert ">100</text>" in page  # the speed


def test_a_report_is_data() -> None:
    report = motionlang.run(FEED).report
    assert report["moves"][0]["duration"] == pytest.approx(2.1)
    again = pickle.loads(pickle.dumps(report))
    assert again == report == json.loads(json.dumps(report))
    assert "<table>" in again._repr_html_()


def test_moves_are_columns() -> None:
    text = FEED.text + "MOVER(0) = -50 : GO(0)\nPAUSE IDLE(0)\n"
    moves = motionlang.run(Source("feed.mnt", text)).moves
    columns = moves.columns()
    assert columns["distance"] == [200.0, -50.0]
    assert columns["line"] == [2, 5]
    assert moves[1:].columns()["line"] == [5]
    assert moves[-1].distance == -50.0


def test_a_program_without_moves_has_the_same_columns() -> None:
    moves = motionlang.run(Source("a.mnt", "PRINT 1\n")).moves
    assert list(moves.columns()) == list(motionlang.run(FEED).moves.columns())


def test_a_data_frame_of_polars() -> None:
    pytest.importorskip("polars")
    frame = motionlang.run(FEED).moves.to_polars()
    assert frame["distance"].to_list() == [200.0]
    rows = motionlang.sweep(FEED, {"axis.0.limits.speed": [125, 150.5]}, jobs=1).to_polars()
    assert rows["axis.0.limits.speed"].to_list() == [125.0, 150.5]


def test_a_data_frame_of_pandas() -> None:
    pytest.importorskip("pandas")
    frame = motionlang.run(FEED).moves.to_pandas()
    assert list(frame["distance"]) == [200.0]
    assert list(motionlang.sweep(FEED, {"axis.0.limits.speed": [125]}, jobs=1).to_pandas()["index"]) == [0]


@pytest.mark.parametrize("library", ["polars", "pandas"])
def test_a_missing_library_is_named(library: str, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("importlib.util.find_spec", lambda name: None)
    with pytest.raises(MissingExtra, match=f"to_{library} needs {library}: python -m pip install {library}$"):
        getattr(motionlang.run(FEED).moves, f"to_{library}")()


def test_a_trace_is_a_structured_array() -> None:
    """After 0.05 s, half of the ramp at 1000 uu/s², the axis has moved 1.25 uu.

    1000 · 0.05² / 2 = 1.25.
    """
    run = motionlang.run(FEED)
    start = run.moves[0].start_time
    rows: Any = run.trace(rate=1000.0, axes=[0], quantities=["position"])
    assert rows.dtype.names == ("time_s", "axis0_position_uu")
    row = rows[50]
    assert row["axis0_position_uu"] == pytest.approx(1000.0 * (row["time_s"] - start) ** 2 / 2, abs=1e-9)


def test_rows_of_a_sweep_are_a_table_in_order() -> None:
    rows = motionlang.sweep(FEED, {"axis.0.limits.speed": [150.0, 125.0]}, jobs=1)
    columns = rows.columns()
    assert columns["index"] == [0, 1]
    assert columns["axis.0.limits.speed"] == [150.0, 125.0]
    assert columns["problem"] == [None, None]

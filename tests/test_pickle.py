"""What a pool of processes can send."""

from __future__ import annotations

import pickle

import pytest

import motionlang
from motionlang.client import CommandError, LineRejected, NoReply
from motionlang.kernel import ProgramError
from motionlang.kernel.errors import Rejected
from motionlang.kernel.tools import MissingExtra

MOVE = "MOVER(0) = 50 : GO(0) : PAUSE IDLE(0)\n"


@pytest.mark.parametrize(
    "error",
    [
        ProgramError.of("never", "X is unknown", 1, 2, "declare it"),
        MissingExtra("to_polars", ["polars"]),
        CommandError(3, "1MR", ["a"], 7),
        LineRejected("SPED = 1", "unknown"),
        NoReply("1TP", 2.0),
        Rejected("range", "too large", "less"),
    ],
    ids=lambda error: type(error).__name__,
)
def test_an_error(error: Exception) -> None:
    sent = pickle.loads(pickle.dumps(error))
    assert (type(sent), str(sent)) == (type(error), str(error))
    fields = {name: value for name, value in vars(error).items() if name != "diagnostics"}
    assert {name: value for name, value in vars(sent).items() if name != "diagnostics"} == fields


def test_the_data_of_a_run() -> None:
    run = motionlang.run(motionlang.Source("a.mnt", MOVE))
    data = run.report, run.moves.columns(), run.output
    assert pickle.loads(pickle.dumps(data)) == data


def test_a_time_profile() -> None:
    profile = motionlang.profile(motionlang.Source("a.mnt", MOVE + "WAIT = 5\n"))
    sent = pickle.loads(pickle.dumps(profile))
    for figures in ("links", "tasks"):
        assert repr(getattr(sent, figures)) == repr(getattr(profile, figures))
    for figures in ("lines", "subs", "kinds", "waited_lines", "slacks"):
        assert repr(getattr(sent, figures)()) == repr(getattr(profile, figures)())


def test_a_table_without_moves_has_the_types_of_others() -> None:
    polars = pytest.importorskip("polars")
    texts = (MOVE, 'PRINT "nothing moves"\n')
    some, none = (motionlang.run(motionlang.Source("a.mnt", text)).moves for text in texts)
    assert polars.concat([none.to_polars(), some.to_polars()]).height == 1

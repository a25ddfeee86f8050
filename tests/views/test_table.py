"""The report on a terminal: complete tables, wide and narrow, of any length."""

from __future__ import annotations

import re
from itertools import pairwise
from math import inf

import pytest

from motionlang.kernel.report import moves
from motionlang.views.formatting import clock_time, decimals_of, figure, formatter
from motionlang.views.report import _Events, _Gathered, render
from motionlang.views.table import Column, Table
from tests.views.runs import ballscrew, ended, new_run, pick, shift

BALLSCREW = """\
ballscrew.mnt · Mint · ended after 1.00005 s · 1 move

axis  command  line  profile      start  time  from   to  distance  peak
                                      s     s    uu   uu        uu  uu/s
────────────────────────────────────────────────────────────────────────
   0  MOVER       5  trapezoid  0.00005   1.0     0  200       200   250
      ├ accel                             0.2                   25
      ├ slew                              0.6                  150
      └ decel                             0.2                   25

axis  position  counts      scale  feedback  state
            uu          counts/uu
──────────────────────────────────────────────────
   0       200  240000       1200  demand    on
"""

PICK = """\
pick.mnt · Mint · still running at the time limit of 3 s · 5 moves

axis  command  line  profile     start      time      from         to   distance      peak  ended by
                                     s         s        uu         uu         uu      uu/s
──────────────────────────────────────────────────────────────────────────────────────────────────────
   0  MOVER       5  trapezoid     0.0  1.050000    0.0000   200.0000   200.0000  250.0000
      ├ accel                           0.200000                         25.0000
      ├ slew                            0.550000                        137.5000
      └ decel                           0.300000                         37.5000
   1  MOVER       6  sinusoidal    0.0  0.723601    0.0000    83.3333    83.3333  230.3294
      ├ accel                           0.289441                         33.3333
      └ decel                           0.434161                         50.0000
   2  MOVER       8  parabolic     0.7  1.100000    0.0000  -191.6667  -191.6667  250.0000  stop
      ├ accel                           0.400000                        -66.6667
      ├ slew                            0.100000                        -25.0000
      └ stop                            0.600000                       -100.0000
   0  MOVEA      12  trapezoid     1.6  1.050000  200.0000     0.0000  -200.0000  250.0000
      ├ accel                           0.200000                        -25.0000
      ├ slew                            0.550000                       -137.5000
      └ decel                           0.300000                        -37.5000
   1  JOG        14  jog           1.6  1.400000   83.3333    26.0908   -57.2425   41.6667  end of run
      ├ accel                           0.052360                         -1.0908
      └ slew                            1.347640                        -56.1517

events
    time  event  axis     value  motion of line
       s
───────────────────────────────────────────────
1.200000  stop      2  -250.000               8

axis   position      counts      scale  feedback  state
             uu              counts/uu
───────────────────────────────────────────────────────
   0     0.0000        0.00       1200  demand    on
   1    26.0908    31309.00       1200  demand    on
   2  -191.6667  -230000.00       1200  demand    on
"""

NARROW = """\
ballscrew.mnt · Mint · ended after 1.00005 s · 1 move

axis  command  time  distance  peak
                  s        uu  uu/s
───────────────────────────────────
   0  MOVER     1.0       200   250
      ├ accel   0.2        25
      ├ slew    0.6       150
      └ decel   0.2        25

axis  position      scale  state
            uu  counts/uu
────────────────────────────────
   0       200       1200  on
"""

MANY = """\
shift.mnt · Mint · ended after 9 min 36 s · 400 moves

axis  command  line  profile    start      time      from        to  distance     peak  commanded
                                    s         s        uu        uu        uu     uu/s       uu/s
─────────────────────────────────────────────────────────────────────────────────────────────────
   0  MOVER       5  trapezoid   0.00  1.600000    0.0000  -40.0000  -40.0000  33.3333    33.3333
   1  MOVER       6  trapezoid   1.44  0.666663    0.0000   -9.2592   -9.2592  27.7776    33.3333
   2  MOVER       5  trapezoid   2.88  1.044450    0.0000   21.4817   21.4817  33.3333    33.3333
   3  MOVER       6  trapezoid   4.32  1.350750    0.0000  -31.6917  -31.6917  33.3333    33.3333
   0  MOVER       5  trapezoid   5.76  0.213635  -40.0000  -40.9508   -0.9508   8.9015    33.3333
   1  MOVER       6  trapezoid   7.20  1.293700   -9.2592   20.5308   29.7900  33.3333    33.3333
   2  MOVER       5  trapezoid   8.64  1.101500   21.4817   -1.9017  -23.3833  33.3333    33.3333
   3  MOVER       6  trapezoid  10.08  0.594273  -31.6917  -24.3342    7.3575  24.7614    33.3333
   0  MOVER       5  trapezoid  11.52  1.542950  -40.9508   -2.8525   38.0983  33.3333    33.3333
   1  MOVER       6  trapezoid  12.96  0.852250   20.5308    5.4558  -15.0750  33.3333    33.3333
… and 390 more moves: --all shows all

line  command  axis  moves       in motion  of the run   each  distance    peak
                                                            s        uu    uu/s
───────────────────────────────────────────────────────────────────────────────
   5  MOVER       0    100  1 min 41.416 s       17.6%  1.014  2116.723  33.333
   6  MOVER       3    100  1 min 41.104 s       17.6%  1.011  2108.415  33.333
   5  MOVER       2    100  1 min 40.972 s       17.5%  1.010  2104.021  33.333
   6  MOVER       1    100  1 min 40.431 s       17.4%  1.004  2085.983  33.333
"""


def test_the_ballscrew_exercise() -> None:
    assert render(ballscrew()) == BALLSCREW


def test_several_axes_and_what_cut_them_short() -> None:
    assert render(pick(), width=110) == PICK


def test_a_narrow_terminal_keeps_what_matters() -> None:
    assert render(ballscrew(), width=36) == NARROW


def test_many_moves_are_summed_up_by_line() -> None:
    assert render(shift()).startswith(MANY)


def test_of_very_many_figures_few_are_stored_that_add_up_to_the_same(monkeypatch: pytest.MonkeyPatch) -> None:
    whole = render(shift())
    monkeypatch.setattr("motionlang.views.report.MAX_TERMS", 7)
    assert render(shift()) == whole
    gathered = _Gathered(moves(shift()), False)
    assert (gathered.count, gathered.by_axis) == (400, {0: 100, 1: 100, 2: 100, 3: 100})
    totals = gathered.totals.values()
    assert [total.count for total in totals] == [100] * 4
    assert max(len(each) for total in totals for each in (total.durations, total.distances)) < 7


def test_all_moves_with_their_phases_where_everything_is_requested() -> None:
    made = render(shift(), everything=True)
    assert made.count("MOVER") == 400 + 4
    assert made.count("├ accel") == 400
    assert "more moves" not in made


@pytest.mark.parametrize(
    ("count", "shown", "phases", "more"),
    [(10, 10, 10, ""), (11, 11, 0, ""), (20, 20, 0, ""), (40, 40, 0, ""), (41, 10, 0, "… and 31 more moves")],
)
def test_ten_moves_have_their_phases_and_forty_a_line_each(
    count: int, shown: int, phases: int, more: str
) -> None:
    """Of more than 40 moves ten are shown, and totals of each of the four axes."""
    text = render(shift(count))
    head, _, totals = text.partition("\nline  command")
    assert sum("MOVER" in line for line in head.splitlines()) == shown
    assert head.count("accel") == phases
    assert totals.count("MOVER") == (4 if more else 0)
    assert ("more moves" in text) is bool(more)
    assert more in text


@pytest.mark.parametrize(
    ("kinds", "everything", "shown"),
    [
        ({"handler": 40}, False, ["handler"] * 40),
        ({"handler": 41}, False, ["handler"] * 10),
        ({"handler": 41}, True, ["handler"] * 41),
        ({"handler": 40, "limit": 1}, False, ["limit"]),  # of more than 40 the important ones
        ({"handler": 29, "limit": 12}, False, ["limit"] * 10),
        ({"stop": 29, "override": 8, "buffer full": 5}, False, ["stop"] * 10),
        ({"handler": 28, "limit": 12}, False, ["handler"] * 28 + ["limit"] * 12),
    ],
)
def test_of_more_than_forty_events_ten_important_ones_are_shown(
    kinds: dict[str, int], everything: bool, shown: list[str]
) -> None:
    rows = [{"kind": kind} for kind, count in kinds.items() for _ in range(count)]
    events = _Events(iter(rows), everything)
    assert [row["kind"] for row in events.shown] == shown
    assert (events.count, events.counts) == (sum(kinds.values()), kinds)


def test_columns_are_left_out_one_after_the_other() -> None:
    """On ever narrower terminals, from the commanded speed to the profile."""
    heads = [
        render(pick(), width=width).splitlines()[2].replace("ended by", "ended")
        for width in range(140, 40, -1)
    ]
    left = [set(before.split()) - set(after.split()) for before, after in pairwise(heads)]
    assert [name for names in left for name in sorted(names)] == [
        "commanded", "from", "start", "line", "to", "ended", "profile"]  # fmt: skip


def test_nothing_moved() -> None:
    run, _ = new_run("hello.mnt")
    run.controller.clock.advance(1e-5)
    assert render(ended(run)) == "hello.mnt · Mint · ended after 0.00001 s · no axis moved\n"


def test_notes_and_errors_of_axes_are_shown() -> None:
    run, controller = new_run()
    controller.axes[1].faults = 4
    controller.axes[1].enabled = False
    run.notes.append("line 3: a wait on an input that no scenario drives")
    text = render(ended(run))
    assert "   1         0       0          1  demand    off, error 4\n" in text
    assert text.endswith("\n\nnote: line 3: a wait on an input that no scenario drives\n")


def test_colour_only_paints_and_charts_are_requested() -> None:
    painted = render(ballscrew(), colour=True)
    assert "\x1b[1mballscrew.mnt\x1b[0m" in painted
    assert "\x1b[32m├ accel\x1b[0m" in painted
    assert "      \x1b[32m├ accel\x1b[0m              " in painted
    assert re.sub(r"\x1b\[[\d;]*m", "", painted) == BALLSCREW
    assert "velocity of axis 0, uu/s" not in painted
    assert "velocity of axis 0, uu/s" in render(ballscrew(), charts=True)


def test_a_chart_of_very_many_moves_is_not_drawn() -> None:
    assert "velocity of axis" in render(shift(400), charts=True)
    assert "velocity of axis" not in render(shift(900), charts=True)


def test_times_as_a_person_says_them() -> None:
    times = (0.0, 1e-5, 0.25, 59.9999999, 60.0, 61.5, 3599.9996, 28_800.0, 30_661.4)
    assert [clock_time(time) for time in times] == [
        "0 s",
        "0.00001 s",
        "0.25 s",
        "60 s",
        "1 min 0 s",
        "1 min 1.5 s",
        "1 h 00 min 0 s",
        "8 h 00 min 0 s",
        "8 h 31 min 1 s",
    ]


def test_figures_have_the_decimals_they_need() -> None:
    assert decimals_of([1.0, 250.0]) == 0
    assert decimals_of([0.2, 0.15]) == 2
    assert decimals_of([1 / 3]) == 4
    assert decimals_of([1e-5 / 3]) == 8
    assert decimals_of([]) == 0
    assert figure(-0.0) == "0.000"
    assert figure(1e12 / 3, 1) == "3.33333e+11"
    assert figure(1e-9, 3) == "1e-09"


@pytest.mark.parametrize(
    ("values", "wanted"),
    [
        ([0.025, -8.88e-16, -0.025], ["0.025", "0.000", "-0.025"]),
        ([5000.0, -9.09e-13, -9.09e-10], ["5000", "0", "0"]),
        ([1.0, 1e-11], ["1", "1e-11"]),  # too large for a rounding error
        ([8.88e-16], ["8.88e-16"]),
        ([inf, 1e-13, 1.0], ["inf", "0", "1"]),
        ([], []),
    ],
)
def test_a_rounding_error_of_a_column_is_zero(values: list[float], wanted: list[str]) -> None:
    assert list(map(formatter(values), values)) == wanted


@pytest.mark.parametrize(
    "name", ["TERM", "COLUMNS", "NO_COLOR", "FORCE_COLOR", "COLORTERM", "JUPYTER_COLUMNS"]
)
def test_nothing_around_it_changes_a_table(monkeypatch: pytest.MonkeyPatch, name: str) -> None:
    monkeypatch.setenv(name, "7")
    assert render(ballscrew()) == BALLSCREW
    assert render(ballscrew(), colour=True).count("\x1b[32m├ accel\x1b[0m") == 1


def test_a_cell_takes_the_room_that_a_terminal_gives_it() -> None:
    columns = (Column("word", left=True, style="word"), Column("n"))
    rows = [{"word": "漢字[b]x[/b]", "n": 1}, {"word": "é", "n": 20}]
    assert Table("words", columns, rows).lines(80) == [
        "word           n",
        "────────────────",
        "漢字[b]x[/b]   1",
        "é             20",
    ]


def test_columns_that_do_not_fit_stand_below_their_row() -> None:
    columns = [
        Column("name", left=True),
        Column("values", left=True, drop=1),
        Column("lines", left=True, drop=2),
    ]
    rows = [
        {"name": "output 0", "values": "1, 0", "lines": "47, 64, 98, 120"},
        {"name": "output 1", "values": "", "lines": ""},
    ]
    table = Table("channels", columns, rows, folds=True)
    assert table.lines(20) == [
        "name      values",
        "────────────────",
        "output 0  1, 0",
        "    lines 47, 64,",
        "    98, 120",
        "output 1",
    ]

"""The scope page in a real browser: every control is used.

The tests are skipped without a Chromium.
"""

from __future__ import annotations

import os
from collections.abc import Iterator
from pathlib import Path
from xml.etree import ElementTree

import pytest

from motionlang.commands.scope import page, write_scope
from motionlang.kernel import Source, run
from motionlang.views.window import Window
from tests.views.browser import Browser
from tests.views.runs import pick, shift

TWO_AXES = """\
SPEED(0, 1) = 50;
ACCEL(0, 1) = 500;
DECEL(0, 1) = 500;
Dim n As Integer
For n = 1 To 3
  VECTORR(0, 1) = 30, 40
  GO(0)
  PAUSE IDLE(0)
  OUTX(1) = 1
  MOVEA(0, 1) = 0; ' home again
  GO(0, 1)
  PAUSE IDLE(0) And IDLE(1)
  OUTX(1) = 0
Next
"""


@pytest.fixture(scope="module")
def folder(tmp_path_factory: pytest.TempPathFactory) -> Path:
    return tmp_path_factory.mktemp("pages")


@pytest.fixture(scope="module")
def started(folder: Path) -> Iterator[Browser]:
    with Browser(folder) as browser:
        yield browser


@pytest.fixture
def browser(started: Browser, folder: Path) -> Iterator[Browser]:
    """Yield a browser with the page of a run of two axes.

    At the end, the page must not have reported an error or used the network.
    """
    path = folder / "two.html"
    if not path.exists():
        write_scope(run(Source("two.mnt", TWO_AXES), dialect="mint"), str(path))
    started.open(path)
    started.requests(), started.complaints()
    started.open(path)
    yield started
    assert started.complaints() == []
    assert started.requests() == set()


def window(browser: Browser) -> list[float]:
    browser.settled()
    found: list[float] = browser.js("[view.begin / END, view.end / END]")
    return found


def test_dragging_zooms_in_and_a_double_click_shows_all(browser: Browser) -> None:
    mouse = browser.mouse(0.25).click_and_hold()
    mouse.move_by_offset(browser.js("Math.round(0.25 * width)"), 0).release().perform()
    assert window(browser) == pytest.approx([0.25, 0.5], abs=0.005)
    browser.mouse(0.6).double_click().perform()
    assert window(browser) == [0.0, 1.0]
    assert browser.js("marks") == []


def test_the_time_at_the_end_of_the_page_is_not_cut_off(browser: Browser) -> None:
    browser.js("show(0, timeTicks().values.at(-1))")
    browser.settled()
    right = "getBoundingClientRect().right"
    assert browser.js(f"[...bottom.querySelectorAll('text')].every((each) => each.{right} <= bottom.{right})")


def test_the_wheel_zooms_around_the_pointer_and_shift_drag_moves(browser: Browser) -> None:
    middle = "scope.getBoundingClientRect().left + LEFT + width / 2"
    browser.js(f"scope.dispatchEvent(new WheelEvent('wheel', {{deltaY: -500, clientX: {middle}}}))")
    begin, end = window(browser)
    assert (begin + end) / 2 == pytest.approx(0.5, abs=0.002)
    assert end - begin < 0.5
    keys = pytest.importorskip("selenium.webdriver.common.keys").Keys
    mouse = browser.mouse(0.5).key_down(keys.SHIFT).click_and_hold()
    mouse.move_by_offset(-200, 0).release().key_up(keys.SHIFT).perform()
    moved, after = window(browser)
    assert moved > begin
    assert after - moved == pytest.approx(end - begin)


def test_two_cursors_and_what_lies_between_them(browser: Browser) -> None:
    for fraction in (0.2, 0.7):
        browser.mouse(fraction).pause(1).click().perform()
    assert browser.js("marks.map((time) => time / END)") == pytest.approx([0.2, 0.7], abs=0.005)
    readout = browser.find("#readout").text
    assert [each for each in ("A ", "B ", "Δ ") if each not in readout] == []
    values = browser.js("[...document.querySelectorAll('#scope .value')].map((each) => each.textContent)")
    assert all("A " in each and "Δ " in each for each in values)
    # A cursor is moved by its line, and removed by a click on it.
    mouse = browser.mouse(0.7).click_and_hold()
    mouse.move_by_offset(browser.js("Math.round(0.1 * width)"), 0).release().perform()
    assert browser.js("marks[1] / END") == pytest.approx(0.8, abs=0.005)
    browser.mouse(0.2).pause(1).click().perform()
    assert browser.js("marks.length") == 1
    browser.keys(pytest.importorskip("selenium.webdriver.common.keys").Keys.ESCAPE)
    assert browser.js("marks.length") == 0


def test_keys_move_and_zoom_and_are_listed_on_the_page(browser: Browser) -> None:
    browser.keys("+")
    assert window(browser) == pytest.approx([0.25, 0.75], abs=0.002)
    browser.keys("\ue014")
    assert window(browser) == pytest.approx([0.3125, 0.8125], abs=0.002)
    browser.keys("-")
    browser.keys("0")
    assert window(browser) == [0.0, 1.0]
    browser.keys("?")
    help_text = browser.find("#help").text
    for key in ("drag", "shift", "wheel", "double click", "click", "Esc", "/"):
        assert key in help_text
    browser.find("#help button").click()
    assert browser.js("help.open") is False
    browser.find("#keys").click()
    assert browser.js("help.open") is True
    browser.find("#help button").click()


def test_search_finds_commands_lines_and_text_of_lines(browser: Browser) -> None:
    browser.keys("/")
    field = browser.find("#search")
    field.send_keys("home again\n")
    assert browser.find("#hits").text == "1 of 15"
    first = browser.js("marks[0]")
    assert browser.js(f"data.axes[0].moves.find((each) => each.start === {first}).line") == 10
    field.send_keys("\n")
    assert browser.find("#hits").text == "2 of 15"
    field.clear()
    field.send_keys("line 6\n")
    assert browser.find("#hits").text == "1 of 15"
    field.clear()
    field.send_keys("CIRCLE\n")
    assert browser.find("#hits").text == "nothing found"
    # Letters that are keys elsewhere are letters here.
    assert window(browser) == [0.0, 1.0]


def test_axes_and_quantities_are_switched_by_their_names(browser: Browser) -> None:
    before = browser.js("panels.length")
    for name in ("axis 1", "acceleration", "channels", "waits"):
        browser.driver.find_element("xpath", f"//button[text()='{name}']").click()
    browser.settled()
    assert browser.js("panels.length") < before
    assert browser.js("panels.map((each) => each.quantity)") == ["position", "velocity"]
    assert browser.js("panels.every((each) => each.axis.name === 'axis 0')")
    browser.driver.find_element("xpath", "//button[text()='axis 1']").click()
    browser.settled()
    assert browser.js("panels.length") == 4


def test_the_path_of_two_axes(browser: Browser) -> None:
    assert not browser.find("#way").is_displayed()
    choices = browser.driver.find_elements("css selector", "#ways select")
    choices[0].send_keys("X: axis 0")
    choices[1].send_keys("Y: axis 1")
    browser.until("document.querySelectorAll('#way path.way').length > 10")
    assert "30 by 40 uu" in browser.find("#way").text


def test_the_lines_that_take_the_time_lead_to_where_they_do(browser: Browser) -> None:
    browser.js("document.getElementById('profile').open = true")
    rows = browser.driver.find_elements("css selector", "#lines tr")
    assert "3.3000 s" in rows[0].text
    assert "VECTORR(0, 1) = 30, 40" in rows[0].text
    browser.js("document.querySelector('#lines tr').scrollIntoView({block: 'center'})")
    rows[0].click()
    assert browser.js("marks[0]") == pytest.approx(browser.js("data.lines[0].time"))
    assert browser.js("data.bands.map((band) => band.name)") == ["critical path", "ParentTask"]
    assert browser.js("document.querySelectorAll('#scope .wait').length") > 5


@pytest.mark.parametrize("kind", ["csv", "svg", "png"])
def test_the_window_can_be_taken_away(browser: Browser, folder: Path, kind: str) -> None:
    browser.keys("+")
    browser.driver.find_element("xpath", f"//button[text()='{kind.upper()}']").click()
    path = folder / f"two.{kind}"
    browser._wait(browser.driver, 30, 0.02).until(lambda _: path.exists() and os.path.getsize(path))
    content = path.read_bytes()
    if kind == "csv":
        rows = content.decode().splitlines()
        assert rows[0].split(",")[:3] == ["time (s)", "axis 0 position (uu)", "axis 0 velocity (uu/s)"]
        assert len(rows) == 2002
        assert float(rows[1].split(",")[0]) == pytest.approx(browser.js("view.begin"))
    elif kind == "svg":
        assert ElementTree.fromstring(content).tag == "{http://www.w3.org/2000/svg}svg"
        assert b"var(" not in content
    else:
        assert content.startswith(b"\x89PNG")
        assert len(content) > 20_000


def test_events_are_a_lane_and_a_list(started: Browser, folder: Path) -> None:
    text = "SPEED(0) = 50\nJOG(0) = 50\nWAIT(1000)\nCANCEL(0)\n"
    write_scope(run(Source("jump.mnt", text), dialect="mint"), str(folder / "jump.html"))
    started.open(folder / "jump.html")
    assert started.js("document.querySelectorAll('#scope .event').length") >= 1
    rows = [
        row.get_attribute("textContent") for row in started.driver.find_elements("css selector", "#events tr")
    ]
    assert any("velocity jump of axis 0 from 50" in row and "line 4CANCEL(0)" in row for row in rows)
    started.js("document.querySelector('#events tr.grave').click()")
    assert started.js("marks[0]") == pytest.approx(1.0, abs=1e-3)
    assert started.complaints() == []


def test_a_second_run_lies_behind_the_first(started: Browser, folder: Path) -> None:
    slower = run(Source("slow.mnt", TWO_AXES.replace("= 50;", "= 40;")), dialect="mint")
    made = run(Source("two.mnt", TWO_AXES), dialect="mint")
    (folder / "both.html").write_text(page(made, against=slower), encoding="utf-8")
    started.open(folder / "both.html")
    assert "against slow.mnt" in started.find("#against").text
    assert started.js("END") == pytest.approx(slower.trace.end)
    assert started.js("document.querySelectorAll('#scope .curve-against').length") >= 2
    assert started.complaints() == []


def test_it_begins_with_the_requested_window(started: Browser, folder: Path) -> None:
    text = page(pick(), window=Window(0.5, 1.0, (1,), (0, 2)))
    (folder / "window.html").write_text(text, encoding="utf-8")
    started.open(folder / "window.html")
    assert started.js("[view.begin, view.end]") == [0.5, 1.0]
    shown = started.js("[...new Set(panels.filter((each) => each.axis).map((each) => each.axis.name))]")
    assert shown == ["axis 1"]
    assert started.find("#way").is_displayed()
    assert started.js("wayAxes") == ["axis 0", "axis 2", ""]


def test_many_moves_are_drawn_whole(started: Browser, folder: Path) -> None:
    """When zoomed out, the page takes the contents of a column from a table.

    The peaks are those of samples.
    """
    made = shift()
    (folder / "shift.html").write_text(page(made), encoding="utf-8")
    started.open(folder / "shift.html")
    for k, axis in enumerate(made.trace.axes):
        fine = made.trace.sample(1000.0, (axis,), quantities=("velocity",)).get(axis, "velocity")
        found = started.js(f"trackPoints(data.axes[{k}].track, 1, 0, END, 30).map(([, value]) => value)")
        assert max(found) == pytest.approx(fine.max(), rel=1e-3)
        assert min(found) == pytest.approx(fine.min(), rel=1e-3)
    assert started.complaints() == []

"""The page in Chromium, with real presses."""

from __future__ import annotations

import json
import threading
from collections.abc import Iterator
from pathlib import Path

import pytest

from motionlang.kernel import Source
from motionlang_explore.panel.roles import Roles
from motionlang_explore.panel.server import MAX_PAGES, PanelServer
from test_explore.panel.browser import PATIENCE, Browser, Tab, browsing, needs_chromium
from test_explore.panel.hands import Hand
from test_explore.panel.test_server import Page, served

pytestmark = needs_chromium
START, PART = "input 1 start", "input 2 part in"


@pytest.fixture(scope="module")
def browser() -> Iterator[Browser]:
    with browsing() as browser:
        yield browser


@pytest.fixture
def bench(tmp_path: Path) -> Iterator[tuple[Hand, PanelServer]]:
    """A program that runs."""
    with served(tmp_path / "press.mnt") as (hand, server):
        hand("run")
        yield hand, server


@pytest.fixture
def hand(bench: tuple[Hand, PanelServer]) -> Hand:
    return bench[0]


@pytest.fixture
def server(bench: tuple[Hand, PanelServer]) -> PanelServer:
    return bench[1]


@pytest.fixture
def tab(browser: Browser, server: PanelServer) -> Iterator[Tab]:
    """A page of the program."""
    tab = browser.tab(server.address)
    yield tab
    tab.close()


def says(tab: Tab, notice: str) -> None:
    tab.until(f"document.querySelector('#notice').textContent === {json.dumps(notice)}")


def is_on(hand: Hand, *numbers: int) -> None:
    hand.sees(lambda state: state["inputs"] == dict.fromkeys(numbers, 1))


def test_a_button_is_on_until_the_mouse_lets_go_of_it_anywhere(hand: Hand, tab: Tab) -> None:
    tab.press(START)
    is_on(hand, 1)
    tab.mouse("Moved", (5, 5))
    began = hand.state["t"]
    assert hand.sees(lambda state: state["t"] > began + 2)["inputs"] == {1: 1}
    tab.mouse("Released")
    is_on(hand)


def test_two_fingers_press_two_buttons(hand: Hand, tab: Tab) -> None:
    for end in ("End", "Cancel"):
        start, part = tab.middle(START), tab.middle(PART)
        tab.touch("Start", start)
        tab.touch("Start", start, part)
        is_on(hand, 1, 2)
        tab.touch("Move", start, (part[0] + 90, part[1] + 90))
        is_on(hand, 1, 2)
        tab.touch(end)
        is_on(hand)


def test_a_key_presses_a_button(hand: Hand, tab: Tab) -> None:
    tab.until("document.querySelectorAll('.push').length === 2")
    tab.js("document.querySelectorAll('.push')[1].focus()")
    for end in ("keyup", "blur"):
        tab.key("Down")
        tab.key("Down")
        is_on(hand, 2)
        if end == "blur":
            tab.js("document.activeElement.blur()")
        tab.key("Up")
        is_on(hand)


@pytest.mark.parametrize("how", ["close", "reload", "hide", "blur"])
def test_a_page_that_goes_releases_what_it_presses(
    browser: Browser, hand: Hand, server: PanelServer, how: str
) -> None:
    tab = browser.tab(server.address)
    tab.click("input 1 start, hold")
    is_on(hand, 1)
    tab.press(PART)
    is_on(hand, 1, 2)
    if how == "close":
        tab.close()
    elif how == "reload":
        tab.do("Page.reload")
    elif how == "hide":
        browser.tab(server.address)
    else:
        tab.js("window.dispatchEvent(new Event('blur'))")
    is_on(hand, 1)
    if how == "reload":
        tab.until("""!!document.querySelector('[aria-label="input 1 start, hold"][aria-checked=true]')""")


def test_fast_presses_leave_nothing_on(hand: Hand, tab: Tab) -> None:
    for _ in range(20):
        tab.click(START)
        tab.click(PART)
    tab.click("save")
    tab.until("document.querySelector('#notice').textContent.startsWith('saved ')")
    is_on(hand)


def test_eight_tabs_of_a_browser_all_work(browser: Browser, hand: Hand, server: PanelServer) -> None:
    tabs = [browser.tab(server.address) for _ in range(8)]
    for each in tabs:
        each.until("parseFloat(document.querySelector('#time').textContent) > 0")
    tabs[0].js("document.querySelector('#run').click()")
    hand.sees(lambda state: state["mode"] == "paused")
    tabs[-1].until("document.querySelector('#mode').textContent === 'paused'")
    assert tabs[-1].js("document.querySelector('#time').textContent") != tabs[0].js(
        "document.querySelector('#time').textContent"
    )
    for each in reversed(tabs[1:]):
        each.close()
    tabs[0].do("Page.bringToFront")
    tabs[0].until("document.querySelector('#mode').textContent === 'paused'")
    tabs[0].close()


def test_a_page_too_many_says_so_and_works_when_another_is_closed(
    browser: Browser, server: PanelServer
) -> None:
    others = [Page(server).events() for _ in range(MAX_PAGES)]
    for each in others:
        next(each)
    tab = browser.tab(server.address)
    says(tab, "too many pages of this panel are visible: close or hide one")
    others[0].close()
    tab.until("document.querySelector('#mode').textContent === 'runs'")
    tab.close()
    for events in others:
        events.close()


def test_a_button_without_an_answer_says_so(hand: Hand, tab: Tab) -> None:
    is_free = threading.Event()

    def act(request: object) -> None:
        is_free.wait(PATIENCE)

    tab.middle(START)
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(hand.session, "act", act)
        tab.click("pause")
        says(tab, "no answer yet: motionlang panel is busy")
        is_free.set()
        says(tab, "")


def test_a_double_click_answers_one_question(browser: Browser, tmp_path: Path) -> None:
    text = 'Dim n\nInput "parts ", n\nInput "speed ", n\nPause INX(1)\n'
    with served(tmp_path / "ask.mnt", text) as (hand, server):
        hand("run")
        tab = browser.tab(server.address)
        tab.until("!document.querySelector('#answer').hidden")
        tab.js("document.querySelector('#line').value = '10'")
        tab.mouse("Moved", tab.middle("answer"))
        for clicks in (1, 2):
            tab.mouse("Pressed", clicks=clicks)
            tab.mouse("Released", clicks=clicks)
        tab.until("/just changed|came too late/.test(document.querySelector('#notice').textContent)")
        hand.sees(lambda state: state["question"] == "speed")
        assert [words for _, words in hand.record] == ["answer 10"]
        tab.close()


def test_the_newest_action_is_first_an_axis_has_its_range_so_far_and_a_notice_goes(
    hand: Hand, tab: Tab
) -> None:
    tab.js("(window.setTimeout = ((real) => (act, ms) => real(act, ms / 100))(setTimeout), 0)")
    tab.click("input 2 part in, hold")
    is_on(hand, 2)
    tab.click("input 1 start, hold")
    is_on(hand, 1, 2)
    tab.until("document.querySelector('#record li').textContent.endsWith('input 1 on')")
    tab.until("document.querySelector('.axis small').textContent === 'so far 0.00 to 20.00'")
    tab.click("save")
    hand.hears("saved ")
    says(tab, "")


def test_the_buttons_of_the_header_are_one_line_on_a_phone(tab: Tab) -> None:
    tab.do("Emulation.setDeviceMetricsOverride", width=400, height=800, deviceScaleFactor=1, mobile=True)
    tab.middle(START)
    assert tab.js("document.querySelector('.top').clientHeight") < 50
    assert tab.js("document.documentElement.scrollWidth") <= 400


def test_a_press_goes_on_when_the_exploration_ends(browser: Browser, tmp_path: Path) -> None:
    is_free = threading.Event()

    def explore(source: Source, settings: object) -> Roles:
        is_free.wait(PATIENCE)
        return Roles({1: "button", 2: "switch", 7: "button"}, {})

    with served(tmp_path / "press.mnt", explore=explore) as (hand, server):
        hand("run")
        tab = browser.tab(server.address)
        tab.press(START)
        is_on(hand, 1)
        is_free.set()
        tab.until("document.querySelectorAll('.push').length === 2")
        tab.middle("input 7")
        began = hand.state["t"]
        assert hand.sees(lambda state: state["t"] > began + 2)["inputs"] == {1: 1}
        tab.mouse("Released")
        is_on(hand)
        tab.click("make input 7 a switch")
        tab.until("document.querySelectorAll('.push').length === 1")
        tab.close()

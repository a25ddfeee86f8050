"""The page in Chromium, with real presses."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path

import pytest

from tests.commands.panel.browser import Browser, Tab, browsing, needs_chromium
from tests.commands.panel.hands import Hand
from tests.commands.panel.test_server import served

pytestmark = needs_chromium
START, PART = "input 1 start", "input 2 part in"


@pytest.fixture(scope="module")
def browser() -> Iterator[Browser]:
    with browsing() as browser:
        yield browser


@pytest.fixture
def hand(tmp_path: Path) -> Iterator[Hand]:
    """A program that runs at `hand.address`."""
    with served(tmp_path / "press.mnt") as (hand, server):
        hand("run")
        hand.address = server.address
        yield hand


@pytest.fixture
def tab(browser: Browser, hand: Hand) -> Iterator[Tab]:
    """A page of the program."""
    tab = browser.tab(hand.address)
    yield tab
    tab.close()


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
def test_a_page_that_goes_releases_what_it_presses(browser: Browser, hand: Hand, how: str) -> None:
    tab = browser.tab(hand.address)
    tab.click("input 1 start, hold")
    is_on(hand, 1)
    tab.press(PART)
    is_on(hand, 1, 2)
    if how == "close":
        tab.close()
    elif how == "reload":
        tab.do("Page.reload")
    elif how == "hide":
        browser.tab(hand.address)
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
    hand.hears("saved ")
    is_on(hand)

"""A minute of random hands on old programs leaves nothing on that nobody presses, switches or latches."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path
from random import Random
from time import monotonic

import pytest

from test_explore.panel.browser import Browser, Tab, browsing, needs_chromium
from test_explore.panel.test_server import served

pytestmark = [needs_chromium, pytest.mark.slow]
PROGRAMS = ("tray-loader", "batch-counter", "checkweigher", "coil-winder", "conveyor-tracking")
SCRIPTS = Path(__file__).parents[4] / "scripts" / "mint"
SECONDS = 12.0


@pytest.fixture(scope="module")
def browser() -> Iterator[Browser]:
    with browsing() as browser:
        yield browser


def middles(tab: Tab) -> list[tuple[float, float]]:
    """Return the middles of the buttons of inputs that are on the screen."""
    found = tab.js(
        """[...document.querySelectorAll(".push, #inputs [role=switch]")].map((each) => each.getBoundingClientRect())
        .filter((box) => box.top > 120 && box.bottom < innerHeight)
        .map((box) => [box.x + box.width / 2, box.y + box.height / 2])"""
    )
    return [(x, y) for x, y in found or []]


@pytest.mark.parametrize("name", PROGRAMS)
def test_random_hands_leave_nothing_on(tmp_path: Path, browser: Browser, name: str) -> None:
    random = Random(name)
    path = tmp_path / f"{name}.mnt"
    with served(path, (SCRIPTS / path.name).read_text(encoding="utf-8")) as (hand, server):
        hand("run")
        tabs = [browser.tab(server.address)]
        end = monotonic() + SECONDS
        while monotonic() < end:
            tab = random.choice(tabs)
            act = random.choice(
                ["press"] * 4 + ["move", "release", "reload", "close", "open", "phone", "back", "restart"]
            )
            places = middles(tab)
            if act == "press" and places:
                tab.mouse("Moved", random.choice(places))
                tab.mouse("Pressed")
                if random.random() < 0.7:
                    tab.mouse("Released")
            elif act == "move":
                tab.mouse("Moved", (5, 5))
            elif act == "release":
                tab.mouse("Released")
            elif act == "reload":
                tab.do("Page.reload")
            elif act == "close":
                tab.close()
                tabs.remove(tab)
            elif act == "phone":
                size = random.choice([(390, 800), (1400, 900)])
                tab.do(
                    "Emulation.setDeviceMetricsOverride",
                    width=size[0],
                    height=size[1],
                    deviceScaleFactor=1,
                    mobile=size[0] < 1000,
                )
            elif act == "back":
                hand("back", time=random.random() * hand.state["t"])
                hand("run")
            elif act == "restart":
                hand("restart", keep=random.random() < 0.5)
            if not tabs or (act == "open" and len(tabs) < 8):
                tabs.append(browser.tab(server.address))
            hand.sees(lambda state: True)
        for tab in tabs:
            tab.close()
        hand("run")
        state = hand.sees(lambda state: not state["pressed"] and not state["pending"])
        switched = {
            each.number for _, each in hand.session._play.record.changes if type(each).__name__ == "Change"
        }
        assert set(state["inputs"]) <= switched | hand.session._play.driven

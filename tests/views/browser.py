"""A headless Chromium that opens a page and uses it like a person.

Tests are skipped without Chromium.
"""

from __future__ import annotations

import json
import shutil
from pathlib import Path
from types import TracebackType
from typing import Any

import pytest


class Browser:
    """One browser for several pages; `with Browser() as browser`."""

    def __init__(self, downloads: Path) -> None:
        webdriver = pytest.importorskip("selenium.webdriver")
        program = (
            shutil.which("chromium") or shutil.which("chromium-browser") or shutil.which("google-chrome")
        )
        driver = shutil.which("chromedriver")
        if program is None or driver is None:
            pytest.skip("no Chromium with a chromedriver is installed")
        options = webdriver.ChromeOptions()
        options.binary_location = program
        for each in ("--headless=new", "--no-sandbox", "--disable-gpu", "--window-size=1300,1000"):
            options.add_argument(each)
        options.add_experimental_option("prefs", {"download.default_directory": str(downloads)})
        options.set_capability("goog:loggingPrefs", {"browser": "ALL", "performance": "ALL"})
        self.driver = webdriver.Chrome(options, webdriver.ChromeService(driver))
        self._actions = pytest.importorskip("selenium.webdriver.common.action_chains").ActionChains
        self._wait = pytest.importorskip("selenium.webdriver.support.wait").WebDriverWait

    def __enter__(self) -> Browser:
        return self

    def __exit__(
        self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None
    ) -> None:
        self.driver.quit()

    def open(self, path: Path) -> None:
        """Load a file, and wait until the page has been drawn at the width that its scroll bar leaves."""
        self.driver.get(path.as_uri())
        self.until("document.getElementById('over') !== null && width === scope.clientWidth - LEFT - RIGHT")

    def js(self, expression: str) -> Any:
        """Return the value of an expression in the page."""
        return self.driver.execute_script(f"return ({expression})")

    def until(self, condition: str) -> None:
        """Wait until a condition is true in the page, half a minute at most."""
        self._wait(self.driver, 30, 0.02).until(lambda _: self.js(condition))

    def settled(self) -> None:
        """Wait until the latest picture that was requested is drawn."""
        self.driver.execute_async_script(
            "const done = arguments[0]; requestAnimationFrame(() => requestAnimationFrame(() => done()))"
        )

    def find(self, selector: str) -> Any:
        return self.driver.find_element("css selector", selector)

    def mouse(self, fraction: float = 0.5, height: int = 40) -> Any:
        """Return mouse actions that begin in the picture, at a fraction of its width."""
        position = "[Math.round(scope.getBoundingClientRect().left + LEFT + %g * width), %s]"
        top = f"document.querySelector('header').getBoundingClientRect().bottom + {height}"
        x, y = self.js(position % (fraction, f"Math.round({top})"))
        actions = self._actions(self.driver, duration=0)
        actions.w3c_actions.pointer_action.move_to_location(x, y)
        return actions

    def keys(self, *keys: str) -> None:
        self.mouse().send_keys(*keys).perform()
        self.settled()

    def complaints(self) -> list[str]:
        """Return the messages on the console since the last call."""
        return [str(each["message"]) for each in self.driver.get_log("browser")]

    def requests(self) -> set[str]:
        """Return the addresses requested since the last call, without files and page data."""
        messages = [json.loads(each["message"])["message"] for each in self.driver.get_log("performance")]
        urls = [
            each["params"]["request"]["url"]
            for each in messages
            if each["method"] == "Network.requestWillBeSent"
        ]
        return {url for url in urls if not url.startswith(("file:", "data:", "blob:"))}

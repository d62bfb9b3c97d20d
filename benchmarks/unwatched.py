"""A browser that nobody watches while it is measured.

A program that drives a page is told of each message that the page's sockets bring. In JupyterLab
this took a quarter of a core, and Chromium some more. So the page is left alone during a drag.
"""

import json
import socket
import subprocess
import tempfile
import time
import urllib.request
from collections.abc import Iterator
from contextlib import contextmanager
from typing import Any

from lab_driver import CHROMIUM, FLAGS

PATIENCE = 60.0  # seconds until Chromium answers


class Browser:
    """Chromium without a window, with one page, which can be left and visited again."""

    def __init__(self, port: int) -> None:
        self.address = f"http://127.0.0.1:{port}"
        self._driver: Any = None
        self._page: Any = None

    @property
    def page(self) -> Any:
        """The page; what was taken from it before it was left is no longer valid."""
        if self._driver is None:
            from playwright.sync_api import sync_playwright

            self._driver = sync_playwright().start()
            visited = self._driver.chromium.connect_over_cdp(self.address)
            (self._page,) = visited.contexts[0].pages
        return self._page

    def leave(self) -> None:
        """Leave the page, which goes on as it is."""
        if self._driver is not None:
            self._driver.stop()
        self._driver = self._page = None

    def targets(self) -> list[dict[str, str]]:
        """Chromium's pages and what else can be driven, as soon as it answers."""
        until = time.perf_counter() + PATIENCE
        while True:
            try:
                with urllib.request.urlopen(f"{self.address}/json", timeout=5) as answer:
                    return list(json.load(answer))
            except OSError:
                if time.perf_counter() > until:
                    raise
                time.sleep(0.1)

    @contextmanager
    def slowed(self, times: float) -> Iterator[None]:
        """Slow the page down so many times, also while it is left."""
        from websocket import create_connection

        (page,) = [target for target in self.targets() if target["type"] == "page"]
        line = create_connection(page["webSocketDebuggerUrl"], suppress_origin=True)
        try:
            slower = {"method": "Emulation.setCPUThrottlingRate", "params": {"rate": times}}
            line.send(json.dumps({"id": 1, **slower}))
            line.recv()
            yield
        finally:
            line.close()


@contextmanager
def open_browser(address: str, width: int = 1280, height: int = 1000) -> Iterator[Browser]:
    """A browser with a page at an address, in a window of so many pixels."""
    with socket.socket() as probe:
        probe.bind(("127.0.0.1", 0))
        port = probe.getsockname()[1]
    with tempfile.TemporaryDirectory(ignore_cleanup_errors=True) as profile:
        command = [str(CHROMIUM), "--headless", *FLAGS, f"--window-size={width},{height}"]
        command += [f"--remote-debugging-port={port}", f"--user-data-dir={profile}", address]
        process = subprocess.Popen(command, stderr=subprocess.DEVNULL)
        browser = Browser(port)
        try:
            browser.targets()
            yield browser
        finally:
            browser.leave()
            process.terminate()
            process.wait()


@contextmanager
def open_notebook(address: str, token: str, notebook: str) -> Iterator[Browser]:
    """A browser with a notebook open in JupyterLab."""
    with open_browser(f"{address}/lab/tree/{notebook}?reset&token={token}") as browser:
        browser.page.set_default_timeout(60_000)
        browser.page.wait_for_selector(".jp-Notebook .jp-Cell")
        yield browser

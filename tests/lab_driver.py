"""Drives a real JupyterLab in headless Chromium: starts it as `python start.py` does, opens a
notebook and runs it.
"""

import json
import os
import secrets
import shutil
import socket
import subprocess
import time
import urllib.request
from contextlib import contextmanager, suppress
from pathlib import Path

from kinoedu.lab import lab_command

CHROMIUM = next(
    filter(None, map(shutil.which, ("chromium", "chromium-browser", "google-chrome"))), None
)
FLAGS = [
    "--no-sandbox",
    "--disable-gpu",
    "--disable-quic",
    "--no-first-run",
    "--disable-background-networking",
    "--disable-component-update",
    "--disable-sync",
]
OPEN = """async ([path, id]) => {
    const { commands, shell } = jupyterapp;
    const kernel = id ? {id} : undefined;
    await commands.execute('docmanager:open', {path, factory: 'Notebook', kernel});
    await shell.currentWidget.context.ready;
    await shell.currentWidget.sessionContext.ready;
    return shell.currentWidget.sessionContext.session.kernel.id; }"""
RUN_ALL = """async () => {
    const panel = jupyterapp.shell.currentWidget;
    await panel.context.ready;
    await panel.sessionContext.ready;
    await panel.sessionContext.session.kernel.info;
    await jupyterapp.commands.execute('notebook:run-all-cells');
    return panel.content.model.toJSON(); }"""


def needs_chromium():
    """Skip a test where there is no browser; fail it in CI, which installs one."""
    if CHROMIUM is None:
        import pytest

        if os.environ.get("CI"):
            pytest.fail("this test needs Chromium, which the project's CI installs")
        pytest.skip(
            "Chromium is not installed here; the same notebooks are run without a browser by nbval"
        )


def written_notebook(*cells: str) -> str:
    """A notebook of code cells, as text."""
    code = [
        {
            "cell_type": "code",
            "id": f"c{k}",
            "metadata": {},
            "source": cell,
            "outputs": [],
            "execution_count": None,
        }
        for k, cell in enumerate(cells)
    ]
    kernel = {"kernelspec": {"display_name": "Python 3", "language": "python", "name": "python3"}}
    return json.dumps({"nbformat": 4, "nbformat_minor": 5, "metadata": kernel, "cells": code})


@contextmanager
def lab(course: Path, home: Path):
    """A JupyterLab server on `course` with settings of its own; yields (address, token)."""
    with socket.socket() as probe:
        probe.bind(("127.0.0.1", 0))
        port = probe.getsockname()[1]
    token = secrets.token_hex(16)
    environment = dict(os.environ, JUPYTER_TOKEN=token, IPYTHONDIR=str(home / "ipython"))
    for name in (
        "JUPYTER_CONFIG_DIR",
        "JUPYTERLAB_SETTINGS_DIR",
        "JUPYTERLAB_WORKSPACES_DIR",
        "JUPYTER_RUNTIME_DIR",
    ):
        environment[name] = str(home / name.lower())
    quiet = (
        home
        / "jupyterlab_settings_dir"
        / "@jupyterlab"
        / "apputils-extension"
        / "notification.jupyterlab-settings"
    )
    quiet.parent.mkdir(parents=True)
    quiet.write_text(json.dumps({"fetchNews": "false", "checkForUpdates": False}))
    command = lab_command(browser=False)
    command += [f"--ServerApp.port={port}", "--ServerApp.port_retries=0", "--expose-app-in-browser"]
    with (home / "server.log").open("w+") as log:
        server = subprocess.Popen(
            command, cwd=course, env=environment, stdout=log, stderr=subprocess.STDOUT
        )
        try:
            wait_for(f"http://127.0.0.1:{port}/api?token={token}", server, home / "server.log")
            yield f"http://127.0.0.1:{port}", token
        finally:
            server.terminate()
            server.wait(30)


def wait_for(address: str, server: "subprocess.Popen[bytes]", log: Path) -> None:
    """Wait until the server answers."""
    while server.poll() is None:
        with suppress(OSError), urllib.request.urlopen(address, timeout=5):
            return
        time.sleep(0.1)
    raise RuntimeError(f"JupyterLab ended: {log.read_text()}")


@contextmanager
def launched():
    """Chromium, without a window."""
    from playwright.sync_api import sync_playwright

    with sync_playwright() as play:
        browser = play.chromium.launch(executable_path=CHROMIUM, args=FLAGS)
        try:
            yield browser
        finally:
            browser.close()


@contextmanager
def lab_page(address: str, token: str):
    """A page of JupyterLab with no notebook open.

    `page.outside` lists requests to other computers, which are refused; `page.errors` are the
    browser's errors.
    """
    with launched() as browser:
        page = browser.new_page(viewport={"width": 1280, "height": 1000})
        page.set_default_timeout(60_000)
        page.outside, page.errors = [], []
        page.on("pageerror", lambda error: complain(page, str(error)))
        page.on(
            "console",
            lambda message: complain(page, message.text) if message.type == "error" else None,
        )
        page.route(
            lambda url: not url.startswith((address, "data:", "blob:")),
            lambda route: (page.outside.append(route.request.url), route.abort()),
        )
        page.goto(f"{address}/lab?reset&token={token}")
        page.wait_for_function("window.jupyterapp")
        page.evaluate("jupyterapp.restored")
        yield page


def complain(page, error: str) -> None:
    """Keep an error of the browser, but not this one of JupyterLab: a notebook that was just closed
    is asked for its focus.
    """
    if not ("_ensureFocus" in error and "null (reading 'footer')" in error):
        page.errors.append(error)


def keep(page, name: str) -> None:
    """Save a screenshot in the folder KINOEDU_SCREENSHOTS, where it is set."""
    if folder := os.environ.get("KINOEDU_SCREENSHOTS"):
        page.screenshot(path=os.path.join(folder, f"{name}.png"))

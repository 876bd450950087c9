# SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
# SPDX-License-Identifier: BSD-3-Clause
"""Browsers without a screen, a GPU and a network, driven by real events: with browser("chromium", "swiftshader") as b.

BROWSERS are the pairs of browser and driver of the GL that there are. Chromium is /usr/bin/chromium with chromedriver,
Firefox firefox-esr, whose WebGL needs an X server even in its headless mode: Xvfb.
"""
import base64
import contextlib
import io
import json
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
import time
import unittest

import numpy as np
from PIL import Image

from webdriver import ChromeDriver, Marionette

sys.path.append(str(pathlib.Path(__file__).resolve().parents[1] / "Python"))
from with_display import own_server  # noqa: E402

PROGRAMS = {"chromium": ("chromium", "chromedriver"), "firefox": ("firefox-esr",)}
BROWSERS = ("chromium", "swiftshader"), ("chromium", "llvmpipe"), ("firefox", "llvmpipe")
TIMEOUTS = {"script": 600_000}  # milliseconds
ELEMENT = "element-6066-11e4-a52e-4f735466cecf"  # the key of an element's id, WebDriver 12
RENDERER = """const gl = document.createElement("canvas").getContext("webgl2");
    return gl && gl.getParameter(gl.getExtension("WEBGL_debug_renderer_info").UNMASKED_RENDERER_WEBGL)"""
# Resolves to the title: when it becomes one of the titles, or after 200 ms.
TITLE = """const [titles] = arguments;
    return new Promise(done => {
      const finish = () => { observer.disconnect(); done(document.title); };
      const observer = new MutationObserver(() => titles.includes(document.title) && finish());
      observer.observe(document.head, { childList: true, subtree: true });
      setTimeout(finish, titles.includes(document.title) ? 0 : 200);
    })"""
TWO_FRAMES = "return new Promise(done => requestAnimationFrame(() => requestAnimationFrame(done)))"
CONTROL_KEYS = {"Tab": "\ue004", "Enter": "\ue007", "Shift": "\ue008", "Control": "\ue009", "Escape": "\ue00c",
                "Space": " ", "ArrowLeft": "\ue012", "ArrowUp": "\ue013", "ArrowRight": "\ue014",
                "ArrowDown": "\ue015", "Delete": "\ue017", "Home": "\ue011", "End": "\ue010"}


def pixels_of_png(text):
    return np.array(Image.open(io.BytesIO(base64.b64decode(text))).convert("RGB"))


def strokes(points, button):
    """A pointer goes down at the first point, over the others and up at the last."""
    moves = [{"type": "pointerMove", "x": x, "y": y, "duration": 20} for x, y in points]
    return [moves[0], {"type": "pointerDown", "button": button}, *moves[1:], {"type": "pointerUp", "button": button}]


class Browser:
    """What both browsers do alike. Coordinates are pixels of the window, y down; the scale of the device is 1."""

    def __init__(self, session):
        self.session = session
        self.heard = []

    def console(self):
        """The errors and warnings since the page was opened or this was called."""
        said, self.heard = self.heard + self.new_messages(), []
        return said

    def run(self, script, *arguments):
        """The value that the body of a function returns in the page; a promise is awaited."""
        return self.session.call("ExecuteScript", script=script, args=list(arguments))

    def open(self, path, fragment=""):
        """A file of this machine in a new document, even if it is the one that is open."""
        self.session.call("Navigate", url="about:blank")
        self.console()
        self.opened = time.monotonic()
        url = pathlib.Path(path).resolve().as_uri()
        self.session.call("Navigate", url=url + ("#" + fragment if fragment else ""))

    def wait_title(self, title, seconds):
        """Seconds from open() until the document has this title; fails at once if a script does or it is "failed"."""
        while (shown := self.run(TITLE, [title, "failed"])) != title:
            if shown == "failed":
                raise RuntimeError("The page says: " + self.run("return document.body.innerText"))
            self.heard += self.new_messages()
            if any(re.search("Uncaught|JavaScript Error", message) for message in self.heard):
                raise RuntimeError(f"The console says: {self.heard}")
            if time.monotonic() > self.opened + seconds:
                raise TimeoutError(f"After {seconds} s the title is {shown!r}, not {title!r}")
        return time.monotonic() - self.opened

    def renderer(self):
        """The renderer of the GL behind WebGL 2, or None."""
        return self.run(RENDERER)

    def png(self, selector="canvas"):
        """The pixels of the first such element as the window shows them: (height, width, 3), from the top."""
        self.run(TWO_FRAMES)  # what a script drew is shown with the next frame
        element = self.session.call("FindElement", using="css selector", value=selector)[ELEMENT]
        return pixels_of_png(self.session.call("TakeScreenshot", id=element))

    def pixels(self, script):
        """The same of a data URL of a PNG that a script returns, as of canvas.toBlob."""
        return pixels_of_png(self.run(script).partition("base64,")[2])

    def perform(self, *sources):
        self.session.call("PerformActions", actions=list(sources))
        self.session.call("ReleaseActions")
        self.run(TWO_FRAMES)

    def mouse(self, *points, button=0, keys=()):
        """Press at the first point, move over the others and release at the last, while keys are held."""
        held = [CONTROL_KEYS[key] for key in keys]
        down = [{"type": "key", "id": "keys", "actions": [{"type": "keyDown", "value": key} for key in held]}]
        self.perform(*down[:len(held)], {"type": "pointer", "id": "mouse",
                                         "actions": [{"type": "pause"}] * len(held) + strokes(points, button)})

    def touch(self, *fingers):
        """Fingers that go down together, each over its points; all have equally many."""
        self.perform(*({"type": "pointer", "id": f"finger{i}", "parameters": {"pointerType": "touch"},
                        "actions": strokes(points, 0)}
                       for i, points in enumerate(fingers)))

    def wheel(self, x, y, pixels):
        """Positive pixels scroll down."""
        self.perform({"type": "wheel", "id": "wheel",
                      "actions": [{"type": "scroll", "x": x, "y": y, "deltaX": 0, "deltaY": pixels}]})

    def keys(self, *keys):
        """Keys one after the other: a letter, or a name of CONTROL_KEYS."""
        values = [CONTROL_KEYS.get(key, key) for key in keys]
        self.perform({"type": "key", "id": "keys", "actions": [
            {"type": kind, "value": value} for value in values for kind in ("keyDown", "keyUp")]})


class Chromium(Browser):
    def new_messages(self):
        return [f"{entry['level']}: {entry['message']}" for entry in self.session.call("Log", type="browser")
                if entry["level"] in ("WARNING", "SEVERE")]

    def size(self, width, height):
        """The size of the window's inner part."""
        self.session.call("DevTools", cmd="Emulation.setDeviceMetricsOverride", params={
            "width": width, "height": height, "deviceScaleFactor": 1, "mobile": False})


class Firefox(Browser):
    # Messages of pages: what scripts write comes from the process of the page, the rest from that of the browser.
    LISTEN = """const pages = Services.ppmm;
        pages.tetmarch = [];
        const keep = text => pages.tetmarch.push(text);
        pages.addMessageListener("tetmarch:console", message => keep(message.data));
        pages.loadProcessScript("data:,(" + encodeURIComponent(function listen() {
          Cc["@mozilla.org/consoleAPI-storage;1"].getService(Ci.nsIConsoleAPIStorage).addLogEventListener(event => {
            const { level, arguments: words } = event.wrappedJSObject;
            if (level === "warn" || level === "error" || level === "assert")
              sendAsyncMessage("tetmarch:console", level + ": " + words.map(String).join(" "));
          }, Cc["@mozilla.org/systemprincipal;1"].createInstance(Ci.nsIPrincipal));
        }.toString()) + ")()", true);
        Services.console.registerListener({ observe(message) {
          if (message instanceof Ci.nsIScriptError && !/^(chrome|resource):/.test(message.sourceName))
            keep(message.message);
        } });"""
    # The browser's window is at least 450 pixels wide; the page in it may be smaller.
    SIZE = """const [width, height] = arguments, page = gBrowser.selectedBrowser;
        window.resizeTo(width + 200, height + 200);
        for (const [name, value] of [["width", width], ["height", height]])
          for (const limit of ["", "min-", "max-"]) page.style.setProperty(limit + name, value + "px");"""

    def in_browser(self, script, *arguments):
        """The same as run() in the browser's own window."""
        self.session.call("SetContext", prefix="Marionette:", value="chrome")
        try:
            return self.run(script, *arguments)
        finally:
            self.session.call("SetContext", prefix="Marionette:", value="content")

    def new_messages(self):
        self.run(TWO_FRAMES)  # the GL of the page has a process of its own
        return self.in_browser("return Services.ppmm.tetmarch.splice(0)")

    def size(self, width, height):
        """The size of the window's inner part."""
        self.in_browser(self.SIZE, width, height)
        while self.run("return [innerWidth, innerHeight]") != [width, height]:
            time.sleep(0.01)


@contextlib.contextmanager
def process(command, environment, output):
    """A process that ends with the block, and with this process, however that ends."""
    started = subprocess.Popen(["setpriv", "--pdeathsig", "KILL", *command], env=environment, stdin=subprocess.DEVNULL,
                               stdout=output, stderr=subprocess.STDOUT)
    try:
        yield started
    finally:
        started.kill()
        started.wait()


def wait_for(path, pattern, started):
    """What the first group of the pattern matches in the text of a file that a process writes."""
    for _ in range(600):
        text = path.read_text() if path.exists() else ""
        if found := re.search(pattern, text):
            return found[1]
        if started.poll() is not None:
            break
        time.sleep(0.05)
    raise RuntimeError(f"{started.args[3]} didn't start: {text}")


CHROMIUM_GL = {"swiftshader": ["--use-angle=swiftshader", "--enable-unsafe-swiftshader"],
               "llvmpipe": ["--use-gl=angle", "--use-angle=gl-egl", "--ignore-gpu-blocklist"]}


@contextlib.contextmanager
def chromium(driver, folder):
    # A kiosk has no tabs and no buttons, which the processors would draw anew for each page.
    options = ["--headless", "--kiosk", "--no-sandbox", "--disable-dev-shm-usage", "--force-color-profile=srgb",
               "--proxy-server=127.0.0.1:9", "--remote-debugging-pipe", f"--user-data-dir={folder}/profile",
               *CHROMIUM_GL[driver]]
    environment = {**os.environ, "HOME": str(folder), "LIBGL_ALWAYS_SOFTWARE": "1"}
    log = folder / "log"
    with open(log, "w") as output, process(["chromedriver", "--port=0"], environment, output) as started:
        port = int(wait_for(log, r"on port (\d+)\.", started))
        session = ChromeDriver(port, {"goog:chromeOptions": {"binary": "/usr/bin/chromium", "args": options},
                                      "timeouts": TIMEOUTS, "goog:loggingPrefs": {"browser": "ALL"}})
        try:
            yield Chromium(session)
        finally:
            session.call("DeleteSession")
            session.close()


FIREFOX_PREFERENCES = {
    "marionette.port": 0, "webgl.force-enabled": True, "webgl.sanitize-unmasked-renderer": False,
    "gfx.color_management.mode": 0, "gfx.webrender.software": True,
    # No network, neither for pages nor for the browser's own services.
    "network.proxy.type": 1, "network.proxy.http": "127.0.0.1", "network.proxy.http_port": 9,
    "network.proxy.ssl": "127.0.0.1", "network.proxy.ssl_port": 9}


@contextlib.contextmanager
def firefox(driver, folder):
    if driver != "llvmpipe":
        raise ValueError(f"Firefox draws with the llvmpipe, not with {driver}")
    profile = folder / "profile"
    profile.mkdir()
    (profile / "user.js").write_text("".join(f"user_pref({json.dumps(name)}, {json.dumps(value)});\n"
                                             for name, value in FIREFOX_PREFERENCES.items()))
    command = ["firefox-esr", "--headless", "--marionette", "--remote-allow-system-access", "--no-remote",
               "--profile", str(profile)]
    with own_server() as display, open(folder / "log", "w") as output:
        environment = {**display, "HOME": str(folder), "LIBGL_ALWAYS_SOFTWARE": "1"}
        with process(command, environment, output) as started:
            port = int(wait_for(profile / "MarionetteActivePort", r"^(\d+)", started))
            session = Marionette(port, {"timeouts": TIMEOUTS})
            try:
                opened = Firefox(session)
                opened.in_browser(Firefox.LISTEN)
                yield opened
            finally:
                session.close()


@contextlib.contextmanager
def browser(name, driver):
    """A browser with a profile of its own; it ends with the block. start is the seconds that it took to start.

    What needs it in a test is skipped if it isn't installed.
    """
    for program in PROGRAMS[name]:
        if not shutil.which(program):
            raise unittest.SkipTest(f"There is no {program}")
    begin = time.monotonic()
    with tempfile.TemporaryDirectory(prefix="tetmarch-", ignore_cleanup_errors=True) as folder:
        with {"chromium": chromium, "firefox": firefox}[name](driver, pathlib.Path(folder)) as opened:
            opened.start = time.monotonic() - begin
            yield opened

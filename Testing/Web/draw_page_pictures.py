# SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
# SPDX-License-Identifier: BSD-3-Clause
"""The pictures of Documentation/Web.md: draw_page_pictures.py MESH.html IMAGE.html FOLDER

The pages are those of the commands there. Chromium draws them with the llvmpipe of Mesa.
"""
import base64
import pathlib
import sys
import time

from PIL import Image

from browsers import browser, pixels_of_png

DESKTOP = 1000, 640
PHONE = 390, 760
PICKED = 330, 420
COLORS = 256  # of a palette, so that a picture stays below 150 KB
LATER = "return new Promise(done => setTimeout(done, 600))"  # after the last coarse frame
IS_COMPLETE = """const { complete } = document.getElementById("picture").viewer;
    return Promise.race([complete.then(() => true), new Promise(done => setTimeout(done, 1000))])"""
MESSAGE = "const shown = document.getElementById('message'); return shown.hidden ? '' : shown.innerText"
SECONDS = 300


def wait(opened, script):
    """Until the script returns true; an error if the page shows a message."""
    begun = time.monotonic()
    while not opened.run(script):
        if message := opened.run(MESSAGE):
            raise RuntimeError(message)
        if time.monotonic() > begun + SECONDS:
            raise TimeoutError(script)
        opened.run(LATER)


def rest(opened):
    opened.run(LATER)
    wait(opened, IS_COMPLETE)
    opened.run(LATER)


def show(opened, page, size, scheme, touch=False):
    """Opens a page as a device shows it: its size, its colour scheme, a finger or a mouse."""
    def set_device(command, **params):
        opened.session.call("DevTools", cmd=f"Emulation.{command}", params=params)
    set_device("setEmulatedMedia", features=[{"name": "prefers-color-scheme", "value": scheme}])
    set_device("setTouchEmulationEnabled", enabled=touch)
    set_device("setDeviceMetricsOverride", width=size[0], height=size[1], deviceScaleFactor=1, mobile=touch)
    opened.open(page)
    wait(opened, "return document.getElementById('picture').viewer?.current != null")
    rest(opened)


def window(opened):
    """What the window shows."""
    answer = opened.session.call("DevTools", cmd="Page.captureScreenshot", params={"format": "png"})
    return pixels_of_png(answer["data"])


def pick(opened, x, y):
    opened.mouse((x, y), (x, y))
    rest(opened)


def scroll_to(opened, heading):
    opened.run("""const all = [...document.querySelectorAll("#panel summary")];
        all.find(summary => summary.textContent === arguments[0]).scrollIntoView()""", heading)


def desktop(opened, mesh, image):
    """A mesh in light, an image in dark colours, with a point picked."""
    show(opened, mesh, DESKTOP, "light")
    shown = [window(opened)]
    show(opened, image, DESKTOP, "dark")
    pick(opened, *PICKED)
    return [*shown, window(opened)]


def phone(opened, image):
    """The picture with the first controls, and the transfer function in dark colours."""
    show(opened, image, PHONE, "light", touch=True)
    shown = [window(opened)]
    show(opened, image, PHONE, "dark", touch=True)
    scroll_to(opened, "Transfer function")
    return [*shown, window(opened)]


def save(pictures, path, width=None):
    """Side by side, from the top, on white."""
    gap = 12
    size = [sum(p.shape[1] for p in pictures) + gap * (len(pictures) - 1), max(p.shape[0] for p in pictures)]
    joined = Image.new("RGB", size, "white")
    left = 0
    for picture in pictures:
        joined.paste(Image.fromarray(picture), (left, 0))
        left += picture.shape[1] + gap
    if width:
        joined = joined.resize((width, round(size[1] * width / size[0])), Image.Resampling.LANCZOS)
    joined.quantize(COLORS, kmeans=4, dither=Image.Dither.NONE).save(path, optimize=True)


if __name__ == "__main__":
    if len(sys.argv) != 4:
        sys.exit(__doc__.splitlines()[0])
    *pages, folder = map(pathlib.Path, sys.argv[1:])
    with browser("chromium", "llvmpipe") as chromium:
        save(desktop(chromium, *pages), folder / "web_page.png", 1500)
        save(phone(chromium, pages[1]), folder / "web_phone.png")

# SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
# SPDX-License-Identifier: BSD-3-Clause
"""ParaView's window as its user has it: real events of mouse and keyboard by xdotool, pictures of the screen by xwd.

Where its widgets are it says itself, by the library of WidgetWatch.cxx.
"""
import json
import os
import pathlib
import struct
import subprocess
import time

import numpy as np

LONGEST = 120  # seconds to wait for anything
STEPS = 8  # of the mouse in a drag


def command(project, plugin, root, file):
    """The words by which `./tetmarch paraview FILE` starts ParaView; `root` is the folder in which it was unpacked."""
    name = ('BUILD=$1; source "$2/Tools/Script/paraview.sh"; name_paraview_command "$3" "$4"; '
            'printf "%s\\0" "${PARAVIEW_COMMAND[@]}"')
    text = subprocess.run(["bash", "-c", name, "-", str(pathlib.Path(root).parent), project, plugin, str(file)],
                          check=True, capture_output=True, text=True).stdout
    return text.split("\0")[:-1]


def xdotool(*words):
    subprocess.run(["xdotool", *(str(word) for word in words)], check=True)


def screen():
    """RGB of each pixel of the screen, from its top."""
    data = subprocess.run(["xwd", "-root", "-silent"], check=True, capture_output=True).stdout
    header = struct.unpack(">25I", data[:100])
    width, height, stride, pixel = header[4], header[5], header[12], header[11] // 8
    begin = header[0] + 12 * header[19]  # after the header and the colour map
    lines = np.frombuffer(data, np.uint8, height * stride, begin).reshape(height, stride)
    return lines[:, : width * pixel].reshape(height, width, pixel)[:, :, 2::-1]


def part(picture, place):
    x, y, width, height = place
    return picture[y : y + height, x : x + width]


class Window:
    """Started by these words; `folder` is for what it keeps: settings, the places of widgets, what it prints."""

    def __init__(self, words, watch, folder):
        self.places = os.path.join(folder, "widgets.json")
        self.output = os.path.join(folder, "output.txt")
        environment = {**os.environ, "HOME": folder, "LD_PRELOAD": watch, "TETMARCH_WIDGETS": self.places}
        with open(self.output, "w", encoding="utf-8") as output:
            self.process = subprocess.Popen([*words, "--dr"], env=environment, stdout=output, stderr=output)
        self.wait(lambda: os.path.exists(self.places), "a window")

    def close(self):
        self.process.terminate()
        try:
            self.process.wait(20)
        except subprocess.TimeoutExpired:
            self.process.kill()
            self.process.wait()

    def wait(self, what_is, what):
        """Until what_is() is true; hands that out."""
        end = time.monotonic() + LONGEST
        while time.monotonic() < end:
            found = what_is()
            if found:
                return found
            if self.process.poll() is not None:
                raise RuntimeError(f"ParaView ended with {self.process.returncode} instead of: {what}")
            time.sleep(0.1)
        raise TimeoutError(f"after {LONGEST} s not yet: {what}")

    def read(self):
        with open(self.places, encoding="utf-8") as file:
            return json.load(file)

    def settle(self):
        """What was sent has been dealt with: ParaView has looked at its widgets again, and the screen stays."""
        look = self.read()["look"]
        self.wait(lambda: self.read()["look"] >= look + 3, "an answer to events")
        before = [screen()]

        def stays():
            time.sleep(0.3)
            now, last = screen(), before[0]
            before[0] = now
            return np.array_equal(now, last)
        self.wait(stays, "a screen that stays")

    def seen(self, end, **others):
        """The widgets whose path ends so, and whose other entries are these."""
        found = self.read()["widgets"]
        return [widget for widget in found
                if widget["path"].endswith(end) and all(widget[key] == value for key, value in others.items())]

    def find(self, end, **others):
        """The one, which may have to come yet."""
        found = self.wait(lambda: self.seen(end, **others), f"a widget {end} {others}")
        if len(found) > 1:
            raise ValueError(f"{len(found)} widgets are {end} {others}")
        return found[0]

    def point(self, widget, at=(0.5, 0.5)):
        x, y, width, height = widget["place"]
        return round(x + at[0] * (width - 1)), round(y + at[1] * (height - 1))

    def click(self, widget, at=(0.5, 0.5), button=1):
        xdotool("mousemove", *self.point(widget, at))
        xdotool("click", button)
        self.settle()

    def drag(self, widget, start, end, button=1):
        """Places in the widget from 0 to 1, y downwards."""
        (x, y), (u, v) = self.point(widget, start), self.point(widget, end)
        xdotool("mousemove", x, y, "mousedown", button)
        for step in range(1, STEPS + 1):
            xdotool("mousemove", round(x + (u - x) * step / STEPS), round(y + (v - y) * step / STEPS))
            time.sleep(0.03)
        xdotool("mouseup", button)
        self.settle()

    def press(self, *keys):
        for key in keys:
            xdotool("key", key)
        self.settle()

    def write(self, text):
        xdotool("type", text)
        self.settle()

    def choose(self, end, text):
        """From a combo box, as its user does: open it, go by the arrow keys, take it."""
        box = self.wait(lambda: next((w for w in self.seen(end, enabled=True) if text in w["items"]), None),
                        f"{text} in {end}")
        self.click(box)
        steps = box["items"].index(text) - box["items"].index(box["text"])
        self.press(*["Down" if steps > 0 else "Up"] * abs(steps), "Return")
        self.find(end, text=text)

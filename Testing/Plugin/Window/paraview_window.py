# SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
# SPDX-License-Identifier: BSD-3-Clause
"""ParaView's window as its user has it: real events of mouse and keyboard by xdotool, pictures of the screen by xwd.

Where its widgets are it says itself, by the library of WidgetWatch.cxx.
"""
import json
import os
import pathlib
import subprocess
import sys
import time

sys.path.append(str(pathlib.Path(__file__).resolve().parent.parent))

from pictures import read_xwd  # noqa: E402
from programs import end, printed_by_script  # noqa: E402

SIZE = (1120, 800)  # of the window
# What the Light Inspector is told of a light, for a volume of 256 along each axis.
LIGHT = {"worldPositionX": 20, "worldPositionY": 270, "worldPositionZ": 230,
         "focalPointX": 128, "focalPointY": 128, "focalPointZ": 128}
LONGEST = 600  # seconds to wait for anything
STEPS = 8  # of the mouse in a drag
QUIET_LOOKS = 3  # looks of WidgetWatch.cxx at a window at rest


def command(project, plugin, root, file):
    """The words by which `./tetmarch paraview FILE` starts ParaView; `root` is the folder in which it was unpacked."""
    name = 'name_paraview_command "$3" "$4"; printf "%s\\0" "${PARAVIEW_COMMAND[@]}"'
    return printed_by_script(name, project, root, plugin, file).split("\0")[:-1]


def xdotool(*words):
    subprocess.run(["xdotool", *(str(word) for word in words)], check=True)


def screen():
    """RGB of each pixel of the screen, from its top."""
    return read_xwd(subprocess.run(["xwd", "-root", "-silent"], check=True, capture_output=True).stdout)


def part(picture, place):
    x, y, width, height = place
    return picture[y : y + height, x : x + width]


def preload(words, library):
    """The command with one more library before those of ParaView: an LD_PRELOAD of its own would hide ours."""
    return [f"{word}:{library}" if word.startswith("LD_PRELOAD=") else word for word in words]


class Window:
    """Started by these words; `folder` is for what it keeps: settings, the places of widgets, what it prints."""

    def __init__(self, words, watch, folder):
        self.places = os.path.join(folder, "widgets.json")
        self.output = os.path.join(folder, "output.txt")
        environment = {**os.environ, "HOME": folder, "TETMARCH_WIDGETS": self.places}
        with open(self.output, "w", encoding="utf-8") as output:
            self.process = subprocess.Popen([*preload(words, watch), "--dr"], env=environment, stdout=output,
                                            stderr=output)
        try:
            self.wait(lambda: os.path.exists(self.places), "a window")
        except (RuntimeError, TimeoutError):
            self.close()
            raise

    def resize(self, width, height):
        """Without a window manager nobody else would."""
        def main_windows():
            words = ["xdotool", "search", "--onlyvisible", "--name", "^ParaView 5"]
            return subprocess.run(words, check=False, capture_output=True, text=True).stdout.split()
        xdotool("windowsize", self.wait(main_windows, "a main window")[0], width, height)
        self.settle()

    def close(self):
        end(self.process)

    def wait(self, what_is, what):
        """Until what_is() is true; hands that out."""
        last = time.monotonic() + LONGEST
        while time.monotonic() < last:
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
        """Returns when events have been handled: ParaView has drawn nothing in the last looks, and puts nothing off."""
        before = self.read()["look"]

        def at_rest():
            seen = self.read()
            return min(seen["look"] - before, seen["quiet"]) >= QUIET_LOOKS
        self.wait(at_rest, "a window at rest")

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
        xdotool("type", "--", text)
        self.settle()

    def choose(self, end, text):
        """From a combo box, as its user does: open it, go by the arrow keys, take it."""
        box = self.wait(lambda: next((w for w in self.seen(end, enabled=True) if text in w["items"]), None),
                        f"{text} in {end}")
        self.click(box)
        steps = box["items"].index(text) - box["items"].index(box["text"])
        self.press(*["Down" if steps > 0 else "Up"] * abs(steps), "Return")
        self.find(end, text=text)

    def enter(self, end, text):
        """Into a field, instead of what it holds."""
        self.click(self.find(end))
        self.press("ctrl+a")
        self.write(text)
        self.press("Tab")

    def tick(self, name):
        """A check box of the panel, by the name of its property."""
        self.click(self.reveal(f"/{name}/CheckBox"), at=(0.02, 0.5))

    def show_as_volume(self, array):
        """What has just been opened, applied."""
        self.click(self.find("/propertiesPanel/Accept", enabled=True))
        self.choose("/representationToolbar/displayRepresentation/comboBox", "Tet Marching")
        self.choose("/variableToolbar/displayColor/Variables", array)

    def view(self):
        """The widget that shows the picture."""
        return self.find("/Viewport", **{"class": "pqQVTKWidget"})

    def add_light(self, coordinates):
        """By the Light Inspector, which stays open; {name of a field: number}"""
        self.menu("v/menu_View", "Light Inspector")
        self.click(self.find("/lightInspectorPanel/addLight"))
        for name, value in coordinates.items():
            self.enter("/InteractiveLight/" + name, str(value))

    def hide_light(self):
        """What shows it in the view; and closes the Light Inspector."""
        self.click(self.find("/InteractiveLight/show3DWidget"), at=(0.05, 0.5))
        self.click(self.find("/lightInspectorDock/qt_dockwidget_closebutton"))

    def drag_crop_face(self, share):
        """That of the greatest x, of a cube seen along z after a reset of the camera in a view that is wider than high.

        With its view angle of 30 degrees the handle is 0.278 heights of the view from its middle. `share` is the part
        of the way to the middle by which the face is moved.
        """
        view = self.view()
        handle = 0.278 * view["place"][3] / view["place"][2]
        self.drag(view, (0.5 + handle, 0.5), (0.5 + (1 - share) * handle, 0.5))

    def menu(self, name, entry):
        """`name` is that of the menu in ParaView, with the letter that opens it before it: "v/menu_View"."""
        letter, menu = name.split("/")
        self.press("alt+" + letter)
        self.click(self.find(f"/{menu}/{entry}"))

    def reveal(self, end):
        """Turns the wheel over the panel of properties until that is well inside it; hands it out."""
        panel = self.find("/propertiesPanel/scrollArea")
        x, y, _, height = panel["place"]
        for button in [4] * 20 + [5] * 60:
            found = self.seen(end)
            if found and found[0]["place"][1] > y + 10 and sum(found[0]["place"][1::2]) < y + height - 20:
                return found[0]
            xdotool("mousemove", x + 3, y + height // 2)
            xdotool("click", button)
            look = self.read()["look"]
            self.wait(lambda look=look: self.read()["look"] >= look + 2, "an answer to the wheel")
        raise ValueError(f"{end} isn't in the panel")

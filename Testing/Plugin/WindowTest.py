# SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
# SPDX-License-Identifier: BSD-3-Clause
"""The line that `./tetmarch paraview` prints starts ParaView's window with the plugin: WindowTest.py PROJECT PLUGIN ROOT

ROOT is the folder in which ParaView was unpacked. Wants a display.
"""
import json
import os
import pathlib
import shlex
import subprocess
import sys
import tempfile
import time
import unittest

import programs
from pictures import read_png

HERE = pathlib.Path(__file__).resolve().parent
PROJECT = PLUGIN = ROOT = None
LONGEST = 1000  # seconds


def printed_line():
    """The last line of what the script explains: the environment and the command."""
    return programs.printed_by_script('explain_plugin "$3"', PROJECT, ROOT, PLUGIN).strip().splitlines()[-1].strip()


class WindowTest(unittest.TestCase):
    def test_the_printed_line_loads_the_plugin(self):
        line = printed_line()
        self.assertIn("--plugin-search-paths=", line)
        with tempfile.TemporaryDirectory() as folder:
            result = os.path.join(folder, "found.json")
            command = f"{line} --dr --script={shlex.quote(str(HERE / 'gui_script.py'))}"
            window = subprocess.Popen(["bash", "-c", "exec env " + command], env={**os.environ, "TETMARCH_GUI_RESULT": result},
                                      stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
            try:
                end = time.monotonic() + LONGEST
                while not os.path.exists(result) and window.poll() is None and time.monotonic() < end:
                    time.sleep(0.5)
                self.assertTrue(os.path.exists(result), f"ParaView said nothing (exit status {window.poll()})")
                with open(result, encoding="utf-8") as file:
                    found = json.load(file)
                self.assertNotIn("error", found)
                for name in ("image", "mesh"):
                    with self.subTest(name):
                        self.assertIn("Tet Marching", found[name]["representations"])
                        self.assertGreater(found[name]["seconds"], 0)
                        surface, volume = (read_png(found[name][what]).reshape(-1, 3) for what in ("surface", "volume"))
                        self.assertGreater((abs(surface - volume).max(axis=1) > 20).mean(), 0.1)
                        self.assertGreater(len({tuple(pixel) for pixel in volume}), 1000)
            finally:
                programs.end(window)


if __name__ == "__main__":
    PROJECT, PLUGIN, ROOT = sys.argv[1:4]
    unittest.main(argv=sys.argv[:1])

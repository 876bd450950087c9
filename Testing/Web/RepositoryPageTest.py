# SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
# SPDX-License-Identifier: BSD-3-Clause
"""The page in Data is what its command writes now: RepositoryPageTest.py BUILD_FOLDER [--write]

The command is in Data/README.md. Two pages are compared in all but the compressed bytes, which may differ between
versions of zlib, and the version of TetMarch. Numbers may differ by a millionth, as the mathematical functions of two
processors do. With --write the new page replaces the one in Data.
"""
import base64
import json
import math
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
import unittest
import zlib

import numpy as np

PROJECT = pathlib.Path(__file__).resolve().parents[2]
KEPT = PROJECT / "Data" / "bonsai.html"
MOST_BYTES = 1_200_000
CLOSE = 1e-6
ELEMENT = r'<script type="application/(?:json|octet-stream)" id="(\w+)">(.*?)</script>\n'
BUILD = None


def write_page(folder):
    """Runs the command in a folder like the project's; returns the path of the page."""
    text = (PROJECT / "Data" / "README.md").read_text(encoding="utf-8").replace("\\\n", " ")
    (command,) = re.findall(rf"build/bin/tetmarch-render .*--html {KEPT.name}", text)
    for name, target in ("Data", PROJECT / "Data"), ("build", BUILD):
        (folder / name).symlink_to(target)
    environment = {**os.environ, "TETMARCH_GL": "egl", "DISPLAY": ""}
    subprocess.run(command.split(), cwd=folder, env=environment, check=True, timeout=1000)
    return folder / KEPT.name


def numbers_of(packed, row):
    """An array of the page: its bytes lie apart, first those of all texels that come first, then the second ones."""
    planes = np.frombuffer(zlib.decompress(packed), np.uint8)
    if row["filter"]:
        planes = np.ascontiguousarray(planes.reshape(row["filter"], -1).T)
    return planes.reshape(-1).view(row["type"])


def are_close(a, b):
    """Whether two values of JSON are equal but for the last digits of numbers."""
    if isinstance(a, dict) and isinstance(b, dict):
        return a.keys() == b.keys() and all(are_close(a[key], b[key]) for key in a)
    if isinstance(a, list) and isinstance(b, list):
        return len(a) == len(b) and all(map(are_close, a, b))
    if isinstance(a, float) or isinstance(b, float):
        return math.isclose(a, b, rel_tol=CLOSE, abs_tol=CLOSE)
    return a == b


class Page:
    """A page taken apart: the program, which is its text without data; the scene; the bytes of its arrays."""

    def __init__(self, path):
        text = path.read_text(encoding="utf-8")
        elements = dict(re.findall(ELEMENT, text, re.DOTALL))
        self.program = re.sub(ELEMENT, "", text, flags=re.DOTALL).splitlines()
        self.scene = json.loads(elements["scene"])
        del self.scene["generator"]
        # How many elements an array takes depends on its compressed size.
        parts = [row.pop("parts") for row in self.scene["arrays"]]
        packed = [b"".join(base64.b64decode(elements[i]) for i in ids) for ids in parts]
        self.arrays = [numbers_of(*each) for each in zip(packed, self.scene["arrays"])]


class RepositoryPageTest(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        folder = pathlib.Path(cls.enterClassContext(tempfile.TemporaryDirectory()))
        cls.kept, cls.made = Page(KEPT), Page(write_page(folder))

    def assert_same(self, same, what):
        if not same:
            self.fail(f"{what} of {KEPT.name} is not what the exporter writes now. If the change is intended: "
                      f"{pathlib.Path(__file__).name} BUILD_FOLDER --write")

    def test_program(self):
        for number, (kept, made) in enumerate(zip(self.kept.program, self.made.program, strict=True), 1):
            self.assert_same(kept == made, f"Line {number} without data, {made[:80]!r},")

    def test_scene(self):
        self.assertEqual(self.kept.scene.keys(), self.made.scene.keys())
        for key, made in self.made.scene.items():
            with self.subTest(key=key):
                self.assert_same(are_close(self.kept.scene[key], made), f"The scene's {key}")

    def test_arrays(self):
        self.assertEqual(len(self.kept.arrays), len(self.made.arrays))
        for i, (kept, made) in enumerate(zip(self.kept.arrays, self.made.arrays)):
            with self.subTest(array=i):
                self.assert_same(kept.shape == made.shape and np.allclose(kept, made, CLOSE, CLOSE), f"Array {i}")

    def test_size(self):
        self.assertLess(KEPT.stat().st_size, MOST_BYTES)


if __name__ == "__main__":
    BUILD = pathlib.Path(sys.argv.pop(1)).resolve()
    if "--write" in sys.argv:
        with tempfile.TemporaryDirectory() as folder:
            shutil.copyfile(write_page(pathlib.Path(folder)), KEPT)
    else:
        unittest.main()

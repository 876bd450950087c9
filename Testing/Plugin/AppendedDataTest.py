# SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
# SPDX-License-Identifier: BSD-3-Clause
"""The plugin says if ParaView loses appended data, and its remedy is one.

AppendedDataTest.py PVPYTHON PLUGIN PUTTING_OFF DATA: the third is the library of putting_off.cxx, which makes any
libexpat one with which data is lost.
"""
import os
import pathlib
import re
import subprocess
import sys
import unittest

HERE = pathlib.Path(__file__).resolve().parent
PVPYTHON = PLUGIN = PUTTING_OFF = DATA = None
CELLS = 271607
WARNING = "This ParaView loses data"


def read(*before):
    """Cells that ParaView reads with these libraries loaded before its own, and what it says."""
    done = subprocess.run([PVPYTHON, str(HERE / "read_appended.py"), "--plugin", PLUGIN, "--data", DATA],
                          env={**os.environ, "LD_PRELOAD": ":".join(before)}, timeout=1000,
                          stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
    cells = re.search(r"^(\d+) cells$", done.stdout, re.M)
    assert done.returncode == 0 and cells, done.stdout
    return int(cells[1]), done.stdout


class AppendedDataTest(unittest.TestCase):
    def setUp(self):
        self.remedy = str(pathlib.Path(PLUGIN).parent / "libTetMarchExpat.so")

    def test_what_the_plugin_says_is_true(self):
        cells, said = read()
        self.assertIn(cells, (0, CELLS))
        self.assertEqual(said.count(WARNING), 1 if cells == 0 else 0, said)

    def test_a_parser_that_puts_off_is_said_once(self):
        cells, said = read(PUTTING_OFF)
        if "ParaView 5\n" not in said:  # a later one tells the parser not to
            self.assertEqual(cells, CELLS)
            self.assertNotIn(WARNING, said)
            return
        self.assertEqual(cells, 0)
        self.assertEqual(said.count(WARNING), 1, said)
        self.assertIn("LD_PRELOAD=" + self.remedy + " ", said)

    def test_the_remedy_mends_it(self):
        for libraries in ((self.remedy,), (self.remedy, PUTTING_OFF)):
            with self.subTest(libraries):
                cells, said = read(*libraries)
                self.assertEqual(cells, CELLS)
                self.assertNotIn(WARNING, said)
                self.assertNotIn("ERR|", said)


if __name__ == "__main__":
    PVPYTHON, PLUGIN, PUTTING_OFF, DATA = sys.argv[1:5]
    unittest.main(argv=sys.argv[:1])

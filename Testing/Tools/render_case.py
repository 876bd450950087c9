# SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
# SPDX-License-Identifier: BSD-3-Clause
"""Tests that run tetmarch-render as a user would: ...Test.py EXECUTABLE PROJECT_FOLDER."""
import json
import os
import pathlib
import pty
import subprocess
import sys
import tempfile
import unittest

import make_inputs
from read_png import read_png


class RenderCase(unittest.TestCase):
    maxDiff = None
    executable = project = None

    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)
        make_inputs.write_all(self.folder)

    def run_tool(self, *arguments, **environment):
        return subprocess.run([self.executable, *map(str, arguments)], cwd=self.folder, text=True, timeout=1000,
                              capture_output=True, env={**os.environ, **environment})

    def run_on_terminal(self, *arguments):
        """What the terminal got on standard error, as bytes."""
        terminal, other_end = pty.openpty()
        with subprocess.Popen([self.executable, *map(str, arguments)], cwd=self.folder, stderr=other_end) as process:
            os.close(other_end)
            text = b""
            try:
                while chunk := os.read(terminal, 4096):
                    text += chunk
            except OSError:  # how Linux says that the other end was closed
                pass
        os.close(terminal)
        self.assertEqual(process.returncode, 0)
        return text

    def expect_failure(self, status, message, *arguments, **environment):
        with self.subTest(arguments=arguments):
            result = self.run_tool(*arguments, **environment)
            self.assertEqual(result.returncode, status, result.stderr)
            self.assertEqual(result.stdout, "")
            self.assertTrue(result.stderr.startswith("tetmarch-render: "), result.stderr)
            self.assertIn(message, result.stderr)
            self.assertNotIn("terminate called", result.stderr)

    def render(self, *arguments):
        """The pixels of out.png and the statistics."""
        result = self.run_tool(*arguments, "--quiet", "--output", "out.png", "--stats", "out.json", "--frames", 3)
        self.assertEqual((result.returncode, result.stdout, result.stderr), (0, "", ""))
        return read_png(self.folder / "out.png"), json.loads((self.folder / "out.json").read_text())

    def draw(self, *arguments):
        """The pixels of out.png, which may be drawn in tiles."""
        result = self.run_tool(*arguments, "--quiet", "--output", "out.png")
        self.assertEqual((result.returncode, result.stdout, result.stderr), (0, "", ""))
        return read_png(self.folder / "out.png")

    def check_warning(self, result, words):
        self.assertEqual(result.returncode, 0, result.stderr)
        self.assertRegex(result.stderr, rf"^tetmarch-render: warning: .*{words}.*\n$")

    def draw_with_warning(self, words, *arguments):
        """The same where the tool has one warning, which says these words."""
        result = self.run_tool(*arguments, "--quiet", "--output", "out.png")
        self.assertEqual(result.stdout, "")
        self.check_warning(result, words)
        return read_png(self.folder / "out.png")


def main():
    RenderCase.executable = sys.argv.pop(1)
    RenderCase.project = pathlib.Path(sys.argv.pop(1)).resolve()
    unittest.main(verbosity=2)

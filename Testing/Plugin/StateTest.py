# SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
# SPDX-License-Identifier: BSD-3-Clause
"""A saved state, loaded in another process, has every property and draws the same picture: StateTest.py PVPYTHON PLUGIN

A trace, run in another process, draws the picture of what was traced. Wants a display.
"""
import pathlib
import subprocess
import sys
import tempfile
import unittest

HERE = pathlib.Path(__file__).resolve().parent
PVPYTHON = PLUGIN = None


def run(script, *arguments):
    done = subprocess.run([PVPYTHON, str(HERE / script), "--plugin", PLUGIN, *arguments], timeout=1000,
                          stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
    print(done.stdout, end="")
    assert done.returncode == 0, f"{script} {arguments} failed"
    assert "ERR|" not in done.stdout and "WARN|" not in done.stdout, f"{script} {arguments}: a message"


class StateTest(unittest.TestCase):
    def test_states_restore_properties_and_pictures(self):
        with tempfile.TemporaryDirectory() as folder:
            run("states.py", "--path", folder)
            for name in ("state.pvsm", "state.py"):
                with self.subTest(name):
                    run("states.py", "--path", str(pathlib.Path(folder) / name))

    def test_traces_run(self):
        with tempfile.TemporaryDirectory() as folder:
            run("traces.py", "--path", folder)
            run("traces.py", "--path", str(pathlib.Path(folder) / "trace.py"))


if __name__ == "__main__":
    PVPYTHON, PLUGIN = sys.argv[1:3]
    unittest.main(argv=sys.argv[:1])

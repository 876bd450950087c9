# SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
# SPDX-License-Identifier: BSD-3-Clause
"""An X server that resets itself once its last client has gone, as that of xvfb-run, serves figure after figure."""
import os
import subprocess
import sys
import unittest

SCRIPT = """
import first_data, vtktetmarch
for _ in range(3):
    vtktetmarch.figure(first_data.one_tetrahedron(), size=(16, 12)).screenshot()
"""


class DisplayTest(unittest.TestCase):
    def test_the_server_keeps_a_client_between_figures(self):
        """This one ends where that one resets itself, so that it shows."""
        reader, writer = os.pipe()
        server = subprocess.Popen(["Xvfb", "-displayfd", str(writer), "-terminate", "-screen", "0", "640x480x24",
                                   "-nolisten", "tcp"], pass_fds=[writer], stderr=subprocess.DEVNULL)
        self.addCleanup(server.wait)
        self.addCleanup(server.terminate)
        os.close(writer)
        with os.fdopen(reader) as answer:
            number = answer.readline().strip()
        run = subprocess.run([sys.executable, "-c", SCRIPT], env={**os.environ, "DISPLAY": ":" + number},
                             cwd=os.path.dirname(os.path.abspath(__file__)), capture_output=True, text=True,
                             timeout=600, check=False)
        self.assertEqual((run.returncode, run.stderr), (0, ""))


if __name__ == "__main__":
    unittest.main(verbosity=2)

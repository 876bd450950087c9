# SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
# SPDX-License-Identifier: BSD-3-Clause
"""An X server that resets itself once its last client has gone, as that of xvfb-run, serves figure after figure."""
import os
import subprocess
import sys
import unittest

from with_display import own_server

SCRIPT = """
import first_data, vtktetmarch
for _ in range(3):
    vtktetmarch.figure(first_data.one_tetrahedron(), size=(16, 12)).screenshot()
"""


class DisplayTest(unittest.TestCase):
    def test_the_server_keeps_a_client_between_figures(self):
        """This one ends where that one resets itself, so that it shows."""
        with own_server("-terminate") as environment:
            run = subprocess.run([sys.executable, "-c", SCRIPT], env=environment, capture_output=True, text=True,
                                 cwd=os.path.dirname(os.path.abspath(__file__)), timeout=600, check=False)
        self.assertEqual((run.returncode, run.stderr), (0, ""))


if __name__ == "__main__":
    unittest.main(verbosity=2)

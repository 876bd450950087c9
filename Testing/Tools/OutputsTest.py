# SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
# SPDX-License-Identifier: BSD-3-Clause
"""What tetmarch-render writes, and never overwrites: OutputsTest.py EXECUTABLE PROJECT_FOLDER."""
import json
import os
import resource
import signal
import subprocess
import time

from read_png import read_png
from render_case import RenderCase, main

SMALL = ("--size", "64x48", "--quiet")


class OutputsTest(RenderCase):
    def setUp(self):
        super().setUp()
        self.inputs = self.contents()

    def contents(self):
        """The bytes of each file of the folder, hidden ones included."""
        return {path.name: path.read_bytes() for path in self.folder.iterdir() if path.is_file()}

    def run_bytes(self, *arguments, **options):
        return subprocess.run([self.executable, *map(str, arguments)], cwd=self.folder, timeout=300,
                              stderr=subprocess.PIPE, **{"stdout": subprocess.PIPE, **options})

    def test_an_output_is_no_input_and_no_other_output(self):
        (self.folder / "sub").mkdir()
        for name in ("symbolic.png", "symbolic.html"):
            (self.folder / name).symlink_to("cube.vtu")
        os.link(self.folder / "cube.vtu", self.folder / "hard.png")
        (self.folder / "list.pvd").write_text('<VTKFile type="Collection"><Collection><DataSet timestep="0" '
                                              'file="cube.vtu"/></Collection></VTKFile>')
        before = self.contents()
        same = ", which is the same file"
        for arguments, what in (
                (("--output", "symbolic.png"), "--output 'symbolic.png' would overwrite the input"),
                (("--output", "hard.png"), "--output 'hard.png' would overwrite the input"),
                (("--html", "symbolic.html"), "--html 'symbolic.html' would overwrite the input"),
                (("--stats", "cube.vtu"), "--stats 'cube.vtu' would overwrite the input"),
                (("--stats", "sub/../cube.vtu"), "--stats 'sub/../cube.vtu' would overwrite the input"),
                (("--stats", self.folder / "cube.vtu"), "would overwrite the input"),
                (("--stats", "ramp.json", "--preset", "./ramp.json"), "would overwrite the file of --preset"),
                (("--stats", "plate.vtk", "--surface", "plate.vtk"), "would overwrite the file of --surface"),
                (("--pixel", "1,1", "--pixel-json", "cube.vtu"), "--pixel-json 'cube.vtu' would overwrite the input"),
                (("--output", "new.png", "--stats", "sub/../new.png"), "would overwrite what --output writes"),
                (("--pixel", "1,1", "--stats", "new", "--pixel-json", "./new"), "would overwrite what --stats writes")):
            self.expect_failure(2, what + same, "cube.vtu", *SMALL, *arguments)
        self.expect_failure(2, "would overwrite a file of the input" + same, "list.pvd", *SMALL, "--stats", "cube.vtu")
        # Before the input is read: it isn't there.
        self.expect_failure(2, "would overwrite the input" + same, "none.vtu", *SMALL, "--stats", "./none.vtu")
        self.assertEqual(self.contents(), before)

    def test_what_is_no_file_is_refused_before_anything_is_read(self):
        os.mkfifo(self.folder / "pipe")
        (self.folder / "folder.png").mkdir()
        for name, reason in (("/dev/null", "it is a device, a pipe or a socket, not a file"),
                             ("pipe", "it is a device, a pipe or a socket, not a file"),
                             ("folder.png", "it is a folder"), ("no/such.png", "there is no folder 'no'")):
            for option in ("--output", "--stats"):
                self.expect_failure(1, f"cannot write '{name}': {reason}", "none.vtu", *SMALL, option, name)
        self.expect_failure(1, "cannot write 'no/such_0000.png': there is no folder 'no'", "none.vtu", "--turntable", 3,
                            "--output", "no/such.png")
        self.expect_failure(1, "cannot write 'no/such.html': there is no folder 'no'", "none.vtu", "--time", "all",
                            "--html", "no/such.html")
        self.assertTrue(os.path.exists("/dev/null"))
        self.assertTrue((self.folder / "pipe").is_fifo())
        self.assertEqual(self.contents(), self.inputs)

    def test_a_full_disk_leaves_the_old_file(self):
        """A limit of the size of files fails a write as a full disk does, for root as well."""
        for options, limit in (((), 500), (("--stats", "out.json"), 600), (("--html", "out.html"), 600),
                               (("--turntable", 2), 500)):
            with self.subTest(options=options):
                for name in ("out.png", "out.json", "out.html", "out_0000.png"):
                    (self.folder / name).write_text("good")
                before = self.contents()
                result = self.run_bytes(
                    "cube.vtu", "--array", "half", *SMALL, "--output", "out.png", *options, restore_signals=False,
                    preexec_fn=lambda: resource.setrlimit(resource.RLIMIT_FSIZE, (limit, limit)),
                    env={**os.environ, "MESA_SHADER_CACHE_DISABLE": "true"})
                self.assertEqual(result.returncode, 1, result.stderr)
                self.assertRegex(result.stderr.decode(), r"^tetmarch-render: error: cannot write 'out[_.a-z0-9]*': "
                                                         r"File too large\n$")
                after = self.contents()
                self.assertEqual(after.keys(), before.keys())
                failed = result.stderr.decode().split("'")[1]
                self.assertEqual(after[failed], b"good")

    def test_a_signal_leaves_whole_pictures(self):
        """Sent when the first of many is there."""
        for number in (signal.SIGINT, signal.SIGTERM):
            with self.subTest(number=number):
                with subprocess.Popen([self.executable, "cube.vtu", "--array", "ramp", *SMALL, "--turntable", "100000",
                                       "--output", f"{number}.png"], cwd=self.folder,
                                      preexec_fn=lambda: signal.signal(number, signal.SIG_DFL)) as process:
                    while not list(self.folder.glob(f"{number}_*.png")) and process.poll() is None:
                        time.sleep(0.01)
                    process.send_signal(number)
                self.assertEqual(process.returncode, -number)
                new = self.contents().keys() - self.inputs.keys()
                self.assertGreater(len(new), 0)
                for name in new:
                    self.assertRegex(name, r"^\d+_\d+\.png$")
                    self.assertEqual(len(read_png(self.folder / name)), 48)

    def test_standard_output(self):
        scene = ("cube.vtu", "--array", "ramp", *SMALL)
        picture = self.draw(*scene)
        for name in ("-", "/dev/stdout"):
            result = self.run_bytes(*scene, "--output", name)
            self.assertEqual((result.returncode, result.stderr), (0, b""))
            (self.folder / "printed.png").write_bytes(result.stdout)
            self.assertEqual(read_png(self.folder / "printed.png"), picture)
        result = self.run_tool(*scene, "--stats", "-", "--frames", 0)
        self.assertEqual(json.loads(result.stdout)["input"], "cube.vtu")
        result = self.run_tool(*scene, "--pixel", "5,5", "--pixel-json", "-")
        self.assertEqual(json.loads(result.stdout)["pixel"], [5, 5])
        self.assertFalse((self.folder / "-").exists())
        for arguments, message in (
                (("--output", "-", "--stats", "-"), "--output - and --stats - both go to standard output"),
                (("--output", "-", "--pixel", "1,1"), "--output - and the text of --pixel both go to"),
                (("--output", "-", "--frames", 1), "--output - and the time of --frames both go to"),
                (("--html", "-", "--stats", "-"), "--html - and --stats - both go to standard output"),
                (("--output", "-", "--turntable", 2), "--output - is for one picture")):
            self.expect_failure(2, message, *scene, *arguments)

    def test_no_picture_goes_to_a_terminal(self):
        terminal, other_end = os.openpty()
        result = self.run_bytes("cube.vtu", *SMALL, "--output", "-", stdout=other_end)
        os.close(other_end)
        os.close(terminal)
        self.assertEqual(result.returncode, 2)
        self.assertIn(b"which is a terminal here; redirect it or name a file", result.stderr)

    def test_a_full_standard_output_is_an_error(self):
        scene = ("cube.vtu", "--array", "ramp", *SMALL)
        for arguments in (("--help",), ("--version",), ("--colors", "list"), ("cube.vtu", "--list"),
                          (*scene, "--output", "-"), (*scene, "--stats", "-"), (*scene, "--frames", 1),
                          (*scene, "--pixel", "1,1")):
            with self.subTest(arguments=arguments), open("/dev/full", "wb") as full:
                result = self.run_bytes(*arguments, stdout=full)
                self.assertEqual(result.returncode, 1)
                self.assertEqual(result.stderr, b"tetmarch-render: error: cannot write to standard output: No space left "
                                                b"on device\n")


if __name__ == "__main__":
    main()

# SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
# SPDX-License-Identifier: BSD-3-Clause
"""A source distribution, the wheel that pip builds of it, and what a user does with that: WheelTest.py [DEFINE...]

pip may ask no registry. DEFINE: settings of CMake, NAME=VALUE, with which the objects of the tests' own build are in the
compiler's cache. Without a cache all would be compiled again, so the test is skipped.
"""
import contextlib
import importlib.util
import io
import os
import pathlib
import shutil
import subprocess
import sys
import tarfile
import tempfile
import unittest
import venv
import zipfile

PROJECT = pathlib.Path(__file__).resolve().parents[2]
DEFINES = []
sys.path[:0] = [str(PROJECT / "Tools" / "Wheel"), str(PROJECT / "Testing" / "Pages")]
import backend  # noqa: E402
from pages import fenced_blocks, text_of  # noqa: E402
from vtk_of_python import VtkOfPython, vtk_of_python  # noqa: E402

# Of each kind: what pip installs for the build, and the pin in the metadata.
KINDS = {
    "Debian 12": (VtkOfPython("9.1.0", None, False), [], "Requires-External: vtk (==9.1.0)"),
    "forky, conda-forge": (VtkOfPython("9.6.2", "9.6.2", False), [], "Requires-Dist: vtk==9.6.2"),
    "pip": (VtkOfPython("9.6.1", "9.6.1", True), ["vtk-sdk==9.6.1"], "Requires-Dist: vtk==9.6.1"),
}


class VtkOfPythonTest(unittest.TestCase):
    def test_each_kind(self):
        for name, (vtk, requirements, pin) in KINDS.items():
            with self.subTest(name):
                self.assertEqual((vtk.build_requirements(), vtk.dependency()), (requirements, pin))

    def test_wheels_without_headers_are_refused(self):
        with self.assertRaisesRegex(SystemExit, "VTK 9.5.2 .* no headers before VTK 9.6"):
            VtkOfPython("9.5.2", "9.5.2", True).build_requirements()


class WheelTest(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        if not importlib.util.find_spec("ensurepip"):
            raise unittest.SkipTest("Python's venv isn't installed")
        if "ccache" not in os.environ.get("CMAKE_CXX_COMPILER_LAUNCHER", ""):
            raise unittest.SkipTest("without a compiler cache, all of the project would be compiled again")
        if not shutil.which("git") or not (PROJECT / ".git").exists():
            raise unittest.SkipTest("a source distribution has the files that git knows")
        folder = pathlib.Path(cls.enterClassContext(tempfile.TemporaryDirectory()))
        with contextlib.redirect_stdout(io.StringIO()):
            archive = folder / backend.build_sdist(folder)
        with tarfile.open(archive) as sdist:
            sdist.extractall(folder)
        # The name of the folder is in the names of the objects.
        cls.sources = (folder / archive.name[:-len(".tar.gz")]).rename(folder / PROJECT.name)
        venv.create(folder / "env", system_site_packages=True, with_pip=True)
        cls.bin, cls.away = folder / "env" / "bin", folder / "away"
        cls.away.mkdir()
        (cls.away / "Data").symlink_to(PROJECT / "Data")
        cls.environment = {**os.environ, "CCACHE_BASEDIR": str(cls.sources), "PIP_NO_INDEX": "1"}
        cls.environment.pop("PYTHONPATH", None)
        settings = {"build-dir": "build", **{f"cmake.define.{define.split('=')[0]}": define.split("=", 1)[1]
                                             for define in DEFINES}}
        cls.run_pip("wheel", "--no-deps", "--wheel-dir", str(folder), str(cls.sources),
                    *(f"--config-settings={key}={value}" for key, value in settings.items()), cwd=cls.sources)
        cls.wheel = next(folder.glob("*.whl"))

    @classmethod
    def run_pip(cls, *arguments, cwd=None):
        run = subprocess.run([cls.bin / "pip", *arguments], cwd=cwd, env=cls.environment, text=True,
                             stdout=subprocess.PIPE, stderr=subprocess.STDOUT, check=False)
        if run.returncode != 0:
            raise AssertionError(run.stdout)

    def run_here(self, *command):
        """What a command prints, in a folder outside of the sources."""
        run = subprocess.run(command, cwd=self.away, env=self.environment, capture_output=True, text=True, check=False)
        self.assertEqual((run.returncode, run.stderr), (0, ""), command)
        return run.stdout

    def test_the_archive_says_what_it_is(self):
        with zipfile.ZipFile(self.wheel) as wheel:
            names = wheel.namelist()
            metadata = wheel.read(f"{backend.name()}.dist-info/METADATA").decode()
            stubs = wheel.read("vtktetmarch/vtkRenderingTetMarch.pyi").decode()
        from vtkmodules.vtkCommonCore import vtkVersion
        self.assertIn(f"=={vtkVersion.GetVTKVersion()}", vtk_of_python().dependency())
        self.assertIn(vtk_of_python().dependency(), metadata.splitlines())
        info = f"{backend.name()}.dist-info/"
        for name in ("vtktetmarch/vtkRenderingTetMarch.so", "vtktetmarch/color_maps.json", "vtktetmarch/built_for.py",
                     "vtktetmarch/bin/tetmarch-render", info + "licenses/LICENSE", info + "entry_points.txt"):
            with self.subTest(name=name):
                self.assertIn(name, names)
        self.assertIn("from vtkmodules", stubs)  # made by importing the module, where pip hides VTK from its build

    def test_installed_it_draws_from_anywhere_and_uninstalled_it_leaves_nothing(self):
        self.run_pip("install", str(self.wheel))
        (example,) = fenced_blocks(text_of("README.md"), "python")
        (self.away / "example.py").write_text(example, encoding="utf-8")
        self.run_here(self.bin / "python", "example.py")
        self.run_here(self.bin / "tetmarch-render", "Data/golfball_small.vtu", "--array", "speed", "--size", "64x48",
                      "--output", "tool.png")
        for picture in ("golfball.png", "tool.png"):
            self.assertEqual((self.away / picture).read_bytes()[1:4], b"PNG")
        printed = self.run_here(self.bin / "python", "-c", "import vtktetmarch; print(vtktetmarch.__file__)")
        self.assertTrue(printed.startswith(str(self.bin.parent)))
        self.run_pip("uninstall", "--yes", "vtktetmarch")
        self.assertEqual(list(self.bin.parent.rglob("*tetmarch*")), [])


if __name__ == "__main__":
    DEFINES = sys.argv[1:]
    del sys.argv[1:]
    unittest.main()

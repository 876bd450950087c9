# SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
# SPDX-License-Identifier: BSD-3-Clause
"""What pip calls to build a wheel (PEP 517): CMake builds the package, and its files go into an archive.

It needs no other package, so that `pip install .` works without a registry, too; and it builds for the VTK that the
running Python has, which general backends don't know. Settings are named as in scikit-build-core:
`--config-settings=build-dir=FOLDER` (build/wheel) and `--config-settings=cmake.define.NAME=VALUE`; the environment
variable CMAKE_ARGS has further options of CMake.
"""
import os
import pathlib
import re
import shlex
import shutil
import subprocess
import sys
import tarfile
import tomllib

from vtk_of_python import clean_environment, vtk_of_python
from wheel_file import info_files, tag, write_wheel

ROOT = pathlib.Path(__file__).resolve().parents[2]
TARGETS = ("vtkRenderingTetMarchPython", "tetmarch-render")
PACKAGED = re.compile(r".*\.(py|pyi|json|so)|py\.typed")
DEFINE = "cmake.define."


def project():
    return tomllib.loads((ROOT / "pyproject.toml").read_text(encoding="utf-8"))["project"]


def version():
    text = (ROOT / "CMakeLists.txt").read_text(encoding="utf-8")
    return re.search(r"project\(TetMarch VERSION (\S+)", text)[1]


def name():
    return f"{project()['name']}-{version()}"


def run(command):
    """Runs a program. Raises SystemExit if it isn't there or fails; its messages have said why."""
    if shutil.which(command[0]) is None:
        raise SystemExit(f"{command[0]} is missing. On Debian: apt-get install cmake ninja-build g++ libvtk9-dev "
                         "nlohmann-json3-dev libegl-dev")
    print(shlex.join(command), flush=True)
    if subprocess.run(command, env=clean_environment(), check=False).returncode != 0:
        raise SystemExit(f"{command[0]} failed; see its messages above")


def build(vtk, settings):
    """Builds the package. Returns its folder."""
    folder = pathlib.Path(settings.get("build-dir", ROOT / "build" / "wheel"))
    defines = {key[len(DEFINE):]: value for key, value in settings.items() if key.startswith(DEFINE)}
    options = {"CMAKE_BUILD_TYPE": "Release", "TETMARCH_WHEEL": "ON", "Python3_EXECUTABLE": sys.executable,
               "CMAKE_PREFIX_PATH": ";".join(vtk.cmake_prefixes()), **defines}
    run(["cmake", "-S", str(ROOT), "-B", str(folder), "-G", "Ninja",
         *(f"-D{key}={value}" for key, value in options.items() if value),
         *shlex.split(os.environ.get("CMAKE_ARGS", ""))])
    run(["cmake", "--build", str(folder), "--target", *TARGETS])
    return folder / "vtktetmarch"


def information(vtk):
    """The files of the folder .dist-info: {name: text}."""
    return info_files(project(), version(), ["Requires-Dist: numpy", vtk.dependency()],
                      (ROOT / "README.md").read_text(encoding="utf-8"),
                      (ROOT / "LICENSE").read_text(encoding="utf-8"))


def get_requires_for_build_wheel(config_settings=None):
    return vtk_of_python().build_requirements()


def prepare_metadata_for_build_wheel(metadata_directory, config_settings=None):
    folder = f"{name()}.dist-info"
    for file, text in information(vtk_of_python()).items():
        path = pathlib.Path(metadata_directory, folder, file)
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text, encoding="utf-8")
    return folder


def build_wheel(wheel_directory, config_settings=None, metadata_directory=None):
    vtk = vtk_of_python()
    package = build(vtk, config_settings or {})
    program = package / "bin" / "tetmarch-render"
    files = {f"vtktetmarch/{file.name}": (file.read_bytes(), False)
             for file in sorted(package.iterdir()) if PACKAGED.fullmatch(file.name)}
    files["vtktetmarch/bin/tetmarch-render"] = (program.read_bytes(), True)
    files |= {f"{name()}.dist-info/{file}": (text.encode(), False) for file, text in information(vtk).items()}
    wheel = f"{name()}-{tag()}.whl"
    write_wheel(pathlib.Path(wheel_directory, wheel), files)
    return wheel


def build_sdist(sdist_directory, config_settings=None):
    """The files that git knows, below one folder, with PKG-INFO."""
    listed = subprocess.run(["git", "-C", str(ROOT), "ls-files", "-z"], capture_output=True, text=True, check=True)
    archive = f"{name()}.tar.gz"
    with tarfile.open(pathlib.Path(sdist_directory, archive), "w:gz", format=tarfile.PAX_FORMAT) as sdist:
        for file in filter(None, listed.stdout.split("\0")):
            sdist.add(ROOT / file, f"{name()}/{file}", recursive=False)
        info = pathlib.Path(sdist_directory, "PKG-INFO")
        info.write_text(information(vtk_of_python())["METADATA"], encoding="utf-8")
        sdist.add(info, f"{name()}/PKG-INFO")
        info.unlink()
    return archive

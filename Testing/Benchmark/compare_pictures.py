# SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
# SPDX-License-Identifier: BSD-3-Clause
"""Whether two builds, or the two shader stages of one, draw the same pictures, to the last bit.

    compare_pictures.py draw BUILD OUT.npz [--variants PROGRAM] [--check] [--every N] [--only WORDS] [--stage STAGE]
    compare_pictures.py compare A.npz B.npz

`draw` has the Python package of a build folder draw a scene for each variant of the shader, picks, and scenes of other
options. Which variants there are is told by tetmarch-variants: that of BUILD, or of another build with --variants.
--check makes sure, by the shaders that Mesa compiles, that these variants are drawn. --only WORDS draws the scenes with
these words in their names, --every N one of N. --stage Compute has rays marched by compute shaders.

`compare` tells which pictures differ and by how much; the exit status is 1 if any does.
"""
import argparse
import pathlib
import subprocess
import sys
import tempfile

import numpy as np
from build_folders import HERE, environment_of, run_again_with_display
from drawn_variants import missing_variants

ABOUT = ("driver", "build")  # what isn't a picture


def draw(build, program, arguments):
    """Returns the exit status."""
    with tempfile.TemporaryDirectory() as folder:
        folder = pathlib.Path(folder)
        texts, captures = folder / "texts", folder / "captures"
        texts.mkdir()
        captures.mkdir()
        variants = subprocess.run([program, texts], check=True, stdout=subprocess.PIPE, text=True).stdout
        (folder / "variants.txt").write_text(variants)
        environment = environment_of(build)
        if arguments.check:
            environment["MESA_SHADER_CAPTURE_PATH"] = str(captures)
        command = [sys.executable, HERE / "draw_pictures.py", folder / "variants.txt", arguments.output.resolve(),
                   str(arguments.every), arguments.only, arguments.stage]
        drawing = subprocess.run(command, env=environment, stdout=subprocess.PIPE, text=True)
        names = drawing.stdout.splitlines()
        if drawing.returncode != 0:
            sys.exit(f"{build} couldn't draw {names[-1] if names else 'in a window'}")
        return report_missing(names, texts, captures) if arguments.check else 0


def report_missing(names, texts, captures):
    """Names of variants begin with their numbers. Returns the exit status."""
    if not any(captures.iterdir()):
        print("The GL isn't Mesa's, so which variants were drawn isn't known")
        return 0
    numbered = {int(name.split()[0]): name for name in names if name[0].isdigit()}
    missing = missing_variants(texts, captures, numbered)
    for number in missing:
        print(f"No scene drew variant {numbered[number]}")
    if not missing:
        print(f"All {len(numbered)} variants were drawn")
    return 1 if missing else 0


def difference(first, second):
    """In words; empty if the arrays are equal to the last bit."""
    if first.shape != second.shape or first.dtype != second.dtype:
        return f"{first.dtype}{list(first.shape)} became {second.dtype}{list(second.shape)}"
    if first.tobytes() == second.tobytes():
        return ""
    if first.dtype.kind == "U":
        return f"'{first}' became '{second}'"
    apart = np.abs(first.astype(np.float64) - second.astype(np.float64))
    return f"{np.count_nonzero(apart != 0)} of {apart.size} values differ, by up to {np.nanmax(apart):.3g}"


def compare(first, second):
    """Returns the exit status."""
    names = [name for name in first if name not in ABOUT]
    for file in (first, second):
        print(f"{file['build']}: {file['driver']}")
    lines = [f"{name}: only in the first" for name in names if name not in second]
    lines += [f"{name}: only in the second" for name in second if name not in first]
    for name in names:
        words = difference(first[name], second[name]) if name in second else ""
        if words:
            lines.append(f"{name}: {words}")
    lines += [f"{name}: {first[name]}" for name in names if name.endswith(": refused")]
    for line in lines:
        print(line)
    print(f"{len(names)} pictures, " + (f"{len(lines)} differ or were refused" if lines else "all equal"))
    return 1 if lines else 0


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    commands = parser.add_subparsers(dest="command", required=True)
    drawing = commands.add_parser("draw")
    drawing.add_argument("build", type=pathlib.Path)
    drawing.add_argument("output", type=pathlib.Path)
    drawing.add_argument("--variants", type=pathlib.Path, metavar="PROGRAM")
    drawing.add_argument("--check", action="store_true")
    drawing.add_argument("--every", type=int, default=1, metavar="N")
    drawing.add_argument("--only", default="", metavar="WORDS")
    drawing.add_argument("--stage", default="", choices=("Fragment", "Compute"))
    comparing = commands.add_parser("compare")
    comparing.add_argument("first", type=np.load)
    comparing.add_argument("second", type=np.load)
    arguments = parser.parse_args()
    if arguments.command == "compare":
        return compare(dict(arguments.first), dict(arguments.second))
    run_again_with_display()
    build = arguments.build.resolve()
    program = (arguments.variants or build / "bin/tetmarch-variants").resolve()
    return draw(build, program, arguments)


if __name__ == "__main__":
    sys.exit(main())

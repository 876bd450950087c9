# SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
# SPDX-License-Identifier: BSD-3-Clause
"""Runs the scripts of the gallery, and writes its page and pictures: draw_gallery.py

It measures each script's figure: the time of its fastest frame, and its error against the ground truth, which takes
some minutes in all.
"""
import contextlib
import os
import pathlib
import runpy
import shutil
import tempfile

PROJECT = pathlib.Path(__file__).resolve().parents[2]
SCRIPTS = PROJECT / "Documentation" / "Examples" / "gallery"
PICTURES = PROJECT / "Documentation" / "Pictures" / "gallery"
PAGE = PROJECT / "Documentation" / "Gallery.md"
ORDER = ("flow", "stress", "ct", "ocean", "time_series", "cut", "lit", "pick", "error_view", "blocks", "cells",
         "isosurfaces")
FRAMES = 25

HEAD = """# Gallery

Twelve pictures of 480 x 360 pixels, each with the script that draws it, from files of this project or from data that
the script makes. Run the scripts from the project's top folder:

    PYTHONPATH=build/lib/python3/dist-packages /usr/bin/python3 Documentation/Examples/gallery/flow.py

The seconds are those of the fastest of {frames} frames after the first one, on two cores without a GPU (llvmpipe). The
errors are of a channel of a pixel, 0 to 1, over the pixels whose ray meets the volume, at the default tolerance of
1/255: `figure.compare()` computes the same picture in double precision. What light adds to the error is outside of the
tolerance ([Limits.md](Limits.md#light)). `Testing/Python/draw_gallery.py` writes this page.

"""


def code_of(name):
    """A script without its licence's lines."""
    return "\n".join((SCRIPTS / f"{name}.py").read_text(encoding="utf-8").splitlines()[2:]) + "\n"


def section(name, seconds, error):
    """Of the page."""
    code = code_of(name)
    title, text = code.split("\n")[0].strip('"').split(": ", 1)
    return (f"## {title}\n\n![{title}](Pictures/gallery/{name}.png)\n\n{text[0].upper()}{text[1:]}\n\n"
            f"{seconds:.2g} s a frame; error {error['rms']:.1g} RMS, {error['max']:.1g} at most.\n\n"
            f"<details><summary>{name}.py</summary>\n\n```python\n{code}```\n\n</details>\n")


@contextlib.contextmanager
def run(name):
    """The figure of a script that runs in a folder of its own, which is the current one meanwhile."""
    with tempfile.TemporaryDirectory() as folder, contextlib.chdir(folder):
        os.symlink(PROJECT / "Data", "Data")
        yield runpy.run_path(str(SCRIPTS / f"{name}.py"))["figure"]


def draw(name):
    """Runs a script; returns its section of the page."""
    with run(name) as figure:
        shutil.copyfile(f"{name}.png", PICTURES / f"{name}.png")
    seconds = min(figure.render().statistics()["seconds"] for _ in range(FRAMES))
    error = figure.compare()
    print(f"{name}: {seconds:.3f} s, {error['rms']:.2g}, {error['max']:.2g}", flush=True)
    return section(name, seconds, error)


def main():
    PICTURES.mkdir(exist_ok=True)
    sections = [draw(name) for name in ORDER]
    PAGE.write_text(HEAD.format(frames=FRAMES) + "\n".join(sections), encoding="utf-8")


if __name__ == "__main__":
    main()

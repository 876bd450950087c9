# SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
# SPDX-License-Identifier: BSD-3-Clause
"""Pages of scenes show the mapper's pictures, in each browser with each driver: PagesOfScenesTest.py BUILD_FOLDER

The tests in C++ make the pages (Common/WebPages.h). By default one view of each hard case is opened in Chromium with
the llvmpipe, and every eighth of them in the other browsers; in all of them scenes which together have each feature of
shaders that pages know. With TETMARCH_WEB_ALL=1 in the environment it is each view and each scene in all of them.
"""
import json
import os
import pathlib
import re
import subprocess
import sys
import tempfile
import unittest

from browser_case import in_every_browser
from check_pages import checked

PROJECT = pathlib.Path(__file__).resolve().parents[2]
ALL = os.environ.get("TETMARCH_WEB_ALL") == "1"
HARD_CASES = 138
STEP = 8  # of hard cases beside Chromium with the llvmpipe
BUILD = FOLDER = None

# Programs of scenes, with what the short run draws of them and the least number of pages that it makes.
SCENES = {
    "Parity": ("Parity.TransparentRanges:Parity.OneColour", 4),
    "Blend": ("*.ConstantCells:*.AverageOverARange:*Mesh.Noise", 20),
    "Gaps": ("*NanParity.InLightAndShadow*:HiddenParity.Shaded", 3),
    "Clipping": ("CutParity*.ParallelAlongAnAxis", 8),
    "StructuredComponents": ("*BytesAndWords/TwoIndependent:*BytesAndWords/ColorAndOpacity:"
                             "*BytesAndWords/DirectColor", 24),
    "Light": ("LightParity/Lattice.BehindTransparentCells:LightParity/Mesh.EachKindOfScalars:"
              "OpaqueShadowPicture.OfABallInside:OpaqueShadowPicture.KeepAToleranceInAnImage:"
              "*LightThroughCuts*AtVertices", 21),
    "Grids": ("Curvilinear.BlankedCellsAndChanges:Curvilinear.ValuesJumpAtASeam:Leaves.LightIsThatOfTheGroundTruth", 3),
    "Slabs": ("Slabs.LightOfAllKinds:Slabs.BlendModesAndSamples", 14),
    "Structured": ("StructuredLight.ShadowsAlongRays", 3),
    "Kernel": ("", 0), "Component": ("", 0), "Sampled": ("", 0),
    "Accuracy": ("", 0), "Combinations": ("", 0),
}
# Features of the key that no page has when it is written: it lists entries by itself, is drawn at once, without fused
# arithmetic, shows the picture alone, and bounds no curved cells.
IN_NO_PAGE = {"ENTRY_LISTS", "OPAQUE_DEPTH", "HAS_FMA", "DIAGNOSTICS", "PEELED", "SHOW_ILLUMINATION",
              "SHOW_GRADIENTS", "SPLIT_CELLS", "REENTERED", "CURVED_ERROR"}


def draw(program, tests, **variables):
    """Runs tests of a program; returns the pages of their scenes."""
    folder = FOLDER / program
    folder.mkdir()
    environment = {**os.environ, "TETMARCH_WEB_PAGES": str(folder), "TETMARCH_GL": "egl", "DISPLAY": "", **variables}
    command = [BUILD / "bin" / f"TetMarch{program}Test", f"--gtest_filter={tests}"]
    subprocess.run(command, env=environment, check=True, stdout=subprocess.DEVNULL)
    return sorted(folder.glob("*.html"))


def steps_of(page):
    return json.loads(re.search(r'id="scene">(.*?)</script>', page.read_text(encoding="utf-8"), re.DOTALL)[1])["steps"]


def features_of(page):
    """Of the shaders of all volumes."""
    volumes = [volume for step in steps_of(page) for volume in step["volumes"]]
    visible = {"VISIBLE_PART" for volume in volumes if "visibleFaceBuffer" in volume["textures"]}
    return visible.union(*(volume["features"] for volume in volumes))


def key_features():
    rows = (PROJECT / "VTKModule" / "Variants" / "features.txt").read_text(encoding="utf-8").splitlines()
    return {row.split()[0] for row in rows if row[:1].isalpha() and row.split()[1] != "none"}


def covering(pages):
    """Pages which together have each feature of the pages; without any of them one would be missing.

    Pages with many features are left out first: SwiftShader compiles their shaders for up to half a minute.
    """
    features = {page: features_of(page) for page in pages}
    for page in sorted(pages, key=lambda page: len(features[page]), reverse=True):
        others = (features[other] for other in features if other != page)
        if features[page] <= set().union(*others):
            del features[page]
    return list(features)


def setUpModule():
    global FOLDER, HARD, DRAWN
    FOLDER = pathlib.Path(unittest.enterModuleContext(tempfile.TemporaryDirectory()))
    HARD = draw("HardCaseDrawing", "Case/*", **({} if ALL else {"TETMARCH_FIRST_VIEWS": "1"}))
    DRAWN = {program: draw(program, "*" if ALL else tests)
             for program, (tests, least) in SCENES.items() if ALL or least}


class ChoiceTest(unittest.TestCase):
    def test_hard_cases(self):
        self.assertEqual(len({page.stem.partition("--")[0] for page in HARD}), HARD_CASES)

    def test_scenes(self):
        for program, pages in DRAWN.items():
            self.assertGreaterEqual(len(pages), SCENES[program][1], program)

    def test_features(self):
        found = set().union(*(features_of(page) for pages in DRAWN.values() for page in pages))
        self.assertEqual(found, key_features() - IN_NO_PAGE)


class PagesOfScenes:
    def test_pictures(self):
        hard = HARD[::1 if ALL or self.which == ("chromium", "llvmpipe") else STEP]
        scenes = [page for pages in DRAWN.values() for page in pages]
        # SwiftShader rounds the corners of triangles to another grid: SurfacesTest.py. It takes minutes for the one with
        # a tolerance of light.
        if self.which[1] == "swiftshader":
            scenes = [page for page in scenes if not any(step["surfaces"] for step in steps_of(page))]
        for page, wrong, _ in checked(hard + (scenes if ALL else covering(scenes)), self.which):
            with self.subTest(page=page.stem):
                self.assertEqual(wrong, [])


in_every_browser(PagesOfScenes, unittest.TestCase)

if __name__ == "__main__":
    BUILD = pathlib.Path(sys.argv.pop(1)).resolve()
    unittest.main()

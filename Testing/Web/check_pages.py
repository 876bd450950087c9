# SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
# SPDX-License-Identifier: BSD-3-Clause
"""Pages of scenes beside the mapper's pictures of them: check_pages.py FOLDER [BROWSER DRIVER]

Every NAME.html of the folder is opened in each browser, in a window of the size of NAME.png. A page is wrong if a
channel of a pixel is more than 2/255 off, the console has a message, or a ray was lost, refused or guarded. What a
wrong page shows is written as NAME.BROWSER.DRIVER.png, and the difference beside it.
"""
import pathlib
import sys

from PIL import Image

from browsers import BROWSERS, browser
from compare import compare, picture_of_difference, read

TOLERANCE = 2
PAGES_OF_BROWSER = 200  # Firefox keeps the WebGL contexts of 300 pages
SECONDS = 600  # SwiftShader compiles the largest shaders for minutes
COUNT = "return document.querySelector('canvas').viewer.count()"


def check(opened, page, which):
    """Returns the faults of a page, a sentence each, and the difference of its picture from the mapper's."""
    expected = read(page.with_suffix(".png"))
    opened.size(expected.shape[1], expected.shape[0])
    opened.open(page, "bare")
    opened.wait_title("ready", SECONDS)
    shown = opened.png()
    apart = compare(shown, expected)
    wrong = opened.console()
    counted = opened.run(COUNT)
    wrong += [f"{counted[name]} rays {name}" for name in ("lost", "refused", "guarded") if counted[name] != 0]
    if apart.most > TOLERANCE:
        wrong.append(str(apart))
        for name, picture in ("", shown), (".difference", picture_of_difference(shown, expected)):
            Image.fromarray(picture).save(page.with_suffix(f".{'.'.join(which)}{name}.png"))
    return wrong, apart


def checked(pages, which):
    """Each page with what check() returns; no difference after an error."""
    for begin in range(0, len(pages), PAGES_OF_BROWSER):
        with browser(*which) as opened:
            for page in pages[begin:begin + PAGES_OF_BROWSER]:
                try:
                    yield page, *check(opened, page, which)
                except (RuntimeError, TimeoutError, ValueError) as error:
                    yield page, [str(error)], None


def check_all(folder, which):
    """Prints a line per wrong page and one of figures; returns the number of wrong pages."""
    pages = sorted(folder.glob("*.html"))
    if not pages:
        sys.exit(f"There is no page in {folder}")
    failed, compared, most, rms = 0, 0, 0, 0.0
    for page, wrong, apart in checked(pages, which):
        failed += bool(wrong)
        if wrong:
            print(f"{page.stem}: {'; '.join(wrong)}", flush=True)
        if apart:
            compared += 1
            most, rms = max(most, apart.most), max(rms, apart.rms)
    print(f"{' '.join(which)}: {len(pages)} pages, {failed} wrong; {compared} pictures compared, max {most}/255, "
          f"RMS {rms:.3f}/255")
    return failed


if __name__ == "__main__":
    if len(sys.argv) not in (2, 4):
        sys.exit(__doc__.splitlines()[0])
    chosen = [tuple(sys.argv[2:])] if len(sys.argv) == 4 else BROWSERS
    sys.exit(sum(check_all(pathlib.Path(sys.argv[1]), which) for which in chosen) > 0)

# SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
# SPDX-License-Identifier: BSD-3-Clause
"""What the pages say of files, folders, tests and figures is so."""
import re
import unittest

from pages import (GENERATED, PROJECT, code_words, fenced_blocks, name_of, pages, sources, table_rows, text_of,
                   without_blocks)

MOST_COLUMNS = 120
MOST_LINES_OF_README = 115
FILE_ENDINGS = "cmake|cxx|glsl|h|json|md|png|py|sh|txt|vtu|xml|module|plugin"
# Files that a page tells of and that aren't ours, or are made by who follows the page.
OTHER_FILES = {"vtkAOSDataArrayTemplate.h", "example.py", "TetMarch.so", "data/vti/bonsai.vti"}
# Folders that a page tells of and that aren't ours.
OTHER_FOLDERS = {"Remote/", "Remote/TetMarch"}
# Stand for any name: `concept_buffers.glsl`.
ANY_NAME = ("concept", "a_b")


def slug(heading):
    """The anchor that GitHub gives to a heading."""
    return re.sub(r"[^\w\- ]", "", heading.replace("`", "").lower()).replace(" ", "-")


def anchors(page):
    text = page.read_text(encoding="utf-8")
    return {slug(h) for h in re.findall(r"^#+ (.*)$", text, re.MULTILINE)} | set(re.findall(r'<a name="([^"]*)">', text))


def is_path(word):
    return (re.fullmatch(r"[\w./+-]+", word) and not word.startswith(("build/", "/", "./"))
            and not word.startswith(ANY_NAME) and "NAME" not in word and ("/" in word or re.search(rf"\w\.({FILE_ENDINGS})$", word)))


def names_something(word, page, files):
    """Whether a word is a path from the top, from the page, from VTKModule or Shaders, or the name of a file."""
    pattern = word.replace("...", "*").rstrip("/")
    if "/" not in word:
        return any(file.match(pattern) for file in files)
    for folder in (PROJECT, page.parent, PROJECT / "VTKModule", PROJECT / "Shaders"):
        if any(folder.glob(pattern)) or any(folder.glob(pattern + ".*")):
            return True
    return False


class PagesTest(unittest.TestCase):
    def test_links_lead_somewhere(self):
        links = [(page, link, anchor) for page in pages()
                 for link, anchor in re.findall(r"\]\(([^)#:]*)(?:#([^)]*))?\)", page.read_text(encoding="utf-8"))]
        self.assertIn((PROJECT / "README.md", "Data/golfball_wake.png", ""), links)
        for page, link, anchor in links:
            with self.subTest(page=name_of(page), link=link, anchor=anchor):
                target = page.parent / link if link else page
                self.assertTrue(target.exists())
                self.assertTrue(not anchor or anchor in anchors(target))

    def test_files_and_folders_exist(self):
        files = [file for file in sources("*") if file.is_file()]
        for page in pages():
            for word in set(filter(is_path, code_words(page.read_text(encoding="utf-8")))):
                with self.subTest(page=name_of(page), word=word):
                    self.assertTrue(word in OTHER_FILES | OTHER_FOLDERS or names_something(word, page, files))

    def test_tests_exist(self):
        """`Suite.Name` in a page is a test, or all tests of that begin with `Suite.*`."""
        sources_of_tests = "\n".join(f.read_text(encoding="utf-8") for f in sources("*.cxx") if "Testing" in f.parts)
        tests = set(re.findall(r"\b(?:TYPED_)?TEST(?:_F|_P)?\(\s*(\w+),\s*(\w+)\)", sources_of_tests))
        suites = {suite for suite, _ in tests}
        found = 0
        for page in pages():
            for word in code_words(page.read_text(encoding="utf-8")):
                for suite, name in re.findall(r"^(?:\w+/)?([A-Z]\w+)\.([A-Z*]\w*)(?:/.*)?$", word):
                    if suite in suites or not name.endswith(("md", "h")):
                        found += 1
                        with self.subTest(page=name_of(page), word=word):
                            self.assertTrue((suite, name) in tests or (name == "*" and suite in suites))
        self.assertGreater(found, 30)

    def test_every_folder_is_named(self):
        """Of the project in the page on its architecture, of the tests in theirs."""
        for page, parents in (("Documentation/Architecture.md", (".", "VTKModule", "Shaders", "Tools")),
                              ("Shaders/README.md", ("Shaders",)),
                              ("Testing/README.md", ("Testing", "Testing/Cxx"))):
            words = {word.rstrip("/") for word in code_words(text_of(page))}
            for parent in parents:
                folders = [f for f in (PROJECT / parent).iterdir() if f.is_dir()
                           and not f.name.startswith((".", "build", "__"))]
                self.assertTrue(folders, parent)
                for folder in folders:
                    with self.subTest(page=page, folder=name_of(folder)):
                        self.assertTrue({folder.name, name_of(folder)} & words)

    def test_rooms_are_those_of_the_list(self):
        """Both in the drawing of the floors and in the table, from the top floor down."""
        rooms = sorted((line.split(maxsplit=2) for line in text_of("VTKModule/floors.txt").splitlines()
                        if line.strip() and not line.startswith("#")), key=lambda room: -int(room[0]))
        page = text_of("Documentation/Architecture.md")
        listed = [[floor, f"`{room}`", what.strip()] for floor, room, what in rooms]
        self.assertEqual([row for row in table_rows(page) if row[0].isdigit()], listed)
        (drawing,) = fenced_blocks(page, "")
        drawn = [(floor, room) for floor, names in re.findall(r"^ +(\d+) +(\w[\w ]*)", drawing, re.MULTILINE)
                 for room in names.split()]
        self.assertEqual(drawn, [(floor, room) for floor, room, _ in rooms])

    def test_generated_pages_have_the_words_of_their_templates(self):
        for page, template in GENERATED.items():
            words = " ".join(text_of(page).split())
            for part in re.split(r"@[a-z-]+@", text_of(template)):
                with self.subTest(page=page, part=part[:60]):
                    self.assertIn(" ".join(part.split()), words)

    def test_figures_of_the_readme_are_those_measured(self):
        """Its table has a mapper's seconds and RMS error of two scenes; the page has both, and more."""
        names = {"TetMarch": "tetmarch", "projected tetrahedra": "projected", "Z-sweep": "zsweep",
                 "Bunyk ray caster": "bunyk-preintegration", "resampled to 128^3 points": "resample:128/1"}
        measured = {tuple(row[:3]): (row[3].split(" ")[0], row[5])
                    for row in table_rows(text_of("Documentation/Accuracy.md")) if len(row) == 11 and "(" in row[3]}
        rows = [row for row in table_rows(text_of("README.md")) if row[0] in names]
        self.assertEqual([row[0] for row in rows], list(dict.fromkeys(row[0] for row in rows)))
        self.assertEqual({row[0] for row in rows}, set(names))
        for mapper, *figures in rows:
            with self.subTest(mapper=mapper):
                self.assertEqual(tuple(figures[:2]), measured["golfball", "smooth", names[mapper]])
                self.assertEqual(tuple(figures[2:]), measured["front1.3m", "smooth", names[mapper]])

    def test_lines_are_short(self):
        self.assertLessEqual(len(text_of("README.md").splitlines()), MOST_LINES_OF_README)
        for page in pages():
            if name_of(page) not in GENERATED:  # their figures are as long as they are
                for number, line in enumerate(without_blocks(page.read_text(encoding="utf-8")).splitlines(), 1):
                    if not line.startswith("|"):
                        with self.subTest(page=name_of(page), line=line):
                            self.assertLessEqual(len(line), MOST_COLUMNS)

    def test_cmake_of_the_readme_is_that_of_a_project_that_is_built(self):
        consumer = text_of("Testing/Package/Consumer/CMakeLists.txt")
        (block,) = fenced_blocks(text_of("README.md"), "cmake")
        for line in block.splitlines():
            with self.subTest(line=line):
                self.assertIn(line.replace("app", "consumer"), consumer)


if __name__ == "__main__":
    unittest.main()

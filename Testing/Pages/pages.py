# SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
# SPDX-License-Identifier: BSD-3-Clause
"""The project's pages: which there are, and what they are made of."""
import pathlib
import re
import tempfile
import textwrap

PROJECT = pathlib.Path(__file__).resolve().parents[2]

# Pages that a program writes, each with the template that has its words.
GENERATED = {
    "Documentation/Accuracy.md": "Testing/Benchmark/AccuracyPage.md",
    "Documentation/Effects.md": "Testing/Benchmark/EffectsPage.md",
    "Documentation/HardCases.md": "Testing/HardCases/HardCasesPage.md",
    "Documentation/LightAccuracy.md": "Testing/Benchmark/LightAccuracyPage.md",
    "Documentation/Structured.md": "Testing/Benchmark/StructuredPage.md",
}


def is_source(path):
    """Whether a path of the project is none of a build folder's, and none of Git's."""
    top = path.relative_to(PROJECT).parts[0]
    return not top.startswith("build") and top not in (".git", ".cache")


def sources(pattern):
    return sorted(path for path in PROJECT.rglob(pattern) if is_source(path))


def pages():
    """All pages but the templates, which are read as the pages that are made of them."""
    return [page for page in sources("*.md") if name_of(page) not in GENERATED.values()]


def name_of(page):
    return page.relative_to(PROJECT).as_posix()


def text_of(page):
    return (PROJECT / page).read_text(encoding="utf-8")


def folder_of_a_user(test, build):
    """A folder in which commands run as in the project's, and which goes with the test."""
    folder = tempfile.TemporaryDirectory()
    test.addCleanup(folder.cleanup)
    path = pathlib.Path(folder.name)
    (path / "build").symlink_to(build)
    (path / "Data").symlink_to(PROJECT / "Data")
    return path


def fenced_blocks(text, language):
    return re.findall(rf"^```{language}\n(.*?)^```$", text, re.MULTILINE | re.DOTALL)


def indented_blocks(text):
    """Blocks of code by indentation: behind an empty line, which a list's further lines are not."""
    blocks = re.findall(r"(?<=\n\n)(?: {4}.*\n(?:\n(?= {4}))*)+", without_fences(text) + "\n")
    return [textwrap.dedent(block).strip() + "\n" for block in blocks]


def without_fences(text):
    return re.sub(r"^```.*?^```$", "", text, flags=re.MULTILINE | re.DOTALL)


def without_blocks(text):
    """The prose: neither fenced nor indented blocks."""
    return re.sub(r"(?<=\n\n)(?: {4}.*\n(?:\n(?= {4}))*)+", "", without_fences(text))


def code_words(text):
    """What stands between backticks in the prose."""
    return re.findall(r"`([^`\n]+)`", without_blocks(text))


def table_rows(text):
    """The cells of each row of each table, without the rules below the heads."""
    rows = [[cell.strip() for cell in line.strip().strip("|").split("|")]
            for line in text.splitlines() if line.startswith("|")]
    return [row for row in rows if not all(re.fullmatch(r":?-+:?", cell) for cell in row)]

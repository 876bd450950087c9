# SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
# SPDX-License-Identifier: BSD-3-Clause
"""Each fault still fits the sources and names tests that exist; and ./tetmarch mutants tells the truth about faults."""
import contextlib
import fnmatch
import io
import pathlib
import re
import tempfile
import unittest

import mutants
import programs
import results as found
from faults import Fault, FaultError, NamedTest, read_faults, read_table
from programs import Outcome
from results import Results, count_text, markdown
from source_copy import SourceCopy, source_files

LEAST_FAULTS = 60
LEAST_OF_THE_MARCH = 5


def text_of(path):
    return path.read_text(encoding="utf-8")


def tests_of_sources():
    """Names of all tests, as GoogleTest has them without parameters."""
    texts = "\n".join(text_of(mutants.PROJECT / path) for path in source_files(mutants.PROJECT)
                      if path.parts[0] == "Testing" and path.suffix in (".cxx", ".h"))
    return {f"{suite}.{name}"
            for suite, name in re.findall(r"^(?:TYPED_)?TEST(?:_[FP])?\((\w+),\s*(\w+)\)", texts, re.MULTILINE)}


def programs_of_build():
    texts = "\n".join(text_of(path) for path in (mutants.PROJECT / "Testing").rglob("CMakeLists.txt"))
    pictures = re.findall(r"^ *tetmarch_(?:picture|window)_test(?:_by\(egl |\()(\w+)", texts, re.MULTILINE)
    return set(re.findall(r"add_executable\((\w+)", texts)) | {f"TetMarch{name}Test" for name in pictures}


class TablesTest(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.faults = read_faults()

    def test_each_fault_fits_the_sources(self):
        for fault in self.faults:
            with self.subTest(fault=fault.name):
                text = text_of(mutants.PROJECT / fault.file)
                self.assertNotEqual(fault.applied_to(text), text)
                self.assertRegex(fault.name, r"^[a-z0-9-]+$")
                self.assertRegex(fault.breaks, r"^[A-Z].*[^.]\.$")

    def test_tests_that_are_to_notice_exist(self):
        tests, built = tests_of_sources(), programs_of_build()
        self.assertIn("EdgeSign.IsExactInFloat", tests)
        for fault in self.faults:
            self.assertTrue(fault.targets)  # those of CTest are known
            for test in fault.tests:
                if not test.is_ctest:
                    self.assertIn(test.program, built, fault.name)
                    for pattern in test.filter.split(":"):
                        with self.subTest(fault=fault.name, pattern=pattern):
                            self.assertTrue(fnmatch.filter(tests, pattern))

    def test_there_are_many_faults_of_all_kinds(self):
        self.assertGreaterEqual(len(self.faults), LEAST_FAULTS)
        self.assertGreaterEqual(sum(fault.slow for fault in self.faults), LEAST_OF_THE_MARCH)
        for begin in ("Shaders/", "VTKModule/Mesh/", "VTKModule/Optics/", "VTKModule/Light/", "VTKModule/Entries/",
                      "VTKModule/Structured/", "VTKModule/GL/", "VTKModule/Processes/", "VTKModule/Python/",
                      "VTKModule/FirstPicture/", "Tools/"):
            self.assertTrue(any(fault.file.startswith(begin) for fault in self.faults), begin)

    def test_a_text_that_is_not_there_once_is_named(self):
        fault = Fault("some-name", "It breaks.", "a.txt", "old", "new", ())
        self.assertEqual(fault.applied_to("the old one"), "the new one")
        for text in ("none", "old and old"):
            with self.assertRaisesRegex(FaultError, "some-name.*a.txt"):
                fault.applied_to(text)

    def test_wrong_tables_are_errors(self):
        row = '[[fault]]\nname = "a"\nbreaks = "B."\nfile = "f"\nold = "o"\nnew = "n"\n'
        with tempfile.TemporaryDirectory() as folder:
            path = pathlib.Path(folder) / "a.toml"
            for text in ("slow = true\n" + row + 'tests = ["P F"]\n', row, row + "tests = []\n",
                         row + 'tests = ["P F"]\nwhy = "?"\n', row + 'tests = ["only-one-word"]\n'):
                path.write_text(text, encoding="utf-8")
                with self.subTest(text=text), self.assertRaises(FaultError):
                    read_table(path)
            path.write_text(row + 'tests = ["P F"]\n', encoding="utf-8")
            self.assertEqual(len(read_faults(path.parent)), 1)
            (path.parent / "b.toml").write_text(path.read_text(encoding="utf-8"), encoding="utf-8")
            self.assertRaisesRegex(FaultError, "named a", read_faults, path.parent)


class FakePrograms:
    """Notices a fault if the file that the test names says so."""
    logs = "logs"

    def __init__(self, copy):
        self.copy = copy
        self.builds = []
        self.runs = []

    def build(self, targets, log):
        self.builds.append((log, targets))
        return "BROKEN" not in text_of(self.copy.copy / "code.txt")

    def run(self, test, limit, log):
        self.runs.append((log, str(test)))
        text = text_of(self.copy.copy / "code.txt")
        passed = test.filter not in text
        return Outcome(passed, test.filter != "missing", 1.0, "" if passed else f"{test.filter}.Fails")


class RunTest(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)
        for name, text in (("code.txt", "sound code\n"), ("README.md", "words\n"), ("build/x", ""), (".hidden", "")):
            path = self.folder / "sources" / name
            path.parent.mkdir(parents=True, exist_ok=True)
            path.write_text(text, encoding="utf-8")
        self.copy = SourceCopy(self.folder / "sources", self.folder / "copy")

    def fault(self, name, new, *tests):
        return Fault(name, "It breaks.", "code.txt", "sound", new, tuple(map(NamedTest.of, tests)))

    def try_all(self, *faults, goes_on=lambda: True):
        """Returns what was found by name, and the programs that ran."""
        tree = self.copy.update()
        results = Results(self.folder / "results.json", tree)
        fake = FakePrograms(self.copy)
        left = [fault for fault in faults if not results.of(fault)]
        mutants.Runner(self.copy, fake, results, say=lambda _: None).run(left, goes_on)
        self.assertEqual(text_of(self.copy.copy / "code.txt"), "sound code\n")
        return {fault.name: (results.of(fault) or {}).get("status") for fault in faults}, fake

    def test_what_is_noticed_and_what_is_not(self):
        faults = [self.fault("first", "One", "P One"), self.fault("second", "Two", "P One", "P Two"),
                  self.fault("unnoticed", "Three", "P One"), self.fault("unbuilt", "BROKEN", "P One"),
                  self.fault("unsound", "Four", "P code"), self.fault("untested", "Five", "P missing")]
        statuses, _ = self.try_all(*faults)
        self.assertEqual(statuses, {"first": found.NOTICED, "second": found.NOTICED, "unnoticed": found.UNNOTICED,
                                    "unbuilt": found.NOT_BUILT, "unsound": found.FAILS_WITHOUT,
                                    "untested": found.FAILS_WITHOUT})
        results = Results(self.folder / "results.json", self.copy.update())
        self.assertEqual(results.of(faults[1])["by"], "Two.Fails")
        self.assertEqual(count_text(faults, results, False), "6 faults, 6 tried, 2 noticed")
        table = markdown(faults, results)
        self.assertIn("| first | It breaks. | `code.txt` | One.Fails | 0 |", table)
        self.assertIn("| **not noticed** |", table)

    def test_a_run_goes_on_where_it_was_stopped(self):
        faults = [self.fault(name, f"One {name}", "P One") for name in ("a", "b", "d")]
        answers = iter([True, True, True])  # without a fault, then two of them
        statuses, _ = self.try_all(*faults, goes_on=lambda: next(answers, False))
        self.assertEqual(statuses, {"a": found.NOTICED, "b": found.NOTICED, "d": None})
        statuses, fake = self.try_all(*faults)
        self.assertEqual(statuses["d"], found.NOTICED)
        self.assertEqual({log for log, _ in fake.builds}, {"d"})
        _, fake = self.try_all(*faults)
        self.assertEqual(fake.builds, [])

    def test_other_sources_are_tried_again_and_other_words_are_not(self):
        fault = self.fault("a", "One", "P One")
        self.try_all(fault)
        (self.folder / "sources/README.md").write_text("other words\n", encoding="utf-8")
        self.assertEqual(self.try_all(fault)[1].builds, [])
        (self.folder / "sources/other.txt").write_text("more code\n", encoding="utf-8")
        self.assertNotEqual(self.try_all(fault)[1].builds, [])
        (self.folder / "sources/other.txt").unlink()
        results = Results(self.folder / "results.json", self.copy.update())
        self.assertFalse((self.copy.copy / "other.txt").exists())
        self.assertIsNone(results.of(fault))
        self.assertEqual(results.of(fault, older=True)["status"], found.NOTICED)
        self.assertIsNone(results.of(self.fault("a", "Two", "P One"), older=True))

    def test_the_copy_has_the_sources_and_keeps_its_build_folder(self):
        self.copy.update()
        self.assertEqual(sorted(map(str, source_files(self.copy.copy))), ["README.md", "code.txt"])
        self.copy.build.mkdir()
        (self.copy.build / "object").touch()
        (self.copy.copy / "code.txt").write_text("left by a run that was killed", encoding="utf-8")
        self.copy.update()
        self.assertEqual(text_of(self.copy.copy / "code.txt"), "sound code\n")
        self.assertTrue((self.copy.build / "object").exists())

    def test_patterns_choose_by_name(self):
        faults = [self.fault(name, "One", "P One") for name in ("mesh-a", "mesh-b", "light-a")]
        self.assertEqual(mutants.chosen(faults, []), faults)
        self.assertEqual(mutants.chosen(faults, ["mesh-*", "light-a"]), faults)
        self.assertEqual(mutants.chosen(faults, ["*-b"]), faults[1:2])
        self.assertRaisesRegex(FaultError, "named gl-", mutants.chosen, faults, ["gl-*"])

    def test_list_prints_names(self):
        output = io.StringIO()
        with contextlib.redirect_stdout(output):
            self.assertEqual(mutants.main([str(self.folder / "nowhere"), "--list", "predicate-*"]), 0)
        self.assertIn("predicate-tie\n", output.getvalue())
        self.assertFalse((self.folder / "nowhere").exists())


class ProgramsTest(unittest.TestCase):
    def test_the_test_that_failed_is_named(self):
        passed = "[==========] Running 2 tests from 1 test suite.\n[ RUN      ] A.B\n[       OK ] A.B (0 ms)\n"
        failed = passed + "[ RUN      ] All/A.C/3\n"
        self.assertEqual(programs.failed_test_of_gtest(failed), "All/A.C/3")  # a crash
        failed += "[  FAILED  ] All/A.C/3, where GetParam() = 7 (1 ms)\n\n[  FAILED  ] 1 test, listed below:\n"
        self.assertEqual(programs.failed_test_of_gtest(failed), "All/A.C/3")
        self.assertEqual(programs.failed_test_of_gtest("[  FAILED  ] A.B (4 ms)\n"), "A.B")
        self.assertEqual(programs.failed_test_of_python("FAIL: test_a (X.test_a)\nERROR: test_b (X)\n"), "test_a")

    def test_a_program_is_run_with_its_filter(self):
        with tempfile.TemporaryDirectory() as name:
            folder = pathlib.Path(name)
            program = folder / "bin/Some"
            program.parent.mkdir()
            program.write_text('#!/bin/sh\necho "[==========] Running $COUNT tests from 1 test suite."\n'
                               'case "$1" in\n'
                               '*=Good) exit 0 ;;\n'
                               '*=Bad) echo "[  FAILED  ] Bad.One (1 ms)"; exit 1 ;;\n'
                               '*=Crash) echo "[ RUN      ] Crash.One"; kill -SEGV $$ ;;\n'
                               '*=Endless) sleep 600 ;;\n'
                               'esac\n'.replace("$COUNT", "1"), encoding="utf-8")
            program.chmod(0o755)
            run = programs.Programs(folder, folder / "logs").run
            self.assertTrue(run(NamedTest("Some", "Good"), 60, "x").passed)
            for name, failed in (("Bad", "Bad.One"), ("Crash", "Crash.One")):
                outcome = run(NamedTest("Some", name), 60, "x")
                self.assertFalse(outcome.passed)
                self.assertTrue(outcome.ran)
                self.assertEqual(outcome.failed, failed)
            outcome = run(NamedTest("Some", "Endless"), 0.2, "x")
            self.assertFalse(outcome.passed)
            self.assertIn("not done after", outcome.failed)


if __name__ == "__main__":
    unittest.main()

# SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
# SPDX-License-Identifier: BSD-3-Clause
"""The check of what shaders take finds what is worse, and nothing else: GpuCompileTest.py BUILD ICD VALIDATOR"""
import dataclasses
import json
import pathlib
import subprocess
import sys
import tempfile
import unittest

import budgets as budgets_of
import report
from compiled_shaders import NotCompiled, Toolchain

HERE = pathlib.Path(__file__).resolve().parent
PAGE = HERE.parents[1] / "Documentation/GpuCompile.md"
BUILD = ICD = VALIDATOR = None
MESH = "picture POINT_SCALARS ENTRY_LISTS HAS_FMA ADAPTIVE"
LIT = "picture POINT_SCALARS ENTRY_LISTS HAS_FMA ADAPTIVE SHADING SINGLE_LIGHT"


class GpuCompileTest(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.tools = Toolchain(pathlib.Path(BUILD), "navi21", ICD, VALIDATOR)
        driver, cls.figures = cls.tools.compile([MESH, LIT])
        cls.version = budgets_of.version_of(driver)

    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)

    def check(self, status, kept=None, budget=1000, version=None):
        """Runs the check of MESH with a kept table that differs from what it takes as it is told."""
        (self.folder / "variants.json").write_text(json.dumps({
            "budgets": [{"name": "any", "pass": "picture", "with": [], "registers": budget}],
            "most_spills": 0, "tolerance": 8, "named": [["mesh", MESH]]}))
        now = self.figures[MESH]
        budgets_of.write_kept(self.folder / "kept.json", version or self.version,
                              {MESH: dataclasses.replace(now, **(kept or {}))})
        result = subprocess.run([sys.executable, HERE / "gpu_compile.py", BUILD, "--named", "--icd", ICD,
                                 "--validator", VALIDATOR, "--variants", self.folder / "variants.json",
                                 "--kept", self.folder / "kept.json"], text=True, capture_output=True)
        self.assertEqual(result.returncode, status, result.stdout + result.stderr)
        return result.stdout

    def test_what_is_as_it_was_passes(self):
        self.assertIn("1 of 1 variants have kept figures; 0 of them are worse", self.check(0))

    def test_more_registers_fail(self):
        now = self.figures[MESH]
        fewer = {"registers": now.registers - 16, "demand": now.demand - 16}
        self.assertIn(f"worse: takes {now.registers} registers", self.check(1, fewer))
        self.assertIn("worse: takes", self.check(1, {"registers": now.registers - 16, "waves": now.waves + 1}))

    def test_a_granule_more_passes(self):
        now = self.figures[MESH]
        self.check(0, {"registers": now.registers - 8, "demand": now.demand - 8})

    def test_registers_that_only_hide_latency_pass(self):
        self.check(0, {"registers": self.figures[MESH].registers - 16})

    def test_a_budget_that_was_met_is_kept(self):
        registers = self.figures[MESH].registers
        met = {"registers": registers - 8}
        self.assertIn("which it met", self.check(1, met, budget=registers - 1))
        self.assertIn(f"missed: {registers - 1}", self.check(0, budget=registers - 1))

    def test_more_spills_fail(self):
        budgets = budgets_of.Budgets.read(HERE / "variants.json")
        kept = {MESH: (self.figures[MESH].registers, self.figures[MESH].demand, self.figures[MESH].waves, 0)}
        spilling = dataclasses.replace(self.figures[MESH], spills=1)
        self.assertEqual(len(budgets_of.worse(budgets, kept, {MESH: spilling})), 1)
        self.assertEqual(budgets_of.worse(budgets, kept, {MESH: self.figures[MESH]}), [])
        self.assertIn("missed: spills", report.target(budgets, MESH, spilling))

    def test_another_compiler_is_told_and_no_failure(self):
        now = self.figures[MESH]
        text = self.check(0, {"registers": now.registers - 16, "demand": now.demand - 16},
                          version={**self.version, "mesa": "1.2"})
        self.assertIn("worse: takes", text)
        self.assertIn("this is no failure", text)

    def test_figures_are_of_the_fragment_shader(self):
        """Light takes more registers and code; with the Mesa of the kept table, waves are those of 512 registers."""
        mesh, lit = self.figures[MESH], self.figures[LIT]
        self.assertGreater(lit.registers, mesh.registers)
        self.assertGreater(lit.bytes, mesh.bytes)
        if self.version == budgets_of.read_kept(HERE / "kept.json")[0]:
            for f in (mesh, lit):
                self.assertEqual(f.waves, min(16, 512 // f.registers))
                self.assertGreater(f.latency, f.throughput)

    def test_rules(self):
        budgets = budgets_of.Budgets.read(HERE / "variants.json")
        for line, name in ((MESH, "default"), (MESH + " VISIBLE_PART REENTERED", "default"), (LIT, "lit"),
                           (MESH + " INDEPENDENT", None), ("pick " + MESH.split(maxsplit=1)[1], None)):
            rule = budgets.rule_of(line)
            self.assertEqual(rule and rule["name"], name, line)
        self.assertEqual(report.group_of(LIT), "meshes, lit")
        self.assertEqual(report.group_of("pick STRUCTURED"), "picks, images")

    def test_kept_figures_are_those_of_the_listed_variants(self):
        """All names have kept figures; those of the listing too, until a feature changes it."""
        _, kept = budgets_of.read_kept(HERE / "kept.json")
        for name, line in budgets_of.Budgets.read(HERE / "variants.json").named.items():
            self.assertIn(line, kept, name)
        self.assertGreater(len(kept), 100)
        self.assertEqual(len(self.tools.shaders("legal", lines=[MESH, MESH + " GONE", "picture LEAPS"])), 1)

    def test_the_page_shows_what_is_kept(self):
        _, kept = budgets_of.read_kept(HERE / "kept.json")
        rows = [[cell.strip() for cell in line.strip("| ").split("|")]
                for line in PAGE.read_text(encoding="utf-8").splitlines() if line.startswith("| ")]
        shown = {row[0]: row[1:5] for row in rows}
        for name, line in budgets_of.Budgets.read(HERE / "variants.json").named.items():
            self.assertEqual(shown.get(name), [str(number) for number in kept[line]], name)
        self.assertIn(f"| all | {len(kept)} |", " ".join(PAGE.read_text(encoding="utf-8").split()))

    def test_what_can_not_be_compiled_is_told(self):
        with self.assertRaisesRegex(NotCompiled, "no scene makes"):
            self.tools.compile(["picture LEAPS"])
        (self.folder / "wrong.frag").write_text("#version 450 core\nvoid main() { float x = length; }\n")
        with self.assertRaisesRegex(NotCompiled, "wrong.frag"):
            self.tools.to_spirv(self.folder / "wrong.frag")
        with self.assertRaisesRegex(NotCompiled, "."):
            dataclasses.replace(self.tools, icd="/nowhere.json").compile([MESH])


if __name__ == "__main__":
    VALIDATOR, ICD, BUILD = sys.argv.pop(), sys.argv.pop(), sys.argv.pop()
    unittest.main(verbosity=2)

# SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
# SPDX-License-Identifier: BSD-3-Clause
"""The manual page of tetmarch-render and its completion: DocumentedOptionsTest.py EXECUTABLE PROJECT_FOLDER."""
import pathlib
import re
import shutil
import subprocess
import sys

from render_case import RenderCase, main


class DocumentedOptionsTest(RenderCase):
    def options(self):
        """Of --help: those at the beginning of lines."""
        help_text = self.run_tool("--help").stdout
        options = set(re.findall(r"--[a-z-]+", "\n".join(re.findall(r"^  (--.*?)(?:  |$)", help_text, re.MULTILINE))))
        self.assertGreater(len(options), 55)
        return options

    def test_the_manual_page_has_every_option(self):
        page = self.folder / "tetmarch-render.1"
        subprocess.run([sys.executable, "-B", self.project / "Tools/Render/make_man_page.py", self.executable, page],
                       check=True)
        text = page.read_text(encoding="utf-8")
        shown = {option for line in re.findall(r"^\.B (\\-\\-.*)$", text, re.MULTILINE)
                 for option in re.findall(r"--[a-z-]+", line.replace("\\-", "-"))}
        self.assertEqual(shown, self.options())
        sections = re.findall(r"^\.SH (.*)$", text, re.MULTILINE)
        self.assertEqual(sections, ["NAME", "SYNOPSIS", "DESCRIPTION", "OPTIONS", "ENVIRONMENT", "EXIT STATUS"])
        for part in ("Data", "Transfer function", "Accuracy", "View", "Output"):
            self.assertIn(f'.SS "{part}"\n', text)
        if shutil.which("groff"):
            result = subprocess.run(["groff", "-man", "-Tutf8", "-ww", page], capture_output=True, text=True,
                                    check=True)
            self.assertEqual(result.stderr, "")
            words = " ".join(re.sub("\x1b\\[[0-9]*m|.\b", "", result.stdout).split())
            self.assertIn("tetmarch-render INPUT [options]", words)
            self.assertIn("0 done, 1 failure, 2 bad command line.", words)

    def complete(self, *words):
        """What a shell offers for the last of these words."""
        programs = pathlib.Path(self.executable).parent
        script = f"""
            PATH="{programs}:$PATH"
            source "{programs.parent}/Tools/Render/completion.bash"
            COMP_WORDS=(tetmarch-render "$@")
            COMP_CWORD=$#
            _tetmarch_render tetmarch-render "${{COMP_WORDS[-1]}}" "${{COMP_WORDS[-2]}}"
            printf '%s\\n' "${{COMPREPLY[@]}}"
        """
        result = subprocess.run(["bash", "-c", script, "bash", *words], cwd=self.folder, capture_output=True, text=True,
                                check=True)
        self.assertEqual(result.stderr, "")
        return set(result.stdout.split("\n")) - {""}

    def test_completion(self):
        self.assertEqual(self.complete("--"), self.options())
        self.assertEqual(self.complete("--sh"), {"--shade", "--shadows"})
        self.assertEqual(self.complete("--shadows", ""), {"off", "automatic", "vertices", "rays"})
        self.assertEqual(self.complete("--shadows", "=", "r"), {"rays"})
        self.assertEqual(self.complete("--shadows", "="), {"off", "automatic", "vertices", "rays"})
        self.assertEqual(self.complete("--preset", "ram"), {"ramp.json"})
        self.assertEqual(self.complete("--shade", "cube."), {"cube.vtu", "cube.vtk"})
        self.assertEqual(self.complete("plate"), {"plate.vtk"})
        self.assertEqual(self.complete("--size", ""), set())
        self.assertEqual(self.complete("--colors", "vi"), {"Viridis"})
        names = set(self.run_tool("--colors", "list").stdout.splitlines())
        self.assertEqual(self.complete("--colors", ""), names | {"list"})


if __name__ == "__main__":
    main()

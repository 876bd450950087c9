# SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
# SPDX-License-Identifier: BSD-3-Clause
"""Every command that a page shows is pasted into a shell, or listed here with the reason why not.

    CommandsTest.py BUILD_FOLDER

Commands are run in a folder with nothing but links to `build` and `Data`. What `./tetmarch` does is not run, since it
sets machines up and builds; but it must know the command. The options of `./tetmarch bench` are pasted to the program
that the script hands them to, with `--quick`. Of a command with meshes that take minutes smaller ones are drawn.
"""
import os
import pathlib
import re
import subprocess
import sys
import unittest

from pages import PROJECT, code_words, folder_of_a_user, indented_blocks, name_of, pages, text_of

BUILD = None

# Blocks of these lines are no commands.
NO_SHELL = ("language", "(")
NOT_PASTED = {  # by regular expression
    "cmake -S . -B build -G Ninja": "configures the build that runs this test",
    "cmake --build build.*": "builds what runs this test",
    "cmake --install build --prefix PREFIX": "the test PackageInstall does it",
    "cmake -S . -B build-plugin -DTETMARCH_PARAVIEW_PLUGIN=ON -DParaView_DIR=.../lib/cmake/paraview-5.11":
        "./tetmarch paraview does it",
    r"/usr/bin/python3 Data/make_image\.py 1024 waves_\S*": "takes 1 GB; RenderImageTest.py makes a smaller one",
    r"build/bin/tetmarch-render waves_\S* .*": "takes 2.5 GB; RenderImageTest.py draws a smaller one",
    r"build/bin/tetmarch-render lobster_\S* .*": "the file is to be downloaded",
    "python3 Testing/Benchmark/compare_.*": "Testing/Benchmark/ComparisonTest.py runs them",
    "PYTHONPATH=build/lib/python3/dist-packages /usr/bin/python3 example.py": "ExamplesTest.py pastes it",
    r"(apt-get install [\w+ -]+|python3 -m venv \S* env|env/bin/(pip install \.|python example\.py))":
        "./tetmarch package test-wheel does it in clean roots",
    r"PYTHONPATH=build/lib/python3/dist-packages /usr/bin/python3 Documentation/Examples/light\.py":
        "Testing/Python/ExamplesTest.py runs all examples",
    r"PYTHONPATH=build/lib/python3/dist-packages /usr/bin/python3 Documentation/Examples/gallery/\w+\.py":
        "Testing/Python/GalleryTest.py runs them",
    "PYTHONPATH=build/lib/python3/dist-packages /usr/bin/python3 -m vtktetmarch script.py":
        "Testing/Python/ReplaceUnstructuredTest.py runs one",
    "PYTHONPATH=build/lib/python3/dist-packages mpiexec -n 4 /usr/bin/python3 parallel.py": "ExamplesTest.py pastes it",
    r"python3 Testing/Processes/(measure_(pieces|hidden)\.py FOLDER|simulate_exchange\.py)": "takes ten minutes; PicturesTest.py draws smaller ones",
}
# Pasted with the second in the place of the first: 133 million tetrahedra take minutes.
SMALLER = (("lattice:281,lattice:282", "lattice:11,lattice:12"),
           ("Testing/Benchmark/write_leaves.py shell.vthb",
            f"{PROJECT}/Testing/Benchmark/write_leaves.py shell.vthb --cells 8 --side 4"))
# Of Google Benchmark, pip and ParaView, not of ours.
OTHER_OPTIONS = {"--benchmark_filter", "--config-settings", "--tdx", "--tdy"}
# Programs of tests run by themselves; here they are only asked which tests they would run.
PROGRAM_OF_TESTS = r"\bbuild/bin/TetMarch\w*Tests?\b"


def is_shell(block):
    """Lines of Python that are no whole example begin with an assignment."""
    return (not block.startswith(NO_SHELL) and re.match(r"\w+ = ", block) is None
            and re.match(r"[\w./][\w./-]*[ =]", block) is not None)


def commands(block):
    """The commands of a block, without comments; lines that end with a backslash go on."""
    lines = re.sub(r"\\\n\s*", "", block).splitlines()
    return [line for line in (re.sub(r"(^|\s+)#.*", "", line).strip() for line in lines) if line]


def shell_blocks():
    return [(name_of(page), block) for page in pages()
            for block in indented_blocks(page.read_text(encoding="utf-8")) if is_shell(block)]


def inline_commands():
    return [(name_of(page), word) for page in pages() for word in code_words(page.read_text(encoding="utf-8"))
            if re.match(r"(\./tetmarch|cmake|build/bin/[\w-]+) ", word)]


class CommandsTest(unittest.TestCase):
    def setUp(self):
        self.folder = folder_of_a_user(self, BUILD)

    def paste(self, text):
        result = subprocess.run(["bash", "-euc", text], cwd=self.folder, text=True, capture_output=True, timeout=1000)
        self.assertEqual(result.returncode, 0, f"{text}\n{result.stderr}")
        return result.stdout

    def known_to_the_script(self, command):
        """Whether `./tetmarch help` has the words of the command, up to its first option or value."""
        words = re.match(r"\./tetmarch ((?:bench )?[a-z-]+(?: --stack forky)?)", command).group(1)
        if words not in self.help and words.startswith("bench "):
            words = "bench"
        return re.search(rf"^  {re.escape(words)}\b", self.help, re.MULTILINE)

    @property
    def help(self):
        return subprocess.run([PROJECT / "tetmarch", "help"], text=True, capture_output=True, check=True).stdout

    def check(self, command):
        """Of one command; what is to be pasted is returned."""
        if command.startswith("./tetmarch"):
            self.assertTrue(self.known_to_the_script(command), command)
            options = re.fullmatch(r"\./tetmarch bench (--.*)", command)
            if options and (BUILD / "bin" / "tetmarch-bench").exists():
                return f"build/bin/tetmarch-bench --quick {options.group(1)}\n"
        elif re.search(PROGRAM_OF_TESTS, command):
            if (BUILD / re.search(PROGRAM_OF_TESTS, command).group(0).replace("build/", "")).exists():
                self.assertIn("  ", self.paste(command + " --gtest_list_tests"), "no test has that name")
        elif not any(re.fullmatch(pattern, command) for pattern in NOT_PASTED):
            for large, small in SMALLER:
                command = command.replace(large, small)
            return command + "\n"
        return ""

    def test_blocks(self):
        blocks = shell_blocks()
        self.assertGreater(len(blocks), 10)
        shown = [c for _, block in blocks + inline_commands() for c in commands(block)]
        for pattern in NOT_PASTED:
            self.assertTrue(any(re.fullmatch(pattern, c) for c in shown), f"no page shows {pattern} any more")
        for page, block in blocks:
            with self.subTest(page=page, block=block):
                text = "".join(map(self.check, commands(block)))
                self.paste(text)
                for output in re.findall(r"--(?:output|html|stats|pixel-json|gpu-report) (\S+)", text):
                    # Files of a series have numbers.
                    self.assertTrue(list(self.folder.glob(output.replace(".png", "*.png"))), output)

    def test_inline_commands(self):
        for page, command in inline_commands():
            with self.subTest(page=page, command=command):
                if not re.search(r"\b[A-Z]{3,}\b", command) or command.startswith("./tetmarch"):
                    self.paste(self.check(command))

    def test_demo(self):
        """Its pictures, by the lines that the script has for them."""
        for name in ("DEMO_MESH", "DEMO_IMAGE"):
            with self.subTest(name=name):
                arguments = re.search(rf"^readonly {name}=\((.*?)\)$", text_of("tetmarch"), re.MULTILINE | re.DOTALL)
                words = " ".join(arguments.group(1).split())
                self.paste(f"ROOT={PROJECT}\nbuild/bin/tetmarch-render {words} --output {name}.png")
                self.assertGreater((self.folder / f"{name}.png").stat().st_size, 100000)

    def test_options_exist(self):
        """Those that pages name, of whatever program of ours."""
        known = self.help
        for program in ("tetmarch-render", "tetmarch-bench"):
            if not (BUILD / "bin" / program).exists():
                self.skipTest(f"{program} isn't built")
            known += self.paste(f"build/bin/{program} --help")
        for script in ("compare_pictures.py draw", "compare_times.py"):
            known += self.paste(f"/usr/bin/python3 {PROJECT}/Testing/Benchmark/{script} --help")
        for script in ("GpuCompile/gpu_compile.py", "Mutants/mutants.py"):
            known += self.paste(f"/usr/bin/python3 -B {PROJECT}/Testing/{script} --help")
        for page in pages():
            for word in code_words(page.read_text(encoding="utf-8")):
                if word.startswith(("--", "tetmarch-", "build/bin/tetmarch")):
                    for option in re.findall(r"--[a-z][a-z_-]+", word):
                        with self.subTest(page=name_of(page), option=option):
                            self.assertTrue(option in known or option in OTHER_OPTIONS)


if __name__ == "__main__":
    BUILD = pathlib.Path(sys.argv.pop(1)).resolve()
    os.environ.setdefault("TETMARCH_GL", "egl")
    os.environ["DISPLAY"] = ""
    unittest.main()

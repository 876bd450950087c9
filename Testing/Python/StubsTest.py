# SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
# SPDX-License-Identifier: BSD-3-Clause
"""Types that editors and type checkers read are those of the package."""
import ast
import inspect
import pathlib
import shutil
import subprocess
import sys
import tempfile
import unittest

import vtktetmarch
from vtkmodules.vtkCommonCore import vtkObjectBase
from vtktetmarch import vtkRenderingTetMarch

PACKAGE = pathlib.Path(vtktetmarch.__file__).parent
EXAMPLES = pathlib.Path(__file__).resolve().parents[2] / "Documentation" / "Examples"
NUMBERS = {"bool", "float", "int"}
# Each line is an error, by these words of mypy.
WRONG = {
    'number: int = vtktetmarch.screenshot("a.vtu", filename="a.png")':
        "Incompatible types in assignment",
    "vtktetmarch.vtkTetMarchVolumeMapper().SetErrorTolerance('low')": 'expected "float"',
    'vtktetmarch.figure("a.vtu").sreenshot()': 'has no attribute "sreenshot"; maybe "screenshot"?',
    'vtktetmarch.volume("a.vtu", unit_distance="far")': 'has incompatible type "str"',
    "vtktetmarch.read(3)": 'incompatible type "int"',
}


def parameters(node):
    """Names of parameters, with their defaults as text; None for those without one, and for `...`."""
    arguments = node.args
    positional = arguments.posonlyargs + arguments.args
    defaults = [None] * (len(positional) - len(arguments.defaults)) + arguments.defaults
    found = dict(zip((a.arg for a in positional), defaults))
    if arguments.vararg:
        found["*" + arguments.vararg.arg] = None
    found.update(zip((a.arg for a in arguments.kwonlyargs), arguments.kw_defaults))
    if arguments.kwarg:
        found["**" + arguments.kwarg.arg] = None
    return {name: None if default is None or ast.unparse(default) == "..." else ast.literal_eval(default)
            for name, default in found.items()}


def parameters_in_use(function):
    stars = {inspect.Parameter.VAR_POSITIONAL: "*", inspect.Parameter.VAR_KEYWORD: "**"}
    return {stars.get(p.kind, "") + p.name: p.default for p in inspect.signature(function).parameters.values()}


def wrapped_classes():
    tree = ast.parse((PACKAGE / "vtkRenderingTetMarch.pyi").read_text(encoding="utf-8"))
    return {node.name: node for node in tree.body if isinstance(node, ast.ClassDef)}


class StubsTest(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.tree = ast.parse((PACKAGE / "__init__.pyi").read_text(encoding="utf-8"))

    def check(self, node, function):
        written, used = parameters(node), parameters_in_use(function)
        self.assertEqual(list(written), list(used), node.name)
        for name, default in written.items():
            if default is not None:
                self.assertEqual(default, used[name], f"{node.name}: {name}")

    def test_functions_and_methods_are_those_of_the_package(self):
        names = set()
        for node in self.tree.body:
            if isinstance(node, ast.FunctionDef):
                names.add(node.name)
                self.check(node, getattr(vtktetmarch, node.name))
            elif isinstance(node, ast.ClassDef):
                names.add(node.name)
                for method in (each for each in node.body if isinstance(each, ast.FunctionDef)):
                    member = getattr(getattr(vtktetmarch, node.name), method.name)
                    self.check(method, member.fget if isinstance(member, property) else member)
        self.assertEqual(names, {name for name in vtktetmarch.__all__ if not name.startswith("vtk")})

    def test_public_methods_are_all_there(self):
        (figure,) = [node for node in self.tree.body if getattr(node, "name", "") == "Figure"]
        written = {node.name for node in figure.body if isinstance(node, ast.FunctionDef)}
        self.assertLessEqual({name for name in vars(vtktetmarch.Figure) if not name.startswith("_")}, written)

    def test_wrapped_classes_have_their_members(self):
        classes = wrapped_classes()
        self.assertEqual(set(classes), {name for name in vtktetmarch.__all__ if name.startswith("vtk")})
        for name, node in classes.items():
            written = {each.target.id if isinstance(each, ast.AnnAssign) else each.name for each in node.body}
            used = {member for member in vars(getattr(vtkRenderingTetMarch, name)) if not member.startswith("_")}
            self.assertEqual(written - {"__init__"}, used, name)

    def test_properties_have_values_of_their_types(self):
        """VTK's classes have properties from 9.4 on."""
        found = set()
        for name, node in wrapped_classes().items():
            made = getattr(vtktetmarch, name)()
            for each in (each for each in node.body if isinstance(each, ast.FunctionDef)):
                kind = ast.unparse(each.returns)
                if kind in NUMBERS and "property" in map(ast.unparse, each.decorator_list):
                    self.assertEqual(type(getattr(made, each.name)).__name__, kind, f"{name}.{each.name}")
                    found.add(kind)
        self.assertEqual(found, NUMBERS if hasattr(vtkObjectBase, "class_name") else set())

    def test_everything_public_has_a_docstring(self):
        for name in vtktetmarch.__all__:
            self.assertGreater(len(getattr(vtktetmarch, name).__doc__ or ""), 20, name)
        for name, member in vars(vtktetmarch.Figure).items():
            if not name.startswith("_"):
                self.assertGreater(len(member.__doc__ or ""), 20, name)

    def test_names_are_those_of_the_package(self):
        self.assertLessEqual(set(vtktetmarch.__all__), set(dir(vtktetmarch)))
        with self.assertRaisesRegex(AttributeError, "no attribute 'volum'"):
            vtktetmarch.volum

    def test_the_classes_alone_need_no_numpy(self):
        script = "import sys; sys.modules['numpy'] = None; import vtktetmarch; vtktetmarch.vtkTetMarchVolumeMapper()"
        subprocess.run([sys.executable, "-c", script], check=True, timeout=1000)

    def test_the_package_says_that_it_has_types(self):
        self.assertTrue((PACKAGE / "py.typed").exists())


class TypeCheckerTest(unittest.TestCase):
    def setUp(self):
        if not shutil.which("mypy"):
            self.skipTest("mypy isn't installed")
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)

    def mypy(self, *files):
        run = subprocess.run(["mypy", "--python-executable", sys.executable, "--ignore-missing-imports",
                              "--check-untyped-defs", "--cache-dir", str(self.folder / "cache"), *map(str, files)],
                             capture_output=True, text=True,
                             env={"PATH": "/usr/bin:/bin", "MYPYPATH": str(PACKAGE.parent)}, timeout=1000)
        return run.returncode, run.stdout + run.stderr

    def test_examples_have_no_errors(self):
        for folder, count in ((EXAMPLES, 7), (EXAMPLES / "gallery", 12)):
            code, text = self.mypy(*sorted(folder.glob("*.py")))
            self.assertEqual(code, 0, text)
            self.assertIn(f"no issues found in {count} source files", text)

    def test_errors_are_found(self):
        script = self.folder / "wrong.py"
        script.write_text("import vtktetmarch\n" + "\n".join(WRONG) + "\n")
        _, text = self.mypy(script)
        for line, words in enumerate(WRONG.values(), 2):
            with self.subTest(line=line):
                self.assertRegex(text, rf"wrong.py:{line}: error: .*({words.replace('?', chr(92) + '?')})")


if __name__ == "__main__":
    unittest.main(verbosity=2)

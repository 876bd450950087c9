# SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
# SPDX-License-Identifier: BSD-3-Clause
"""A class of tests that runs in every browser, with every driver of the GL."""
import pathlib
import sys
import tempfile
import unittest

from browsers import BROWSERS, browser


class BrowserCase(unittest.TestCase):
    """self.browser is open for all tests of the class, self.folder is an empty folder for their pages."""

    @classmethod
    def setUpClass(cls):
        cls.folder = pathlib.Path(cls.enterClassContext(tempfile.TemporaryDirectory()))
        cls.browser = cls.enterClassContext(browser(*cls.which))


def in_every_browser(tests, base=BrowserCase):
    """Puts test cases into the module of a class of tests: one for each browser, which self.which names."""
    for which in BROWSERS:
        name = tests.__name__ + "".join(word.capitalize() for word in which)
        case = type(name, (tests, base), {"which": which, "__module__": tests.__module__})
        setattr(sys.modules[tests.__module__], name, case)

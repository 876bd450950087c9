# SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
# SPDX-License-Identifier: BSD-3-Clause
"""The mouse turns the widget's picture in a browser: Jupyter's notebook in Chromium, without a window."""
import base64
import importlib.util
import os
import pathlib
import shutil
import socket
import subprocess
import tempfile
import time
import unittest

import numpy as np

import first_data
import vtktetmarch
from PicturesTest import pixels_of_png

PROGRAMS = "jupyter-notebook", "chromium", "chromedriver"
MODULES = "selenium", "ipykernel", "ipywidgets", "nbformat"
MISSING = [name for name in PROGRAMS if not shutil.which(name)] + \
    [name for name in MODULES if not importlib.util.find_spec(name)]
CODE = f"""
import sys
sys.path.insert(0, {os.path.dirname(os.path.abspath(__file__))!r})
import first_data, vtktetmarch
vtktetmarch.figure(first_data.vectors(), size=(240, 180)).widget()
"""


@unittest.skipIf(MISSING, f"{', '.join(MISSING)} isn't installed: apt-get install jupyter-notebook chromium-driver "
                          "jupyter-nbextension-jupyter-js-widgets python3-selenium")
class MouseTest(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)
        self.port = self.start_server()
        self.browser = self.start_browser()

    def start_server(self):
        import nbformat
        from nbformat import v4
        kernel = {"kernelspec": {"name": "python3", "display_name": "Python 3", "language": "python"}}
        nbformat.write(v4.new_notebook(cells=[v4.new_code_cell(CODE)], metadata=kernel), self.folder / "a.ipynb")
        with socket.socket() as free:
            free.bind(("127.0.0.1", 0))
            port = free.getsockname()[1]
        server = subprocess.Popen(["jupyter-notebook", "--no-browser", "--allow-root", "--ip=127.0.0.1",
                                   f"--port={port}", "--NotebookApp.token=abc", f"--notebook-dir={self.folder}"],
                                  env={**os.environ, "HOME": str(self.folder)}, stderr=subprocess.DEVNULL)
        self.addCleanup(server.wait, 60)
        self.addCleanup(server.terminate)
        return port

    def start_browser(self):
        from selenium import webdriver
        from selenium.webdriver.chrome.service import Service
        options = webdriver.ChromeOptions()
        for argument in ("--headless=new", "--no-sandbox", "--disable-dev-shm-usage", "--window-size=1400,1000"):
            options.add_argument(argument)
        browser = webdriver.Chrome(service=Service(shutil.which("chromedriver")), options=options)
        self.addCleanup(browser.quit)
        return browser

    def wait_for(self, condition, what, seconds=60):
        """Its value."""
        end = time.monotonic() + seconds
        while time.monotonic() < end:
            value = condition()
            if value:
                return value
            time.sleep(0.1)
        self.fail(f"{what} did not come within {seconds} s")

    def notebook(self):
        """Whether the notebook is open, with a kernel."""
        from selenium.common.exceptions import WebDriverException
        try:
            self.browser.get(f"http://127.0.0.1:{self.port}/notebooks/a.ipynb?token=abc")
            return self.wait_for(lambda: self.browser.execute_script(
                "return window.IPython && IPython.notebook.kernel && IPython.notebook.kernel.is_connected()"), "a kernel")
        except WebDriverException:
            return False

    def shows(self, expected):
        """Whether the page shows these pixels, as PNG."""
        source = self.browser.execute_script("var i = document.querySelector('.tetmarch-view img'); return i && i.src")
        if not (source or "").startswith("data:image/png;base64,iV"):
            return False
        path = self.folder / "a.png"
        path.write_bytes(base64.b64decode(source.split(",")[1]))
        return np.array_equal(pixels_of_png(path), expected)

    def test_it_drags_and_turns_its_wheel(self):
        from selenium.webdriver.common.action_chains import ActionChains
        from selenium.webdriver.common.actions.wheel_input import ScrollOrigin
        self.wait_for(self.notebook, "the notebook")
        self.browser.execute_script("IPython.notebook.execute_all_cells()")
        figure = vtktetmarch.figure(first_data.vectors(), size=(240, 180))
        first = figure.screenshot()
        self.wait_for(lambda: self.shows(first), "the first picture")
        area = self.browser.find_element("css selector", ".tetmarch-view div[onpointerdown]")
        ActionChains(self.browser).move_to_element(area).click_and_hold().move_by_offset(20, 10) \
            .move_by_offset(30, 0).release().perform()
        turned = figure.look({"azimuth": -20, "elevation": 4}).screenshot()
        self.wait_for(lambda: self.shows(turned), "the picture that is turned")
        ActionChains(self.browser).scroll_from_origin(ScrollOrigin.from_element(area), 0, -200).perform()
        nearer = figure.look({"azimuth": -20, "elevation": 4, "zoom": 2**0.5}).screenshot()
        self.wait_for(lambda: self.shows(nearer), "the nearer picture")


if __name__ == "__main__":
    unittest.main(verbosity=2)

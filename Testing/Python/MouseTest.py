# SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
# SPDX-License-Identifier: BSD-3-Clause
"""The mouse turns the widget's picture in a browser: Jupyter's notebook or JupyterLab in Chromium, without a window."""
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

# Of each server: further options, the page, whether a kernel runs there, and what runs the cells.
SERVERS = {
    "jupyter-notebook": (["--NotebookApp.token=abc"], "notebooks",
                         "window.IPython && IPython.notebook.kernel && IPython.notebook.kernel.is_connected()",
                         "IPython.notebook.execute_all_cells()"),
    "jupyter-lab": (["--IdentityProvider.token=abc", "--LabApp.expose_app_in_browser=True"], "lab/tree",
                    "window.jupyterapp?.shell.currentWidget?.sessionContext?.session?.kernel?.connectionStatus"
                    " == 'connected'", "jupyterapp.commands.execute('notebook:run-all-cells')"),
}
FOUND = [name for name in SERVERS if shutil.which(name)]
MISSING = [name for name in ("chromium", "chromedriver") if not shutil.which(name)] + \
    [name for name in ("selenium", "ipykernel", "ipywidgets", "nbformat") if not importlib.util.find_spec(name)] + \
    ([] if FOUND else list(SERVERS))
CODE = f"""
import sys
sys.path.insert(0, {os.path.dirname(os.path.abspath(__file__))!r})
import first_data, vtktetmarch
vtktetmarch.figure(first_data.vectors(), size=(240, 180)).widget()
"""


# Gives the picture of the widget as a URL with its bytes.
PICTURE = """
const done = arguments[0], none = () => done(""), img = document.querySelector(".tetmarch-view img");
if (!img || !img.src) return none();
fetch(img.src).then(answer => answer.blob()).then(blob => {
  const reader = new FileReader();
  reader.onload = () => done(reader.result);
  reader.readAsDataURL(blob);
}).catch(none);
"""


@unittest.skipIf(MISSING, f"{', '.join(MISSING)} isn't installed: apt-get install chromium-driver python3-selenium, "
                          "and jupyter-notebook jupyter-nbextension-jupyter-js-widgets, or jupyterlab")
class MouseTest(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)
        self.options, self.page, self.runs, self.run_cells = SERVERS[FOUND[0]]
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
        server = subprocess.Popen([FOUND[0], "--no-browser", "--allow-root", "--ip=127.0.0.1", f"--port={port}",
                                   *self.options], cwd=self.folder, env={**os.environ, "HOME": str(self.folder)},
                                  stderr=subprocess.DEVNULL)
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
            self.browser.get(f"http://127.0.0.1:{self.port}/{self.page}/a.ipynb?token=abc")
            return self.wait_for(lambda: self.browser.execute_script(f"return {self.runs}"), "a kernel")
        except WebDriverException:
            return False

    def shows(self, expected):
        """Whether the page shows these pixels, as PNG."""
        picture = base64.b64decode(self.browser.execute_async_script(PICTURE).partition(",")[2])
        return picture.startswith(b"\x89PNG") and np.array_equal(pixels_of_png(picture), expected)

    def test_it_drags_and_turns_its_wheel(self):
        from selenium.webdriver.common.action_chains import ActionChains
        from selenium.webdriver.common.actions.wheel_input import ScrollOrigin
        self.wait_for(self.notebook, "the notebook")
        self.browser.execute_script(self.run_cells)
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

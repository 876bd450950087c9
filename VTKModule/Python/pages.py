# SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
# SPDX-License-Identifier: BSD-3-Clause
"""A figure as a web page: one file that any browser draws, or a frame in a notebook."""
import html
import os
import warnings

from .checks import checked_path, checked_positive, checked_text, checked_word
from .descriptions import array_title
from .errors import VtkErrors
from .files import write_file
from .vtkRenderingTetMarch import vtkTetMarchWebExporter


def page_of(figure, controls, title):
    """The text of a page. What of the scene is not in it becomes a warning of the figure's method that was called."""
    figure.render()
    exporter = vtkTetMarchWebExporter()
    exporter.SetActiveRenderer(figure.renderer)
    exporter.SetRenderWindow(figure.renderer.GetRenderWindow())
    exporter.SetTitle(title)
    exporter.SetControls(checked_word(controls, ("all", "none"), "controls") == "all")
    with VtkErrors(exporter) as errors:
        text = exporter.WriteToString()
        figure.renderer.GetRenderWindow().ReleaseCurrent()  # another thread may draw the next frame
    if errors:
        raise RuntimeError(str(errors))
    omissions = exporter.GetOmissions().splitlines()
    if figure.transparent:
        omissions.append("The page has no alpha channel: it has the background of the renderer.")
    if omissions:
        warnings.warn(" ".join(omissions), RuntimeWarning, stacklevel=4)
    return text


def title_of(figure, title):
    return array_title(figure.volume) if title is None else checked_text(title, "title is a text or None")


def to_html(figure, path, controls, title):
    """See Figure.to_html()."""
    if path is not None and os.path.splitext(checked_path(path, "path"))[1].lower() not in (".html", ".htm"):
        raise ValueError(f"a page is written as HTML; path ends with .html, not as {path!r}")
    text = page_of(figure, controls, title_of(figure, title))
    if path is None:
        return text
    write_file(text.encode(), path)
    return path


class Page:
    """A figure's page in a notebook. It runs in the browser alone: it needs no kernel, and a saved notebook keeps it.

    text: of the page. height: in pixels. title: a text. The page's script can't reach anything of the notebook.
    """

    def __init__(self, figure, height, controls, title):
        """See Figure.page()."""
        self.height = figure.size[1] if height is None else round(checked_positive(height, "height"))
        self.title = title_of(figure, title)
        self.text = page_of(figure, controls, self.title)

    def __repr__(self):
        return f"<Page: {self.title}, {len(self.text) / 1e6:.1f} MB>"

    def _repr_html_(self):
        return (f'<iframe srcdoc="{html.escape(self.text)}" title="{html.escape(self.title)}" width="100%" '
                f'height="{self.height}" frameborder="0" sandbox="allow-scripts allow-downloads" '
                'allow="fullscreen; clipboard-write"></iframe>')

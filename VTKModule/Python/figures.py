# SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
# SPDX-License-Identifier: BSD-3-Clause
"""A picture of a volume: in a file, as an array, in a notebook, in a window."""
import os

from vtkmodules.vtkRenderingCore import vtkProp, vtkRenderer, vtkRenderWindow, vtkVolume

from . import measures, pages
from .box_axes import BoxAxes, room_of
from .cameras import place_camera, view_of
from .checks import checked_flag, checked_items, checked_number, checked_path, checked_size, checked_text
from .colors import rgb
from .descriptions import array_title, describe
from .display import check_display
from .errors import VtkErrors
from .forks import check_process, note_window
from .pixels import pixels_of, png_bytes, write_png
from .scalar_bar import ScalarBar, share_of
from .volumes import volume as make_volume
from .windows import show_window

SIZE = (900, 600)
BACKGROUND = (0.03, 0.035, 0.05)


class Figure:
    """A volume, a renderer and a camera, drawn without a window on the screen unless show() is called.

    renderer: a vtkRenderer; camera: its vtkCamera; volume: the vtkVolume; size: (width, height) in pixels; transparent:
    whether pictures have an alpha channel in place of the background. All may be changed between pictures. In a
    notebook, a figure shows its picture.
    """

    def __init__(self, data, *arguments, size=SIZE, background=BACKGROUND, camera="iso", transparent=False, **how):
        """data: as in volume(), with its further arguments; or only a vtkVolume. See figure()."""
        self.size = checked_size(size)
        self.transparent = checked_flag(transparent, "transparent")
        self.renderer = vtkRenderer()
        self.renderer.SetBackground(*rgb(background, "background"))
        if isinstance(data, vtkVolume):
            if arguments or how:
                raise TypeError("a vtkVolume is drawn as it is: arrays, functions and properties go to volume()")
            self.volume = data
        else:
            self.volume = make_volume(data, *arguments, **how)
        self.renderer.AddVolume(self.volume)
        self._window = None
        self._error = ""
        self._bar = self._axes = None
        mapper = self.volume.GetMapper()
        if mapper is None:
            raise ValueError("the vtkVolume has no mapper: volume() makes one that has")
        self.look(camera)

    @property
    def camera(self):
        """The vtkCamera of the renderer."""
        return self.renderer.GetActiveCamera()

    @property
    def mapper(self):
        """The mapper of the volume, with all methods of VTK."""
        return self.volume.GetMapper()

    def add(self, *props):
        """Adds actors or other props of VTK to the scene. Returns the figure."""
        for prop in props:
            if not isinstance(prop, vtkProp):
                raise TypeError(f"each of props is a vtkProp, such as a vtkActor, not {prop!r}")
            self.renderer.AddViewProp(prop)
        return self

    def look(self, camera):
        """Places the camera: "iso", "x", "-z", ..., a dict or a vtkCamera, as in figure(). Returns the figure."""
        bar = share_of(self.size) if self._bar else 0.0
        room = room_of(self.size, bar) if self._axes else 1.0
        place_camera(self.camera, camera, self.volume, self.size[0] / self.size[1], bar, room)
        self._looked = camera, view_of(self.camera)
        self.renderer.ResetCameraClippingRange()
        return self

    def _look_again(self):
        """Makes room beside the volume, unless the camera was moved since look()."""
        camera, view = self._looked
        return self.look(camera) if view_of(self.camera) == view else self

    def scalar_bar(self, title=None):
        """Adds a bar with the colours of values at the right, as tetmarch-render --scalar-bar. Returns the figure.

        title: a text; None: the array's name. Another call changes it. The camera makes room for the bar, unless it was
        moved since look(). In a view that draws errors, cells or lookups (view_mode), their legend is in its place.
        """
        title = array_title(self.volume) if title is None else checked_text(title, "title is a text or None")
        if self._bar:
            self._bar.title = title
            return self
        self._bar = ScalarBar(self.renderer, self.volume, title)
        return self._look_again()

    def axes(self, titles="xyz"):
        """Adds axes with coordinates along edges of the data's box, as tetmarch-render --axes. Returns the figure.

        titles: the three axes' names, such as ("lon", "lat", "depth"). Another call changes them. The camera makes room
        for the box and its labels, unless it was moved since look(). There are no axes while some of the box is behind
        the camera.
        """
        what = "titles are texts of three axes"
        titles = [checked_text(title, what) for title in
                  (titles if isinstance(titles, str) else checked_items(titles, what))]
        if len(titles) != 3:
            raise ValueError(f"{what}, not {len(titles)}: {titles!r}")
        if self._axes:
            self._axes.titles = titles
            return self
        self._axes = BoxAxes(self.renderer, self.volume, titles)
        return self._look_again()

    def __repr__(self):
        return f"<Figure: {describe(self.volume)}>"

    def _hidden_window(self):
        check_process()
        if self._window is None:
            check_display()
            self._window = vtkRenderWindow()
            self._window.SetOffScreenRendering(True)
            self._window.SetAlphaBitPlanes(1)
            self._window.AddRenderer(self.renderer)
            note_window(self._window)
        return self._window

    def render(self):
        """Draws a frame. Raises RuntimeError with VTK's errors; warnings become Python's."""
        window = self._hidden_window()
        window.SetSize(*checked_size(self.size))
        self.renderer.ResetCameraClippingRange()
        background = self.renderer.GetBackground()
        if self.transparent:
            self.renderer.SetBackground(0, 0, 0)  # transparent pixels have no colour
        self.renderer.SetBackgroundAlpha(0.0 if self.transparent else 1.0)
        with VtkErrors(self.mapper) as errors:
            window.Render()
            window.ReleaseCurrent()  # another thread may draw the next frame
        self.renderer.SetBackground(background)
        # A mapper reports an error once, and draws nothing as long as it persists.
        if errors:
            self._error = str(errors)
        elif not self._draws_nothing():
            self._error = ""
        if self._error:
            raise RuntimeError(self._error)
        return self

    def _render_small(self):
        """Draws a few pixels, to find errors that do not depend on the size."""
        size, self.size = self.size, (8, 8)
        try:
            self.render()
        finally:
            self.size = size

    def _draws_nothing(self):
        drawn = getattr(self.mapper, "GetNumberOfDraws", None)
        return self.volume.GetVisibility() and drawn is not None and drawn() == 0

    def screenshot(self, filename=None, *, size=None, transparent=None):
        """Draws the scene: an array (height, width, 3) of uint8, the uppermost row first; 4 channels if transparent.

        filename: writes a PNG file, and returns the path. size, transparent: of this picture and the next ones; None:
        as before. Colours are not premultiplied. Raises RuntimeError if the scene can't be drawn.
        """
        if size is not None:
            self.size = checked_size(size)
        if transparent is not None:
            self.transparent = checked_flag(transparent, "transparent")
        if filename is not None and os.path.splitext(checked_path(filename, "filename"))[1].lower() != ".png":
            raise ValueError(f"a picture is written as PNG; filename ends with .png, not as {filename!r}")
        self.render()
        pixels = pixels_of(self._window, self.transparent)
        if filename is None:
            return pixels
        write_png(pixels, filename)
        return filename

    def save(self, path):
        """screenshot() to a file. Returns the path."""
        return self.screenshot(path)

    def to_html(self, path=None, controls="all", title=None):
        """The scene as a web page that any browser with WebGL 2 draws, also without a network: a text.

        path: writes it as a file, and returns the path. controls: "all": a panel with transfer functions, accuracy and
        so on, "none": the picture alone, which the mouse turns as well. title: a text; None: the array's name. What of
        the scene is not in the page becomes a warning. Raises RuntimeError if the scene can't be drawn.
        """
        return pages.to_html(self, path, controls, title)

    def page(self, height=None, controls="all", title=None):
        """to_html() as the last line of a notebook's cell: the page, live without a kernel. See vtktetmarch.pages.Page.

        height: in pixels; None: that of the figure. Its width is the cell's.
        """
        return pages.Page(self, height, controls, title)

    def _repr_png_(self):
        return png_bytes(self.screenshot())

    def show(self, title="TetMarch"):
        """Opens a window: the left button turns, the right one and the wheel zoom, q ends. Returns when closed.

        Raises RuntimeError if the scene can't be drawn.
        """
        checked_text(title, "the title is a text")
        self._render_small()
        self._window.RemoveRenderer(self.renderer)
        self._window.Finalize()
        self._window = None
        self.renderer.SetBackgroundAlpha(1.0)
        show_window(self.renderer, self.size, title)

    def pick(self, x, y):
        """Picks at a pixel, x from the left and y from the top, as picture[y, x] of screenshot().

        A dict: position (three numbers, in the world), value (in the array's unit), cell (its id), block (its flat
        index in a tree, else 0); or None if the volume isn't hit, see vtkTetMarchSettings.SetPickOpacityThreshold().
        """
        check_process()
        width, height = self.size
        x, y = int(checked_number(x, "x")), int(checked_number(y, "y"))
        if not (0 <= x < width and 0 <= y < height):
            raise ValueError(f"the pixel ({x}, {y}) is outside of the picture of {width} x {height}")
        if self._window is None or tuple(self._window.GetSize()) != tuple(self.size):
            self.render()
        with VtkErrors(self.mapper) as errors:
            hit = self.mapper.Pick(self.renderer, self.volume, x, height - 1 - y)
            self._window.ReleaseCurrent()
        if errors:
            raise RuntimeError(str(errors))
        if not hit:
            return None
        return {"position": tuple(self.mapper.GetPickedPosition()), "value": self.mapper.GetPickedScalar(),
                "cell": self.mapper.GetPickedCellId(), "block": self.mapper.GetPickedBlock()}

    def statistics(self):
        """Statistics of the last frame: see vtktetmarch.statistics()."""
        return measures.statistics(self)

    def compare(self):
        """The error of a frame against the ground truth: see vtktetmarch.compare()."""
        return measures.compare_figure(self)

    def widget(self):
        """The picture in a notebook, turned by the mouse, with controls: see vtktetmarch.widgets.FigureWidget."""
        from .widgets import FigureWidget
        return FigureWidget(self)


def figure(data, *arguments, **how):
    """A Figure of data as accepted by volume(), or of a vtkVolume.

    Arguments are those of volume(), and
    size: (width, height) in pixels. background: a colour: a name, "#rrggbb" or three numbers, 0 to 1.
    camera: "iso": obliquely, so that the visible part just fits; "x", "-x", "y", "-y", "z" or "-z": likewise, looking
        along that axis or against it; a vtkCamera; or a dict with any of position, focal_point, view_up, view_angle
        (degrees), parallel_scale, azimuth, elevation (degrees), zoom.
    transparent: whether pictures have an alpha channel in place of the background.
    """
    return Figure(data, *arguments, **how)


def screenshot(data, *arguments, filename=None, **how):
    """A picture of figure(): an array (height, width, 3 or 4) of uint8; the path, if `filename` is given."""
    return figure_of(data, *arguments, **how).screenshot(filename)


def compare(data, *arguments, **how):
    """The error of a picture against the ground truth, which the CPU computes in double precision; this is slow.

    data and other arguments: as in figure(). If data is a Figure, one frame of it is drawn.
    Returns a dict: rms, max, mean and minimum of the largest error of a channel, 0 to 1, over the pixels whose ray met
    the volume; pixels: their number; percentiles: {50: ..., 90: ..., 99: ..., 99.9: ...}; error_bound: the same for the
    bound; statistics: those of that frame, see statistics(). Raises RuntimeError if there is nothing to compare.
    """
    return figure_of(data, *arguments, **how).compare()


def show(data, *arguments, **how):
    """Opens a window with the arguments of figure(), or with a Figure. Returns when it is closed."""
    figure_of(data, *arguments, **how).show()


def figure_of(data, *arguments, **how):
    """A Figure itself, or one with the arguments of figure()."""
    if isinstance(data, Figure):
        if arguments or how:
            raise TypeError("a Figure is drawn as it is: arguments go to figure()")
        return data
    return Figure(data, *arguments, **how)

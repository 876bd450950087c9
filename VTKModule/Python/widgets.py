# SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
# SPDX-License-Identifier: BSD-3-Clause
"""A figure in a notebook that is turned by the mouse, with controls beside it."""
import asyncio
import itertools
import math

from vtkmodules.vtkRenderingCore import vtkCamera

from .colors import color_function, map_names
from .measures import mapper_of, statistics
from .opacities import nodes_of, piecewise_function
from .pixels import jpeg_bytes, png_bytes
from .volumes import configure

try:
    import ipywidgets

    from .mouse import Mouse
except ImportError as error:
    raise ImportError(f"a widget needs ipywidgets ({error}): apt-get install python3-ipywidgets") from None

AT_REST = 0.3  # seconds without a change, until the full picture is drawn
GATHERING = 0.01  # seconds in which changes that have already come are put together
COARSE_RATE = 20.0  # pictures a second while something changes
DEGREES_PER_PIXEL = 0.4
PIXELS_PER_DOUBLING = 400.0  # of the wheel
TOLERANCES = [1 / 16, 1 / 64, 1 / 255, *(2.0**-power for power in range(10, 17, 2))]
GIVEN = "as given"
STEPS = 48  # of the drawn functions
NUMBERS = itertools.count()  # names for what is drawn: a page may have several


def slider(name, value, low, high, step):
    return ipywidgets.FloatSlider(description=name, value=value, min=low, max=high, step=step)


def running_loop():
    """The event loop in which this is called, or None: a kernel has one, a script has none."""
    try:
        return asyncio.get_running_loop()
    except RuntimeError:
        return None


def text_of(function):
    """A vtkPiecewiseFunction as "value opacity, value opacity, ..."."""
    return ", ".join(f"{value:.5g} {opacity:.5g}" for value, opacity in nodes_of(function))


def function_of(text):
    """The vtkPiecewiseFunction of such a text. Raises ValueError."""
    try:
        pairs = [tuple(map(float, pair.split())) for pair in text.split(",")]
        return piecewise_function(pairs, 0, 1)
    except ValueError as error:
        raise ValueError(f"opacity is written as pairs, value opacity, value opacity: {error}") from None


def drawing_of(color, opacity, width=300, height=60):
    """Colours below the curve of the opacity, as SVG."""
    name = f"tetmarch-colors-{next(NUMBERS)}"
    low, high = color.GetRange()
    shares = [i / STEPS for i in range(STEPS + 1)]
    values = [low + (high - low) * share for share in shares]
    stops = "".join(f'<stop offset="{share:.3f}" stop-color="rgb({r:.0f},{g:.0f},{b:.0f})"/>' for share, (r, g, b) in
                    ((share, [255 * c for c in color.GetColor(v)]) for share, v in zip(shares, values)))
    curve = " ".join(f"{share * width:.1f},{(1 - opacity.GetValue(value)) * height:.1f}"
                     for share, value in zip(shares, values))
    return (f'<svg width="{width}" height="{height + 16}"><defs><linearGradient id="{name}">{stops}</linearGradient>'
            f'</defs><polygon points="0,{height} {curve} {width},{height}" fill="url(#{name})" stroke="#888"/>'
            f'<text y="{height + 13}" font-size="12">{low:.4g}</text><text x="{width}" y="{height + 13}" '
            f'font-size="12" text-anchor="end">{high:.4g}</text></svg>')


class FigureWidget(ipywidgets.HBox):
    """A Figure's picture with controls, for Jupyter; needs ipywidgets, from version 6 on, and nothing else.

    Dragging turns the camera about its focal point, from where it was when the widget was made, and the wheel zooms.
    The controls are attributes with a `value`, and can be set in Python, too:
    azimuth, elevation: in degrees. zoom, exposure: powers of 2; exposure divides the unit distance.
    tolerance: of a channel, 0 to 1. colors: the name of a colour map. opacity: "value opacity, value opacity, ...".
    shade, shadows: bool. ambient, diffuse, specular: of the light.
    info: the seconds of the picture that is seen, and the bound of its error. frames: number of pictures so far.

    In a kernel, changes draw a coarse picture (rays some pixels apart, JPEG) as soon as the kernel is free, and the
    full one (PNG), that of figure.screenshot(), after 0.3 s without a change. Changes that come while a picture is
    drawn share the next one. Without an event loop each change draws the full picture at once.
    """

    def __init__(self, figure):
        mapper_of(figure)
        self.figure = figure
        self.frames = 0  # that were drawn
        self._soon = self._later = None
        self._start = vtkCamera()
        self._start.DeepCopy(figure.camera)
        of_volume = figure.volume.GetProperty()
        width, height = figure.size
        self.picture = ipywidgets.Image(format="png", width=str(width), height=str(height))
        self.info = ipywidgets.HTML()
        self.azimuth = slider("azimuth", 0.0, -180.0, 180.0, 1.0)
        self.elevation = slider("elevation", 0.0, -89.0, 89.0, 1.0)
        self.zoom = slider("zoom, 2^", 0.0, -3.0, 5.0, 0.05)
        self.exposure = slider("exposure, 2^", 0.0, -6.0, 6.0, 0.1)
        tolerance = min(TOLERANCES, key=lambda each: abs(math.log(each / figure.mapper.GetErrorTolerance())))
        self.tolerance = ipywidgets.SelectionSlider(
            description="tolerance", value=tolerance, options=[(f"1/{1 / each:.0f}", each) for each in TOLERANCES])
        self.shade = ipywidgets.Checkbox(description="light", value=bool(of_volume.GetShade()))
        self.shadows = ipywidgets.Checkbox(description="shadows", value=figure.mapper.GetShadowMethod() != 0)
        self.ambient = slider("ambient", of_volume.GetAmbient(), 0.0, 1.0, 0.05)
        self.diffuse = slider("diffuse", of_volume.GetDiffuse(), 0.0, 2.0, 0.05)
        self.specular = slider("specular", of_volume.GetSpecular(), 0.0, 1.0, 0.05)
        self.colors = ipywidgets.Dropdown(description="colours", value=GIVEN, options=[GIVEN, *map_names()])
        self.opacity = ipywidgets.Text(description="opacity", value=text_of(of_volume.GetScalarOpacity()))
        self.functions = ipywidgets.HTML()
        self._connect(of_volume)
        controls = [self.info, self.azimuth, self.elevation, self.zoom, self.exposure, self.tolerance, self.colors,
                    self.opacity, self.functions, self.shade, self.shadows, self.ambient, self.diffuse, self.specular]
        self.mouse = Mouse(self.picture, width, height, self._turn)
        super().__init__([self.mouse, ipywidgets.VBox(controls)])
        self._draw_functions()
        self.draw()

    def _connect(self, of_volume):
        given = of_volume.GetRGBTransferFunction()
        distances = [of_volume.GetScalarOpacityUnitDistance(i) for i in range(4)]

        def expose(stops):
            for i, distance in enumerate(distances):
                of_volume.SetScalarOpacityUnitDistance(i, distance / 2**stops)

        def set_colors(name):
            of_volume.SetColor(given if name == GIVEN else color_function(name, *given.GetRange()))
            self._draw_functions()

        def set_opacity(text):
            of_volume.SetScalarOpacity(function_of(text))
            self._draw_functions()

        def set_property(name):
            return lambda value: configure(self.figure.volume, **{name: value})

        for control, apply in (
                (self.azimuth, None), (self.elevation, None), (self.zoom, None), (self.exposure, expose),
                (self.tolerance, lambda value: configure(self.figure.volume, accuracy_level="default",
                                                         error_tolerance=value)),
                (self.shadows, lambda on: configure(self.figure.volume, shadow_method="automatic" if on else "off")),
                (self.colors, set_colors), (self.opacity, set_opacity), (self.shade, set_property("shade")),
                (self.ambient, set_property("ambient")), (self.diffuse, set_property("diffuse")),
                (self.specular, set_property("specular"))):
            control.observe(self._applier(apply), names="value")

    def _applier(self, apply):
        def changed(change):
            try:
                if apply:
                    apply(change["new"])
            except ValueError as error:
                self._tell(error)
            else:
                self._ask()
        return changed

    def _turn(self, x, y, wheel):
        self.azimuth.value = (self.azimuth.value - DEGREES_PER_PIXEL * x + 180) % 360 - 180
        self.elevation.value = min(max(self.elevation.value + DEGREES_PER_PIXEL * y, -89), 89)
        self.zoom.value = min(max(self.zoom.value - wheel / PIXELS_PER_DOUBLING, -3), 5)

    def _ask(self):
        """Asks for a picture. Changes that come before it is drawn, or while one is drawn, share the next."""
        loop = running_loop()
        if loop is None:
            self.draw()
        elif self._soon is None:
            self._soon = loop.call_later(GATHERING, self._draw_coarse)

    def _draw_coarse(self):
        self._cancel()
        self._frame(COARSE_RATE)
        self._later = running_loop().call_later(AT_REST, self.draw)

    def _cancel(self):
        for call in (self._soon, self._later):
            if call is not None:
                call.cancel()
        self._soon = self._later = None

    def draw(self):
        """Draws the full picture now, with the values of all controls: that of figure.screenshot()."""
        self._cancel()
        self._frame(0)

    def _frame(self, rate):
        """rate: pictures a second, as fast as which rays are left out; 0: all rays are marched, and measured."""
        camera, mapper = self.figure.camera, self.figure.mapper
        camera.DeepCopy(self._start)
        camera.Azimuth(self.azimuth.value)
        camera.Elevation(self.elevation.value)
        camera.OrthogonalizeViewUp()
        camera.Zoom(2**self.zoom.value)
        collects, window = mapper.GetCollectDiagnostics(), self.figure.renderer.GetRenderWindow()
        before = window.GetDesiredUpdateRate() if window else 0
        try:
            mapper.SetCollectDiagnostics(collects or not rate)
            if rate and window:
                window.SetDesiredUpdateRate(rate)
            pixels = self.figure.screenshot()
        except RuntimeError as error:
            self._tell(error)
            return
        finally:
            mapper.SetCollectDiagnostics(collects)
            if window:
                window.SetDesiredUpdateRate(before)
        self.frames += 1
        lossy = rate and not self.figure.transparent
        self.picture.format = "jpeg" if lossy else "png"
        self.picture.value = jpeg_bytes(pixels) if lossy else png_bytes(pixels)
        self._tell_of(statistics(self.figure))

    def _tell_of(self, frame):
        distance, bound = frame["used_image_sample_distance"], frame["error_bound"]
        if distance > 1:
            error = f"rays are {distance:.1f} pixels apart"
        elif bound is None:
            error = "the error is measured at rest"
        else:
            error = f"no channel is off by more than {bound['max']:.2g}"
        self.info.value = f"<b>{frame['seconds']:.3f} s</b>, {error}"

    def _tell(self, error):
        message = str(error).replace("&", "&amp;").replace("<", "&lt;")
        self.info.value = f'<span style="color:#c33">{message}</span>'

    def _draw_functions(self):
        of_volume = self.figure.volume.GetProperty()
        self.functions.value = drawing_of(of_volume.GetRGBTransferFunction(), of_volume.GetScalarOpacity())

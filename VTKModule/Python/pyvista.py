# SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
# SPDX-License-Identifier: BSD-3-Clause
"""PyVista: plotter.add_volume(data, mapper="tetmarch") and data.tetmarch.plot() exist once this module is imported.

PyVista's own add_volume() does the work, with its arguments and defaults; mappers and data are ours.
"""
import functools
import inspect
import itertools
import types

import numpy as np
import pyvista
from vtkmodules.vtkCommonDataModel import (vtkCompositeDataSet, vtkExplicitStructuredGrid, vtkImageData,
                                           vtkRectilinearGrid, vtkStructuredGrid, vtkUnstructuredGrid)

from .checks import checked_number, checked_positive
from .inputs import blocks_of, drawn_data, is_structured, joined
from .pyvista_classes import (NAN, ExactImageData, ExactRectilinearGrid, ExactUnstructuredGrid,
                              TetMarchSmartVolumeMapper, TetMarchVolume, TetMarchVolumeMapper, TetMarchVolumeProperty)

MAPPER = "tetmarch"
ALIASES = ("rng", "colormap", "backface_culling", "scalar")  # arguments that PyVista takes, and that aren't in its list
EXACT = {vtkImageData: ExactImageData, vtkRectilinearGrid: ExactRectilinearGrid,
         vtkUnstructuredGrid: ExactUnstructuredGrid}
BLOCK_COLORS = ("Reds", "Greens", "Blues", "Greys", "Oranges", "Purples")  # of multi_colors
HELP = '''

With ``mapper="tetmarch"`` rays are marched from cell to cell: cells of all types and values of cells are drawn as they
are, with a bounded error. The default of ``opacity_unit_distance`` is that of images for all data, with the cube root
of the number of points as dimension. Further arguments are then ``nan_color`` and ``nan_opacity`` (cells with NaN
aren't drawn without them), and all of ``vtktetmarch.configure()``. A MultiBlock without ``multi_colors`` is one volume,
in a list; its surfaces are left out.
'''

owner = next(cls for cls in pyvista.Plotter.__mro__ if "add_volume" in vars(cls))
original = owner.add_volume
signature = inspect.signature(original)
choice = types.SimpleNamespace(is_default=False)


def with_classes(function, **classes):
    """The same function, in whose module other classes have these names. The module itself isn't changed."""
    missing = sorted(classes.keys() - function.__globals__.keys())
    if missing:
        raise ImportError(f"PyVista {pyvista.__version__} draws volumes in another way than vtktetmarch.pyvista knows: "
                          f"its add_volume() has no {', '.join(missing)}; versions like 0.48 have")
    made = types.FunctionType(function.__code__, {**function.__globals__, **classes}, function.__name__,
                              function.__defaults__, function.__closure__)
    made.__kwdefaults__ = function.__kwdefaults__
    return made


def add_by_pyvista(volume_class, **arguments):
    """PyVista's add_volume() with our classes."""
    return with_classes(inspect.unwrap(original), SmartVolumeMapper=TetMarchSmartVolumeMapper,
                        UnstructuredGridVolumeRayCastMapper=TetMarchVolumeMapper, Volume=volume_class,
                        VolumeProperty=TetMarchVolumeProperty)(**arguments)


def exact(data, active=None):
    """A shallow copy that add_volume() doesn't resample, with the active scalars of `active`, a data set of PyVista."""
    made = next(cls for kind, cls in EXACT.items() if isinstance(data, kind))()
    made.ShallowCopy(data)
    name = getattr(active, "active_scalars_name", None)
    if name is not None and name in made.array_names:
        made.set_active_scalars(name, active.active_scalars_info.association.name.lower())
    return made


def exact_tree(blocks, given):
    """The first of several images or rectilinear grids, which stands for all. Chooses `clim` for all of them."""
    first = next((block for block in blocks if block.active_scalars_name is not None), blocks[0])
    made = exact(first, first)
    made._blocks = blocks
    name = given.get("scalars")
    if name is None:
        association, name = first.active_scalars_info
        given.update(scalars=name, preference=association.name.lower())
    elif not isinstance(name, str):
        raise TypeError(f"scalars of blocks is the name of an array, not {type(name).__name__}")
    values = [block[name] for block in blocks if name in block.array_names]
    if given.get("clim") is None and values:
        given["clim"] = (min(np.nanmin(each) for each in values), max(np.nanmax(each) for each in values))
    return made


def drawn_by_pyvista(volume, given):
    """What PyVista's add_volume() is given: data that it doesn't resample, or what it refuses by itself."""
    if isinstance(volume, vtkCompositeDataSet):
        blocks = [pyvista.wrap(block) for block in blocks_of(drawn_data(volume))]
        made = exact_tree(blocks, given) if is_structured(volume) else exact(joined(blocks), blocks[0])
    elif isinstance(volume, (vtkStructuredGrid, vtkExplicitStructuredGrid)) and min(volume.dimensions) > 1:
        blocks, made = [volume], exact(joined([volume]), volume)
    elif isinstance(volume, tuple(EXACT)) and isinstance(volume, pyvista.DataSet):
        blocks, made = [volume], exact(volume, volume)
    else:
        return volume
    if given.get("opacity_unit_distance") is None and (made._blocks or isinstance(made, vtkUnstructuredGrid)):
        given["opacity_unit_distance"] = unit_distance(blocks)
    return made


def unit_distance(blocks):
    """The diagonal over the number of steps along it, as PyVista's default is for images."""
    bounds = np.array([block.bounds for block in blocks])
    diagonal = np.linalg.norm(bounds[:, 1::2].max(axis=0) - bounds[:, ::2].min(axis=0))
    points = sum(block.n_points for block in blocks)
    return diagonal / (np.cbrt(points) - 1) if diagonal > 0 and points > 1 else None


def add_blocks(plotter, given, others):
    """Each block of a MultiBlock as a volume with colours of its own."""
    name = given.pop("name", None)
    blocks = blocks_of(drawn_data(given.pop("volume")))
    named = {**given, **others, "mapper": MAPPER}
    return [plotter.add_volume(pyvista.wrap(block), **{**named, "cmap": colors,
                                                       "name": None if name is None else f"{name}-{number}"})
            for number, (block, colors) in enumerate(zip(blocks, itertools.cycle(BLOCK_COLORS)))]


def chosen_nan_color(plotter, color, opacity):
    """A pyvista.Color, or None if neither colour nor opacity are given."""
    if color is None and opacity is None:
        return None
    if opacity is not None and not 0 <= checked_number(opacity, "nan_opacity") <= 1:
        raise ValueError(f"nan_opacity is 0 to 1, not {opacity!r}")
    try:
        return pyvista.Color(plotter.theme.nan_color if color is None else color,
                             opacity=None if opacity is None else float(opacity))
    except (TypeError, ValueError) as error:
        raise type(error)(f"nan_color is a colour of PyVista: {error}") from None


@functools.wraps(original)
def add_volume(self, *arguments, **named):
    given = dict(signature.bind(self, *arguments, **named).arguments)
    mapper = given.get("mapper")
    if not (choice.is_default if mapper is None else isinstance(mapper, str) and mapper == MAPPER):
        return original(self, *arguments, **named)
    others = given.pop("kwargs", {})
    volume = given["volume"]
    is_tree = isinstance(volume, vtkCompositeDataSet)
    if is_tree and given.get("multi_colors"):
        del given["self"]
        return add_blocks(self, given, others)
    own = {name: others.pop(name) for name in [*others] if name not in ALIASES}
    if given.get("opacity_unit_distance") is not None:
        checked_positive(given["opacity_unit_distance"], "opacity_unit_distance")
    nan_color = chosen_nan_color(self, *(own.pop(name, None) for name in NAN))
    if nan_color is not None:
        own.setdefault("draw_nan_cells", True)
    given["volume"] = drawn_by_pyvista(volume, given)
    given["mapper"] = "smart"  # PyVista's choice is another one for unstructured grids
    actor = add_by_pyvista(functools.partial(TetMarchVolume, own, nan_color, tuple(signature.parameters)), **given,
                           **others)
    return [actor] if is_tree else actor


def make_default(is_default=True):
    """Whether add_volume() without `mapper`, or with None, takes ours; False: the theme's, as PyVista does."""
    choice.is_default = bool(is_default)


class Accessor:
    """data.tetmarch of PyVista's data sets and blocks."""

    def __init__(self, data):
        self._data = data

    def plot(self, **arguments):
        """Draws the data as a volume in a window, or as the arguments say. Returns what pyvista.plot() returns.

        arguments: those of pyvista.plot(), as off_screen, window_size, cpos, screenshot and return_img, and those of
        Plotter.add_volume() with mapper="tetmarch".
        """
        return pyvista.plot(self._data, volume=True, mapper=MAPPER, **arguments)


def register_accessor():
    """Adds `tetmarch` to PyVista's data."""
    if hasattr(pyvista, "register_dataset_accessor"):  # from PyVista 0.48 on
        for kind in (pyvista.DataSet, pyvista.MultiBlock):
            pyvista.register_dataset_accessor(MAPPER, kind)(Accessor)
    else:
        for kind in (pyvista.DataSet, pyvista.MultiBlock):
            setattr(kind, MAPPER, property(Accessor))


add_volume.__doc__ = inspect.getdoc(original) + HELP
with_classes(inspect.unwrap(original), SmartVolumeMapper=None, UnstructuredGridVolumeRayCastMapper=None, Volume=None,
             VolumeProperty=None)
owner.add_volume = add_volume
register_accessor()

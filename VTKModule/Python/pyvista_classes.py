# SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
# SPDX-License-Identifier: BSD-3-Clause
"""PyVista's data sets, mappers, volume and property as add_volume() of vtktetmarch.pyvista uses them."""
import difflib

import pyvista
from pyvista.plotting.mapper import _BaseVolumeMapper
from pyvista.plotting.volume import Volume
from pyvista.plotting.volume_property import VolumeProperty
from vtkmodules.vtkCommonDataModel import vtkMultiBlockDataSet

from .properties import copy_properties, property_names
from .volumes import configure
from .vtkRenderingTetMarch import vtkTetMarchSmartVolumeMapper, vtkTetMarchVolumeMapper

SPECIAL = ("clipping_planes", "gradient_opacity", "isosurface_values")  # of configure()
NAN = ("nan_color", "nan_opacity")


class Exact:
    """A data set that is drawn as it is: values of cells are not averaged to points, cells not decomposed."""

    _blocks = ()  # drawn in place of the data set, which is one of them

    def cell_data_to_point_data(self, *_, **_named):
        """The data set itself."""
        return self

    def triangulate(self, *_, **_named):
        """The data set itself."""
        return self

    def __setitem__(self, name, values):
        """Adds an array where it belongs, and removes one of its name from the others: the name is then unique."""
        cells = getattr(getattr(values, "association", None), "name", "") == "CELL" or len(values) != self.n_points
        kept, other = (self.cell_data, self.point_data) if cells else (self.point_data, self.cell_data)
        if len(values) in (self.n_points, self.n_cells) and name in other:
            other.remove(name)
        if cells and len(values) == self.n_cells:
            kept[name] = values
        else:
            super().__setitem__(name, values)


class ExactImageData(Exact, pyvista.ImageData):
    """An image that is drawn as it is."""


class ExactRectilinearGrid(Exact, pyvista.RectilinearGrid):
    """A rectilinear grid that is drawn as it is."""


class ExactUnstructuredGrid(Exact, pyvista.UnstructuredGrid):
    """An unstructured grid that is drawn as it is."""


class VolumeMapper(_BaseVolumeMapper):
    """What both of our mappers add to PyVista's."""

    _one_of_blocks = None

    @property
    def dataset(self):
        """The data set that is drawn; one of them for blocks."""
        return _BaseVolumeMapper.dataset.fget(self) if self._one_of_blocks is None else self._one_of_blocks

    @dataset.setter
    def dataset(self, data):
        _BaseVolumeMapper.dataset.fset(self, data)
        if isinstance(data, Exact):
            association, name = data.active_scalars_info
            self.scalar_map_mode = association.name.lower()
            if data._blocks:
                self._one_of_blocks = data
                self.SetInputDataObject(tree_of(data._blocks, association, name))

    def copy(self):
        """A mapper of the same data with the same settings, which are its own."""
        made = super().copy()
        copy_properties(self.GetSettings(), made.GetSettings())
        copy_properties(self, made)
        return made


class TetMarchSmartVolumeMapper(VolumeMapper, vtkTetMarchSmartVolumeMapper):
    """A vtkTetMarchSmartVolumeMapper as a mapper of PyVista."""


class TetMarchVolumeMapper(VolumeMapper, vtkTetMarchVolumeMapper):
    """A vtkTetMarchVolumeMapper as a mapper of PyVista."""


class TetMarchVolumeProperty(VolumeProperty):
    """A property that takes the colour and opacity of NaN from the lookup table, too."""

    def apply_lookup_table(self, lookup_table):
        """Sets colours and opacities to those of a pyvista.LookupTable."""
        super().apply_lookup_table(lookup_table)
        *color, opacity = lookup_table.GetNanColor()
        self.GetRGBTransferFunction().SetNanColor(*color)
        self.GetRGBTransferFunction().SetNanOpacity(opacity)


class TetMarchVolume(Volume):
    """A volume that gets properties of ours together with its vtkVolumeProperty, before it is added to a scene."""

    def __init__(self, properties=None, nan_color=None, known=()):
        """properties: of configure(). nan_color: a pyvista.Color or None. known: names to suggest for unknown ones."""
        super().__init__()
        self._properties, self._nan_color, self._known = properties or {}, nan_color, known

    @property
    def prop(self):
        """The vtkVolumeProperty."""
        return self.GetProperty()

    @prop.setter
    def prop(self, made):
        self.SetProperty(made)
        if self._nan_color is not None:
            self.mapper.lookup_table.SetNanColor(*self._nan_color.float_rgba)
        self._check_names()
        configure(self, **self._properties)

    def _check_names(self):
        mapper = self.GetMapper()
        names = [*property_names((mapper, mapper.GetSettings(), self.GetProperty(), self)), *SPECIAL]
        plain = {name.replace("_", "") for name in names}
        for name in self._properties:
            if name.replace("_", "").lower() not in plain:
                near = difflib.get_close_matches(name, [*self._known, *NAN, *names], 3)
                hint = f"; did you mean {' or '.join(map(repr, near))}?" if near else ""
                raise TypeError(f"add_volume() has no argument {name!r}{hint}")


def tree_of(blocks, association, name):
    """A vtkMultiBlockDataSet of shallow copies of blocks, whose active scalars have this name, or are none."""
    tree = vtkMultiBlockDataSet()
    for number, block in enumerate(blocks):
        copy = block.NewInstance()
        copy.ShallowCopy(block)
        attributes = copy.GetCellData() if association.name == "CELL" else copy.GetPointData()
        attributes.SetActiveScalars(name if attributes.HasArray(name) else None)
        tree.SetBlock(number, copy)
    return tree

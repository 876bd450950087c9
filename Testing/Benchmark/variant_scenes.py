# SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
# SPDX-License-Identifier: BSD-3-Clause
"""The scene that calls for a variant of the shader: each feature is something that a user sets."""
import numpy as np
import vtkmodules.all as vtk
import made_grids as grids
import made_images as images
from vtkmodules.util.numpy_support import numpy_to_vtk
from vtktetmarch import vtkTetMarchSmartVolumeMapper, vtkTetMarchVolumeMapper

# What a variant may have; TETMARCH_HAS_FMA is the driver's choice.
FEATURES = frozenset("""
    POINT_SCALARS ENTRY_LISTS BVH OPAQUE_DEPTH ADAPTIVE DIAGNOSTICS PEELED TRANSPARENT_RANGES CONSTANT_COLOR
    CLIPPED CROPPED NAN_SHOWN HIDDEN_CELLS EXTREME SUM ISOSURFACES INDEPENDENT COLOR_AND_OPACITY DIRECT_COLOR
    CELL_GRADIENTS GRADIENT_OPACITY SHADING HEADLIGHT_ONLY SINGLE_LIGHT FEW_LIGHTS WORLD_LIGHTS SCATTERING CAST_SHADOWS
    SEVERAL_SHADOWS SAMPLED_SHADOWS LIGHT_TOLERANCE LIGHT_THROUGH_CUTS OPAQUE_SHADOWS HEADLIGHT_SHADOWS OCCLUSION
    SHOW_ILLUMINATION SHOW_GRADIENTS STRUCTURED RECTILINEAR OCTREE LEAPS POINT_SAMPLED SLABS MANY_SLABS VISIBLE_PART
    REENTERED CURVILINEAR JOINED_SIDES CURVED_ERROR CORNER_SCALARS
    """.split())
ARRAY = "field"
CUBES = 4
CELLS = 16  # of a lattice, along each axis: four blocks or more
CELLS_OF_BLOCK = 3  # one block, also if half cells are added at both ends
BEND = np.array([0.01, -0.02, 0.015])  # of curved edges
VISIBLE_FROM = 0.8  # along x of a mesh of which a part is visible: its last layer of cubes
MOST_LAYERS = 2048  # of a texture of Mesa: more make two textures a component
SAMPLE_DISTANCE = 0.02
HIDDEN_CELL = 32  # vtkDataSetAttributes::HIDDENCELL


class VariantScene:
    """Mapper, volume, actors, lights and camera for a set of features.

    Where several things call for the same feature (two blend modes, say), the scene's number chooses among them.
    """

    def __init__(self, features, number):
        unknown = features - FEATURES
        if unknown:
            raise ValueError(f"no scene is known for {sorted(unknown)}")
        self.features, self.number = features, number
        if self.is_lattice():
            self.mapper = vtkTetMarchSmartVolumeMapper()
            self.mapper.InteractiveAdjustSampleDistancesOff()
        else:
            self.mapper = vtkTetMarchVolumeMapper()
        self.mapper.AutoAdjustSampleDistancesOff()
        self.volume = vtk.vtkVolume()
        self.volume.SetMapper(self.mapper)
        self.property = self.volume.GetProperty()
        self.property.SetScalarOpacityUnitDistance(0.3)
        self.renderer = vtk.vtkRenderer()
        self.renderer.SetBackground(0.2, 0.3, 0.1)
        self.renderer.AutomaticLightCreationOff()
        self.renderer.AddVolume(self.volume)
        set_data = self.set_trees if self.has("OCTREE") else self.set_lattice if self.is_lattice() else self.set_grid
        for step in (set_data, self.set_functions, self.set_blending, self.set_surfaces, self.set_cuts,
                     self.set_effects, self.set_lights, self.set_quality, self.set_camera):
            step()

    def has(self, feature):
        return feature in self.features

    def one_of(self, *choices):
        return choices[self.number % len(choices)]

    # --- Data ------------------------------------------------------------------------------------

    def is_lattice(self):
        return self.has("STRUCTURED") and not self.has("OCTREE")

    def components(self):
        if self.has("INDEPENDENT"):
            return self.one_of(2, 3, 4)
        return 2 if self.has("COLOR_AND_OPACITY") else 4 if self.has("DIRECT_COLOR") else 1

    def is_reentered(self):
        return self.has("BVH") or self.has("REENTERED") and not self.has("VISIBLE_PART")

    def make_grid(self):
        if self.has("CURVILINEAR"):
            joined = self.has("JOINED_SIDES")
            places = grids.lattice_points(CUBES, grids.JITTER / 3 if joined else grids.JITTER, 1)
            if self.is_reentered():  # not convex
                places[:, 1] += 0.2 * np.sin(np.pi * places[:, 0])
            if joined:  # one side becomes an edge
                edge = places[:, 0] == 0
                places[edge, 2] = grids.lattice_points(CUBES, 0, 1)[edge, 2]
                places[:, 1] = 0.5 + (places[:, 1] - 0.5) * places[:, 0]
            return grids.curvilinear(places, CUBES)
        return grids.lattice(CUBES, grids.outside_a_hole if self.is_reentered() else None)

    def set_grid(self):
        grid = self.make_grid()
        if self.has("POINT_SCALARS"):
            data, places = grid.GetPointData(), grids.points_of(grid)
            self.mapper.SetScalarModeToUsePointFieldData()
        else:
            data, places = grid.GetCellData(), grids.cell_centres_of(grid)
            self.mapper.SetScalarModeToUseCellFieldData()
        values = np.stack([grids.waves(places, 0.8 + 0.2 * k, k) for k in range(self.components())], axis=1)
        if self.has("VISIBLE_PART"):
            # Of most of the mesh nothing is seen, and all of the rest is.
            values = np.where(places[:, :1] < VISIBLE_FROM, 0.2, 0.6 + 0.28 * values)
        elif self.has("TRANSPARENT_RANGES") or self.has("ISOSURFACES"):
            # Next to each value of which nothing is seen there is one that is seen.
            unseen = np.arange(len(values))[:, np.newaxis] % 2 == 0
            values = np.where(unseen, 0.2 + 0.1 * values, 0.6 + 0.28 * values)
        if self.has("NAN_SHOWN"):
            # Of odd numbers, which are those that are seen above; or of those in the part that is visible.
            visible = np.flatnonzero(places[:, 0] > (VISIBLE_FROM if self.has("VISIBLE_PART") else -1))
            values[visible[5::28]] = np.nan
        if self.has("JOINED_SIDES") and self.has("POINT_SCALARS"):
            _, first, group = np.unique(places, axis=0, return_index=True, return_inverse=True)
            values = values[first[group]]  # no jumps
        if self.has("CORNER_SCALARS"):
            grid, points = grids.with_points_of_each_cell(grid)
            data, values = grid.GetPointData(), values[points]
            values *= 1 + 0.01 * (np.arange(len(values))[:, np.newaxis] // 4 % 3)  # jumps between cells
        if self.has("CURVED_ERROR"):
            # Within this tolerance no edge is cut.
            self.mapper.SetGeometryTolerance(1.0)
            grid, ends = grids.with_quadratic_cells(grid, BEND)
            if self.has("POINT_SCALARS"):
                values = np.concatenate([values, values[ends].mean(axis=1) + 0.02])
            data = grid.GetPointData() if self.has("POINT_SCALARS") else grid.GetCellData()
        grids.add_array(data, ARRAY, values)
        self.show_data(grid)

    def set_lattice(self):
        """Points or cells; interpolated, or one scalar a cell."""
        # Where no surface is to be leapt to, no block may be without one; between constant cells rays never leap to one.
        may_leap = self.has("ISOSURFACES") and self.has("POINT_SCALARS")
        cells = CELLS_OF_BLOCK if may_leap and not self.has("LEAPS") else CELLS
        if self.has("SLABS"):
            full = 2 if self.has("MANY_SLABS") and self.components() == 1 else 1
            cells = (cells, cells, full * MOST_LAYERS + 50)
        else:
            cells = (cells, cells, cells)
        of_points, even = self.one_of(True, False), not self.has("RECTILINEAR")
        # From a tenth of empty blocks on rays leap; from a half on they pass what is transparent.
        unseen = 0.8 if self.has("TRANSPARENT_RANGES") else 0.35 if self.has("LEAPS") else 0.0
        low = 0.6 if self.has("LEAPS") and not self.has("ISOSURFACES") else 0.0
        grid = images.lattice(cells, even)
        if of_points:
            self.mapper.SetScalarModeToUsePointFieldData()
        else:
            self.mapper.SetScalarModeToUseCellFieldData()
        if self.has("POINT_SCALARS"):
            self.property.SetInterpolationTypeToLinear()
        else:
            self.property.SetInterpolationTypeToNearest()
        values = images.values_of(cells, even, of_points, low, unseen, self.has("NAN_SHOWN"), self.components())
        grids.add_array(grid.GetPointData() if of_points else grid.GetCellData(), ARRAY, values)
        self.show_data(grid)

    def set_trees(self):
        """Of four levels; the values of each node are those of a place at random."""
        source = vtk.vtkRandomHyperTreeGridSource()
        source.SetDimensions(4, 4, 4)
        source.SetOutputBounds(0, 1, 0, 1, 0, 1)
        source.SetMaxDepth(4)
        source.SetSeed(3)
        source.Update()
        trees = source.GetHyperTreeGridOutput()
        if self.has("RECTILINEAR"):
            for method in (trees.SetXCoordinates, trees.SetYCoordinates, trees.SetZCoordinates):
                method(numpy_to_vtk(images.coordinates(3, False), deep=True))
        places = np.random.RandomState(1).random_sample((trees.GetGlobalNodeIndexMax() + 1, 3))
        values = np.stack([grids.waves(places, 0.8 + 0.2 * k, k) for k in range(self.components())], axis=1)
        if self.has("NAN_SHOWN"):
            values[5::29] = np.nan
        trees.GetCellData().Initialize()
        grids.add_array(trees.GetCellData(), ARRAY, values)
        mask = vtk.vtkBitArray()
        for node in range(len(values)):
            mask.InsertNextValue(int(self.has("HIDDEN_CELLS") and node % 5 == 4))
        trees.SetMask(mask)
        self.mapper.SetScalarModeToUseCellFieldData()
        self.mapper.SelectScalarArray(ARRAY)
        self.mapper.SetInputDataObject(trees)
        self.grid = trees

    def show_data(self, grid):
        if self.has("HIDDEN_CELLS"):
            marks = np.zeros(grid.GetNumberOfCells(), dtype=np.uint8)
            # A layer, or here and there: then rays march through what is hidden.
            hidden = slice(len(marks) // 5) if self.has("VISIBLE_PART") else slice(None, None, 5)
            marks[hidden] = HIDDEN_CELL
            grids.add_array(grid.GetCellData(), "vtkGhostType", marks)
        self.mapper.SelectScalarArray(ARRAY)
        self.mapper.SetInputDataObject(grid)
        self.grid = grid

    def set_functions(self):
        for component in range(self.components()):
            self.property.SetColor(component, self.make_colors(component))
            self.property.SetScalarOpacity(component, self.make_opacities())
            self.property.SetScalarOpacityUnitDistance(component, 0.3 + 0.1 * component)
        if self.components() > 1:
            self.property.SetIndependentComponents(self.has("INDEPENDENT"))
            if not self.is_lattice():  # there all is drawn where no vector mode is set
                self.mapper.SetVectorModeToAllComponents()

    def make_colors(self, component):
        colors = vtk.vtkColorTransferFunction()
        colors.SetNanColor(0.9, 0.2, 0.7)
        if self.has("CONSTANT_COLOR"):
            colors.AddRGBPoint(0.5, 0.9, 0.6, 0.3)
            return colors
        for k, (scalar, *rgb) in enumerate(((0.1, 0.1, 0.2, 0.9), (0.4, 0.2, 0.9, 0.3), (0.55, 0.9, 0.8, 0.1),
                                            (0.9, 0.9, 0.2, 0.1))):
            colors.AddRGBPoint(scalar, *(rgb[(c + component) % 3] for c in range(3)))
        return colors

    def make_opacities(self):
        opacities = vtk.vtkPiecewiseFunction()
        if self.has("LEAPS"):
            for scalar, opacity in ((0.3, 0.0), (0.4, 0.1), (0.7, 0.6), (0.8, 0.2), (1.0, 0.9)):
                opacities.AddPoint(scalar, opacity)
        elif self.has("TRANSPARENT_RANGES") or self.has("VISIBLE_PART"):
            # Half of the values, or more, are below 0.5 by far, and few are above 0.9.
            for scalar, opacity in ((0.55, 0.0), (0.6, 0.7), (0.75, 0.2), (0.85, 0.9), (0.9, 0.0)):
                opacities.AddPoint(scalar, opacity)
        else:
            for scalar, opacity in ((0.0, 0.3), (0.35, 0.05), (0.5, 0.6), (0.6, 0.1), (0.9, 0.8)):
                opacities.AddPoint(scalar, opacity)
        return opacities

    def set_blending(self):
        if self.has("EXTREME"):
            self.mapper.SetBlendMode(self.one_of(self.mapper.MAXIMUM_INTENSITY_BLEND,
                                                 self.mapper.MINIMUM_INTENSITY_BLEND))
        elif self.has("SUM"):
            self.mapper.SetBlendMode(self.one_of(self.mapper.AVERAGE_INTENSITY_BLEND, self.mapper.ADDITIVE_BLEND))
            self.mapper.SetAverageIPScalarRange(*self.one_of((0.3, 0.8), (0.0, 1.0)))
        elif self.has("ISOSURFACES"):
            self.mapper.SetBlendModeToIsoSurface()
            for i, value in enumerate((0.36, 0.47, 0.58, 0.8)):
                self.property.GetIsoSurfaceValues().SetValue(i, value)
        if self.has("NAN_SHOWN"):
            self.mapper.DrawNanCellsOn()

    # --- What else is in the scene ---------------------------------------------------------------

    def add_actor(self, source, color, opacity):
        mapper = vtk.vtkPolyDataMapper()
        mapper.SetInputConnection(source.GetOutputPort())
        actor = vtk.vtkActor()
        actor.SetMapper(mapper)
        actor.GetProperty().SetColor(*color)
        actor.GetProperty().SetOpacity(opacity)
        actor.GetProperty().LightingOff()
        self.renderer.AddActor(actor)

    def set_surfaces(self):
        if self.has("OPAQUE_DEPTH") or self.has("OPAQUE_SHADOWS"):
            ball = vtk.vtkSphereSource()
            ball.SetCenter(0.65, 0.5, 0.6)
            ball.SetRadius(0.2)
            self.add_actor(ball, (0.5, 0.5, 0.9), 1.0)
        if self.has("PEELED"):
            plane = vtk.vtkPlaneSource()
            plane.SetOrigin(-0.2, 0.5, -0.2)
            plane.SetPoint1(1.2, 0.3, -0.2)
            plane.SetPoint2(-0.2, 0.6, 1.2)
            self.add_actor(plane, (0.9, 0.9, 0.2), 0.4)
            self.renderer.UseDepthPeelingOn()
            self.renderer.UseDepthPeelingForVolumesOn()
            self.renderer.SetMaximumNumberOfPeels(20)
            self.renderer.SetOcclusionRatio(0.0)

    def set_cuts(self):
        if self.has("CROPPED"):
            self.mapper.CroppingOn()
            self.mapper.SetCroppingRegionPlanes(0.3, 0.7, 0.25, 0.7, 0.35, 0.65)
            self.one_of(self.mapper.SetCroppingRegionFlagsToFence,
                        self.mapper.SetCroppingRegionFlagsToInvertedCross)()
        elif self.has("CLIPPED") and self.one_of(False, True):
            self.mapper.CroppingOn()
            self.mapper.SetCroppingRegionPlanes(0.1, 0.8, 0.05, 0.9, 0.15, 0.95)
            self.mapper.SetCroppingRegionFlagsToSubVolume()
        elif self.has("CLIPPED"):
            for origin, normal in (((0.2, 0.0, 0.0), (1.0, 0.2, 0.1)), ((0.0, 0.0, 0.9), (0.1, 0.1, -1.0))):
                plane = vtk.vtkPlane()
                plane.SetOrigin(*origin)
                plane.SetNormal(*normal)
                self.mapper.AddClippingPlane(plane)

    # --- Light -----------------------------------------------------------------------------------

    def set_effects(self):
        if self.has("GRADIENT_OPACITY"):
            opacities = vtk.vtkPiecewiseFunction()
            opacities.AddPoint(0.0, 0.2)
            opacities.AddPoint(3.0, 1.0)
            self.property.SetGradientOpacity(opacities)
        if self.has("CELL_GRADIENTS"):
            self.mapper.SetGradientTypeToCell()
        if self.has("SHADING"):
            for component in range(self.components()):  # which reflect light alike
                self.property.ShadeOn(component)
                self.property.SetAmbient(component, 0.3)
                self.property.SetDiffuse(component, 0.8)
                self.property.SetSpecular(component, 0.4)
                self.property.SetSpecularPower(component, 12.0)
        if self.has("CAST_SHADOWS") or self.has("HEADLIGHT_SHADOWS"):
            self.mapper.SetShadowMethod(self.mapper.SHADOWS_ALONG_RAYS if self.has("SAMPLED_SHADOWS")
                                        else self.mapper.SHADOWS_AT_VERTICES)
        self.mapper.SetLightTolerance(1 / 255 if self.has("LIGHT_TOLERANCE") else 0)
        self.mapper.SetLightThroughCuts(self.has("LIGHT_THROUGH_CUTS"))
        self.mapper.SetOpaqueShadows(self.has("OPAQUE_SHADOWS"))
        self.mapper.SetAmbientOcclusion(self.has("OCCLUSION"))
        self.mapper.SetAmbientOcclusionDirections(8)
        self.mapper.SetVolumetricScatteringBlending(self.one_of(0.6, 1.5) if self.has("SCATTERING") else 0.0)
        if self.has("SHOW_ILLUMINATION"):
            self.mapper.SetViewModeToIllumination()
        if self.has("SHOW_GRADIENTS"):
            self.mapper.SetViewModeToGradients()

    def add_light(self, position, color, casts):
        light = vtk.vtkLight()
        light.SetColor(*color)
        light.SetShadowAttenuation(1.0 if casts else 0.0)
        if position:
            light.SetLightTypeToSceneLight()
            light.SetPosition(*position)
            light.SetFocalPoint(0.5, 0.5, 0.5)
        else:
            light.SetLightTypeToHeadlight()
        self.renderer.AddLight(light)
        return light

    def set_lights(self):
        if not self.has("SHADING"):
            return
        if self.has("HEADLIGHT_ONLY"):
            self.add_light(None, (1.0, 0.9, 0.8), self.has("HEADLIGHT_SHADOWS"))
            return
        sun = self.add_light((2.0, -1.0, 0.5 if self.has("SLABS") else 3.0), (0.9, 0.9, 0.7), self.has("CAST_SHADOWS"))
        if not self.has("SINGLE_LIGHT"):
            self.add_light((-2.0, -2.0, 0.5), (0.3, 0.5, 0.9), self.has("SEVERAL_SHADOWS"))
            if self.has("HEADLIGHT_SHADOWS"):
                self.add_light(None, (0.4, 0.3, 0.3), True)
            if not self.has("FEW_LIGHTS") and not self.has("STRUCTURED"):
                for x in range(4):
                    self.add_light((x, 3.0, -2.0), (0.05, 0.1, 0.15), False)
        if self.has("WORLD_LIGHTS") and self.one_of(False, True):
            self.volume.SetScale(1.0, 1.0, 0.8)
        elif self.has("WORLD_LIGHTS"):
            sun.PositionalOn()
            sun.SetConeAngle(self.one_of(20.0, 180.0, 120.0))
            sun.SetAttenuationValues(0.8, 0.05, 0.01)

    # --- Quality and view ------------------------------------------------------------------------

    def set_quality(self):
        # Scalars of cells and constant colours have nothing to adapt: whatever the level.
        self.mapper.SetAccuracyLevel(self.mapper.DEFAULT if self.has("ADAPTIVE") else self.mapper.FAST)
        if self.has("POINT_SAMPLED"):
            self.mapper.SetAccuracyLevelToSampled()
            self.mapper.SetSampleDistance(SAMPLE_DISTANCE)
            self.mapper.SetUseJittering(self.one_of(False, True))
        self.mapper.SetCollectDiagnostics(self.has("DIAGNOSTICS"))

    def is_seen_from_inside(self):
        """All of the mesh is the part that rays enter."""
        unknown = self.has("EXTREME") or self.has("SUM") or self.has("INDEPENDENT")
        return self.has("VISIBLE_PART") and (unknown or (self.has("ISOSURFACES") and not self.has("POINT_SCALARS")))

    def set_camera(self):
        camera = self.renderer.GetActiveCamera()
        camera.SetViewUp(0, 0, 1)
        # Rays across thousands of layers, to the eye or to a light, may be longer than llvmpipe's loops
        # (Documentation/Limits.md).
        along_layers = self.has("SLABS")
        if not self.is_seen_from_inside() and (
                self.has("ENTRY_LISTS") or along_layers or (self.has("STRUCTURED") and self.one_of(True, False, True))):
            visible_side = (2.4, -1.3, 1.2)
            side = (1.5, -2.2, 0.5 if along_layers else 1.6)
            camera.SetPosition(*(visible_side if self.has("VISIBLE_PART") else side))
            camera.SetFocalPoint(0.5, 0.5, 0.45)
            if along_layers or self.one_of(False, False, True):
                camera.ParallelProjectionOn()
                camera.SetParallelScale(0.8)
        else:
            camera.SetPosition(0.35, 0.02, 0.41)
            camera.SetFocalPoint(0.7, 0.9, 0.6)
            camera.SetViewAngle(70.0)
        self.renderer.ResetCameraClippingRange()
        if not self.has("ENTRY_LISTS") and not self.has("STRUCTURED"):
            # In perspective, rays from inside have lists.
            camera.ParallelProjectionOn()
            camera.SetParallelScale(0.5)
            camera.SetClippingRange(0.01, 5.0)

# SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
# SPDX-License-Identifier: BSD-3-Clause
"""What ParaView's panel is told: groups, a tooltip for each property, and which values it may have."""
import json
import pathlib

from lattices import ARRAY, image, lattice, source_of
from other_grids import adaptive, curvilinear, field, trees
from paraview import simple
from views import load_plugin, open_view, parse_arguments, show

GROUPS = {
    "Blend": ["BlendMode", "DrawNanCells", "IsosurfaceValues", "OpacityLaw", "ScalarOpacityUnitDistance"],
    "Quality": ["AccuracyLevel", "ErrorBudget", "FrameTimeBudget", "MaximumImageSampleDistance"],
    "Light": ["AmbientOcclusion", "LightPreset", "LightTimeBudget", "Shade", "ShadowMethod"],
    "Cut": ["CroppingRegionFlags", "UseCropping"],
    "Cropping Box": ["CroppingOrigin", "CroppingScale"],
    "Diagnostics": ["ViewMode", "ViewRange"],
}
# In the panel, in no group: the statistics of the last frame aren't shown there.
FIGURES = {"BudgetKept", "GPUMemoryBytes", "LightComplete", "TimeToDraw", "UsedAccuracyLevel", "UsedErrorTolerance",
           "UsedImageSampleDistance", "UsedPixelTolerance"}
# Any number will do, or ParaView makes the range of the data's array or box.
FREE = {"AverageIPScalarRange", "CroppingOrigin", "CroppingScale", "MaxMemoryInBytes", "SampleDistance"}
SETTINGS = pathlib.Path(__file__).resolve().parents[2] / "VTKModule/Mapper/settings.json"
PRESETS = {"Fast", "Default", "Accurate", "Reference"}


def groups_of(proxy):
    """{label: names without their prefix}"""
    found = {}
    for i in range(proxy.GetNumberOfPropertyGroups()):
        group = proxy.GetPropertyGroup(i)
        names = [proxy.GetPropertyName(group.GetProperty(k)) for k in range(group.GetNumberOfProperties())]
        if any((name or "").startswith("TetMarch") for name in names):
            found[group.GetXMLLabel()] = {name.removeprefix("TetMarch") for name in names}
    return found


def check_groups(proxy):
    groups = groups_of(proxy)
    assert set(groups) == set(GROUPS), f"the groups are {sorted(groups)}"
    for label, names in GROUPS.items():
        assert set(names) <= groups[label], f"{label} lacks {set(names) - groups[label]}"
    in_groups = set.union(*groups.values())
    for prop in properties(proxy):
        name = proxy.GetPropertyName(prop).removeprefix("TetMarch")
        assert prop.GetInformationOnly() or name in in_groups, f"{name} is in no group"
    return groups


def properties(proxy):
    names = [name for name in simple.servermanager._getPyProxy(proxy).ListProperties() if name.startswith("TetMarch")]
    return [proxy.GetProperty(name) for name in names]


def check_tooltips(proxy):
    for prop in properties(proxy):
        name = proxy.GetPropertyName(prop)
        if prop.IsA("vtkSMProxyProperty"):  # the opacity function, which has an editor of its own, and what isn't shown
            continue
        text = prop.GetDocumentation() and prop.GetDocumentation().GetDescription()
        assert text and len(text.split()) >= 3, f"{name} has no tooltip: {text}"


def domains(prop):
    iterator = prop.NewDomainIterator()
    iterator.Begin()
    while not iterator.IsAtEnd():
        yield iterator.GetDomain()
        iterator.Next()


def check_ranges(proxy):
    for prop in properties(proxy):
        name = proxy.GetPropertyName(prop).removeprefix("TetMarch")
        numbers = prop.IsA("vtkSMVectorProperty") and not prop.IsA("vtkSMStringVectorProperty")
        if numbers and not prop.GetInformationOnly() and name not in FREE:
            assert any(True for _ in domains(prop)), f"{name} has no range"
    level = proxy.GetProperty("TetMarchAccuracyLevel").FindDomain("vtkSMEnumerationDomain")
    presets = {level.GetEntryText(i) for i in range(level.GetNumberOfEntries())}
    assert PRESETS <= presets, f"the presets of accuracy are {presets}"


def check_figures(proxy):
    """Of the last frame; they can be asked for, not set."""
    for name in FIGURES:
        assert proxy.GetProperty("TetMarch" + name).GetInformationOnly(), name


def check_settings(proxy):
    """Each setting that has a panel in the table is a property with that text, and no other one is."""
    images = "UniformGrid" in proxy.GetXMLName()
    for row in json.loads(SETTINGS.read_text(encoding="utf-8")):
        name = "TetMarch" + row["name"]
        prop = proxy.GetProperty(name)
        kind = row.get("panel", {}).get("only")
        expected = "panel" in row and kind in (None, "images" if images else "grids")
        assert expected == bool(prop), f"{name} must be there if the table has its panel, and only then"
        if prop:
            text = row["panel"].get("text_of_images" if images else "text", row["panel"]["text"])
            assert prop.GetDocumentation().GetDescription().split() == " ".join(text).split(), name


def main():
    arguments = parse_arguments(__doc__)
    load_plugin(arguments)
    view = open_view()
    for data, kind, association in ((lattice((2, 2, 2), field), "UnstructuredGridRepresentation", "POINTS"),
                                    (curvilinear((2, 2, 2), field), "StructuredGridRepresentation", "POINTS"),
                                    (adaptive()[0], "AMRRepresentation", "CELLS"),
                                    (trees()[0], "HyperTreeGridRepresentation", "CELLS"),
                                    (image((2, 2, 2), field), "UniformGridRepresentation", "POINTS")):
        display = show(source_of(data), view, ARRAY, association, kind)
        groups = check_groups(display.SMProxy)
        check_tooltips(display.SMProxy)
        check_ranges(display.SMProxy)
        check_figures(display.SMProxy)
        check_settings(display.SMProxy)
        print(kind, {label: len(names) for label, names in groups.items()})


main()

# SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
# SPDX-License-Identifier: BSD-3-Clause
"""What VTK expects of every property: a setter that is heard, a time of change, a line of what is printed."""
import json
import pathlib
import re
import unittest

import vtkmodules.all
import vtktetmarch
from vtktetmarch.properties import property_names, snake_case

CLASSES = [getattr(vtktetmarch, name) for name in vtktetmarch.__all__ if name.startswith("vtk")]

# What can't be found by trying numbers.
OTHER_VALUES = {"Mapper": vtktetmarch.vtkTetMarchVolumeMapper(), "BlendMode": 3,
                "Settings": vtktetmarch.vtkTetMarchSettings(), "ArrayName": "p", "FileName": "a.mha", "Title": "a",
                "InputData": vtkmodules.all.vtkImageData(), "Controller": vtkmodules.all.vtkDummyController()}
# Figures with an argument before the value, and what belongs to a class instead of an object.
NO_PROPERTIES = {"Values", "ReplacesProjectedTetrahedra", "ReplacesSmartVolume"}
# Their choices have other names now.
DEPRECATED = {"SetViewModeToShellFaces", "SetViewModeToShellCoordinates"}


def names_of_properties(cls):
    """X for each SetX that the class itself declares, with a GetX."""
    own = {name[3:] for name in vars(cls) if name.startswith("Set") and hasattr(cls, "Get" + name[3:])}
    if hasattr(cls, "GetBlendModeAsString"):
        own.add("BlendMode")  # of a class of VTK's; which ones there are is our own
    return sorted(own - NO_PROPERTIES)


def other_than(thing, name):
    """Sets a value that isn't there yet, and returns it."""
    get, put = getattr(thing, "Get" + name), getattr(thing, "Set" + name)
    before = get()
    if name in OTHER_VALUES:
        candidates = [OTHER_VALUES[name]]
    elif isinstance(before, tuple):
        candidates = [tuple(value + 0.5 * (i + 1) for i, value in enumerate(before)), tuple(range(len(before)))]
    elif isinstance(before, bool):
        candidates = [not before]
    else:
        candidates = [before + step for step in (1, -1, 0.25, -0.25, 17)]
        if isinstance(before, int):
            candidates = [int(value) for value in candidates]
    for value in candidates:
        put(value)
        if get() != before:
            return get()
    raise AssertionError(f"{name} stays {before}")


def line_of(thing, name):
    """The last of that name: classes above may have one, too."""
    found = re.findall(rf"^ +{name}:(.*)$", str(thing), re.MULTILINE)
    return found[-1].strip() if found else None


def table(name):
    """The rows that vtkTetMarchSettings or vtkTetMarchFrameStatistics is made from."""
    path = pathlib.Path(__file__).resolve().parents[2] / "VTKModule/Mapper" / name
    return json.loads(path.read_text(encoding="utf-8"))


def value_of(text):
    """A number of a table, where it is one."""
    try:
        return {"true": True, "false": False}[text] if text in ("true", "false") else float(text)
    except ValueError:
        return None


PROPERTIES = [(cls, name) for cls in CLASSES for name in names_of_properties(cls)]


class ContractTest(unittest.TestCase):
    def test_there_are_properties(self):
        found = {cls.__name__: names_of_properties(cls) for cls in CLASSES}
        self.assertGreater(len(found["vtkTetMarchVolumeMapper"]), 30)
        self.assertGreater(len(found["vtkTetMarchSettings"]), 25)
        self.assertLess(set(found["vtkTetMarchSettings"]), set(found["vtkTetMarchVolumeMapper"]))
        self.assertLess(set(found["vtkTetMarchSettings"]), set(found["vtkTetMarchSmartVolumeMapper"]))
        self.assertLess({"GPUMemoryBytes", "Seconds"}, set(found["vtkTetMarchFrameStatistics"]))
        self.assertEqual(found["vtkTetMarchLegend"], ["Mapper"])

    def test_the_time_of_change_moves_if_a_value_does(self):
        for cls, name in PROPERTIES:
            with self.subTest(cls=cls.__name__, property=name):
                thing = cls()
                before = thing.GetMTime()
                value = other_than(thing, name)
                changed = thing.GetMTime()
                self.assertGreater(changed, before)
                getattr(thing, "Set" + name)(value)
                self.assertEqual(thing.GetMTime(), changed, "nothing has changed")

    def test_each_is_printed(self):
        for cls, name in PROPERTIES:
            with self.subTest(cls=cls.__name__, property=name):
                thing = cls()
                before = line_of(thing, name)
                self.assertIsNotNone(before, "there is no line of it")
                other_than(thing, name)
                self.assertNotEqual(line_of(thing, name), before)

    def test_switches_switch(self):
        for cls in CLASSES:
            for name in [name[:-2] for name in vars(cls) if name.endswith("On")]:
                with self.subTest(cls=cls.__name__, property=name):
                    thing = cls()
                    for way, value in (("On", True), ("Off", False)):
                        getattr(thing, name + way)()
                        self.assertEqual(bool(getattr(thing, "Get" + name)()), value)

    def test_names_of_choices(self):
        """SetXToY() makes GetXAsString() Y, where there is one."""
        checked = 0
        for cls in CLASSES:
            for name in set(vars(cls)) - DEPRECATED:
                choice = re.fullmatch(r"Set(\w+?)To(\w+)", name)
                if choice and hasattr(cls, f"Get{choice.group(1)}AsString"):
                    with self.subTest(method=name):
                        thing = cls()
                        getattr(thing, name)()
                        self.assertEqual(getattr(thing, f"Get{choice.group(1)}AsString")(), choice.group(2))
                        checked += 1
        self.assertGreater(checked, 20)

    def test_the_replaced_mapper_has_the_time_of_what_draws(self):
        mapper = vtktetmarch.vtkTetMarchProjectedTetrahedraMapper()
        before = mapper.GetMTime()
        mapper.GetMarchingMapper().AmbientOcclusionOn()
        self.assertGreater(mapper.GetMTime(), before)

    def test_the_mappers_have_all_of_the_settings_and_the_figures(self):
        for mapper in (vtktetmarch.vtkTetMarchVolumeMapper, vtktetmarch.vtkTetMarchSmartVolumeMapper):
            with self.subTest(mapper=mapper.__name__):
                self.check_settings_and_figures(mapper)

    def check_settings_and_figures(self, mapper):
        own = {name for name in vars(vtktetmarch.vtkTetMarchSettings)
               if not name.startswith("__") and name != "EnumType"}
        self.assertGreater(len(own), 100)
        # Least and greatest values of what VTK's class has, too, are that class's own.
        self.assertLess(own, set(vars(mapper)) | {name for name in dir(mapper) if name.endswith(("MinValue", "MaxValue"))})
        of_frame = {name for name in vars(vtktetmarch.vtkTetMarchFrameStatistics)
                    if name.endswith(("Builds", "Bytes", "Rays", "Cells", "Lookups", "Entries", "Hits", "Draws"))
                    and name.startswith("Get")}
        self.assertGreater(len(of_frame), 15)
        self.assertLess(of_frame, set(vars(mapper)))

    def test_each_row_of_the_settings_reaches_mappers_and_keywords(self):
        rows = table("settings.json")
        self.assertEqual({row["name"] for row in rows}, set(names_of_properties(vtktetmarch.vtkTetMarchSettings)))
        mappers = (vtktetmarch.vtkTetMarchVolumeMapper, vtktetmarch.vtkTetMarchSmartVolumeMapper)
        for row in rows:
            for cls in (vtktetmarch.vtkTetMarchSettings, *mappers):
                with self.subTest(cls=cls.__name__, setting=row["name"]):
                    self.check_setting(row, cls())
            for cls in mappers:
                self.assertIn(snake_case(row["name"]), property_names((cls(),)))

    def check_setting(self, row, thing):
        get = getattr(thing, "Get" + row["name"])
        if row["type"] == "choice":
            constants = [choice["constant"] for choice in row["choices"]]
            self.assertEqual([getattr(thing, constant) for constant in constants], list(range(len(constants))))
            least, greatest, default = 0, len(constants) - 1, constants.index(row["default"])
            if row["name"] == "OpacityLaw" and isinstance(thing, vtktetmarch.vtkTetMarchSmartVolumeMapper):
                default = thing.STRUCTURED
        elif row["type"] == "double[2]":
            self.assertEqual(get(), tuple(map(float, row["default"])))
            return
        else:
            least, greatest, default = (value_of(row.get(key, "")) for key in ("least", "greatest", "default"))
        self.assertAlmostEqual(get(), default, 7)
        for limit, wanted in ((least, -1e30), (greatest, 1e30)):
            if limit is not None:
                getattr(thing, "Set" + row["name"])(wanted if isinstance(get(), float) else int(wanted / 1e22))
                self.assertAlmostEqual(get(), limit, 7)

    def test_each_row_of_the_statistics_reaches_the_mappers(self):
        rows = table("statistics.json")
        of_frame = names_of_properties(vtktetmarch.vtkTetMarchFrameStatistics)
        self.assertEqual({row["name"] for row in rows}, set(of_frame))
        for cls in (vtktetmarch.vtkTetMarchVolumeMapper, vtktetmarch.vtkTetMarchSmartVolumeMapper):
            for row in rows:
                with self.subTest(cls=cls.__name__, figure=row["name"]):
                    method = ("Is" if row["type"] == "bool" else "Get") + row["name"]
                    self.assertEqual(method in vars(cls), not row.get("own", False))

    def test_the_factory_prints_what_it_replaces(self):
        factory = vtktetmarch.vtkTetMarchObjectFactory
        for name in ("ReplacesProjectedTetrahedra", "ReplacesSmartVolume"):
            with self.subTest(name=name):
                self.assertEqual(line_of(factory(), name), "Off")
                getattr(factory, "Set" + name)(True)
                line = line_of(factory(), name)
                getattr(factory, "Set" + name)(False)
                self.assertEqual(line, "On")


if __name__ == "__main__":
    unittest.main(verbosity=2)

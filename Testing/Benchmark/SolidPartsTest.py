# SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
# SPDX-License-Identifier: BSD-3-Clause
"""The datasets of tetmarch-bench that are solid parts of others' files: SolidPartsTest.py EXECUTABLE."""
from benchmark_case import BenchmarkCase, main

SIZE = 8


def write_hexahedra(path):
    """A lattice of SIZE^3 cubes, as a legacy file, in place of the real part."""
    edge = SIZE + 1
    number = {(i, j, k): i + edge * (j + edge * k) for k in range(edge) for j in range(edge) for i in range(edge)}
    corners = ((0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0), (0, 0, 1), (1, 0, 1), (1, 1, 1), (0, 1, 1))
    cells = [[number[i + a, j + b, k + c] for a, b, c in corners]
             for k in range(SIZE) for j in range(SIZE) for i in range(SIZE)]
    lines = ["# vtk DataFile Version 3.0", "cubes", "ASCII", "DATASET UNSTRUCTURED_GRID",
             f"POINTS {len(number)} float", *(" ".join(map(str, point)) for point in number),
             f"CELLS {len(cells)} {9 * len(cells)}", *("8 " + " ".join(map(str, cell)) for cell in cells),
             f"CELL_TYPES {len(cells)}", *["12"] * len(cells)]
    path.parent.mkdir(parents=True)
    path.write_text("\n".join(lines) + "\n")


class SolidPartsTest(BenchmarkCase):
    def test_cells_are_cut_by_shared_midpoints(self):
        """Six tetrahedra a cube, each cut into eight: the points are those of cubes half as long."""
        write_hexahedra(self.folder / "data" / "unstructured" / "wheelset.vtk")
        report, _ = self.report_of("--quick", "--datasets", "wheelset", "--more-data", "data", "--errors")
        dataset = report["datasets"][0]
        self.assertEqual(dataset["tetrahedra"], 8 * 6 * SIZE**3)
        self.assertEqual(dataset["points"], (2 * SIZE + 1) ** 3)
        mappers = {mapper["name"]: mapper for mapper in dataset["mappers"]}
        for mapper in mappers.values():
            self.assertIsNone(mapper["failure"], mapper["name"])
            # As much of the window as a lattice fills: no cell is lost.
            self.assertGreater(mapper["covered_share"], 0.2)
        self.assertLess(mappers["tetmarch"]["errors"]["max"], 1 / 255)
        self.assertLess(mappers["bunyk"]["errors"]["rms"], 0.6)  # of the same thing, at least

    def test_real_parts(self):
        result = self.run_benchmark("--quick", "--datasets", "wheelset,crushed-can", "--mappers", "tetmarch")
        self.assertEqual(result.returncode, 0, result.stderr)
        for name, tetrahedra in (("wheelset", 175_472), ("crushed-can", 230_400)):
            with self.subTest(dataset=name):
                if f"{name} is left out" in result.stderr:
                    self.skipTest("its file is absent")
                self.assertIn(f"| {name} | {tetrahedra} | tetmarch | 0.", result.stdout)

    def test_absent_parts_are_left_out(self):
        result = self.run_benchmark("--quick", "--datasets", "wheelset,crushed-can,lattice:8", "--mappers", "tetmarch",
                                    "--more-data", "no/such/folder")
        self.assertEqual(result.returncode, 0, result.stderr)
        for name in ("wheelset", "crushed-can"):
            self.assertIn(f"{name} is left out: it is not in no/such/folder", result.stderr)
            self.assertNotIn(f"| {name} |", result.stdout)
        self.assertIn("| lattice:8 |", result.stdout)


if __name__ == "__main__":
    main()

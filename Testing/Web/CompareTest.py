# SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
# SPDX-License-Identifier: BSD-3-Clause
"""Distances of pictures."""
import unittest

import numpy as np

from compare import compare, picture_of_difference


class CompareTest(unittest.TestCase):
    def setUp(self):
        self.one = np.arange(4 * 5 * 3, dtype=np.uint8).reshape(4, 5, 3) + 100
        self.other = self.one.copy()

    def test_equal(self):
        self.assertEqual(str(compare(self.one, self.other)), "max 0/255 at (0, 0), RMS 0.000/255, 0 pixels above 2/255")

    def test_both_ways(self):
        self.other[2, 3, 1] -= 6
        self.other[0, 0, :] += 2
        for pictures in (self.one, self.other), (self.other, self.one):
            apart = compare(*pictures)
            self.assertEqual((apart.most, apart.worst, apart.over), (6, (3, 2), 1))
            self.assertAlmostEqual(apart.rms, ((36 + 3 * 4) / 60) ** 0.5)
            shown = picture_of_difference(*pictures)
            self.assertEqual([shown[2, 3].tolist(), shown[0, 0].tolist(), shown[1, 1].tolist()],
                             [[0, 255, 0], [128] * 3, [0] * 3])

    def test_sizes(self):
        with self.assertRaisesRegex(ValueError, "differ in size: 5 x 4 and 5 x 3"):
            compare(self.one, self.one[1:])


if __name__ == "__main__":
    unittest.main()

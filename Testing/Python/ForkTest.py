# SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
# SPDX-License-Identifier: BSD-3-Clause
"""Figures in forked children: an exception instead of a hang, and the parent draws on."""
import multiprocessing
import os
import unittest

import numpy as np

import first_data
import vtktetmarch

SECONDS = 120  # a child that hangs is ended then


def figure_of_tetrahedron():
    return vtktetmarch.figure(first_data.one_tetrahedron(), size=(60, 40))


def answer_of(call, answers):
    try:
        answers.put(call())
    except Exception as error:  # which one is what the test asks
        answers.put(error)


@unittest.skipUnless(hasattr(os, "fork"), "nothing is forked here")
class ForkTest(unittest.TestCase):
    def setUp(self):
        self.figure = figure_of_tetrahedron()

    def in_child(self, call):
        """What the call returns in a forked child, or raises."""
        context = multiprocessing.get_context("fork")
        answers = context.SimpleQueue()
        child = context.Process(target=answer_of, args=(call, answers))
        child.start()
        child.join(SECONDS)
        hangs = child.is_alive()
        child.kill()
        child.join()
        self.assertFalse(hangs, "the child hangs")
        self.assertEqual(child.exitcode, 0)
        return answers.get()

    def test_a_figure_that_was_drawn_says_what_to_do(self):
        before = self.figure.screenshot()
        for call in (self.figure.screenshot, self.figure.show, self.figure.compare, lambda: self.figure.pick(30, 20)):
            error = self.in_child(call)
            self.assertIsInstance(error, RuntimeError)
            self.assertRegex(str(error), "make the figure in the child, or start the child by .*'spawn'")
        self.assertTrue(np.array_equal(self.figure.screenshot(), before))

    def test_what_it_says_helps(self):
        expected = self.figure.screenshot()
        self.assertTrue(np.array_equal(self.in_child(lambda: figure_of_tetrahedron().screenshot()), expected))
        with multiprocessing.get_context("spawn").Pool(1) as pool:
            self.assertTrue(np.array_equal(pool.apply(picture_of_tetrahedron), expected))
        self.assertTrue(np.array_equal(self.figure.screenshot(), expected))

    def test_a_figure_that_was_not_drawn_is_the_childs(self):
        picture = self.in_child(self.figure.screenshot)
        self.assertTrue(np.array_equal(self.figure.screenshot(), picture))

    def test_a_child_may_forget_the_figure(self):
        """Closing the window of the parent would hang, or end the connection of both."""
        before = self.figure.screenshot()

        def forget():
            self.figure = None
            return "forgotten"

        self.assertEqual(self.in_child(forget), "forgotten")
        self.assertTrue(np.array_equal(self.figure.screenshot(), before))


def picture_of_tetrahedron():
    return figure_of_tetrahedron().screenshot()


if __name__ == "__main__":
    unittest.main(verbosity=2)

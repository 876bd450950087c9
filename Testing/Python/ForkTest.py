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


def answer_of(call, writer):
    try:
        writer.send(call())
    except Exception as error:  # which one is what the test asks
        writer.send(error)


def answer_of_child(call, start="fork"):
    """What the call returns in a child, or the exception; None if the child gives no answer."""
    reader, writer = multiprocessing.Pipe(duplex=False)
    child = multiprocessing.get_context(start).Process(target=answer_of, args=(call, writer))
    child.start()
    writer.close()
    try:
        return reader.recv() if reader.poll(SECONDS) else None
    except EOFError:
        return None
    finally:
        child.kill()
        child.join()


@unittest.skipUnless(hasattr(os, "fork"), "nothing is forked here")
class ForkTest(unittest.TestCase):
    def setUp(self):
        self.figure = figure_of_tetrahedron()

    def in_child(self, call):
        """What the call returns in a forked child, or raises."""
        answer = answer_of_child(call)
        self.assertIsNotNone(answer, "the child hangs, or ended without a word")
        return answer

    def test_a_child_of_a_process_that_drew_says_what_to_do(self):
        """A figure of its own hung there, once in many runs."""
        before = self.figure.screenshot()
        for call in (self.figure.screenshot, self.figure.show, self.figure.compare, lambda: self.figure.pick(30, 20),
                     picture_of_tetrahedron):
            error = self.in_child(call)
            self.assertIsInstance(error, RuntimeError)
            self.assertRegex(str(error), "start it by .*'spawn'.*, or before the first picture")
        self.assertTrue(np.array_equal(self.figure.screenshot(), before))

    def test_what_it_says_helps(self):
        """A process that was spawned draws; so does its child, since that was forked before."""
        expected = self.figure.screenshot()
        for picture in answer_of_child(pictures_of_child_and_parent, "spawn"):
            self.assertTrue(np.array_equal(picture, expected))
        self.assertTrue(np.array_equal(self.figure.screenshot(), expected))

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


def pictures_of_child_and_parent():
    """Of a figure that was not drawn when the child was forked."""
    figure = figure_of_tetrahedron()
    return answer_of_child(figure.screenshot), figure.screenshot()


if __name__ == "__main__":
    unittest.main(verbosity=2)

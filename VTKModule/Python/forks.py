# SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
# SPDX-License-Identifier: BSD-3-Clause
"""Windows in forked processes: a child has no threads of the GL, and shares the connection to the display."""
import os
import weakref

PROCESSES = weakref.WeakKeyDictionary()  # window: the process that opened it


def note_window(window):
    """A window was opened by this process."""
    PROCESSES[window] = os.getpid()


def check_process(window):
    """Raises RuntimeError, which says what to do, if a window, or None, is of a process that this one was forked from.
    """
    if window is not None and PROCESSES[window] != os.getpid():
        raise RuntimeError("this figure was drawn before its process was forked, and OpenGL does not work in such a "
                           "child: make the figure in the child, or start the child by "
                           "multiprocessing.get_context('spawn')")


def keep_windows():
    """In a child: windows are never deleted, since closing them would hang, or end the connection of the parent."""
    for window in PROCESSES:
        window.Register(None)


if hasattr(os, "register_at_fork"):
    os.register_at_fork(after_in_child=keep_windows)

# SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
# SPDX-License-Identifier: BSD-3-Clause
"""Windows in forked processes: a child has no threads of the GL, and shares the connection to the display."""
import os
import weakref

PROCESSES = set()  # this process, if it opened a window, and those from which it was forked
WINDOWS = weakref.WeakSet()


def note_window(window):
    """A window was opened by this process."""
    PROCESSES.add(os.getpid())
    WINDOWS.add(window)


def check_process():
    """Raises RuntimeError with the remedy if this process was forked from one that has opened a window.

    The child can't open windows of its own either: opening one releases the context that the parent left current, which
    waits for threads that only the parent has, or for a lock that one of them held.
    """
    if PROCESSES - {os.getpid()}:
        raise RuntimeError("figures were drawn before this process was forked, and OpenGL does not work in such a "
                           "child: start it by multiprocessing.get_context('spawn'), or before the first picture")


def keep_windows():
    """In a child: windows are never deleted, since closing them would hang, or end the connection of the parent."""
    for window in WINDOWS:
        window.Register(None)


if hasattr(os, "register_at_fork"):
    os.register_at_fork(after_in_child=keep_windows)

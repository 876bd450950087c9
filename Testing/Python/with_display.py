# SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
# SPDX-License-Identifier: BSD-3-Clause
"""Runs a command with a display: with_display.py [--own] COMMAND...

Windows of VTK before 9.4 want one. If DISPLAY is unset, an X server of the command's own serves it. With --own that is
always so, for what needs the keyboard: of all windows of a display one has it.
"""
import contextlib
import os
import subprocess
import sys


@contextlib.contextmanager
def own_server(*options):
    """The environment of a process, with the display of an X server that was started with these options."""
    reader, writer = os.pipe()
    # The server itself chooses a free display and writes its number.
    server = subprocess.Popen(["Xvfb", "-displayfd", str(writer), "-screen", "0", "1280x1024x24", *options,
                               "-nolisten", "tcp"], pass_fds=[writer], stderr=subprocess.DEVNULL)
    os.close(writer)
    try:
        with os.fdopen(reader) as answer:
            number = answer.readline().strip()
        if not number:
            sys.exit("Xvfb didn't start")
        yield {**os.environ, "DISPLAY": ":" + number}
    finally:
        server.terminate()
        server.wait()


if __name__ == "__main__":
    arguments = sys.argv[1:]
    own = arguments[:1] == ["--own"]
    if own or not os.environ.get("DISPLAY"):
        with own_server("-noreset") as environment:
            status = subprocess.call(arguments[own:], env=environment)
        sys.exit(status)
    sys.exit(subprocess.call(arguments))

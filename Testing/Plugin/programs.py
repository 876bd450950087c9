# SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
# SPDX-License-Identifier: BSD-3-Clause
"""Programs that a test starts beside itself, and ends."""
import contextlib
import pathlib
import socket
import subprocess
import time

LONGEST = 600  # seconds until a server accepts connections
PATIENCE = 30  # seconds for a program to end by itself


def end(program):
    program.terminate()
    try:
        program.wait(PATIENCE)
    except subprocess.TimeoutExpired:
        program.kill()
        program.wait()


def printed_by_script(words, project, root, *arguments):
    """What words of bash print that know Tools/Script/paraview.sh; arguments are $3 and on. `root` is the folder in which
    ParaView was unpacked."""
    script = 'BUILD=$1; source "$2/Tools/Script/paraview.sh"; ' + words
    return subprocess.run(["bash", "-c", script, "-", str(pathlib.Path(root).parent), project, *map(str, arguments)],
                          check=True, capture_output=True, text=True).stdout


def free_port():
    with socket.socket() as made:
        made.bind(("", 0))
        return made.getsockname()[1]


@contextlib.contextmanager
def serving(words, printed, environment=None):
    """A pvserver by these words, and its port, when it accepts connections; what it says goes to the file `printed`."""
    port = free_port()
    said = pathlib.Path(printed)
    with said.open("w") as output:
        server = subprocess.Popen([*words, f"--server-port={port}"], env=environment, stdout=output,
                                  stderr=subprocess.STDOUT)
    try:
        last = time.monotonic() + LONGEST
        while "Accepting" not in said.read_text():
            if server.poll() is not None or time.monotonic() > last:
                raise RuntimeError("pvserver accepts no connection:\n" + said.read_text())
            time.sleep(0.1)
        yield server, port
    finally:
        end(server)

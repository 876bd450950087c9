# SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
# SPDX-License-Identifier: BSD-3-Clause
"""Files that are complete once they have their names."""
import contextlib
import os
import secrets
import shutil


def write_file(content, path):
    """Renames the file when it is complete: on a full disk an existing file is kept. OSError contains the path."""
    path = os.fsdecode(path)
    target = os.path.realpath(path)  # keeps a symbolic link
    temporary = os.path.join(os.path.dirname(target), f".tetmarch-{os.getpid()}-{secrets.token_hex(8)}")
    try:
        exists = os.path.exists(target)
        if exists:
            with open(target, "r+b"):  # the error states why it can't be written
                pass
        with open(temporary, "xb") as file:
            file.write(content)
        if exists:
            shutil.copymode(target, temporary)
        os.replace(temporary, target)
    except OSError as error:
        raise OSError(error.errno, error.strerror, path) from None
    finally:
        with contextlib.suppress(FileNotFoundError):
            os.remove(temporary)

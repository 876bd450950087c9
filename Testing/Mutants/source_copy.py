# SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
# SPDX-License-Identifier: BSD-3-Clause
"""A copy of the sources, into which faults are put. Its own folder `build` is left alone."""
import hashlib
import os
import pathlib
import shutil


def source_files(root):
    """Paths of all sources from the top: neither build folders, nor hidden files, nor what Python keeps."""
    found = []
    for folder, folders, files in os.walk(root):
        here = pathlib.Path(folder).relative_to(root)
        folders[:] = sorted(name for name in folders if not name.startswith(".") and name != "__pycache__"
                            and not (here == pathlib.Path() and name.startswith("build")))
        found += [here / name for name in sorted(files) if not name.startswith(".")]
    return found


def decides(path):
    """Whether a file may decide whether a fault is noticed: words do not, nor does this program."""
    return path.suffix != ".md" and path.parts[0] != "Documentation" and path.parts[:2] != ("Testing", "Mutants")


class SourceCopy:
    def __init__(self, root, copy):
        self.root = pathlib.Path(root)
        self.copy = pathlib.Path(copy)

    @property
    def build(self):
        return self.copy / "build"

    def update(self):
        """Makes the copy equal to the sources; files that are equal keep their times. Returns a hash of the sources."""
        tree = hashlib.sha256()
        files = source_files(self.root)
        for path in files:
            content = (self.root / path).read_bytes()
            there = self.copy / path
            if not there.is_file() or there.read_bytes() != content:
                there.parent.mkdir(parents=True, exist_ok=True)
                shutil.copy(self.root / path, there)
            if decides(path):
                tree.update(f"{path} {len(content)}\n".encode() + content)
        for path in set(source_files(self.copy)) - set(files):
            (self.copy / path).unlink()
        return tree.hexdigest()[:16]

    def apply(self, fault):
        path = self.copy / fault.file
        path.write_text(fault.applied_to(path.read_text(encoding="utf-8")), encoding="utf-8")

    def restore(self, fault):
        shutil.copy(self.root / fault.file, self.copy / fault.file)

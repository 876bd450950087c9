# SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
# SPDX-License-Identifier: BSD-3-Clause
"""The tables of faults: each is a small edit of one file that some test must notice."""
import dataclasses
import hashlib
import json
import pathlib
import tomllib

TABLES = pathlib.Path(__file__).resolve().parent / "Faults"

# What to build for a test of CTest, by the begin of its name; other tests are programs of their own.
TARGETS_OF_CTEST = {
    "TetMarchProcesses": ("vtkRenderingTetMarchPython",),
    "TetMarchPython": ("vtkRenderingTetMarchPython",),
    "TetMarchRender": ("tetmarch-render",),
    "TetMarchWebScripts": ("RenderingTetMarch",),
}


class FaultError(Exception):
    """A table is wrong, or does not fit the sources any more."""


@dataclasses.dataclass(frozen=True)
class NamedTest:
    """Tests of one program: "PROGRAM FILTER" of GoogleTest, or "ctest NAME"."""
    program: str
    filter: str

    @classmethod
    def of(cls, text):
        words = text.split(" ")
        if len(words) != 2 or not all(words):
            raise FaultError(f"{text!r} is neither 'PROGRAM FILTER' nor 'ctest NAME'")
        return cls(*words)

    @property
    def is_ctest(self):
        return self.program == "ctest"

    @property
    def targets(self):
        if not self.is_ctest:
            return (self.program,)
        for begin, targets in TARGETS_OF_CTEST.items():
            if self.filter.startswith(begin):
                return targets
        raise FaultError(f"TARGETS_OF_CTEST does not say what {self.filter} needs")

    def __str__(self):
        return f"{self.program} {self.filter}"


@dataclasses.dataclass(frozen=True)
class Fault:
    name: str
    breaks: str  # what is wrong with it, a sentence
    file: str    # from the top of the sources
    old: str     # occurs once in the file
    new: str
    tests: tuple # of NamedTest; one of them must fail. They run in this order.
    slow: bool = False  # much must be compiled again

    @property
    def targets(self):
        return tuple(sorted({target for test in self.tests for target in test.targets}))

    def applied_to(self, text):
        count = text.count(self.old)
        if count != 1:
            raise FaultError(f"{self.name}: its text occurs {count} times in {self.file}, but must occur once: "
                             f"{self.old!r}")
        return text.replace(self.old, self.new)

    def key(self):
        """Equal for equal edits with equal tests."""
        what = (self.file, self.old, self.new, *map(str, self.tests))
        return hashlib.sha256(json.dumps(what).encode()).hexdigest()[:16]


def read_table(path):
    with open(path, "rb") as file:
        table = tomllib.load(file)
    unknown = set(table) - {"fault", "builds_slowly"}
    if unknown:
        raise FaultError(f"{path.name}: unknown: {', '.join(sorted(unknown))}")
    slow = table.get("builds_slowly", False)
    faults = []
    for row in table["fault"]:
        wanted = {"name", "breaks", "file", "old", "new", "tests"}
        if set(row) != wanted or not row["tests"]:
            raise FaultError(f"{path.name}: {row.get('name', row)} must have {', '.join(sorted(wanted))}, and a test")
        faults.append(Fault(**{**row, "tests": tuple(map(NamedTest.of, row["tests"]))}, slow=slow))
    return faults


def read_faults(folder=TABLES):
    """All faults, those that are built quickly first."""
    faults = [fault for path in sorted(folder.glob("*.toml")) for fault in read_table(path)]
    names = [fault.name for fault in faults]
    twice = sorted({name for name in names if names.count(name) > 1})
    if twice:
        raise FaultError(f"several faults are named {twice[0]}")
    return sorted(faults, key=lambda fault: fault.slow)

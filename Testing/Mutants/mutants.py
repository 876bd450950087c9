# SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
# SPDX-License-Identifier: BSD-3-Clause
"""Puts faults into a copy of the sources, one after the other, and runs the tests that must notice them.

mutants.py FOLDER [OPTION]... [NAME-PATTERN]... Each fault of Testing/Mutants/Faults is built and tested in FOLDER/tree,
whose folder `build` is configured already. FOLDER/mutants.md is the table of what was found, FOLDER/logs has outputs.
A run that was stopped goes on: what was found with the same sources, edit and tests is not tried again. The exit status
is 1 if a fault is not noticed, does not compile, or is to be noticed by a test that fails without it.
"""
import argparse
import fnmatch
import itertools
import pathlib
import sys
import time

import results as found
from faults import FaultError, read_faults
from programs import Programs
from results import Results, count_text, markdown
from source_copy import SourceCopy

PROJECT = pathlib.Path(__file__).resolve().parents[2]
PAGE = PROJECT / "Testing/Mutants/README.md"
BEGIN_OF_TABLE = "## Last results\n"

# A test with a fault is ended after so many seconds, or so many times as long as it takes without.
LEAST_LIMIT = 300
LIMIT_FACTOR = 20
MOST_SECONDS = 7200  # of a test without a fault


def arguments_of(words):
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("folder", type=lambda text: pathlib.Path(text).resolve())
    parser.add_argument("patterns", nargs="*", metavar="NAME-PATTERN", help="only faults with such a name, as 'mesh-*'")
    parser.add_argument("--copy", action="store_true", help="only copy the sources")
    parser.add_argument("--list", action="store_true", help="only print the names")
    parser.add_argument("--seconds", type=float, metavar="N", help="begin no fault after that time")
    parser.add_argument("--older", action="store_true", help="a fault that was noticed with other sources is not tried again")
    parser.add_argument("--page", action="store_true", help="write the table of all faults into the page")
    return parser.parse_intermixed_args(words)


def chosen(faults, patterns):
    """Those that a pattern names; all without patterns."""
    for pattern in patterns:
        if not any(fnmatch.fnmatchcase(fault.name, pattern) for fault in faults):
            raise FaultError(f"no fault is named {pattern}")
    return [fault for fault in faults
            if not patterns or any(fnmatch.fnmatchcase(fault.name, pattern) for pattern in patterns)]


class Runner:
    def __init__(self, copy, programs, results, say=print):
        self.copy = copy
        self.programs = programs
        self.results = results
        self.say = say

    def run(self, faults, goes_on=lambda: True, after=lambda: None):
        """Faults with the same targets are tried together, and those of one file behind each other."""
        def key(fault):
            return fault.slow, fault.targets
        ordered = sorted(faults, key=lambda fault: (*key(fault), fault.file, fault.name))
        for (_, targets), group in itertools.groupby(ordered, key):
            group = list(group)
            self.try_without(group, targets, goes_on)
            for fault in group:
                if goes_on():
                    self.try_fault(fault)
                    after()

    def try_without(self, group, targets, goes_on):
        """Runs the tests of a group once without a fault, if it is not known yet that they pass."""
        unknown = sorted({test for fault in group for test in fault.tests
                          if self.results.seconds_without_fault(test) is None}, key=str)
        if unknown and goes_on():
            if not self.programs.build(targets, "sound"):
                raise FaultError(f"the sources could not be built; see {self.programs.logs}/sound.build.log")
            for test in unknown:
                outcome = self.programs.run(test, MOST_SECONDS, "sound")
                if outcome.passed and outcome.ran:
                    self.results.add_without_fault(test, outcome.seconds)
                else:
                    self.say(f"{test} {'fails without a fault' if outcome.ran else 'is no test'}: {outcome.failed}")

    def try_fault(self, fault):
        begin = time.monotonic()
        status, by = self.status_of(fault)
        self.results.add(fault, status, by, time.monotonic() - begin)
        self.say(f"{fault.name}: {status}{' by ' if by else ''}{by}")

    def status_of(self, fault):
        limits = [self.results.seconds_without_fault(test) for test in fault.tests]
        if None in limits:
            return found.FAILS_WITHOUT, ""
        self.copy.apply(fault)
        try:
            if not self.programs.build(fault.targets, fault.name):
                return found.NOT_BUILT, ""
            for test, seconds in zip(fault.tests, limits):
                outcome = self.programs.run(test, max(LEAST_LIMIT, LIMIT_FACTOR * seconds), fault.name)
                if not outcome.passed:
                    return found.NOTICED, outcome.failed
            return found.UNNOTICED, ""
        finally:
            self.copy.restore(fault)


def write_page(faults, results, older):
    words = PAGE.read_text(encoding="utf-8").split(BEGIN_OF_TABLE)[0]
    PAGE.write_text(f"{words}{BEGIN_OF_TABLE}\n{count_text(faults, results, older)}.\n\n"
                    f"{markdown(faults, results, older)}", encoding="utf-8")


def main(words):
    arguments = arguments_of(words)
    begin = time.monotonic()
    everything = read_faults()
    faults = chosen(everything, arguments.patterns)
    if arguments.list:
        print("\n".join(fault.name for fault in faults))
        return 0
    copy = SourceCopy(PROJECT, arguments.folder / "tree")
    tree = copy.update()
    if arguments.copy:
        return 0
    for fault in faults:
        fault.applied_to((PROJECT / fault.file).read_text(encoding="utf-8"))
    results = Results(arguments.folder / "results.json", tree)
    table = arguments.folder / "mutants.md"

    def write():
        table.write_text(markdown(faults, results, arguments.older), encoding="utf-8")

    runner = Runner(copy, Programs(copy.build, arguments.folder / "logs"), results,
                    say=lambda text: print(text, flush=True))
    left = [fault for fault in faults if not results.of(fault, arguments.older)]
    runner.run(left, lambda: not arguments.seconds or time.monotonic() - begin < arguments.seconds, write)
    write()
    if arguments.page:
        write_page(everything, results, arguments.older)
    print(f"{count_text(faults, results, arguments.older)}; the table is {table}")
    done = [one for fault in faults if (one := results.of(fault, arguments.older))]
    return 0 if all(one["status"] == found.NOTICED for one in done) else 1


if __name__ == "__main__":
    try:
        sys.exit(main(sys.argv[1:]))
    except FaultError as wrong:
        sys.exit(f"mutants.py: error: {wrong}")

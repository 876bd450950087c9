# SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
# SPDX-License-Identifier: BSD-3-Clause
"""What was found, kept from run to run, and as a table."""
import json

NOTICED = "noticed"
UNNOTICED = "not noticed"
NOT_BUILT = "does not compile"
FAILS_WITHOUT = "its test fails without it"


class Results:
    def __init__(self, path, tree):
        self.path = path
        self.tree = tree  # hash of the sources
        self.kept = json.loads(path.read_text(encoding="utf-8")) if path.exists() else {"faults": {}, "sound": {}}

    def of(self, fault, older=False):
        """What was found with these sources; older: or that it was noticed with others."""
        found = self.kept["faults"].get(fault.key())
        counts = found and (found["tree"] == self.tree or (older and found["status"] == NOTICED))
        return found if counts else None

    def add(self, fault, status, by="", seconds=0.0):
        self.kept["faults"][fault.key()] = {"name": fault.name, "tree": self.tree, "status": status, "by": by,
                                            "seconds": round(seconds, 1)}
        self.write()

    def seconds_without_fault(self, test):
        """How long a test takes that passes; None if it is not known yet, or does not."""
        return self.kept["sound"].get(self.tree, {}).get(str(test))

    def add_without_fault(self, test, seconds):
        self.kept["sound"] = {self.tree: {**self.kept["sound"].get(self.tree, {}), str(test): round(seconds, 1)}}
        self.write()

    def write(self):
        self.path.parent.mkdir(parents=True, exist_ok=True)
        self.path.write_text(json.dumps(self.kept, indent=1) + "\n", encoding="utf-8")


def count_text(faults, results, older):
    found = [results.of(fault, older) for fault in faults]
    done = [one for one in found if one]
    noticed = sum(one["status"] == NOTICED for one in done)
    return f"{len(faults)} faults, {len(done)} tried, {noticed} noticed"


def markdown(faults, results, older=False):
    lines = ["| fault | what is broken | file | noticed by | s |", "|---|---|---|---|---|"]
    for fault in sorted(faults, key=lambda fault: fault.name):
        found = results.of(fault, older)
        by = "not tried yet" if not found else found["by"] if found["status"] == NOTICED else f"**{found['status']}**"
        seconds = f"{found['seconds']:.0f}" if found else ""
        lines.append(f"| {fault.name} | {fault.breaks} | `{fault.file}` | {by} | {seconds} |")
    return "\n".join(lines) + "\n"

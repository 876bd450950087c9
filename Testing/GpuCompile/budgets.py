# SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
# SPDX-License-Identifier: BSD-3-Clause
"""What a variant may take (variants.json), what it took when the table was kept (kept.json), and what is worse now."""
import dataclasses
import json
import re


@dataclasses.dataclass
class Budgets:
    rules: list
    most_spills: int
    tolerance: int
    named: dict  # from a name to a line

    @classmethod
    def read(cls, file):
        data = json.loads(file.read_text())
        return cls(data["budgets"], data["most_spills"], data["tolerance"], dict(data["named"]))

    def rule_of(self, line):
        """The rule for a variant, or none."""
        name, *features = line.split()
        for rule in self.rules:
            needed = set(rule["with"])
            allowed = needed | set(rule["may_have"]) if "may_have" in rule else set(features)
            if rule["pass"] == name and needed <= set(features) <= allowed:
                return rule
        return None

    def is_met(self, line, registers, spills):
        rule = self.rule_of(line)
        return spills <= self.most_spills and (rule is None or registers <= rule["registers"])


def version_of(driver):
    """What compiles: Mesa's major and minor version, and the compiler. Only figures of the same are comparable."""
    mesa = re.search(r"Mesa (\d+\.\d+)", driver["driver"])
    compiler = "LLVM" if "LLVM" in driver["driver"] + driver["device"] else "ACO"
    return {"mesa": mesa.group(1) if mesa else driver["driver"], "compiler": compiler, "family": driver["family"]}


def read_kept(file):
    """What compiled, and (registers, demand, waves, spills) of each line."""
    data = json.loads(file.read_text()) if file.exists() else {"version": {}, "variants": {}}
    return data["version"], {line: tuple(numbers) for line, numbers in data["variants"].items()}


def write_kept(file, version, figures):
    rows = ",\n".join(f'  "{line}": [{f.registers}, {f.demand}, {f.waves}, {f.spills}]' for line, f in figures.items())
    file.write_text(f'{{\n "version": {json.dumps(version)},\n "variants": {{\n{rows}\n }}\n}}\n')


def worse(budgets, kept, figures):
    """A sentence for each variant that is worse than it was kept.

    The compiler may take more registers than the code demands, to hide latency. So more of them are worse only where
    the code demands more as well, or where a wave is lost.
    """
    found = []
    for line, now in figures.items():
        if line not in kept:
            continue
        registers, demand, waves, spills = kept[line]
        needs_more = now.waves < waves or now.demand > demand + budgets.tolerance
        rule = budgets.rule_of(line)
        if now.spills > spills:
            found.append(f"spills {now.spills} registers, kept are {spills}: {line}")
        elif now.registers > registers + budgets.tolerance and needs_more:
            found.append(f"takes {now.registers} registers, kept are {registers} and {budgets.tolerance} more: {line}")
        elif rule and registers <= rule["registers"] < now.registers:
            found.append(f"takes {now.registers} registers, its budget is {rule['registers']}, which it met: {line}")
    return found

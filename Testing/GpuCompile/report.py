# SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
# SPDX-License-Identifier: BSD-3-Clause
"""Tables of what variants take."""
import re
import statistics

FEW_WAVES = 4  # below that a SIMD has little to do while others wait for memory
SHADOWS = {"CAST_SHADOWS", "HEADLIGHT_SHADOWS", "OCCLUSION"}
OTHER_BLENDS = {"EXTREME", "SUM", "ISOSURFACES"}
DEPENDENT = {"COLOR_AND_OPACITY", "DIRECT_COLOR"}


def group_of(line):
    """Of pictures by what takes most registers; else the pass."""
    name, *words = line.split()
    features = set(words)
    if name != "picture":
        kind = {"light": "light at vertices", "boundary": "boundary", "pick": "picks"}.get(name)
        return "other passes" if kind is None else kind + (", images" if "STRUCTURED" in features else ", meshes")
    kind = "images" if "STRUCTURED" in features else "meshes"
    if "SAMPLED_SHADOWS" in features:
        return f"{kind}, sampled shadows"
    if "SHADING" in features:
        return f"{kind}, lit, with shadows" if features & SHADOWS else f"{kind}, lit"
    if "INDEPENDENT" in features:
        return f"{kind}, independent components"
    if features & DEPENDENT:
        return f"{kind}, dependent components"
    if features & OTHER_BLENDS:
        return f"{kind}, other blend modes"
    return f"{kind}, one scalar"


def table(head, rows):
    """In Markdown, whose columns a terminal shows one below the other, too."""
    cells = [[str(cell) for cell in row] for row in [head, *rows]]
    widths = [max(map(len, column)) for column in zip(*cells)]
    lines = ["| " + " | ".join(cell.ljust(width) if k == 0 else cell.rjust(width)
                               for k, (cell, width) in enumerate(zip(row, widths))) + " |" for row in cells]
    rule = "|" + "|".join("-" * (width + 2) for width in widths) + "|"
    return "\n".join([lines[0], rule, *lines[1:]]) + "\n"


def target(budgets, line, figures):
    rule = budgets.rule_of(line)
    if figures.spills > budgets.most_spills:
        return "missed: spills"
    if rule is None:
        return ""
    return f"{'met' if budgets.is_met(line, figures.registers, figures.spills) else 'missed'}: {rule['registers']}"


COLUMNS = ("VGPRs", "demand", "SGPRs", "waves", "spills", "scratch", "code", "latency", "throughput", "target")


def row_of(budgets, line, f):
    return (f.registers, f.demand, f.scalar_registers, f.waves, f.spills, f.scratch, f.bytes, f.latency, f.throughput,
            target(budgets, line, f))


def table_of_variants(budgets, figures):
    """The worst first."""
    order = sorted(figures, key=lambda line: (-figures[line].spills, -figures[line].registers, -figures[line].latency))
    return table(("variant", *COLUMNS), [(line, *row_of(budgets, line, figures[line])) for line in order])


def table_of_named(budgets, figures):
    """In short, as the page has it."""
    head = ("scene", "VGPRs", "demand", "waves", "spills", "code", "latency", "target")
    rows = [(name, f.registers, f.demand, f.waves, f.spills, f.bytes, f.latency, target(budgets, line, f))
            for name, line in budgets.named.items() for f in [figures.get(line)] if f]
    return table(head, rows)


def median(numbers):
    return f"{statistics.median(numbers):g}"


def table_of_groups(figures):
    groups = {}
    for line, f in figures.items():
        groups.setdefault(group_of(line), []).append(f)
    return table(("group", "variants", "median VGPRs", "most VGPRs", "median waves", f"below {FEW_WAVES} waves",
                  "that spill", "into memory"),
                 [(name, *summary(groups[name])) for name in sorted(groups)] + [("all", *summary(figures.values()))])


def summary(figures):
    figures = list(figures)
    return (len(figures), median([f.registers for f in figures]), max(f.registers for f in figures),
            median([f.waves for f in figures]), sum(f.waves < FEW_WAVES for f in figures),
            sum(f.spills > 0 for f in figures), sum(f.scratch > 0 for f in figures))


def table_of_targets(budgets, figures):
    rows = []
    for rule in budgets.rules:
        of_rule = [line for line in figures if budgets.rule_of(line) is rule]
        met = [line for line in of_rule if budgets.is_met(line, figures[line].registers, figures[line].spills)]
        rows.append((f"{rule['name']}: {rule['registers']} VGPRs, no spills", len(of_rule), len(met)))
    rows.append(("all: no spills", len(figures), sum(f.spills <= budgets.most_spills for f in figures.values())))
    return table(("target", "variants", "met by"), rows)


def with_tables(page, *tables):
    """The text of a page with these in the place of its tables that begin with the same cell."""
    for new in tables:
        first = new.split("|")[1].strip()
        page, count = re.subn(rf"^\| {first} .*\n(?:\|.*\n)+", lambda _: new, page, flags=re.MULTILINE)
        if count != 1:
            raise ValueError(f"the page has {count} tables that begin with {first}")
    return page

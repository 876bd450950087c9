# SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
# SPDX-License-Identifier: BSD-3-Clause
"""Files that list other files as time steps: ParaView's .pvd (XML) and .series (JSON)."""
import json
import math
import os
import xml.etree.ElementTree as ElementTree

ENDINGS = (".pvd", ".series")


def is_list(path):
    return os.path.splitext(os.fspath(path))[1].lower() in ENDINGS


def entries_of_pvd(path):
    """(time or None, number of the part, name, file) of each entry."""
    try:
        root = ElementTree.parse(path).getroot()
    except ElementTree.ParseError as error:
        raise ValueError(f"it is no XML ({error})") from None
    found = root.find("Collection")
    if found is None:
        raise ValueError("it has no element <Collection> that lists files")
    for entry in found.findall("DataSet"):
        time = entry.get("timestep")
        name = entry.get("name") or entry.get("group") or ""
        yield time, int(entry.get("part") or 0), name, entry.get("file")


def entries_of_json(path):
    with open(path, encoding="utf-8") as file:
        try:
            found = json.load(file)
        except ValueError:
            raise ValueError("it is no JSON") from None
    files = found.get("files") if isinstance(found, dict) else None
    if not isinstance(files, list):
        raise ValueError('it has no list "files"')
    for entry in files:
        if not isinstance(entry, dict) or "time" not in entry or "name" not in entry:
            raise ValueError('each entry of "files" needs a "name" and a "time"')
        yield entry["time"], 0, "", entry["name"]


def number_of(time):
    try:
        number = float(time)
    except (TypeError, ValueError):
        number = math.nan
    if not math.isfinite(number):
        raise ValueError(f"{time!r} is no time")
    return number


def steps_of(path):
    """The times, or () if the list has none, and for each step its (name, file) in the order of their parts."""
    path = os.fspath(path)
    steps = {}
    timed = False
    try:
        for time, part, name, file in (entries_of_pvd if path.lower().endswith(".pvd") else entries_of_json)(path):
            if not isinstance(file, str) or not file:
                raise ValueError("it lists a file without a name")
            if is_list(file):
                raise ValueError(f"it lists {file!r}, which is a list of files itself")
            timed = timed or time is not None
            found = os.path.join(os.path.dirname(path), file)
            steps.setdefault(0.0 if time is None else number_of(time), []).append((part, name, found))
        if not steps:
            raise ValueError("it lists no files")
    except ValueError as error:
        raise ValueError(f"{path!r} can't be read: {error}") from None
    times = tuple(sorted(steps))
    return times if timed else (), [[entry[1:] for entry in sorted(steps[time], key=lambda e: e[0])] for time in times]

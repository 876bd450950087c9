# SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
# SPDX-License-Identifier: BSD-3-Clause
"""Damages files and has the programs read them: fuzz_files.py --driver TetMarchTryFiles --render tetmarch-render
[--window TetMarchTryWindow].

Each file is read by the driver in a process of its own. A sample of them is drawn by tetmarch-render, and another one
opened in the window of tetmarch-view. These are findings: a crash, a hang, a failure without a message, success without
a picture, and memory of more than ten times the file unless a size in the file requires it. Findings are kept in the
folder --keep. The exit status is 1 if there are any.
"""
import argparse
import collections
import os
import pathlib
import random
import resource
import signal
import subprocess
import sys
import tempfile

import damage
import seeds

CPU_SECONDS, WALL_SECONDS = 20, 400
BASE_KIB = 400 * 1024  # of a process of VTK
# Where a reader of VTK crashes, that is told; none of these is read by one.
OURS = {"metaimage", "metaimage-deflated", "nrrd", "nrrd-text", "nhdr", "raw", "preset", "session"}
# The reader of VTK 9.1 makes a polyhedron of as many faces as a binary legacy file says; that of CGNS repeats an error
# without end: see Documentation/Limits.md.
HANGING = {"vtk-mesh-binary", "cgns-adf"}
# The library below VTK 9.1's reader writes beyond its memory, so the program may crash later: see the same page.
BREAKING = {"cgns-adf"}


def make_case(kind, seed_path, number, seed):
    """A damaged file beside its seed, of that number."""
    chance = random.Random(f"{seed} {kind} {number}")
    data = damage.damaged(seed_path.read_bytes(), chance)
    stem = seed_path.stem
    if kind == "raw" and chance.random() < 0.3:
        stem = damage.damaged(stem.encode(), chance).decode(errors="replace")
        stem = "".join(c for c in stem if c.isprintable() and c not in "/\\")[:100]
    path = seed_path.with_name(f"{stem.split('_')[0]}-{number}{stem[len(stem.split('_')[0]):]}{seed_path.suffix}")
    path.write_bytes(data)
    return path


def try_all(driver, paths):
    """(outcome, KiB, message) of each."""
    result = subprocess.run([driver], input="".join(f"{path}\n" for path in paths), text=True, capture_output=True,
                            errors="replace", check=True)
    lines = [line.split("\t", 2) for line in result.stdout.splitlines()]
    assert len(lines) == len(paths), result.stdout[-500:]
    return [(outcome, int(size), message) for outcome, size, message in lines]


def is_of_readers(kind, outcome):
    """Whether it is what readers of VTK do, which nothing of ours can keep them from."""
    return (outcome == "reader" and kind not in OURS or outcome == "hung" and kind in HANGING
            or outcome == "crashed" and kind in BREAKING)


def is_sound(kind, path, outcome, kib):
    # What is refused was refused for a size, or a size asked for the memory.
    return (is_of_readers(kind, outcome) or outcome == "refused"
            or (outcome == "read" and kib < BASE_KIB + 10 * path.stat().st_size // 1024))


def limit_process():
    resource.setrlimit(resource.RLIMIT_CPU, (CPU_SECONDS, CPU_SECONDS))
    resource.setrlimit(resource.RLIMIT_CORE, (0, 0))


def draw(render, kind, path, mesh):
    """What is wrong with how tetmarch-render ends, or None."""
    picture = path.with_suffix(".png")
    data = [mesh, "--preset", path] if path.stem.startswith("preset") else [path]
    command = [render, *map(str, data), "--size", "32x24", "--threads", "1", "--quiet", "--output", str(picture)]
    try:
        result = subprocess.run(command, capture_output=True, text=True, errors="replace", timeout=WALL_SECONDS,
                                preexec_fn=limit_process)
    except subprocess.TimeoutExpired:
        return "hangs"
    drawn = picture.exists() and picture.read_bytes().startswith(b"\x89PNG") and picture.stat().st_size > 60
    picture.unlink(missing_ok=True)
    if result.returncode == 0:
        return None if drawn else "success without a picture"
    if result.returncode < 0:
        ending = "hung" if -result.returncode in (signal.SIGXCPU, signal.SIGKILL) else "crashed"
        if is_of_readers(kind, ending):
            return None
    if result.returncode not in (1, 2):
        return f"ends with {result.returncode}: {result.stderr[-300:]}"
    return None if "tetmarch-render: error: " in result.stderr and not drawn else "failure without a message"


def open_in_window(window, paths, folder):
    """(outcome, message) of each, one after the other in the same window; in another one if that has ended."""
    results = []
    while len(results) < len(paths):
        rest = paths[len(results):]
        run = subprocess.run([window], input="".join(f"{path}\n" for path in rest), text=True, capture_output=True,
                             errors="replace", cwd=folder)
        results += [tuple(line.split("\t", 1)) for line in run.stdout.splitlines()]
        if len(results) < len(paths):
            told = run.stderr[-300:]
            results.append(("reader" if run.returncode == 1 and "VTK's reader crashed" in told else
                            "hung" if -run.returncode in (signal.SIGXCPU, signal.SIGALRM) else "crashed",
                            f"the window ends with {run.returncode}: {told}"))
        elif run.returncode != 0:
            results[-1] = ("crashed", f"the window ends with {run.returncode} at its end: {run.stderr[-300:]}")
    return results


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--driver", required=True)
    parser.add_argument("--render", required=True)
    parser.add_argument("--window", type=os.path.abspath, help="TetMarchTryWindow; it wants a display")
    parser.add_argument("--each", type=int, default=40, help="files of each kind")
    parser.add_argument("--drawn", type=int, default=30, help="how many in all tetmarch-render draws")
    parser.add_argument("--opened", type=int, default=12, help="how many in all the window opens")
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--only", nargs="*", help="kinds")
    parser.add_argument("--keep", type=pathlib.Path, help="folder for what was found")
    arguments = parser.parse_args()

    session = subprocess.run([arguments.driver, "--session", "vtu-ascii/seed.vtu"], text=True, capture_output=True,
                             check=True).stdout
    found, counts, in_window = [], collections.Counter(), collections.Counter()
    with tempfile.TemporaryDirectory() as folder:
        originals = seeds.write_seeds(pathlib.Path(folder), session)
        kinds = [kind for kind in originals if not arguments.only or kind in arguments.only]
        for kind, result in zip(kinds, try_all(arguments.driver, [originals[kind] for kind in kinds])):
            assert result[0] == "read", f"the sound file of {kind}: {result}"
        cases = [(kind, make_case(kind, originals[kind], number, arguments.seed))
                 for kind in kinds for number in range(arguments.each)]
        for (kind, path), (outcome, kib, message) in zip(cases, try_all(arguments.driver, [path for _, path in cases])):
            counts[kind, outcome] += 1
            if not is_sound(kind, path, outcome, kib):
                found.append((kind, path, f"{outcome}, {kib} KiB: {message}"))
        chance = random.Random(arguments.seed)
        drawable = [case for case in cases if case[0] != "session"]
        for kind, path in chance.sample(drawable, min(arguments.drawn, len(drawable))):
            wrong = draw(arguments.render, kind, path, originals.get("vtu-ascii", path))
            if wrong:
                found.append((kind, path, f"tetmarch-render {wrong}"))
        if arguments.window:
            chance = random.Random(f"{arguments.seed} window")
            openable = [case for case in cases if case[0] != "preset"]
            opened = chance.sample(openable, min(arguments.opened, len(openable)))
            sound = [originals[kind] for kind in kinds if kind != "preset"]
            for path, result in zip(sound, open_in_window(arguments.window, sound, folder)):
                assert result[0] == "read", f"the sound file {path} in the window: {result}"
            for kind, path in opened:  # a reader may leave a window behind that crashes later, so each has its own
                (outcome, message), = open_in_window(arguments.window, [path], folder)
                in_window[outcome] += 1
                if outcome not in ("read", "refused") and not is_of_readers(kind, outcome):
                    found.append((kind, path, f"tetmarch-view: {outcome}: {message}"))
        for kind, path, what in found:
            print(f"{kind}: {path.name}: {what}")
            if arguments.keep:
                arguments.keep.mkdir(parents=True, exist_ok=True)
                (arguments.keep / f"{kind}-{path.name}").write_bytes(path.read_bytes())
    outcomes = ("read", "refused", "reader", "crashed", "hung", "silent", "unclear")
    print(f"{'kind':20}" + "".join(f"{outcome:>9}" for outcome in outcomes))
    for kind in kinds:
        print(f"{kind:20}" + "".join(f"{counts[kind, outcome]:9}" for outcome in outcomes))
    if arguments.window:
        print(f"{sum(in_window.values())} of them in the window: "
              + ", ".join(f"{count} {outcome}" for outcome, count in sorted(in_window.items())))
    print(f"{len(cases)} files, {len(found)} findings")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())

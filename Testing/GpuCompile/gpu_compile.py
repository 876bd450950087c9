# SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
# SPDX-License-Identifier: BSD-3-Clause
"""What a real GPU's compiler makes of the shaders, without a GPU: gpu_compile.py BUILD [OPTION]...

Mesa's Vulkan driver for AMD (RADV) compiles the variants that the tests have the GL build. What they take is printed,
the worst first, and compared with Testing/GpuCompile/kept.json. The exit status is 1 where a variant spills more
registers than is kept there, takes more of them than is kept and a tolerance, or leaves a budget that it met.
"""
import argparse
import pathlib
import sys

import budgets as budgets_of
import report
from compiled_shaders import NotCompiled, Toolchain

HERE = pathlib.Path(__file__).resolve().parent
KEPT = HERE / "kept.json"
PAGE = HERE.parents[1] / "Documentation/GpuCompile.md"
KEPT_FAMILY = "navi21"
ICDS = ("radeon_icd.x86_64.json", "radeon_icd.json")
ICD_FOLDERS = ("/usr/share/vulkan/icd.d", "/usr/local/share/vulkan/icd.d", "/etc/vulkan/icd.d")


def find_icd():
    found = [str(path) for folder in ICD_FOLDERS for path in (pathlib.Path(folder) / name for name in ICDS)
             if path.exists()]
    if not found:
        sys.exit("gpu_compile.py: there is no Vulkan driver for AMD (Debian's mesa-vulkan-drivers)")
    return found[0]


def rdna(name):
    """RADV counts the waves of others in another way."""
    if not name.startswith(("navi", "gfx1")):
        raise argparse.ArgumentTypeError("must be a GPU of RDNA, such as navi21")
    return name


def arguments_of(words):
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("build", type=lambda text: pathlib.Path(text).resolve())
    parser.add_argument("--named", action="store_true", help="only the variants that variants.json has names for")
    parser.add_argument("--update", action="store_true", help="write kept.json and the tables of the page anew instead of comparing")
    parser.add_argument("--family", type=rdna, default=KEPT_FAMILY, help="of AMD's GPUs of RDNA (%(default)s)")
    parser.add_argument("--jobs", type=int, default=2, help="processes at a time (%(default)s)")
    parser.add_argument("--markdown", type=pathlib.Path, metavar="FILE.md", help="write the tables there, too")
    parser.add_argument("--variants", type=pathlib.Path, default=HERE / "variants.json", metavar="FILE.json",
                        help="budgets and names")
    parser.add_argument("--kept", type=pathlib.Path, default=KEPT, metavar="FILE.json")
    parser.add_argument("--icd", metavar="FILE.json", help="of the driver")
    parser.add_argument("--validator", default="glslangValidator", help="Khronos' compiler")
    arguments = parser.parse_args(words)
    if arguments.update and (arguments.named or arguments.family != KEPT_FAMILY):
        parser.error(f"--update writes the figures of all variants, for {KEPT_FAMILY}")
    return arguments


def lines_to_compile(arguments, tools, budgets, kept):
    """Of a listing that has changed, as it does by a new feature, those that were kept are compiled, too."""
    lines = list(budgets.named.values())
    if not arguments.named:
        lines += tools.shaders("list")
        if not arguments.update:
            lines += tools.shaders("legal", lines=kept)
    return list(dict.fromkeys(lines))


def show_progress(done, of):
    if sys.stderr.isatty():
        print(f"\r{done} of {of} shaders", end="\n" if done == of else "", file=sys.stderr, flush=True)


def compare(budgets, kept_version, kept, version, figures):
    """What to print, and the exit status."""
    known = sum(line in kept for line in figures)
    found = budgets_of.worse(budgets, kept, figures)
    lines = [f"{known} of {len(figures)} variants have kept figures; {len(found)} of them are worse"]
    lines += [f"worse: {sentence}" for sentence in found]
    if not kept:
        return ["no figures are kept; --update keeps those above"], 0
    if version != kept_version:
        lines.append(f"this is no failure, since other figures come of another compiler: kept are those of "
                     f"{kept_version}, this is {version}")
        return lines, 0
    return lines, 1 if found else 0


def main(words):
    arguments = arguments_of(words)
    budgets = budgets_of.Budgets.read(arguments.variants)
    kept_version, kept = budgets_of.read_kept(arguments.kept)
    tools = Toolchain(arguments.build, arguments.family, arguments.icd or find_icd(), arguments.validator,
                      arguments.jobs)
    try:
        driver, figures = tools.compile(lines_to_compile(arguments, tools, budgets, kept), show_progress)
    except NotCompiled as error:
        sys.exit(f"gpu_compile.py: {error}")
    version = budgets_of.version_of(driver)
    text = f"{driver['device']}, {driver['driver']}, compiled by {version['compiler']}\n\n"
    tables = [report.table_of_named(budgets, figures), report.table_of_targets(budgets, figures)]
    if not arguments.named:
        tables.insert(0, report.table_of_groups(figures))
        text += report.table_of_variants(budgets, figures) + "\n"
    text += "\n".join(tables)
    print(text)
    if arguments.markdown:
        arguments.markdown.write_text(text)
    if arguments.update:
        budgets_of.write_kept(arguments.kept, version, figures)
        print(f"wrote {arguments.kept}")
        if arguments.kept == KEPT:
            PAGE.write_text(report.with_tables(PAGE.read_text(encoding="utf-8"), *tables), encoding="utf-8")
            print(f"wrote the tables of {PAGE}")
        return 0
    lines, status = compare(budgets, kept_version, kept, version, figures)
    print("\n".join(lines))
    return status


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))

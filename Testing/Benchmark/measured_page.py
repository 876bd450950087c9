# SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
# SPDX-License-Identifier: BSD-3-Clause
"""What the pages that are made of measurements have in common: a template whose @words@ are filled in."""
import argparse
import pathlib


def parser_of(description, *paths):
    parser = argparse.ArgumentParser(description=description)
    for name in paths:
        parser.add_argument(name, type=pathlib.Path)
    parser.add_argument("--remark", default="", help="what to say of this run beside its machine")
    return parser


def grid_options(description, count, default, frames=7, **how):
    """The folder of a table, which is made, the number of cells, the size of the window and the number of frames."""
    parser = argparse.ArgumentParser(description=description.splitlines()[0])
    parser.add_argument("folder", type=pathlib.Path)
    parser.add_argument(count, type=int, default=default, **how)
    parser.add_argument("--size", type=lambda text: [int(n) for n in text.split("x")], default="512x512")
    parser.add_argument("--frames", type=int, default=frames)
    options = parser.parse_args()
    options.folder.mkdir(parents=True, exist_ok=True)
    return options


def charts_folder(output):
    folder = output / "Charts"
    folder.mkdir(parents=True, exist_ok=True)
    return folder


def row(cells):
    return "| " + " | ".join(cells) + " |\n"


def machine(report):
    environment = report["environment"] or {"vtk_version": "?", "gl": {"renderer": "?", "backend": "?"}}
    return (
        f"{report['date']}, TetMarch {report['tetmarch_version']}, VTK {environment['vtk_version']}, "
        f"{environment['gl']['renderer']} by {environment['gl']['backend']}; {report['cpu']}, "
        f"{report['cpu_threads']} threads"
    )


def measured_table(report_file):
    """Of the file in Markdown that tetmarch-bench writes beside its JSON: all but the heading."""
    table = report_file.with_suffix(".md")
    return table.read_text().split("\n", 2)[2] if table.exists() else ""


def write_page(page, report, remark, parts):
    """Fills the template of Accuracy.md, AccuracyPage.md, with parts by name and with what every report has."""
    text = pathlib.Path(__file__).resolve().with_name(f"{page.stem}Page.md").read_text()
    common = {
        "machine": machine(report),
        "remark": remark,
        "size": " x ".join(str(n) for n in report["size"]),
        "frames": str(report["frames"]),
    }
    for name, value in {**common, **parts}.items():
        text = text.replace(f"@{name}@", value.rstrip("\n"))
    page.write_text(text)
    print(f"wrote {page} and charts beside it")

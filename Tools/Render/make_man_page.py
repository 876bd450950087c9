# SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
# SPDX-License-Identifier: BSD-3-Clause
"""The manual page of tetmarch-render from what its --help says: make_man_page.py EXECUTABLE OUTPUT"""
import re
import subprocess
import sys

SECTIONS = ("Environment", "Exit status")


def escape(text):
    """Text as roff has it: no hyphens for minus signs, no line that is a request."""
    text = text.replace("\\", "\\e").replace("-", "\\-")
    return "\\&" + text if text.startswith((".", "'")) else text


def entries(lines):
    """Pairs of what stands on the left and its description, from lines of options."""
    found = []
    for line in lines:
        if line.startswith("  ") and line[2] != " ":
            parts = re.split(r"\s{2,}", line.strip(), maxsplit=1)
            found.append([parts[0], parts[1:]])
        else:
            found[-1][1].append(line.strip())
    return [(left, " ".join(words)) for left, words in found]


def blocks(text):
    """Paragraphs of the help, each a list of lines."""
    return [block.splitlines() for block in text.strip().split("\n\n")]


def page(help_text, version):
    usage, description, *groups = blocks(help_text)
    synopsis = usage[0].removeprefix("Usage: ").removeprefix("tetmarch-render ")
    out = [f'.TH TETMARCH\\-RENDER 1 "" "{version}" "User Commands"',
           ".SH NAME", "tetmarch\\-render \\- draw a volume of an unstructured grid or an image",
           ".SH SYNOPSIS", ".B tetmarch\\-render", escape(synopsis),
           ".SH DESCRIPTION", escape(" ".join(description)), ".SH OPTIONS"]
    for lines in groups:
        title = "" if lines[0].startswith(" ") else lines[0]
        body = lines[1:] if title else lines
        if title.startswith("Exit status"):
            out += [".SH EXIT STATUS", escape(title.split(": ", 1)[1])]
            continue
        if title:
            out.append(f".SH {title.upper()}" if title in SECTIONS else f'.SS "{escape(title)}"')
        for left, words in entries(body):
            out += [".TP", f".B {escape(left)}", escape(words) if words else "\\&"]
    return "\n".join(out) + "\n"


def main():
    executable, output = sys.argv[1:]
    help_text, version = (subprocess.run([executable, option], check=True, capture_output=True, text=True).stdout
                          for option in ("--help", "--version"))
    with open(output, "w", encoding="utf-8") as file:
        file.write(page(help_text, " ".join(version.split()[:2])))


if __name__ == "__main__":
    main()

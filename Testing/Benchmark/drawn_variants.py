# SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
# SPDX-License-Identifier: BSD-3-Clause
"""Which variants of the shader were drawn, by the texts that Mesa got (MESA_SHADER_CAPTURE_PATH)."""
import re

FRAGMENT = "[fragment shader]"


def lines_of(text):
    """The lines of a shader, without what VTK writes before it and with VTK's names of the outputs."""
    _, mark, rest = text.partition("#line")
    named = re.sub(r"gl_FragData\[(\d+)\]", r"fragOutput\1", mark + rest)
    stripped = (line.strip() for line in named.splitlines())
    return [line for line in stripped if line and not line.startswith(("//", "#line", "out vec4 fragOutput"))]


def contains_in_order(lines, wanted):
    rest = iter(lines)
    return all(line in rest for line in wanted)


def captured_shaders(folder):
    """The distinct fragment shaders, each as a tuple of its lines."""
    return {tuple(lines_of(file.read_text().partition(FRAGMENT)[2])) for file in folder.glob("*.shader_test")}


def is_drawn(wanted, captured):
    """Passes that peel add lines to a shader, others leave it as it is."""
    return tuple(wanted) in captured or any("peel" in " ".join(lines).lower() and contains_in_order(lines, wanted)
                                            for lines in captured)


def missing_variants(texts, captures, numbers):
    """Those of the numbered variants that were not drawn: no text of theirs was compiled."""
    captured = captured_shaders(captures)
    return [number for number in numbers
            if not any(is_drawn(lines_of(text.read_text()), captured) for text in texts.glob(f"{number}-*.frag"))]

# SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
# SPDX-License-Identifier: BSD-3-Clause
"""What the driver's compiler makes of variants: texts by tetmarch-gpu-shaders, SPIR-V by glslangValidator, figures by
tetmarch-gpu-statistics."""
import concurrent.futures
import dataclasses
import json
import os
import pathlib
import subprocess
import tempfile

PORTION = 8  # shaders of one process


class NotCompiled(Exception):
    """With what a tool said."""


@dataclasses.dataclass
class Figures:
    """Of one shader, as the driver tells them."""
    registers: int  # vector registers, one value for each ray of a wave
    demand: int  # of these, before the compiler orders instructions to hide latency, and takes more
    scalar_registers: int
    waves: int  # that a SIMD can hold at a time
    spills: int  # registers that don't fit, vector and scalar ones
    scratch: int  # bytes of memory that a wave needs for them
    bytes: int  # of code
    latency: int  # cycles of a wave, as the compiler estimates
    throughput: int  # cycles of a SIMD for each wave that runs, the same

    @classmethod
    def of(cls, result):
        statistics = {name: int(number) for name, number in result["statistics"].items()}
        # From RDNA on RADV counts by 32 rays, and so a wave of 64 twice.
        waves = statistics.get("Subgroups per SIMD", 0) * 32 // (result["subgroup_size"] or 32)
        return cls(statistics["VGPRs"], statistics.get("Pre-Sched VGPRs", 0), statistics.get("SGPRs", 0), waves,
                   statistics.get("Spilled VGPRs", 0) + statistics.get("Spilled SGPRs", 0),
                   statistics.get("Scratch size", 0), statistics.get("Code size", 0),
                   statistics.get("Latency", 0), statistics.get("Inverse Throughput", 0))


@dataclasses.dataclass
class Toolchain:
    build: pathlib.Path
    family: str
    icd: str
    validator: str = "glslangValidator"
    jobs: int = 2

    def shaders(self, *arguments, lines=()):
        """What tetmarch-gpu-shaders prints, line by line."""
        result = subprocess.run([self.build / "bin/tetmarch-gpu-shaders", *arguments], text=True, capture_output=True,
                                input="".join(line + "\n" for line in lines))
        if result.returncode:
            raise NotCompiled(result.stderr.strip())
        return result.stdout.splitlines()

    @property
    def environment(self):
        # No layer, no cache, and no settings of the user may change what is compiled.
        kept = {name: value for name, value in os.environ.items()
                if not name.startswith(("VK_", "RADV_", "ACO_", "MESA_", "AMD_"))}
        return {**kept, "RADV_FORCE_FAMILY": self.family, "VK_ICD_FILENAMES": self.icd, "VK_DRIVER_FILES": self.icd,
                "VK_LOADER_LAYERS_DISABLE": "~implicit~", "MESA_SHADER_CACHE_DISABLE": "true"}

    def to_spirv(self, source):
        """-R: uniforms outside of blocks, which Vulkan's GLSL has not."""
        result = subprocess.run([self.validator, "-V", "-R", "--auto-map-bindings", "--auto-map-locations", source,
                                 "-o", f"{source}.spv"], text=True, capture_output=True)
        if result.returncode:
            raise NotCompiled(f"{source}:\n{result.stdout}{result.stderr}")
        return f"{source}.spv"

    def portion(self, vertex, sources):
        """The driver, then the result of each source."""
        result = subprocess.run([self.build / "bin/tetmarch-gpu-statistics", vertex, *map(self.to_spirv, sources)],
                                text=True, capture_output=True, env=self.environment)
        rows = [json.loads(line) for line in result.stdout.splitlines()]
        for row in rows:
            if "error" in row:
                raise NotCompiled(f"{row['file']}: {row['error']}")
        if result.returncode or len(rows) != len(sources) + 1:
            raise NotCompiled(result.stderr.strip() or f"the driver ended with {result.returncode}")
        return rows

    def compile(self, lines, progress=lambda done, of: None):
        """The driver, and the figures of each line: a pass and its features."""
        figures = {}
        driver = {}
        with tempfile.TemporaryDirectory() as folder, \
                concurrent.futures.ThreadPoolExecutor(self.jobs) as pool:
            self.shaders("write", folder, lines=lines)
            vertex = self.to_spirv(f"{folder}/pass.vert")
            portions = [list(enumerate(lines))[at:at + PORTION] for at in range(0, len(lines), PORTION)]
            sources = [[f"{folder}/{number}.frag" for number, _ in portion] for portion in portions]
            for portion, rows in zip(portions, pool.map(lambda files: self.portion(vertex, files), sources)):
                driver = rows[0]
                for (_, line), row in zip(portion, rows[1:]):
                    figures[line] = Figures.of(row)
                progress(len(figures), len(lines))
        return {**driver, "family": self.family}, figures

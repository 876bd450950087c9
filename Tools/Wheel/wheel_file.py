# SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
# SPDX-License-Identifier: BSD-3-Clause
"""Writes a wheel, and its metadata (PEP 427, PEP 621, core metadata 2.1)."""
import base64
import hashlib
import sys
import sysconfig
import zipfile

GENERATOR = "tetmarch"


def tag():
    """The tag of wheels for this Python and this machine: cp311-cp311-linux_x86_64."""
    python = f"cp{sys.version_info.major}{sys.version_info.minor}"
    return f"{python}-{python}-{sysconfig.get_platform().replace('-', '_').replace('.', '_')}"


def metadata(project, version, dependencies, readme):
    """The text of METADATA.

    project: the table [project] of pyproject.toml. dependencies: lines of the metadata. readme: Markdown.
    """
    lines = ["Metadata-Version: 2.1", f"Name: {project['name']}", f"Version: {version}",
             f"Summary: {project['description']}", f"License: {project['license']['text']}",
             f"Requires-Python: {project['requires-python']}", f"Keywords: {','.join(project['keywords'])}"]
    lines += [f"Author: {author['name']}" for author in project["authors"]]
    lines += [f"Classifier: {classifier}" for classifier in project["classifiers"]]
    lines += [*dependencies, "License-File: LICENSE", "Description-Content-Type: text/markdown"]
    return "\n".join(lines) + "\n\n" + readme


def entry_points(project):
    """The text of entry_points.txt."""
    groups = {"console_scripts": project["scripts"], **project["entry-points"]}
    return "\n".join(f"[{group}]\n" + "".join(f"{name} = {target}\n" for name, target in entries.items())
                     for group, entries in groups.items())


def info_files(project, version, dependencies, readme, license_text):
    """The files of the folder .dist-info but RECORD: {name: text}."""
    return {"METADATA": metadata(project, version, dependencies, readme),
            "WHEEL": f"Wheel-Version: 1.0\nGenerator: {GENERATOR} ({version})\nRoot-Is-Purelib: false\nTag: {tag()}\n",
            "entry_points.txt": entry_points(project),
            "licenses/LICENSE": license_text}


def write_wheel(path, files):
    """Writes a wheel of files: {name in the wheel: (bytes, whether it is a program)}, the .dist-info folder last."""
    record = []
    info = next(name.split("/")[0] for name in files if name.split("/")[0].endswith(".dist-info"))
    with zipfile.ZipFile(path, "w", zipfile.ZIP_DEFLATED) as wheel:
        for name, (content, is_program) in files.items():
            entry = zipfile.ZipInfo(name, (2026, 1, 1, 0, 0, 0))  # the same wheel from the same files
            entry.compress_type = zipfile.ZIP_DEFLATED
            entry.external_attr = (0o100755 if is_program else 0o100644) << 16
            wheel.writestr(entry, content)
            digest = base64.urlsafe_b64encode(hashlib.sha256(content).digest()).rstrip(b"=").decode()
            record.append(f"{name},sha256={digest},{len(content)}\n")
        wheel.writestr(f"{info}/RECORD", "".join(record) + f"{info}/RECORD,,\n")

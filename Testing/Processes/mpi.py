# SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
# SPDX-License-Identifier: BSD-3-Clause
"""Runs a script in several processes, for so long and no longer."""
import importlib.util
import os
import pathlib
import shutil
import subprocess
import sys

HERE = pathlib.Path(__file__).resolve().parent
# More processes than cores (OMPI_MCA_... with Open MPI 4, PRTE_MCA_... with 5), also as root, as in a container.
ENVIRONMENT = {"OMPI_ALLOW_RUN_AS_ROOT": "1", "OMPI_ALLOW_RUN_AS_ROOT_CONFIRM": "1",
               "OMPI_MCA_rmaps_base_oversubscribe": "1", "PRTE_MCA_rmaps_default_mapping_policy": ":oversubscribe",
               "OMPI_MCA_mpi_yield_when_idle": "1",
               "OMPI_MCA_btl_vader_single_copy_mechanism": "none", "LP_NUM_THREADS": "1"}


def has_mpi():
    return shutil.which("mpiexec") is not None and importlib.util.find_spec("mpi4py") is not None


def run(processes, script, *arguments, seconds=1000):
    """Returns what the processes wrote. A process that waits for ever is an error."""
    paths = [str(HERE), str(HERE.parent / "Benchmark"), os.environ.get("PYTHONPATH", "")]
    # mpi4py's own runner ends all processes when one raises an exception; else the others wait for it.
    command = ["mpiexec", "-n", str(processes), sys.executable, "-m", "mpi4py", str(HERE / script),
               *map(str, arguments)]
    result = subprocess.run(command, text=True, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, timeout=seconds,
                            env={**os.environ, **ENVIRONMENT, "PYTHONPATH": os.pathsep.join(paths)})
    if result.returncode != 0:
        raise AssertionError(f"{' '.join(command)} ended with {result.returncode}:\n{result.stdout}")
    return result.stdout

# SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
# SPDX-License-Identifier: BSD-3-Clause
"""Builds targets and runs tests in a build folder."""
import dataclasses
import os
import re
import resource
import signal
import subprocess
import time

MOST_MEMORY = 8 << 30  # of a test, in bytes: a fault may make it take all there is


@dataclasses.dataclass(frozen=True)
class Outcome:
    passed: bool
    ran: bool        # at least one test ran
    seconds: float
    failed: str = "" # the first test that failed, or why the program ended


def limit_process():
    resource.setrlimit(resource.RLIMIT_DATA, (MOST_MEMORY, MOST_MEMORY))
    resource.setrlimit(resource.RLIMIT_CORE, (0, 0))


def run_logged(command, log, limit=None, environment=None, prepare=None):
    """Returns the exit status, or None if the command was ended after `limit` seconds with all that it has started."""
    with open(log, "w", encoding="utf-8") as output:
        process = subprocess.Popen(command, stdout=output, stderr=subprocess.STDOUT, stdin=subprocess.DEVNULL,
                                   env=environment, start_new_session=True, preexec_fn=prepare)
        try:
            return process.wait(limit)
        except BaseException as stopped:
            os.killpg(process.pid, signal.SIGKILL)
            process.wait()
            if isinstance(stopped, subprocess.TimeoutExpired):
                return None
            raise


def failed_test_of_gtest(output):
    """The first test that failed; if the program crashed, the one that ran."""
    failed = re.findall(r"^\[  FAILED  \] (\S+?),? ", output, re.MULTILINE)
    running = re.findall(r"^\[ RUN      \] (\S+)", output, re.MULTILINE)
    return failed[0] if failed else running[-1] if running else ""


def failed_test_of_python(output):
    failed = re.findall(r"^(?:FAIL|ERROR): (\w+)", output, re.MULTILINE)
    return failed[0] if failed else ""


class Programs:
    """The build folder of a copy of the sources."""

    def __init__(self, build, logs):
        self.folder = build
        self.logs = logs
        logs.mkdir(parents=True, exist_ok=True)

    def build(self, targets, log):
        """Returns whether all could be built."""
        return run_logged(["cmake", "--build", self.folder, "--target", *targets], self.logs / f"{log}.build.log") == 0

    def run(self, test, limit, log):
        command, environment = self.command_of(test, limit)
        path = self.logs / f"{log}.test.log"
        begin = time.monotonic()
        status = run_logged(command, path, limit, environment, limit_process)
        seconds = time.monotonic() - begin
        output = path.read_text(encoding="utf-8", errors="replace")
        if test.is_ctest:
            ran = "No tests were found" not in output
            name = " ".join(filter(None, (test.filter, failed_test_of_python(output))))
        else:
            ran = re.search(r"^\[==========\] Running 0 tests", output, re.MULTILINE) is None
            name = failed_test_of_gtest(output) or f"{test.program}, which ended with {status}"
        if status is None:
            name += f" (not done after {limit:.0f} s)"
        return Outcome(status == 0, ran, seconds, "" if status == 0 else name)

    def command_of(self, test, limit):
        if test.is_ctest:
            return ["ctest", "--test-dir", self.folder, "-R", f"^{test.filter}$", "--no-tests=error",
                    "--output-on-failure", "--timeout", str(int(limit) + 10)], None
        return [self.folder / "bin" / test.program, f"--gtest_filter={test.filter}", "--gtest_fail_fast",
                "--gtest_color=no"], {**os.environ, "TETMARCH_GL": "egl", "DISPLAY": ""}

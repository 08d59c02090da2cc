# SPDX-License-Identifier: Apache-2.0
# SPDX-FileCopyrightText: The Gonio authors
"""Runs goniotool for the attacks."""

import hashlib
import os
import pathlib
import resource
import shutil
import subprocess
import tempfile

MEMORY = 8 << 30
SANITIZED = bool({"ASAN_OPTIONS", "TSAN_OPTIONS"} & os.environ.keys())  # sanitizers reserve terabytes of addresses
TIMEOUT = 3000 if SANITIZED else 300  # s


def digest(path):
    return hashlib.sha256(path.read_bytes()).hexdigest()


class Attack:
    """Runs goniotool in a folder of its own and collects findings."""

    def __init__(self, name, tool):
        self.name, self.tool = name, tool
        self.runs, self.findings = 0, []
        self.folder = pathlib.Path(tempfile.mkdtemp(prefix=f"gonio-{name}-"))

    def start(self, arguments, **options):
        return subprocess.Popen([self.tool, *map(str, arguments)], cwd=self.folder, stdout=subprocess.PIPE,
                                stderr=subprocess.PIPE, text=True, errors="replace", **options)

    def run(self, arguments, limit_memory=False, environment=None):
        self.runs += 1
        limit_memory = limit_memory and not SANITIZED
        limit = (lambda: resource.setrlimit(resource.RLIMIT_AS, (MEMORY, MEMORY))) if limit_memory else None
        process = self.start(arguments, preexec_fn=limit, env={**os.environ, **(environment or {})})
        try:
            output, error = process.communicate(timeout=TIMEOUT)
        except subprocess.TimeoutExpired:
            process.kill()
            output, error = process.communicate()
            error = f"still running after {TIMEOUT} s"
        return process.returncode, output, error

    def finding(self, arguments, text):
        self.findings.append(f"{self.name}: goniotool {' '.join(map(str, arguments))}: {text}")

    def leftovers(self, known):
        return sorted(str(p.relative_to(self.folder)) for p in self.folder.rglob("*") if p not in known and p.is_file())

    def close(self):
        shutil.rmtree(self.folder, ignore_errors=True)

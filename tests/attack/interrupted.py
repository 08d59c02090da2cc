# SPDX-License-Identifier: Apache-2.0
# SPDX-FileCopyrightText: The Gonio authors
"""SIGINT and SIGKILL at random times."""

import random
import signal
import subprocess
import time

from runner import digest

RUNS = 20

LONG = [["fit", "library:merl-copy/chrome", "--model", "he", "--out", "x.binary"],
        ["factor", "library:merl-copy/aluminium", "--terms", "10", "--out", "x.pdv"],
        ["encode", "library:merl-copy/aluminium", "--coefficients", "4096", "--out", "x.code"],
        ["render", "library:merl-copy/aluminium", "--size", "256", "--samples", "256", "--out", "x.exr"],
        ["plan", "--samples", "8", "--out", "x.csv"],
        ["export", "library:merl-copy/aluminium", "x", "--for", "mitsuba"]]


def signals(attack, _):
    rng = random.Random(2)
    for arguments in LONG:
        started = time.monotonic()
        code, _, error = attack.run(arguments)
        duration = time.monotonic() - started
        whole = {p.name: digest(p) for p in attack.folder.iterdir()}
        if code != 0 or not whole:
            attack.finding(arguments, f"does not run: {error.strip()[:200]}")
        for i in range(RUNS if whole else 0):
            for file in attack.folder.iterdir():
                file.unlink()
            attack.runs += 1
            kind = signal.SIGINT if i % 2 else signal.SIGKILL
            process = attack.start(arguments)
            time.sleep(rng.uniform(0, duration))
            process.send_signal(kind)
            try:
                _, error = process.communicate(timeout=60)
            except subprocess.TimeoutExpired:
                process.kill()
                process.communicate()
                attack.finding(arguments, "runs on for a minute after SIGINT")
                continue
            found = {p.name: digest(p) for p in attack.folder.iterdir()}
            partial = [name for name in found if name in whole and found[name] != whole[name]]
            if partial:
                attack.finding(arguments, f"{kind.name}: {partial} partial")
            if kind == signal.SIGINT and process.returncode != 0 and found:
                attack.finding(arguments, f"SIGINT left {sorted(found)}")
            if kind == signal.SIGINT and process.returncode not in (0, 1, 130, -signal.SIGINT):
                attack.finding(arguments, f"SIGINT: exit code {process.returncode}: {error.strip()[:200]}")
        for file in attack.folder.iterdir():
            file.unlink()

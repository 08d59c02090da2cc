#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
# SPDX-FileCopyrightText: The Gonio authors
"""Attacks goniotool and prints a table: attack, number of runs, findings.

attack.py GONIOTOOL SEEDS [ATTACK ...]   without ATTACK: all; SEEDS: small valid files, as reader_mutation writes them
                                         (build/PRESET/test-output/fuzz/seeds)

  damaged       damaged files of every format, 8 GB of memory: exit code 0 or 1, one line that names the file, no output
  extreme       extreme tables through every command that reads a material
  outputs       outputs onto inputs, into missing folders and onto a full disk (needs root, for a small file system)
  signals       SIGINT and SIGKILL at random times: no output, or a complete one
  threads       the same bytes with 1, 2, 3, 7 and 64 threads
  addresses     the same bytes wherever the allocator that GONIO_SHIFTED_ALLOCATOR names puts the data: its addresses are
                multiples of 16 bytes, but of 32 only by chance
  instructions  the same values as the goniotool that GONIOTOOL_ANY_PROCESSOR names, which was built with
                GONIO_MODERN_PROCESSOR=OFF: without AVX2 and FMA

Fixed seed: every run does the same.
"""

import pathlib
import sys
import time

from damaged import damaged
from extreme import extreme
from interrupted import signals
from outputs import outputs
from runner import Attack
from same_bytes import addresses, threads


def instructions(attack, seeds):
    from instruction_sets import instruction_sets  # needs numpy, which the other attacks do not
    instruction_sets(attack, seeds)


def main():
    if len(sys.argv) < 3:
        sys.exit(__doc__)
    tool, seeds = str(pathlib.Path(sys.argv[1]).resolve()), pathlib.Path(sys.argv[2]).resolve()
    attacks = {"damaged": damaged, "extreme": extreme, "outputs": outputs, "signals": signals, "threads": threads,
               "addresses": addresses, "instructions": instructions}
    failed = False
    print(f"{'attack':<14}{'runs':>6}{'findings':>10}{'seconds':>9}")
    for name in sys.argv[3:] or attacks:
        attack = Attack(name, tool)
        started = time.monotonic()
        try:
            attacks[name](attack, seeds)
        finally:
            attack.close()
        print(f"{name:<14}{attack.runs:>6}{len(attack.findings):>10}{time.monotonic() - started:>9.0f}", flush=True)
        for finding in attack.findings:
            print("  " + finding, flush=True)
        failed = failed or bool(attack.findings)
    sys.exit(1 if failed else 0)


if __name__ == "__main__":
    main()

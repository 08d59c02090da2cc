# SPDX-License-Identifier: Apache-2.0
# SPDX-FileCopyrightText: The Gonio authors
"""Outputs onto inputs, into missing folders and onto a full disk."""

import pathlib
import subprocess
import sys

from runner import digest


def outputs(attack, seeds):
    source = attack.folder / "source.binary"
    attack.run(["convert", "library:merl-copy/chrome", source.name])
    before = digest(source)
    commands = [["convert", source.name], ["factor", source.name, "--out"], ["encode", source.name, "--out"],
                ["render", source.name, "--size", "16", "--samples", "1", "--out"]]
    suffix = {"convert": ".binary", "factor": ".pdv", "encode": ".code", "render": ".png"}
    for command in commands:
        for out in (source.name, f"./{source.name}"):
            if command[0] != "convert":
                continue
            code, _, error = attack.run([*command, out])
            if code == 0 or digest(source) != before:
                attack.finding([*command, out], "overwrites its input")
        out = f"missing/folder/x{suffix[command[0]]}"
        code, _, error = attack.run([*command, out])
        if code != 1 or "missing" not in error:
            attack.finding([*command, out], f"exit code {code}: {error.strip()[:200]}")
    disk = attack.folder / "disk"
    disk.mkdir()
    if subprocess.run(["mount", "-t", "tmpfs", "-o", "size=64k", "tmpfs", str(disk)], capture_output=True).returncode:
        print("outputs: no small file system (not root): full disks are left out", file=sys.stderr)
        return
    try:
        (disk / "filler").write_bytes(bytes(60 << 10))
        for command in commands:
            out = f"disk/x{suffix[command[0]]}"
            (attack.folder / out).write_bytes(b"old")
            code, _, error = attack.run(["--force", *command, out])
            kept = (attack.folder / out).read_bytes() == b"old"
            left = [p.name for p in disk.iterdir() if p.name not in ("filler", pathlib.Path(out).name)]
            if code == 0 and kept:
                attack.finding([*command, out], "says success on a full disk")
            if code != 0 and (not kept or left):
                attack.finding([*command, out], f"full disk: old file kept: {kept}, left: {left}")
            (attack.folder / out).unlink(missing_ok=True)
    finally:
        subprocess.run(["umount", str(disk)], check=False)

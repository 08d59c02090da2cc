#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
# SPDX-FileCopyrightText: The Gonio authors
"""Attacks goniotool and prints a table: attack, number of runs, findings.

attack.py GONIOTOOL SEEDS [ATTACK ...]   without ATTACK: all; SEEDS: small valid files, as reader_mutation writes them
                                         (build/PRESET/test-output/fuzz/seeds)

  damaged    damaged files of every format, 8 GB of memory: exit code 0 or 1, one line that names the file, no output
  extreme    extreme tables through every command that reads a material
  outputs    outputs onto inputs, into missing folders and onto a full disk (needs root, for a small file system)
  signals    SIGINT and SIGKILL at random times: no output, or a complete one
  threads    the same bytes with 1, 2, 3, 7 and 64 threads

Fixed seed: every run does the same.
"""

import hashlib
import os
import pathlib
import random
import resource
import shutil
import signal
import struct
import subprocess
import sys
import tempfile
import time

MEMORY = 8 << 30
SANITIZED = bool({"ASAN_OPTIONS", "TSAN_OPTIONS"} & os.environ.keys())  # sanitizers reserve terabytes of addresses
TIMEOUT = 300
DAMAGED_RUNS = 300
SIGNAL_RUNS = 20
THREADS = (1, 2, 3, 7, 64)


class Attack:
    """Runs goniotool in a folder of its own and collects findings."""

    def __init__(self, name, tool):
        self.name, self.tool = name, tool
        self.runs, self.findings = 0, []
        self.folder = pathlib.Path(tempfile.mkdtemp(prefix=f"gonio-{name}-"))

    def start(self, arguments, **options):
        return subprocess.Popen([self.tool, *map(str, arguments)], cwd=self.folder, stdout=subprocess.PIPE,
                                stderr=subprocess.PIPE, text=True, errors="replace", **options)

    def run(self, arguments, limit_memory=False):
        self.runs += 1
        limit_memory = limit_memory and not SANITIZED
        limit = (lambda: resource.setrlimit(resource.RLIMIT_AS, (MEMORY, MEMORY))) if limit_memory else None
        process = self.start(arguments, preexec_fn=limit)
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


# ---------------------------------------------------------------- damaged

READING = {  # suffix or name of a seed: the command that reads it; FILE is the damaged file, OUT an output
    "ensemble.dictionary": ["encode", "merl.binary", "--dictionary", "FILE", "--out", "OUT.code"],
    "figure.json": ["figure", "FILE", "--out", "OUT.svg"],
    "mesh.glb": ["render", "library:rgl/paper_blue", "--scene", "FILE", "--size", "8", "--samples", "1", "--out", "OUT.png"],
    "picture.exr": ["render", "library:rgl/paper_blue", "--environment", "FILE", "--size", "8", "--samples", "1", "--out",
                    "OUT.png"],
    "plan.csv": ["measure", "library:rgl/paper_blue", "--plan", "FILE", "--out", "OUT.csv"],
    "values.csv": ["reconstruct", "--plan", "plan.csv", "--values", "FILE", "--basis", "pca.basis", "--out", "OUT.binary"],
    "pca.basis": ["reconstruct", "--plan", "plan.csv", "--values", "values.csv", "--basis", "FILE", "--out", "OUT.binary"],
    "readings.csv": ["measure", "--factors", "symmetric-deviation", "--values", "FILE", "--predict", "OUT.pdv"],
    "npf.bin": ["info", "FILE#red"],
    "scene.json": ["render", "library:rgl/paper_blue", "--scene", "FILE", "--size", "8", "--samples", "1", "--out", "OUT.png"],
    "material": ["convert", "FILE", "OUT.binary"],
}
SAME_COMMAND = {"mesh.obj": "mesh.glb", "mesh.ply": "mesh.glb", "picture.hdr": "picture.exr"}


def damaged_bytes(data, rng):
    data = bytearray(data)
    kind = rng.randrange(6)
    at = rng.randrange(len(data))
    if kind == 0:
        return bytes(data[:at])
    if kind == 1:
        for _ in range(rng.randrange(1, 50)):
            data[rng.randrange(len(data))] = rng.randrange(256)
    if kind == 2:
        data[at:at] = rng.randbytes(rng.randrange(1, 200))
    if kind == 3:
        data[at:at + 64] = bytes(min(64, len(data) - at))
    if kind == 4:  # a huge number
        at = min(at, max(0, len(data) - 4))
        data[at:at + 4] = rng.choice([b"\xff\xff\xff\xff", b"\xff\xff\xff\x7f", b"\x00\x00\x80\x7f", b"9999"])
    if kind == 5:
        return rng.choice([b"", rng.randbytes(len(data)), bytes(data) * 2, b"[" * 200000])
    return bytes(data)


def damaged(attack, seeds):
    rng = random.Random(1)
    files = sorted(p for p in seeds.iterdir() if p.name != "spectra.csv")
    for file in files:
        shutil.copy(file, attack.folder)
    known = set(attack.folder.iterdir())
    for i in range(DAMAGED_RUNS):
        seed = files[i % len(files)]
        name = SAME_COMMAND.get(seed.name, seed.name)
        file = attack.folder / f"damaged-{i}{seed.suffix}"
        file.write_bytes(damaged_bytes(seed.read_bytes(), rng))
        arguments = [a.replace("FILE", file.name).replace("OUT", "out") for a in READING.get(name, READING["material"])]
        code, _, error = attack.run(arguments, limit_memory=True)
        left = attack.leftovers(known | {file})
        lines = error.strip().splitlines()
        if code not in (0, 1):
            attack.finding(arguments, f"exit code {code}: {error.strip()[:200]}")
        if code == 1 and (len(lines) != 1 or file.name not in error):
            attack.finding(arguments, f"{len(lines)} lines that should be one and name the file: {error.strip()[:300]}")
        if code == 1 and left:
            attack.finding(arguments, f"failed, and left {left}")
        for path in left:
            (attack.folder / path).unlink()
        file.unlink()


# ---------------------------------------------------------------- extreme

def merl(folder, name, value):
    """A MERL file of 90 x 90 x 180 cells; value(channel, cell) or a number, raw."""
    counts = (90, 90, 180)
    cells = counts[0] * counts[1] * counts[2]
    with open(folder / name, "wb") as file:
        file.write(struct.pack("<3i", *counts))
        for channel in range(3):
            if callable(value):
                file.write(value(channel, cells))
            else:
                file.write(struct.pack("<d", value) * cells)
    return name


def extreme_tables(folder):
    def spike(channel, cells):
        data = bytearray(struct.pack("<d", 0.1) * cells)
        data[8 * 5000:8 * 5001] = struct.pack("<d", 1e30)
        return bytes(data)

    def empty_channel(channel, cells):
        return struct.pack("<d", 0.0 if channel == 1 else 100.0) * cells

    def grazing(channel, cells):  # only the largest theta_h and theta_d have data
        rows = []
        for h in range(90):
            for d in range(90):
                rows.append(struct.pack("<d", 50.0 if h > 70 or d > 80 else -1.0) * 180)
        return b"".join(rows)

    return [merl(folder, "zero.binary", 0.0), merl(folder, "spike.binary", spike), merl(folder, "huge.binary", 1e300),
            merl(folder, "empty-channel.binary", empty_channel), merl(folder, "invalid.binary", -1.0),
            merl(folder, "grazing.binary", grazing)]


EXTREME = [["info"], ["check"], ["fit", "--model", "ggx"], ["fit", "--model", "lambert"],
           ["factor", "--terms", "2", "--out", "x.pdv"], ["factor", "--method", "hosvd"], ["encode", "--out", "x.code"],
           ["encode", "--method", "components"], ["render", "--size", "16", "--samples", "2", "--out", "x.png"],
           ["export", "x", "--for", "glsl"], ["evaluate", "--wi", "0.1", "0", "--wo", "0.2", "0"]]


def extreme(attack, _):
    for table in extreme_tables(attack.folder):
        for command in EXTREME:
            arguments = [command[0], table, *command[1:]]
            code, output, error = attack.run(arguments, limit_memory=True)
            if code not in (0, 1, 2):
                attack.finding(arguments, f"exit code {code}: {error.strip()[:300]}")
            if code == 1 and command[0] != "check" and len(error.strip().splitlines()) != 1:
                attack.finding(arguments, f"not one line: {error.strip()[:300]}")
            if "nan" in output.lower().replace("finance", ""):
                attack.finding(arguments, "NaN in the output")


# ---------------------------------------------------------------- outputs

def digest(path):
    return hashlib.sha256(path.read_bytes()).hexdigest()


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


# ---------------------------------------------------------------- signals

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
        for i in range(SIGNAL_RUNS if whole else 0):
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


# ---------------------------------------------------------------- threads

SAME_BITS = [(["fit", "library:merl-copy/aluminium", "--model", "cook-torrance", "--out", "x.binary"],
              "x.binary"),
             (["factor", "library:merl-copy/aluminium", "--terms", "5", "--out", "x.pdv"], "x.pdv"),
             (["factor", "library:merl-copy/aluminium", "--terms", "3", "--joint", "--out", "x.pdv"], "x.pdv"),
             (["encode", "library:merl-copy/aluminium", "--out", "x.code"], "x.code"),
             (["dictionary", "train", "a.binary", "b.binary", "--dictionaries", "2", "--sparsities", "32", "--iterations", "2",
               "--out", "x.dictionary"], "x.dictionary"),
             (["plan", "--samples", "10", "--out", "x.csv"], "x.csv"),
             (["convert", "library:rgl/paper_blue", "x.binary"], "x.binary"),
             (["render", "library:rgl/paper_blue", "--size", "64", "--samples", "16", "--out", "x.exr"], "x.exr"),
             (["interpolate", "library:merl-copy/aluminium", "library:merl-copy/chrome", "--weights", "0.5", "0.5",
               "--space", "dictionary", "--out", "x.binary"], "x.binary")]


def threads(attack, _):
    attack.run(["convert", "library:merl-copy/chrome", "a.binary"])
    attack.run(["convert", "library:merl-copy/red-fabric", "b.binary"])
    for arguments, out in SAME_BITS:
        digests = {}
        for count in THREADS:
            path = attack.folder / out
            path.unlink(missing_ok=True)
            code, _, error = attack.run(["--threads", count, *arguments])
            if code != 0 or not path.exists():
                attack.finding(arguments, f"{count} threads: {error.strip()[:300]}")
                break
            digests[count] = digest(path)
        if len(set(digests.values())) > 1:
            attack.finding(arguments, f"different bytes: {digests}")


def main():
    if len(sys.argv) < 3:
        sys.exit(__doc__)
    tool, seeds = str(pathlib.Path(sys.argv[1]).resolve()), pathlib.Path(sys.argv[2]).resolve()
    attacks = {"damaged": damaged, "extreme": extreme, "outputs": outputs, "signals": signals, "threads": threads}
    failed = False
    print(f"{'attack':<10}{'runs':>6}{'findings':>10}{'seconds':>9}")
    for name in sys.argv[3:] or attacks:
        attack = Attack(name, tool)
        started = time.monotonic()
        try:
            attacks[name](attack, seeds)
        finally:
            attack.close()
        print(f"{name:<10}{attack.runs:>6}{len(attack.findings):>10}{time.monotonic() - started:>9.0f}", flush=True)
        for finding in attack.findings:
            print("  " + finding, flush=True)
        failed = failed or bool(attack.findings)
    sys.exit(1 if failed else 0)


if __name__ == "__main__":
    main()

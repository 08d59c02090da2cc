# SPDX-License-Identifier: Apache-2.0
# SPDX-FileCopyrightText: The Gonio authors
"""SIGINT and SIGKILL at random times."""

import random
import shutil
import signal
import subprocess
import time

from runner import digest

RUNS = 20
INPUTS = "inputs"

PREPARATION = [["convert", "library:merl-copy/chrome", f"{INPUTS}/chrome.binary"],
               ["convert", "library:merl-copy/red-fabric", f"{INPUTS}/red-fabric.binary"],
               ["plan", "--samples", "20", "--out", f"{INPUTS}/plan.csv"],
               ["measure", "library:merl-copy/steel", "--plan", f"{INPUTS}/plan.csv", "--out", f"{INPUTS}/values.csv"]]

LONG = [["fit", "library:merl-copy/chrome", "--model", "he", "--out", "x.binary"],
        ["edit", "library:rgl/paper_blue", "--model", "cook-torrance", "--control", "roughness=2", "--out", "x.binary"],
        ["factor", "library:merl-copy/aluminium", "--terms", "10", "--out", "x.pdv"],
        ["encode", "library:merl-copy/aluminium", "--coefficients", "4096", "--out", "x.code"],
        ["dictionary", "train", f"{INPUTS}/chrome.binary", f"{INPUTS}/red-fabric.binary", "--dictionaries", "2",
         "--sparsities", "32", "--iterations", "2", "--only-complete", "--out", "x.dictionary"],
        ["train-neural", "library:merl-copy/aluminium", "--steps", "4000", "--out", "x.nbrdf"],
        ["interpolate", "library:merl-copy/aluminium", "library:merl-copy/chrome", "--space", "factors", "--out",
         "x.pdv"],
        ["plan", "--samples", "8", "--out", "x.csv"],
        ["measure", "library:rgl/paper_blue", "--factors", "half-difference", "--out", "x.csv", "--predict",
         "x.binary"],
        ["reconstruct", "--plan", f"{INPUTS}/plan.csv", "--values", f"{INPUTS}/values.csv", "--out", "x.binary"],
        ["render", "library:merl-copy/aluminium", "--size", "256", "--samples", "256", "--out", "x.exr"],
        ["render", "library:merl-copy/aluminium", "--size", "64", "--samples", "64", "--strategy-costs", "--out",
         "x.exr"],
        ["compare", "library:rgl/paper_blue", "library:merl-copy/blue-fabric", "--image", "x.png"],
        ["figure", "--materials", "library:merl-copy/aluminium", "--representations", "ggx", "factors-3d:5", "--size",
         "96", "--out", "x.pdf", "x.svg", "--csv", "x.csv"],
        ["export", "library:merl-copy/aluminium", "x", "--for", "mitsuba"]]

STUDY = ["study", "library:merl-copy/aluminium", "library:merl-copy/chrome", "--representations", "fits", "factors",
         "--models", "lambert", "ggx", "--terms", "1", "3", "--size", "32", "--no-times", "--out", "x"]


def outputs_of(attack):
    """Digests of the files that a command has written."""
    return {str(p.relative_to(attack.folder)): digest(p) for p in attack.folder.rglob("*")
            if p.is_file() and p.relative_to(attack.folder).parts[0] != INPUTS}


def clear(attack):
    for path in attack.folder.iterdir():
        if path.is_dir() and path.name != INPUTS:
            shutil.rmtree(path)
        elif path.is_file():
            path.unlink()


def interrupted(attack, arguments, kind, delay):
    """Exit code and error of the command that gets a signal; None: it ran on for a minute."""
    attack.runs += 1
    process = attack.start(arguments)
    time.sleep(delay)
    process.send_signal(kind)
    try:
        _, error = process.communicate(timeout=60)
    except subprocess.TimeoutExpired:
        process.kill()
        process.communicate()
        attack.finding(arguments, f"still running a minute after {kind.name}")
        return None
    return process.returncode, error


def whole_run(attack, arguments):
    """Outputs and duration of the command without a signal."""
    clear(attack)
    started = time.monotonic()
    code, _, error = attack.run(arguments)
    duration = time.monotonic() - started
    whole = outputs_of(attack)
    if code != 0 or not whole:
        attack.finding(arguments, f"does not run: {error.strip()[:200]}")
    return whole, duration


def kinds_and_delays(rng, duration):
    for i in range(RUNS):
        yield signal.SIGINT if i % 2 else signal.SIGKILL, rng.uniform(0, duration)


def check_files(attack, arguments, rng):
    """An interrupted command leaves either no file or complete ones: where SIGINT cut its work, none."""
    whole, duration = whole_run(attack, arguments)
    for kind, delay in kinds_and_delays(rng, duration) if whole else ():
        clear(attack)
        ended = interrupted(attack, arguments, kind, delay)
        if ended is None:
            continue
        code, error = ended
        found = outputs_of(attack)
        partial = [name for name in found if name in whole and found[name] != whole[name]]
        if partial:
            attack.finding(arguments, f"{kind.name}: {partial} partial")
        if kind == signal.SIGINT and code not in (0, -kind):
            attack.finding(arguments, f"SIGINT: exit code {code}: {error.strip()[:200]}")
        elif kind == signal.SIGINT and found.keys() != (set() if "interrupted" in error else whole.keys()):
            attack.finding(arguments, f"SIGINT: exit code {code} with the files {sorted(found)}")


def check_resumed_study(attack, rng):
    """A study that was interrupted and resumed writes the same files as one that was not."""
    whole, duration = whole_run(attack, STUDY)
    for kind, delay in kinds_and_delays(rng, duration) if whole else ():
        clear(attack)
        if interrupted(attack, STUDY, kind, delay) is None:
            continue
        code, _, error = attack.run([*STUDY, "--resume"])
        if code != 0:
            attack.finding(STUDY, f"resumed after {kind.name}: {error.strip()[:200]}")
            continue
        found = outputs_of(attack)
        if different := [name for name, value in whole.items() if found.get(name) != value]:
            attack.finding(STUDY, f"resumed after {kind.name}: other {different}")
        if kind == signal.SIGINT and found.keys() != whole.keys():
            attack.finding(STUDY, f"resumed after {kind.name}: left {sorted(found.keys() - whole.keys())}")


def signals(attack, _):
    rng = random.Random(2)
    # A shell starts commands in the background with SIGINT ignored, and goniotool would inherit that.
    signal.signal(signal.SIGINT, signal.default_int_handler)
    (attack.folder / INPUTS).mkdir()
    for arguments in PREPARATION:
        code, _, error = attack.run(arguments)
        if code != 0:
            attack.finding(arguments, f"does not run: {error.strip()[:200]}")
    for arguments in LONG:
        check_files(attack, arguments, rng)
    check_resumed_study(attack, rng)

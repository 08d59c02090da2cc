#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
# SPDX-FileCopyrightText: The Gonio authors
"""Measures how many wrong operators in core the tests notice (mutation testing).

    scripts/mutate.py FOLDER [--revision R] [--also R2] [--count 50] [--seed 1]

Clones the repository to FOLDER, picks operators of core at random and compiles all of them at once, each with its opposite beside
it; the environment variable GONIO_MUTANT chooses the one that is wrong in a run. Runs the tests of the operator's module, then all tests of
core that take at most 5 s, and writes each result as it comes. With --also, only operators on lines that stand in R2 too are picked,
so that the numbers of two revisions compare the tests alone: run it once with --revision A --also B and once the other way round.

Needs python3-clang. Takes about an hour on two cores.
"""
import argparse
import json
import os
import random
import re
import shlex
import subprocess
import sys
from pathlib import Path

import clang.cindex as clang

OPPOSITE = {"<": ">=", "<=": ">", ">": "<=", ">=": "<", "==": "!=", "!=": "==", "+": "-", "-": "+", "*": "/", "/": "*",
            "&&": "||", "||": "&&"}
ARITHMETIC = {clang.TypeKind.BOOL, clang.TypeKind.INT, clang.TypeKind.UINT, clang.TypeKind.LONG, clang.TypeKind.ULONG,
              clang.TypeKind.FLOAT, clang.TypeKind.DOUBLE}
HEADER = """#pragma once
#include <cstdlib>
inline const int gonioMutant = std::getenv("GONIO_MUTANT") ? std::atoi(std::getenv("GONIO_MUTANT")) : 0;
"""


def run(*command, **options):
    return subprocess.run(command, check=True, text=True, stdout=subprocess.PIPE, **options).stdout


def lines_of(revision):
    """All lines of core in a revision, without their indentation."""
    return {line.split(":", 2)[-1].strip() for line in run("git", "grep", "-h", "", revision, "--", "core").splitlines()}


def parse(index, flags, file):
    unit = index.parse(str(file), args=flags)
    errors = [d for d in unit.diagnostics if d.severity >= clang.Diagnostic.Error]
    return None if errors else unit


def operators(unit, file):
    """Binary operators of numbers in the file that are evaluated at run time: (line, start, end, end of the left side,
    start of the right side), offsets in bytes."""
    found = []

    def walk(cursor, constant):
        for child in cursor.get_children():
            if child.location.file and child.location.file.name != str(file):
                continue
            is_constant = constant or (child.kind.is_declaration() and child.kind != clang.CursorKind.NAMESPACE
                                       and any(t.spelling in ("constexpr", "static_assert")
                                               for t, _ in zip(child.get_tokens(), range(6))))
            if child.kind == clang.CursorKind.BINARY_OPERATOR and not is_constant:
                sides = list(child.get_children())
                kinds = {c.type.get_canonical().kind for c in [child, *sides]}
                if len(sides) == 2 and kinds <= ARITHMETIC:
                    found.append((child.location.line, child.extent.start.offset, child.extent.end.offset,
                                  sides[0].extent.end.offset, sides[1].extent.start.offset))
            walk(child, is_constant)

    walk(unit.cursor, False)
    return found


def pick(source, flags, count, seed, also):
    """The operators that are made wrong: {file: [(id, start, end, operator, end of the left side,
    start of the right side, text of the line)]}."""
    candidates = []
    for file in sorted((source / "core").rglob("*.cpp")):
        for number, line in enumerate(file.read_text().splitlines(), 1):
            text = line.strip()
            if text.startswith(("//", "#")) or (also is not None and text not in also):
                continue
            if re.search(r" (<|<=|>|>=|==|!=|\+|-|\*|/|&&|\|\|) ", text):
                # The order of the draw depends on the text alone, so two revisions draw the same lines.
                candidates.append((random.Random(f"{seed} {text}").random(), text, file, number))
    candidates.sort(key=lambda c: c[:2])
    index = clang.Index.create()
    units, picked, seen, number_of = {}, {}, set(), 0
    for _, text, file, line in candidates:
        if number_of == count:
            break
        if text in seen:
            continue
        seen.add(text)
        if file not in units:
            unit = parse(index, flags, file)
            units[file] = (operators(unit, file), file.read_bytes()) if unit else ([], b"")
        found, content = units[file]
        for at, start, end, left, right in found:
            operator = content[left:right].strip(b" \n()").decode(errors="replace")
            taken = any(start < e and s < end for _, s, e, *_ in picked.get(file, []))
            if at != line or operator not in OPPOSITE or taken:
                continue
            number_of += 1
            picked.setdefault(file, []).append((number_of, start, end, operator, left, right, text))
            break
    return picked


def make_wrong(source, picked):
    header = source / "core" / "mutant.h"
    header.write_text(HEADER)
    for file, mutants in picked.items():
        content = file.read_bytes()
        for number, start, end, operator, left, right, _ in sorted(mutants, key=lambda m: -m[1]):
            whole = content[start:end]
            at = content.index(operator.encode(), left) - start
            wrong = whole[:at] + OPPOSITE[operator].encode() + whole[at + len(operator):]
            content = content[:start] + b"(gonioMutant == %d ? (%s) : (%s))" % (number, wrong, whole) + content[end:]
        file.write_bytes(b'#include "core/mutant.h"\n' + content)


def tests(build, *selection, mutant=0, stop=True):
    """Runs tests; True if all passed."""
    command = ["ctest", "--test-dir", build, "-j", "2", "--timeout", "300", *selection] + (["--stop-on-failure"] if stop else [])
    done = subprocess.run(command, text=True, stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
                          env={**os.environ, "GONIO_MUTANT": str(mutant), "QT_QPA_PLATFORM": "offscreen"})
    return done.returncode == 0, done.stdout


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("folder", type=Path)
    parser.add_argument("--revision", default="HEAD")
    parser.add_argument("--also")
    parser.add_argument("--count", type=int, default=50)
    parser.add_argument("--seed", type=int, default=1)
    options = parser.parse_args()
    source, build = options.folder.resolve(), options.folder.resolve() / "build" / "core"
    revision = run("git", "rev-parse", options.revision).strip()
    also = lines_of(options.also) if options.also else None
    run("git", "clone", "--quiet", ".", str(source))
    run("git", "checkout", "--quiet", revision, cwd=source)
    run("cmake", "--preset", "core", "-DGONIO_BUILD_BENCHMARKS=OFF", cwd=source)
    commands = json.loads((build / "compile_commands.json").read_text())
    command = next(c for c in commands if "/gonio_core.dir/" in c["command"] and "pch" not in Path(c["file"]).name)
    flags = [f for f in shlex.split(command["command"]) if f.startswith(("-I", "-D", "-std", "-isystem", "/usr/include"))]
    picked = pick(source, flags, options.count, options.seed, also)
    make_wrong(source, picked)
    targets = re.findall(r"^(core_\w+_tests):", run("ninja", "-C", str(build), "-t", "targets", "all"), re.M)
    print("building", len(targets), "programs of tests", flush=True)
    subprocess.run(["nice", "ninja", "-C", str(build), *targets], check=True, stdout=subprocess.DEVNULL)

    _, output = tests(str(build), "-L", "^core", stop=False)
    seconds = {m[1]: (float(m[3]), m[2]) for m in re.finditer(r"Test +#\d+: (\w+) \.* *\**(\w+)\s+([\d.]+) sec", output)}
    quick = [name for name, (time, result) in seconds.items() if result == "Passed" and time <= 5]
    failing = [name for name, (_, result) in seconds.items() if result not in ("Passed", "Skipped")]
    print(len(seconds), "tests;", len(quick), "quick ones; failing without a wrong operator:", ", ".join(failing) or "none", flush=True)
    left_out = ["-E", "^(" + "|".join(failing or ["-"]) + ")$"]
    noticed = 0
    total = sum(map(len, picked.values()))
    for number, file, operator, text in sorted((m[0], f, m[3], m[6]) for f, ms in picked.items() for m in ms):
        module = file.relative_to(source).parts[1]
        passed, _ = tests(str(build), "-L", f"^core/{module}$", *left_out, mutant=number)
        by = "own tests" if not passed else ""
        if passed:
            passed, _ = tests(str(build), "-R", "^(" + "|".join(quick) + ")$", mutant=number)
            by = "other tests" if not passed else "NOTHING"
        noticed += not passed
        print(f"{number}\t{file.relative_to(source)}\t{operator} -> {OPPOSITE[operator]}\t{by}\t{text}", flush=True)
    print(f"noticed: {noticed} of {total}")


if __name__ == "__main__":
    sys.exit(main())

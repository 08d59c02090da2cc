#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
# SPDX-FileCopyrightText: The Gonio authors
"""Prints the strings that users read as a Markdown table: file, context, text.

scripts/strings.py [FOLDER ...]   without FOLDER: app, core and widgets

Listed are the translated strings of the editor, the descriptions and messages of goniotool, and the descriptions of
parameters, models, metrics and export targets. Strings without a space count only where they are translated.
"""

import pathlib
import re
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent
TOKEN = re.compile(
    r'''(?P<comment>//[^\n]*|/\*.*?\*/|^[ \t]*\#[ \t]*include[^\n]*)|(?P<char>'(?:\\.|[^'\\\n])+')'''
    r'''|(?P<raw>R"(?P<tag>[^(\s]*)\(.*?\)(?P=tag)")|(?P<text>"(?:\\.|[^"\\\n])*")''', re.DOTALL | re.MULTILINE)
CALL = re.compile(r'([A-Za-z_][\w:]*)\s*[({](?:[^(){};]|\([^(){};]*\))*$')
TRANSLATED = re.compile(r'(^|::)(tr|translate|QT_TR_NOOP|QT_TRANSLATE_NOOP)$')
WORDS = re.compile(r'[^\W_][,.:;)%]* +[(\w]')
CODE = re.compile(r';(\\n|\s*$)|[{}]|==|^\s*#|->|\bvec[234]\b')


def strings(source):
    """Yields the context and text of each group of adjacent string literals."""
    group, start, end = [], 0, 0
    for match in TOKEN.finditer(source):
        if match.lastgroup == "comment" or match.group("text") is None:
            continue
        if group and source[end:match.start()].strip():
            yield context(source, start), "".join(group)
            group = []
        if not group:
            start = match.start()
        group.append(match.group("text")[1:-1])
        end = match.end()
    if group:
        yield context(source, start), "".join(group)


def context(source, start):
    """The innermost call or initialiser that holds the literal at `start`."""
    found = CALL.search(source[max(0, start - 400):start])
    return found.group(1) if found else ""


def shown(where, text):
    """Whether users read this string; ids, keys and code of shaders are left out."""
    if TRANSLATED.search(where):
        return True
    return WORDS.search(text) is not None and CODE.search(text) is None and "qDebug" not in where


def main():
    folders = sys.argv[1:] or ["app", "core", "widgets"]
    print("| file | context | text |\n|---|---|---|")
    for folder in folders:
        for path in sorted((ROOT / folder).rglob("*")):
            if path.suffix not in (".cpp", ".h"):
                continue
            for where, text in strings(path.read_text(encoding="utf-8")):
                if shown(where, text):
                    print(f"| {path.relative_to(ROOT)} | {where} | {text.replace('|', chr(92) + '|')} |")


if __name__ == "__main__":
    main()

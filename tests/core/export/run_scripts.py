# SPDX-License-Identifier: Apache-2.0
# SPDX-FileCopyrightText: The Gonio authors
"""Runs the scripts for Blender of a folder without Blender, and prints the dictionaries that they contain as JSON.

Usage: run_scripts.py FOLDER. Only the functions are defined. The scripts are compiled from their bytes, in which
Python honours a declaration of the encoding.
"""
import json
import os
import sys
import types

for module in ("bpy", "mathutils"):
    sys.modules[module] = types.ModuleType(module)

contents = {}
for file in sorted(os.listdir(sys.argv[1])):
    path = os.path.join(sys.argv[1], file)
    with open(path, "rb") as script:
        code = compile(script.read(), path, "exec")
    names = {"__name__": "gonio_script", "__file__": path}
    exec(code, names)
    contents[file] = names["GONIO"] if "GONIO" in names else names["SCENE"]
print(json.dumps(contents))

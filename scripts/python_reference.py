#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
# SPDX-FileCopyrightText: The Gonio authors
"""Prints the reference of the module gonio as Markdown, made from its docstrings: the page python-reference.md of the guide
(cmake/Pages.cmake). It needs neither the built module nor NumPy.
"""
import ast
import inspect
import math
import pathlib
import re
import sys
import unittest.mock

if __name__ == "__main__":  # signatures and docstrings do not depend on these
    sys.modules.update({name: unittest.mock.MagicMock() for name in ("numpy", "numpy.typing", "gonio._core")})
    sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "python"))
import gonio

SECTIONS = {
    "Materials": ["open", "library", "from_table", "grid_directions", "coordinates", "to_coordinates",
                  "from_coordinates", "check", "set_threads", "Material", "GridDirections",
                  "LibraryEntry", "Check"],
    "Models, fits, edits": ["models", "fit", "fit_all", "edit", "edit_factors", "artist_controls", "metrics", "Model",
                            "Parameter", "Fit", "Metric"],
    "Factors, codes, interpolation": ["factorize", "published_deviation_nodes", "open_factors", "factorize_baseline", "baselines", "encode", "decode",
                                      "open_code", "dictionary", "train_dictionary", "learn_patches", "interpolate", "Factors", "BaselineFactors", "Code", "ChannelCode", "Dictionary", "PatchDictionary", "PatchCode", "Interpolation",
                                      "train_neural", "neural_brdf", "open_neural", "NeuralBrdf"],
    "Acquisition": ["plan", "open_plan", "measure", "reconstruct", "plan_factors", "open_factor_readings",
                    "predict_from_factors", "bundled_basis", "learn_basis", "learn_atoms", "open_basis", "separate", "learn_separated_basis",
                    "SeparatedBasis", "Plan", "Readings", "Reconstruction",
                    "FactorPlan", "FactorPrediction", "Basis"],
    "Photographs": ["from_images", "plan_images", "ImageReconstruction", "ImagePlan", "InputCheck"],
    "Images, studies, exports": ["render", "scenes", "effects", "compare", "study", "export", "targets", "Comparison",
                                   "Effect", "Record", "Export", "Target"],
}


def class_nodes():
    """The syntax trees of all classes of the package, by name."""
    nodes = {}
    for file in pathlib.Path(gonio.__file__).parent.glob("*.py"):
        for node in ast.parse(file.read_text()).body:
            if isinstance(node, ast.ClassDef):
                nodes[node.name] = node
    return nodes


CLASSES = class_nodes()


def fields_of(item):
    """{name: docstring} of the fields of a data class or named tuple: the strings behind them."""
    body = CLASSES[item.__name__].body
    return {node.target.id: inspect.cleandoc(text.value.value)
            for node, text in zip(body, body[1:])
            if isinstance(node, ast.AnnAssign) and isinstance(text, ast.Expr) and isinstance(text.value, ast.Constant)}


def signature(function):
    """Arguments as they are written: names, types, defaults."""
    text = re.sub(r"(: |-> )'([^']*)'", r"\1\2", str(inspect.signature(function)))
    for written, shown in (("self, ", ""), ("(self)", "()"), (" -> None", ""),
                           *((str(math.radians(angle)), f"radians({angle})") for angle in (85, 89, 60, 2))):
        text = text.replace(written, shown)
    return re.sub(r"NDArray\[np\.(\w+?)_?\]", r"NDArray[\1]", text)


def markdown(docstring):
    """A docstring with its sections as lists. What is indented before them stays code."""
    lines = []
    in_section = False
    for line in docstring.splitlines():
        heading = re.fullmatch(r"(Args|Returns|Raises):", line)
        item = re.match(r"    (\w+): (.*)", line)
        in_section = in_section or heading is not None
        if not in_section:
            lines.append(line)
        elif heading:
            lines.append({"Args": "Arguments:", "Returns": "Returns:", "Raises": "Raises:"}[heading[1]])
            lines.append("")
        elif item:
            lines.append(f"- `{item[1]}`: {item[2]}")
        else:
            lines.append("  " + line.strip() if line.startswith("        ") else line[4:] if re.match(r"    \S", line) else line)
    return "\n".join(lines)


def linked(text):
    """Names of pages as links."""
    return re.sub(r"\bdocs/([\w-]+)\.md\b", r"[\1](\1.md)", text)


def described(title, item, level):
    return f"{'#' * level} {title}\n\n{linked(markdown(inspect.getdoc(item)))}\n"


def class_text(name, item):
    parts = [described(f"class `{name}`", item, 3)]
    fields = fields_of(item) if hasattr(item, "__dataclass_fields__") or hasattr(item, "_fields") else {}
    properties = {key: inspect.getdoc(value) for key, value in vars(item).items() if isinstance(value, property) and key[0] != "_"}
    if fields or properties:
        parts.append("\n".join(f"- `{key}`: {linked(' '.join(text.split()))}" for key, text in {**fields, **properties}.items()) + "\n")
    if "__init__" in vars(item) and not fields and "not directly" not in item.__init__.__doc__:
        parts.append(described(f"`{name}{signature(item.__init__)}`", item.__init__, 4))
    for key, value in vars(item).items():
        if inspect.isfunction(value) and key[0] != "_":
            parts.append(described(f"`{name}.{key}{signature(value)}`", value, 4))
    return "\n".join(parts)


def page():
    """The whole page."""
    parts = ["# Reference of the Python module\n", "[Python](python.md) shows how to use it. Terms are explained in the [glossary](glossary.md).\n",
             linked(inspect.getdoc(gonio)) + "\n"]
    for section, names in SECTIONS.items():
        parts.append(f"## {section}\n")
        for name in names:
            item = getattr(gonio, name)
            parts.append(class_text(name, item) if inspect.isclass(item) else described(f"`gonio.{name}{signature(item)}`", item, 3))
    listed = [name for names in SECTIONS.values() for name in names]
    missing = set(gonio.__all__) - {"Error"} - set(listed)
    if missing:
        raise SystemExit(f"not in a section: {', '.join(sorted(missing))}")
    return "\n".join(parts)


if __name__ == "__main__":
    sys.stdout.reconfigure(encoding="utf-8")
    print(page(), end="")

# SPDX-License-Identifier: Apache-2.0
# SPDX-FileCopyrightText: The Gonio authors
# Tables of the results of goniotool compare.
import csv
import json
import math
import os
import re
import statistics


def comparison(path):
    """{column: value}; an SNR without a number is that of equal pictures."""
    result = json.loads(Path(path).read_text())
    snr = {f"{title} [dB]": math.inf if result[key] is None else result[key]
           for title, key in (("rendered SNR", "renderedSnr"), ("BRDF SNR", "brdfSnr"))}
    return snr | result["errors"]


def write_csv(path, rows):
    with open(path + ".part", "w", newline="") as file:
        table = csv.DictWriter(file, rows[0].keys(), lineterminator="\n")
        table.writeheader()
        table.writerows(rows)
    os.replace(path + ".part", path)


def write_comparison_tables(trials, materials_table, medians_table):
    """A row for each material, and the medians over the materials for each number of samples and seed."""
    rows, groups = [], {}
    for path in trials:
        name, samples, seed = re.search("([^/]+)/samples-([0-9]+)-seed-([0-9]+).json$", path).groups()
        values = comparison(path)
        rows.append({"material": name, "fold": FOLD_OF[name], "samples": samples, "seed": seed} | values)
        groups.setdefault((samples, seed), []).append(values)
    write_csv(materials_table, rows)
    write_csv(medians_table, [
        {"samples": samples, "seed": seed, "materials": len(group)}
        | {column: statistics.median(values[column] for values in group) for column in group[0]}
        for (samples, seed), group in groups.items()])

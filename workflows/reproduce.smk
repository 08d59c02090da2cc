# SPDX-License-Identifier: Apache-2.0
# SPDX-FileCopyrightText: The Gonio authors
# The figures and tables of Tongbuasirilai 2023 (docs/reproduction.md): a job each, then the report.
import json
import subprocess

REPRODUCE = config["reproduce"]
REPRODUCE_OPTIONS = " ".join(
    [f"--{name} {shlex.quote(REPRODUCE[name])}" for name in ("merl", "rgl", "dtu") if REPRODUCE[name]]
    + (["--quick"] if REPRODUCE["quick"] else []))


def reproduced_figures():
    """The names of the files of each figure, from the records of goniotool."""
    command = [config["goniotool"], "reproduce", "--list", "--json"]
    if REPRODUCE["figures"]:
        command += ["--only", listed(REPRODUCE["figures"])]
    return [figure["files"] for figure in json.loads(subprocess.check_output(command))["figures"]]


def reproduced_id(wildcards):
    return wildcards.figure.split("-")[1]


rule reproduce_figure:
    output: multiext(OUT + "/reproduction/{figure}", ".pdf", ".csv", ".svg", ".json")
    log: OUT + "/log/reproduce-{figure}.log"
    threads: threads_of("reproduce")
    resources:
        mem_mb=need("reproduce", "mem_mb"),
        runtime=need("reproduce", "runtime"),
    params:
        id=reproduced_id,
        folder=folder_of_output,
    wildcard_constraints:
        figure="(?:figure|table)-[0-9.]+",
    shell:
        "{GONIOTOOL} reproduce {REPRODUCE_OPTIONS} --only {params.id} --threads {threads} --progress "
        "--out {params.folder:q} > {log:q} 2>&1"

# Of the figures that are there: it makes none.
rule reproduce:
    input: lambda wildcards: [f"{OUT}/reproduction/{name}.json" for name in reproduced_figures()]
    output: OUT + "/reproduction/report.html"
    log: OUT + "/log/reproduce-report.log"
    threads: threads_of("summary")
    resources:
        mem_mb=need("summary", "mem_mb"),
        runtime=need("summary", "runtime"),
    params:
        folder=folder_of_output,
        only=("--only " + listed(REPRODUCE["figures"])) if REPRODUCE["figures"] else "",
    shell:
        "{GONIOTOOL} reproduce {REPRODUCE_OPTIONS} {params.only} --threads {threads} --out {params.folder:q} > {log:q} 2>&1"

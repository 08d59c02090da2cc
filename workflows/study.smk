# SPDX-License-Identifier: Apache-2.0
# SPDX-FileCopyrightText: The Gonio authors
# Accuracy (and cost, with times) of every representation of each material: a job each, then the medians.
STUDY = config["study"]
STUDY_OPTIONS = (f"--representations {listed(STUDY['representations'])} {STUDY['options']} --size {STUDY['size']} "
                 f"--samples {STUDY['samples']}" + ("" if STUDY["times"] else " --no-times"))

rule study_material:
    input: file_of
    output: multiext(OUT + "/study/{name}", ".json", ".csv", ".svg")
    log: OUT + "/log/study-{name}.log"
    threads: threads_of("study")
    resources:
        mem_mb=need("study", "mem_mb"),
        runtime=need("study", "runtime"),
    params:
        material=material_of,
        folder=folder_of_output,
        options=STUDY_OPTIONS,
    shell:
        "{GONIOTOOL} study {params.material:q} {params.options} --resume --threads {threads} --progress "
        "--out {params.folder:q} > {log:q} 2>&1"

rule study:
    input: [f"{OUT}/study/{name}.json" for name in MATERIALS]
    output: multiext(OUT + "/study/summary", ".json", ".csv", ".svg")
    log: OUT + "/log/study-summary.log"
    threads: threads_of("summary")
    resources:
        mem_mb=need("summary", "mem_mb"),
        runtime=need("summary", "runtime"),
    params:
        folder=folder_of_output,
        options=STUDY_OPTIONS,
    shell:
        "{GONIOTOOL} study {SOURCE_ARGUMENTS} {params.options} --resume --threads {threads} --out {params.folder:q} "
        "> {log:q} 2>&1"

ruleorder: study > study_material

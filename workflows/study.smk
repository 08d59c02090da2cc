# SPDX-License-Identifier: Apache-2.0
# SPDX-FileCopyrightText: The Gonio authors
# Accuracy (and cost, with times) of every representation of each material.
STUDY = config["study"]

rule study_shard:
    input: MATERIAL_FILES
    output: OUT + "/study/shards/{shard}/shard.json"
    log: OUT + "/log/study-{shard}.log"
    threads: threads_of("study")
    resources:
        mem_mb=need("study", "mem_mb"),
        runtime=need("study", "runtime"),
    params:
        shard=shard_of,
        folder=folder_of_output,
        options=f"--representations {listed(STUDY['representations'])} {STUDY['options']} --size {STUDY['size']} "
            f"--samples {STUDY['samples']}" + ("" if STUDY["times"] else " --no-times"),
    shell:
        "{GONIOTOOL} study {SOURCE_ARGUMENTS} {params.options} --resume --shard {params.shard} --threads {threads} "
        "--progress --out {params.folder:q} > {log:q} 2>&1"

rule study:
    input: shard_files(OUT + "/study", STUDY["shards"])
    output: multiext(OUT + "/study/joined/summary", ".json", ".csv", ".svg")
    log: OUT + "/log/study-merge.log"
    threads: threads_of("merge")
    resources:
        mem_mb=need("merge", "mem_mb"),
        runtime=need("merge", "runtime"),
    params:
        shards=lambda wildcards, input: [str(Path(shard).parent) for shard in input],
        folder=folder_of_output,
    shell:
        "{GONIOTOOL} merge {params.shards:q} --threads {threads} --out {params.folder:q} > {log:q} 2>&1"

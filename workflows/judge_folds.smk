# SPDX-License-Identifier: Apache-2.0
# SPDX-FileCopyrightText: The Gonio authors
# Each material as codes over the dictionary that has not learned from it.
JUDGING = config["judging"]

rule judge_shard:
    input:
        materials=MATERIAL_FILES,
        dictionaries=rules.train_folds.input,
    output: OUT + "/judged/shards/{shard}/shard.json"
    log: OUT + "/log/judge-{shard}.log"
    threads: threads_of("judge")
    resources:
        mem_mb=need("judge", "mem_mb"),
        runtime=need("judge", "runtime"),
    params:
        shard=shard_of,
        folder=folder_of_output,
        dictionaries=listed(rules.train_folds.input),
        options=f"--representations codes --coefficients {listed(JUDGING['coefficients'])} "
            f"--size {JUDGING['size']} --samples {JUDGING['samples']} --no-times",
    shell:
        "{GONIOTOOL} study {SOURCE_ARGUMENTS} --dictionary {params.dictionaries:q} {params.options} --resume "
        "--shard {params.shard} --threads {threads} --progress --out {params.folder:q} > {log:q} 2>&1"

rule judge_folds:
    input: shard_files(OUT + "/judged", JUDGING["shards"])
    output: multiext(OUT + "/judged/joined/summary", ".json", ".csv", ".svg")
    log: OUT + "/log/judge-merge.log"
    threads: threads_of("merge")
    resources:
        mem_mb=need("merge", "mem_mb"),
        runtime=need("merge", "runtime"),
    params:
        shards=lambda wildcards, input: [str(Path(shard).parent) for shard in input],
        folder=folder_of_output,
    shell:
        "{GONIOTOOL} merge {params.shards:q} --threads {threads} --out {params.folder:q} > {log:q} 2>&1"

# SPDX-License-Identifier: Apache-2.0
# SPDX-FileCopyrightText: The Gonio authors
# Each material as codes over the dictionary that has not learned from it: a job each, then the medians.
JUDGING = config["judging"]
JUDGING_OPTIONS = (f"--representations codes --coefficients {listed(JUDGING['coefficients'])} --size {JUDGING['size']} "
                   f"--samples {JUDGING['samples']} --no-times")

rule judge_material:
    input:
        material=file_of,
        dictionaries=rules.train_folds.input,
    output: multiext(OUT + "/judged/{name}", ".json", ".csv", ".svg")
    log: OUT + "/log/judge-{name}.log"
    threads: threads_of("judge")
    resources:
        mem_mb=need("judge", "mem_mb"),
        runtime=need("judge", "runtime"),
    params:
        material=material_of,
        folder=folder_of_output,
        dictionaries=listed(rules.train_folds.input),
        options=JUDGING_OPTIONS,
    shell:
        "{GONIOTOOL} study {params.material:q} --dictionary {params.dictionaries:q} {params.options} --resume "
        "--threads {threads} --progress --out {params.folder:q} > {log:q} 2>&1"

rule judge_folds:
    input: [f"{OUT}/judged/{name}.json" for name in MATERIALS]
    output: multiext(OUT + "/judged/summary", ".json", ".csv", ".svg")
    log: OUT + "/log/judge-summary.log"
    threads: threads_of("summary")
    resources:
        mem_mb=need("summary", "mem_mb"),
        runtime=need("summary", "runtime"),
    params:
        folder=folder_of_output,
        dictionaries=listed(rules.train_folds.input),
        options=JUDGING_OPTIONS,
    shell:
        "{GONIOTOOL} study {SOURCE_ARGUMENTS} --dictionary {params.dictionaries:q} {params.options} --resume "
        "--threads {threads} --out {params.folder:q} > {log:q} 2>&1"

ruleorder: judge_folds > judge_material

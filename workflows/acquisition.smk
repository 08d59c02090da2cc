# SPDX-License-Identifier: Apache-2.0
# SPDX-FileCopyrightText: The Gonio authors
# For each fold and number of samples a plan from the materials of all other folds; each material of the fold is measured
# at its directions, reconstructed and compared.
include: "comparison_tables.smk"

ACQUISITION = config["acquisition"]
PLANS = OUT + "/acquisition/plans/fold-{fold}-samples-{samples}-seed-{seed}"
TRIALS = OUT + "/acquisition/materials/{name}/samples-{samples}-seed-{seed}"


def plan_of(wildcards):
    plan = PLANS.format(fold=FOLD_OF[wildcards.name], samples=wildcards.samples, seed=wildcards.seed)
    return {"plan": plan + ".csv", "basis": plan + ".basis"}


rule plan_fold:
    input: MATERIAL_FILES
    output:
        plan=PLANS + ".csv",
        basis=PLANS + ".basis",
    log: OUT + "/log/plan-{fold}-{samples}-{seed}.log"
    threads: threads_of("plan")
    resources:
        mem_mb=need("plan", "mem_mb"),
        runtime=need("plan", "runtime"),
    params:
        excluded=lambda wildcards: held_out(wildcards.fold),
        options=f"--method {ACQUISITION['method']} {ACQUISITION['plan_options']}",
    shell:
        "{GONIOTOOL} plan --train {SOURCE_ARGUMENTS} --exclude {params.excluded} --samples {wildcards.samples} "
        "--seed {wildcards.seed} {params.options} --threads {threads} --progress --out {output.plan:q} > {log:q} 2>&1"

rule measure:
    input: unpack(plan_of), material=file_of
    output: TRIALS + ".csv"
    log: OUT + "/log/measure-{name}-{samples}-{seed}.log"
    threads: threads_of("measure")
    resources:
        mem_mb=need("measure", "mem_mb"),
        runtime=need("measure", "runtime"),
    params:
        material=material_of,
        options=ACQUISITION["measure_options"],
    shell:
        "{GONIOTOOL} measure {params.material:q} --plan {input.plan:q} --seed {wildcards.seed} {params.options} "
        "--threads {threads} --out {output:q} > {log:q} 2>&1"

rule reconstruct:
    input: unpack(plan_of), values=TRIALS + ".csv"
    output: temp(TRIALS + ".binary")
    log: OUT + "/log/reconstruct-{name}-{samples}-{seed}.log"
    threads: threads_of("reconstruct")
    resources:
        mem_mb=need("reconstruct", "mem_mb"),
        runtime=need("reconstruct", "runtime"),
    params:
        options=ACQUISITION["reconstruct_options"],
    shell:
        "{GONIOTOOL} reconstruct --plan {input.plan:q} --values {input.values:q} {params.options} "
        "--threads {threads} --out {output:q} > {log:q} 2>&1"

# Standard output is not written atomically.
rule compare:
    input: material=file_of, reconstructed=TRIALS + ".binary"
    output: TRIALS + ".json"
    log: OUT + "/log/compare-{name}-{samples}-{seed}.log"
    threads: threads_of("compare")
    resources:
        mem_mb=need("compare", "mem_mb"),
        runtime=need("compare", "runtime"),
    params:
        material=material_of,
        options=f"--size {ACQUISITION['size']} --samples {ACQUISITION['picture_samples']}",
    shell:
        "{GONIOTOOL} compare {params.material:q} {input.reconstructed:q} {params.options} --json "
        "--threads {threads} > {output:q}.part 2> {log:q} && mv {output:q}.part {output:q}"

rule acquisition:
    input:
        expand(TRIALS + ".json", name=MATERIALS, samples=ACQUISITION["samples"], seed=ACQUISITION["seeds"])
    output:
        materials=OUT + "/acquisition/materials.csv",
        medians=OUT + "/acquisition/medians.csv",
    run:
        write_comparison_tables(input, output.materials, output.medians)

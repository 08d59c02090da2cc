# SPDX-License-Identifier: Apache-2.0
# SPDX-FileCopyrightText: The Gonio authors
# One dictionary for each fold, from the materials of all others.
TRAINING = config["training"]
TRAINING_OPTIONS = " ".join([
    f"--dictionaries {TRAINING['dictionaries']}",
    f"--sparsities {listed(TRAINING['sparsities'])}",
    f"--iterations {TRAINING['iterations']}",
    f"--passes {TRAINING['passes']}",
    f"--subspace-loss {TRAINING['subspace_loss']}",
    f"--seed {config['seed']}",
    TRAINING["options"],
])

rule train_folds:
    input: expand(OUT + "/folds/fold-{fold}.dictionary", fold=FOLDS)

# The checkpoint is no output, since outputs of a failed job are removed. Other settings have another checkpoint.
rule train_fold:
    input: MATERIAL_FILES
    output: OUT + "/folds/fold-{fold}.dictionary"
    log: OUT + "/log/train-{fold}.log"
    threads: threads_of("train")
    resources:
        mem_mb=need("train", "mem_mb"),
        runtime=need("train", "runtime"),
    params:
        options=TRAINING_OPTIONS,
        excluded=lambda wildcards: held_out(wildcards.fold),
        checkpoint=lambda wildcards: OUT + f"/checkpoints/fold-{wildcards.fold}-"
            + digest(TRAINING_OPTIONS, SOURCES, held_out(wildcards.fold)) + ".checkpoint",
    shell:
        "mkdir -p {OUT:q}/checkpoints && {GONIOTOOL} dictionary train {SOURCE_ARGUMENTS} --exclude {params.excluded} "
        "{params.options} --checkpoint {params.checkpoint:q} --only-complete --threads {threads} --progress "
        "--out {output:q} > {log:q} 2>&1"

#!/bin/sh
# SPDX-License-Identifier: Apache-2.0
# SPDX-FileCopyrightText: The Gonio authors
# scripts/install_workflow_tools.sh [--slurm]: installs Snakemake, which runs the workflows (docs/workflows.md), on Debian 12
# (as root; about 650 MB, a few minutes), and with --slurm also Slurm and MUNGE (about 20 MB), for scripts/slurm_workflow.sh.
set -eu
apt-get update
apt-get install --yes --no-install-recommends snakemake
if [ "${1:-}" = --slurm ]; then apt-get install --yes --no-install-recommends slurm-wlm munge; fi

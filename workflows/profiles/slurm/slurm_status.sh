#!/bin/sh
# SPDX-License-Identifier: Apache-2.0
# SPDX-FileCopyrightText: The Gonio authors
# slurm_status.sh JOB: the state of a Slurm job as Snakemake expects it: running, success or failed. The controller
# forgets a job a few minutes after its end; the accounting database, where there is one, does not.
state() {
  scontrol --oneliner show job "$1" 2>/dev/null | sed -n 's/.* JobState=\([A-Z_]*\).*/\1/p'
}

for wait in 1 2 4 8 0; do
  found=$(state "$1")
  [ -n "$found" ] || found=$(sacct --noheader --parsable2 --allocations --format=State --jobs "$1" 2>/dev/null | head -n 1)
  [ -z "$found" ] || break
  sleep "$wait"
done
case $found in
  COMPLETED) echo success ;;
  PENDING | CONFIGURING | RUNNING | COMPLETING | SUSPENDED | STOPPED | SIGNALING | STAGE_OUT | RESIZING) echo running ;;
  *) echo failed ;;
esac

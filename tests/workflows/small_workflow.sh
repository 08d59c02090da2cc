#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# SPDX-FileCopyrightText: The Gonio authors
# small_workflow.sh GONIOTOOL FOLDER: runs every workflow (docs/workflows.md) on small materials: dry, whole, and killed in
# its middle and continued, which must give the same bytes. Exit code 77: Snakemake is not installed.
set -eu
goniotool=$1 folder=$2
root=$(cd "$(dirname "$0")/../.." && pwd)
command -v snakemake >/dev/null 2>&1 || {
  echo "skipped: snakemake is not installed (scripts/install_workflow_tools.sh installs it)"
  exit 77
}
rm -rf "$folder"
mkdir -p "$folder"
python3 "$root/tests/workflows/make_tables.py" "$folder/tables"

fail() {
  printf 'failed: %s\n' "$*" >&2
  exit 1
}

# workflow RUN MATERIALS TARGET ... [OPTION ...]: in the folder RUN.
workflow() {
  local run=$1 materials=$2
  shift 2
  mkdir -p "$folder/$run"
  (cd "$folder/$run" && exec snakemake "$@" -s "$root/workflows/Snakefile" --profile "$root/workflows/profiles/local" \
    --configfile "$root/tests/workflows/small.yaml" --config goniotool="$goniotool" out=out "materials=$materials") \
    >>"$folder/$run.log" 2>&1
}
tables() { workflow "$1" "['../tables']" judge_folds study "${@:2}"; }
bundled() {
  workflow "$1" "['library:sgd/chrome', 'library:sgd/blue-fabric', 'library:sgd/gold-metallic-paint']" acquisition "${@:2}"
}
# With times: its results differ from run to run.
reproduction() { workflow "$1" "['../tables']" reproduce "${@:2}"; }

tables dry --dry-run || { cat "$folder/dry.log"; fail "dry run"; }
bundled dry --dry-run || { cat "$folder/dry.log"; fail "dry run of the acquisition"; }
[ ! -e "$folder/dry/out" ] || fail "the dry run wrote results"

tables whole || { cat "$folder/whole.log"; fail "the whole run"; }
bundled whole || { cat "$folder/whole.log"; fail "the whole acquisition"; }

# Killed when the study has one of its materials.
study=$folder/killed/out/study
# Snakemake's record of a job that is not finished.
unfinished=$folder/killed/.snakemake/incomplete/$(printf %s out/study/table-0.json | base64 -w0 | tr '+/' '-_')
set -m
tables killed &
workflow=$!
set +m
for _ in $(seq 6000); do
  [ ! -e "$study/table-0.json" ] || [ -e "$unfinished" ] || break
  sleep 0.01
done
kill -KILL -- "-$workflow"
wait "$workflow" 2>/dev/null || true
if [ ! -e "$study/table-0.json" ] || [ -e "$study/summary.json" ]; then fail "the run was not killed in its middle"; fi
first=$(stat -c %i "$study/table-0.json")
tables killed --unlock
tables killed || { cat "$folder/killed.log"; fail "continuing the run"; }
bundled killed || { cat "$folder/killed.log"; fail "the acquisition after it"; }
[ "$first" = "$(stat -c %i "$study/table-0.json")" ] || fail "a finished material was measured again"
diff -r --exclude=log --exclude=checkpoints "$folder/whole/out" "$folder/killed/out" || fail "the bits differ"

: >"$folder/whole.log"
tables whole
bundled whole
[ "$(grep -c "Nothing to be done" "$folder/whole.log")" = 2 ] || fail "finished jobs run again"
reproduction reproduced || { cat "$folder/reproduced.log"; fail "the reproduction"; }
for file in figure-5.4.pdf table-2.1.csv report.html; do
  [ -s "$folder/reproduced/out/reproduction/$file" ] || fail "$file of the reproduction is missing"
done
for table in judged/summary.csv study/summary.csv acquisition/medians.csv; do
  [ -s "$folder/whole/out/$table" ] || fail "$table is missing"
done

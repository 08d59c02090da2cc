#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# SPDX-FileCopyrightText: The Gonio authors
# scripts/check_style.sh [BASE]: clang-format on every source file, also if it is not added yet; clang-tidy (.clang-tidy) on the
# source files that differ from the commit BASE. Without BASE: from where the branch left origin/main, or from the commit before this one.
set -eu
# shellcheck source=scripts/setup.sh
. "$(dirname "$0")/setup.sh"
cd "$root"

# Another version of clang-format breaks lines elsewhere, and of clang-tidy has other checks under the same names, so only
# those of Debian 12 are asked.
clang_version=14
if clang-format --version 2>/dev/null | grep -q "version $clang_version\."; then
  git ls-files -co --exclude-standard '*.cpp' '*.h' | xargs clang-format --dry-run --Werror || fail "run clang-format -i on the files above"
else
  printf 'gonio: clang-format %s is not installed: the layout of the sources is not checked\n' "$clang_version" >&2
fi

base=${1:-$(git merge-base HEAD origin/main 2>/dev/null || true)}
if [ -z "$base" ] || [ "$base" = "$(git rev-parse HEAD)" ]; then base=$(git rev-parse --verify -q HEAD~1 || true); fi
[ -n "$base" ] || exit 0
# The largest number of files: clang-tidy takes 3 to 36 s for each, of the 20 min that all of it may take. A larger change is checked by naming its commits.
max_files=4
mapfile -t changed < <(git diff --name-only --diff-filter=d "$base" -- '*.cpp' | grep -E '^(core|widgets|app)/' || true)
[ ${#changed[@]} -gt 0 ] || exit 0
if [ ${#changed[@]} -gt "$max_files" ]; then
  printf 'gonio: clang-tidy checks the first %d of %d changed files\n' "$max_files" ${#changed[@]} >&2
  changed=("${changed[@]:0:$max_files}")
fi
clang-tidy --version 2>/dev/null | grep -q "version $clang_version\." ||
  { printf 'gonio: clang-tidy %s is not installed: nothing is analysed\n' "$clang_version" >&2; exit 0; }
configure tidy
# The sources include the code that moc makes.
cmake --build "$root/build/tidy" --target gonio_widgets_moc gonio_app_moc >"$root/build/tidy-generated.log" 2>&1 ||
  { cat "$root/build/tidy-generated.log" >&2; fail "the files that clang-tidy needs could not be generated"; }
printf '%s\n' "${changed[@]}" | xargs -P 2 -n 1 clang-tidy -p "$root/build/tidy" --quiet --warnings-as-errors='*' 2>"$root/build/tidy.log" ||
  fail "clang-tidy has findings (see above; the checks are in .clang-tidy)"

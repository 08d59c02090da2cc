#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# SPDX-FileCopyrightText: The Gonio authors
# scripts/long_tests.sh: the tests of the core with as many draws and random cases as ./check has no time for, and the
# benchmark of accuracy (about a quarter of an hour on two cores).
set -eu
# shellcheck source=scripts/setup.sh
. "$(dirname "$0")/setup.sh"
install_packages
cd "$root"
configure release
cmake --build build/release || fail "the build failed (see above)"
export QTEST_FUNCTION_TIMEOUT=3000000  # ms; five minutes without
GONIO_LONG_TESTS=1 ctest --preset release -L '^(core|fuzz)' || fail "tests failed (see above)"
measured=../shared/data/rgl  # the development data
[ ! -d "$measured" ] || build/release/tests/studies/gonio_studies accuracy_marks "$measured" ||
  fail "a representation has not the accuracy of its mark (see above)"

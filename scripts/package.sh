#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# SPDX-FileCopyrightText: The Gonio authors
# scripts/package.sh: builds build/package/gonio_VERSION_ARCHITECTURE.deb, for any processor of this architecture.
set -eu
# shellcheck source=scripts/setup.sh
. "$(dirname "$0")/setup.sh"
install_packages
configure package
cmake --build "$root/build/package" --target gonio goniotool gonio_python || fail "the build failed (see above)"
(cd "$root/build/package" && cpack -G DEB >cpack.log) || fail "the package could not be made (see build/package/cpack.log)"
printf '%s\n' "$root"/build/package/gonio_*.deb

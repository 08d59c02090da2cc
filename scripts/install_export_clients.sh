#!/bin/sh
# SPDX-License-Identifier: Apache-2.0
# SPDX-FileCopyrightText: The Gonio authors
# scripts/install_export_clients.sh [--npm-only] [FOLDER]: installs the programs that read exports in tests, on Debian 12 or 13
# (as root; about 620 MB), and into FOLDER those of npm (62 MB), for tests with GONIO_EXPORT_CLIENTS=FOLDER/node_modules.
# With --npm-only no packages of Debian. Tests of clients that are not installed are skipped.
set -eu
packages=yes
if [ "${1:-}" = --npm-only ]; then
  packages=no
  shift
fi
if [ $packages = yes ]; then
  apt-get update
  apt-get install --yes --no-install-recommends blender
  [ $# -eq 0 ] || apt-get install --yes --no-install-recommends chromium
fi
[ $# -gt 0 ] || exit 0
# The validator of glTF, MaterialX as WebAssembly and three.js.
command -v npm >/dev/null || apt-get install --yes --no-install-recommends nodejs npm
npm install --no-audit --no-fund --prefix "$1" gltf-validator@2.0.0-dev.3.10 @needle-tools/materialx@1.4.6 three@0.187 \
  puppeteer-core@25.16

#!/bin/sh
# SPDX-License-Identifier: Apache-2.0
# SPDX-FileCopyrightText: The Gonio authors
# scripts/install_export_clients.sh [FOLDER]: installs the programs that read exports in tests, on Debian 12 (as root; about
# 620 MB), and into FOLDER those of npm. Tests of clients that are not installed are skipped.
set -eu
apt-get update
apt-get install --yes --no-install-recommends blender
# The validator of glTF, MaterialX as WebAssembly and three.js, for tests with GONIO_EXPORT_CLIENTS=FOLDER/node_modules.
if [ $# -gt 0 ]; then
  apt-get install --yes --no-install-recommends chromium
  command -v npm >/dev/null || apt-get install --yes --no-install-recommends nodejs npm
  npm install --no-audit --no-fund --prefix "$1" gltf-validator@2.0.0-dev.3.10 @needle-tools/materialx@1.4.6 three@0.187 \
    puppeteer-core@25.16
fi

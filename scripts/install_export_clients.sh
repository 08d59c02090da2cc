#!/bin/sh
# SPDX-License-Identifier: Apache-2.0
# SPDX-FileCopyrightText: The Gonio authors
# Installs the programs that read exports in tests, on Debian 12 (as root; about 620 MB). Tests of clients that are not
# installed are skipped.
set -eu
apt-get update
apt-get install --yes --no-install-recommends blender

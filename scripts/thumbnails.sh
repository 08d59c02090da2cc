#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# SPDX-FileCopyrightText: The Gonio authors
# scripts/thumbnails.sh: renders the pictures of the bundled materials into resources/thumbnails (one JPEG file of a
# megabyte and its index). A minute on two cores. Run it when a bundled material, the rim lights or the tone curve has changed;
# the test `thumbnail` fails when the pictures are out of date.
set -eu
root=$(cd "$(dirname "$0")/.." && pwd)
editor=$root/build/release/app/gonio/gonio
[ -x "$editor" ] || { echo "thumbnails: build the editor first (./run)" >&2; exit 1; }
QT_QPA_PLATFORM=offscreen "$editor" --thumbnails "$root/resources/thumbnails"

#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# SPDX-FileCopyrightText: The Gonio authors
# scripts/thumbnails.sh: draws the pictures of the bundled materials anew, into resources/thumbnails. A minute on two cores.
set -eu
root=$(cd "$(dirname "$0")/.." && pwd)
editor=$root/build/release/app/gonio/gonio
[ -x "$editor" ] || { echo "thumbnails: build the editor first (./run)" >&2; exit 1; }
drawn=$(mktemp -d)
trap 'rm -rf "$drawn"' EXIT
QT_QPA_PLATFORM=offscreen "$editor" --thumbnails "$drawn"
mkdir -p "$root/resources/thumbnails"
rm -f "$root/resources/thumbnails"/*.png
mv "$drawn"/*.png "$root/resources/thumbnails"

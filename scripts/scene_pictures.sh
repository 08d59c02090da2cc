#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# SPDX-FileCopyrightText: The Gonio authors
# scripts/scene_pictures.sh [PICTURE]: renders the project's own scenes side by side into docs/images/scenes.png, with
# ImageMagick's montage. GONIOTOOL names another build's program.
set -eu
root=$(cd "$(dirname "$0")/.." && pwd)
out=${1:-$root/docs/images/scenes.png}
tool=${GONIOTOOL:-$root/build/release/app/goniotool/goniotool}
[ -x "$tool" ] || { echo "scene_pictures: build goniotool first (./run)" >&2; exit 1; }
command -v montage >/dev/null 2>&1 || { echo "scene_pictures: montage is missing (imagemagick)" >&2; exit 1; }
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT

# picture SCENE MATERIAL ...
picture() {
  scene=$1
  shift
  "$tool" render "$@" --scene "$scene" --size 200 --samples 256 --out "$folder/$scene.png"
  pictures="${pictures:-} $folder/$scene.png"
}
paint=library:sgd/gold-metallic-paint
for scene in sphere sphere-distant-light sphere-on-plane sphere-under-lamp sphere-point-light; do picture $scene $paint; done
picture two-spheres $paint library:sgd/blue-metallic-paint2
picture row $paint library:sgd/red-fabric library:sgd/chrome
for scene in shader-ball cloth cylinder plane bowl torus; do picture $scene $paint; done
# shellcheck disable=SC2086
montage $pictures -tile 5x3 -geometry +4+4 -background '#303030' -depth 8 "$out"

#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# SPDX-FileCopyrightText: The Gonio authors
# scripts/start_pictures.sh [GONIOTOOL]: renders the pictures of the editor's start page into resources/start: six materials on
# the shader ball, and one picture for each kind of editing. Needs ImageMagick; five minutes on two cores. Run it when one of
# the materials, the studio or the tone curve has changed.
set -eu
root=$(cd "$(dirname "$0")/.." && pwd)
tool=${1:-$root/build/release/app/goniotool/goniotool}
[ -x "$tool" ] || { echo "start_pictures: build goniotool first (./run)" >&2; exit 1; }
out=$root/resources/start
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
mkdir -p "$out"
# The shader ball on a dark ground, which ends a picture as quietly on a dark page as on a light one.
cat >"$work/ball.json" <<'END'
{"format": "gonio scene", "version": 1,
 "camera": {"yaw": 18, "pitch": 21, "distance": 4.3, "target": [0, -0.12, 0]},
 "objects": [
   {"name": "the shader ball", "shape": "mesh", "mesh": "shader-ball"},
   {"name": "the ground", "shape": "rectangle", "centre": [0, -1, 0], "halfU": [0, 0, 60], "halfV": [60, 0, 0],
    "material": {"diffuse": [0.05, 0.05, 0.05]}}],
 "environment": {"picture": "studio"}}
END
samples=${SAMPLES:-128}

# ball MATERIAL SIZE PICTURE
ball() { "$tool" render "$1" --scene "$work/ball.json" --size "$2" --samples "$samples" --out "$work/$3.png" >/dev/null; }

for material in rgl/cc_ibiza_sunset rgl/cc_iris_purple_gem merl-copy/gold-metallic-paint rgl/chm_light_blue \
  rgl/acrylic_felt_purple rgl/leaf_maple; do
  name=${material#*/}
  ball "library:$material" 256 "$name"
  convert "$work/$name.png" -quality 88 "$out/$name.jpg"
done

# strips NAME PICTURE ...: one picture from vertical strips of several of one size; the ball is divided evenly
width=320 height=200 ball_left=96 ball_right=232
strips() {
  local name=$1 x=0 i=0 end
  shift
  local parts=()
  for picture in "$@"; do
    i=$((i + 1))
    end=$((i == $# ? width : ball_left + (ball_right - ball_left) * i / $#))
    convert "$work/$picture.png" -crop "$((end - x))x$height+$x+0" +repage "$work/strip-$picture.png"
    parts+=("$work/strip-$picture.png")
    x=$end
  done
  convert "${parts[@]}" +append "$work/$name.png"
}
paint=library:merl-copy/gold-metallic-paint gem=library:rgl/cc_iris_purple_gem
"$tool" edit "$paint" --model ggx --control tint=1,0.35,0.3 --out "$work/redder.gonio" >/dev/null
"$tool" edit "$paint" --model ggx --control roughness=4 --control tint=1,0.35,0.3 --out "$work/rougher.gonio" >/dev/null
ball "$paint" "${width}x$height" sliders-0
ball "$work/redder.gonio" "${width}x$height" sliders-1
ball "$work/rougher.gonio" "${width}x$height" sliders-2
strips sliders sliders-0 sliders-1 sliders-2
for t in 0 1 2 3 4; do
  "$tool" interpolate "$paint" "$gem" --at "$(awk "BEGIN { print $t / 4 }")" --out "$work/blend-$t.binary" >/dev/null
  ball "$work/blend-$t.binary" "${width}x$height" "blend-$t"
done
strips blend blend-0 blend-1 blend-2 blend-3 blend-4
ball library:rgl/chm_light_blue "${width}x$height" curves
# A profile of a highlight with its points, as in the Factor curves panel.
points() { awk -v from="$1" -v to="$2" -v step="$3" -v form="$4" 'BEGIN {
  for (x = from; x <= to; x += step) { y = 180 - 150 * exp(-((x - 160) / 52) ^ 2); printf form, x, y, x + 5, y } }'; }
convert "$work/curves.png" -fill none -stroke '#5fa3dd' -strokewidth 3 -draw "polyline $(points 12 308 4 '%g,%g ')" \
  -fill '#e4e4e4' -stroke '#191919' -strokewidth 1 -draw "$(points 40 280 40 'circle %g,%g %g,%g ')" \
  "$work/curves-drawn.png"
convert "$work/sliders.png" -quality 88 "$out/sliders.jpg"
convert "$work/curves-drawn.png" -quality 88 "$out/curves.jpg"
convert "$work/blend.png" -quality 88 "$out/blend.jpg"

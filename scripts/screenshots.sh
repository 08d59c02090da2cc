#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# SPDX-FileCopyrightText: The Gonio authors
# scripts/screenshots.sh [FOLDER [NAME ...]]: takes the pictures of the editor in README and docs, or those of these names, on
# a virtual display, into docs/images. A minute each. GONIO names another build's program.
set -eu
root=$(cd "$(dirname "$0")/.." && pwd)
folder=${1:-$root/docs/images}
editor=${GONIO:-$root/build/release/app/gonio/gonio}
[ -x "$editor" ] || { echo "screenshots: build the editor first (./run)" >&2; exit 1; }
mkdir -p "$folder"
[ $# -eq 0 ] || shift
names=" $* "
# Settings of its own, so that the pictures show the editor as it comes.
settings=$(mktemp -d)
trap 'rm -rf "$settings"' EXIT

# picture NAME THEME FILE [OPTION ...]
picture() {
  name=$1 theme=$2 file=$3
  shift 3
  case "$names" in "  " | *" $name "*) ;; *) return 0 ;; esac
  XDG_CONFIG_HOME=$settings XDG_DATA_HOME=$settings LIBGL_ALWAYS_SOFTWARE=1 \
    xvfb-run -a -s "-screen 0 1600x1000x24 -noreset" \
    "$editor" "$file" "$@" --theme "$theme" --size 1500x940 --wait 400 --screenshot "$folder/$name"
  echo "$folder/$name"
}
picture editor-dark.jpg dark library:rgl/cc_ibiza_sunset
picture editor-light.jpg light library:rgl/acrylic_felt_pink
picture editor-comparison.jpg dark library:merl-copy/gold-metallic-paint --compare difference
picture editor-models.jpg light library:merl-copy/gold-metallic-paint --models
picture editor-factors.jpg light library:merl-copy/gold-metallic-paint --factors
picture factors-original.png dark library:sgd/gold-metallic-paint --factors
picture factors-widened.png dark library:sgd/gold-metallic-paint --factors --widen 1.8
picture factors-swapped.png dark library:sgd/gold-metallic-paint --factors --take-f1 library:sgd/green-metallic-paint
picture interpolation.png light library:sgd/gold-metallic-paint \
  --interpolate library:sgd/gold-metallic-paint,library:sgd/blue-metallic-paint2
picture editor-study.png light library:merl-copy/gold-metallic-paint --study "PDV factors, two curves, 1 term"
picture editor-acquisition.png dark library:rgl/vch_golden_yellow --acquire 40 --acquisition-page 1
# Images of docs/tutorial-photographs.md.
cat >"$settings/film.json" <<'END'
{"format": "gonio photographs", "version": 1, "images": [
  {"file": "film-1.exr", "camera": {"position": [0, 0, 4]}, "lights": [{"environment": "studio", "rotation": 0}]},
  {"file": "film-2.exr", "camera": {"position": [0, 0, 4]}, "lights": [{"environment": "studio", "rotation": 90}]},
  {"file": "film-3.exr", "camera": {"position": [0, 0, 4]}, "lights": [{"environment": "studio", "rotation": 200}]}]}
END
case "$names" in "  " | *" editor-photographs.png "*)
  "$(dirname "$editor")/../goniotool/goniotool" photograph simulate "$settings/film.json" library:rgl/vch_golden_yellow \
    --noise 0.01 ;;
esac
picture editor-photographs.png dark library:rgl/vch_golden_yellow --photographs "$settings/film.json"
picture editor-representation.png dark library:sgd/brass --encoded 64 --compare split
picture editor-row.png light library:merl-copy/gold-metallic-paint --scene row \
  --slots library:merl-copy/aluminium,library:rgl/acrylic_felt_purple,library:merl-copy/alum-bronze
# The figure of docs/tutorial-figure.md.
cat >"$settings/figure.json" <<'END'
{
  "format": "gonio figure", "version": 1, "columns": "one",
  "materials": [
    {"path": "library:rgl/vch_golden_yellow", "label": "yellow film"},
    {"path": "library:rgl/satin_purple", "label": "satin purple"},
    {"path": "library:merl-copy/chrome", "label": "chrome"}
  ],
  "representations": [
    {"id": "ggx", "label": "GGX"},
    {"id": "factors-3d", "budget": 10, "label": "PDV, 10 terms"},
    {"id": "code", "budget": 1024, "label": "Sparse code"},
    {"id": "nonparametric", "label": "Non-param. factors"}
  ],
  "pictures": {"samples": 32},
  "numbers": ["rendered-snr", "flip", "bytes"],
  "inset": {"x": 0.2, "y": 0.2, "size": 0.25},
  "errorMaximum": 0.1
}
END
picture editor-figure.jpg dark library:rgl/vch_golden_yellow --figure "$settings/figure.json"

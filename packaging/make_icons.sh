#!/usr/bin/env bash
# Draws the icons again: packaging/icon.wind.json as `windloom render` shows it, in the sizes that desktops ask for.
# Needs ImageMagick. usage: packaging/make_icons.sh WINDLOOM
set -euo pipefail
[ $# = 1 ] || { echo "usage: packaging/make_icons.sh WINDLOOM" >&2; exit 2; }
windloom=$(realpath "$1")
cd "$(dirname "$0")"
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

"$windloom" render icon.wind.json --camera icon --time 3 --size 1024x1024 --overlay arrows --full-quality \
  --backend cpu --out "$work/whole.png"
mkdir -p icons
for size in 16 22 24 32 48 64 128 256 512; do
  # The smaller the icon, the nearer the arrow: it has to be seen before the grass.
  part=1024
  if [ "$size" -lt 32 ]; then part=960; fi
  # Drawn four times as large and then made smaller, so that the round corners are smooth.
  large=$((size * 4))
  convert -size "${large}x$large" xc:none -fill white \
    -draw "roundrectangle 0,0 $((large - 1)),$((large - 1)) $((large * 20 / 100)),$((large * 20 / 100))" "$work/mask.png"
  convert "$work/whole.png" -gravity center -crop "${part}x$part+0+0" +repage -modulate 96,112 -filter Lanczos \
    -resize "${large}x$large!" -alpha set "$work/mask.png" -compose DstIn -composite \
    -filter Box -resize "${size}x$size!" -strip -define png:exclude-chunks=date,time -define png:color-type=6 \
    -define png:compression-level=9 "icons/windloom-$size.png"
done

#!/usr/bin/env bash
# Makes the pictures of README.md and docs/thesis.md: records the sessions, draws them, puts them side by side.
# Usage: tools/scripts/figures/figures.sh [FOLDER [FIGURE...]]     FOLDER: docs/images unless said; FIGURE: tower, 4, 5, 7, 8, … (all unless said)
# Needs build/release/tools/tumble, ffmpeg and gnuplot. Figs. 8 and 9 are tools/scripts/figures/figures_drawn.sh's.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/../../.."
tumble=$PWD/build/release/tools/tumble
out=${1:-docs/images}
(($# == 0)) || shift
wanted=" $* "
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
mkdir -p "$out"

is_wanted() { [[ $wanted == "  " || $wanted == *" $1 "* ]]; }
record() { # name, case or scene, arguments
  [[ -f $work/$1.tumble ]] || "$tumble" record "$2" -o "$work/$1.tumble" --quiet "${@:3}"
}
draw() { # picture, session, step, arguments
  "$tumble" render "$work/$2.tumble" --step "$3" -o "$work/$1.png" --size "$size" "${@:4}" >/dev/null
}
row() { # figure, pictures from left to right, scaled to one height
  local inputs=() scaled='' joined='' k=0
  for picture in "${@:2}"; do
    inputs+=(-i "$work/$picture.png")
    scaled+="[$k]scale=-2:${size#*x}:flags=neighbor[s$k];"
    joined+="[s$k]"
    k=$((k + 1))
  done
  ffmpeg -v error -y "${inputs[@]}" -filter_complex "$scaled${joined}hstack=$k" "$work/$1.png"
}
column() { # figure, rows from top to bottom
  local inputs=() k=0
  for picture in "${@:2}"; do
    inputs+=(-i "$work/$picture.png")
    k=$((k + 1))
  done
  ffmpeg -v error -y "${inputs[@]}" -filter_complex "vstack=$k" "$work/$1.png"
}
publish() { # picture, name: few enough bytes for a document, with 256 colours
  ffmpeg -v error -y -i "$work/$1.png" -vf "split[a][b];[a]palettegen=max_colors=256[p];[b][p]paletteuse=dither=sierra2_4a" \
    -compression_level 9 "$out/$2.png"
  printf '%s  %s bytes\n' "$out/$2.png" "$(stat -c %s "$out/$2.png")"
}

if is_wanted tower; then
  size=880x496
  record round brick_tower
  draw tower round 160 --samples 3
  cp "$work/tower.png" "$out/brick_tower.png"
fi

if is_wanted 4; then
  size=400x300
  crates() { # degrees
    printf '[world]\nmethod = "thesis"\nsteps = 1\n[camera]\nposition = [1.2, -6.5, 3.4]\ntarget = [0.15, 0, 0.85]\nfov = 32\nblur = 0\n'
    printf '[light]\nposition = [4, -6, 10]\n[[box]]\nposition = [-0.95, 0, 0.9]\naxis = [0.6, 0.2, 1]\ndegrees = %s\n' "$1"
    printf '[[box]]\nposition = [1.05, 0, 0.95]\nsize = [1.6, 0.7, 0.9]\naxis = [-0.3, 1, 0.5]\ndegrees = %s\n' "$1"
  }
  for degrees in 0 35; do
    crates $degrees >"$work/bounds-$degrees.toml"
    record bounds-$degrees "$work/bounds-$degrees.toml"
    draw 4-$degrees bounds-$degrees 0 --show bounds --effects -motion,-bloom
  done
  row 4 4-0 4-35
  publish 4 fig04_bounding_boxes
fi

# Two crates that meet at one point, and at several that are merged into one.
crate_scene() { # degrees about x of the falling crate
  printf '[world]\nmethod = "thesis"\nsteps = 60\nsubsteps = 1\n[[box]]\nposition = [0, 0, 0.5]\n[[box]]\n'
  printf 'position = [0.3, 0.2, 2.1]\naxis = [1, 0.4, 0]\ndegrees = %s\n' "$1"
  printf '[camera]\nposition = [2.6, -5.5, 2.6]\ntarget = [0.1, 0, 1.0]\nfov = 29\nblur = 0\n[light]\nposition = [5, -6, 12]\n'
}
if is_wanted 5; then
  size=400x300
  crate_scene 38 >"$work/point.toml"
  crate_scene 0 >"$work/flat.toml"
  record point "$work/point.toml"
  record flat "$work/flat.toml"
  draw 5a point 18 --show contacts --effects -motion
  draw 5b flat 24 --show contacts --effects -motion
  row 5 5a 5b
  publish 5 fig05_06_collision_points
fi
if is_wanted 7; then
  size=400x300
  record with friction_with
  record without friction_without
  draw 7a with 0
  draw 7b without 240
  draw 7c with 240
  row 7 7a 7b 7c
  publish 7 fig07_friction
fi
if is_wanted 8 || is_wanted 9; then
  tools/scripts/figures/figures_drawn.sh "$out"
fi
if is_wanted 10; then
  size=400x300
  record freeze freeze_and_wake
  for k in 40 110 470; do draw 10-$k freeze $k --show freezing --effects -bloom; done
  row 10 10-40 10-110 10-470
  publish 10 fig10_freezing
fi
if is_wanted 11; then
  size=800x300
  record stacks stacks --set 'camera.position=[6.5, -27, 5.5]' --set 'camera.target=[2.7, 0, 3.1]' --set camera.fov=24 \
    --set 'light.position=[14, -16, 22]'
  draw 11 stacks 480
  publish 11 fig11_stacking
fi

# What chapter IV adds, one effect after the other.
close=(--set 'camera.position=[-5.5, -6.5, 2.6]' --set 'camera.target=[-9.0, 0.5, 1.2]' --set camera.focus=8.5
  --set 'light.position=[-14, -12, 5]' --set 'light.target=[-9, 0, 1]')
if is_wanted 12; then
  size=400x300
  record close stacks "${close[@]}"
  draw 12a close 300 --effects vertex,-shadow,-bloom,-dof,-motion
  draw 12b close 300 --effects specular
  row 12 12a 12b
  publish 12 fig12_13_shading_specular
fi
if is_wanted 14; then
  size=400x300
  record shade freeze_and_wake --set 'light.position=[-20, -14, 22]' --set 'light.target=[-2, 2, 1]'
  draw 14a shade 110 --effects specular
  draw 14b shade 110 --effects specular,shadow
  draw 15 shade 110 --pass depth
  row 14 14a 14b 15
  publish 14 fig14_15_shadows_depth_map
fi
if is_wanted 16; then
  size=400x300
  record freeze freeze_and_wake
  draw 16a freeze 110 --show freezing --effects -bloom
  draw 16b freeze 110 --show freezing --pass hdr
  draw 16c freeze 110 --show freezing
  row 16 16a 16b 16c
  publish 16 fig16_bloom
fi
if is_wanted 17; then
  size=400x300
  record deep stacks --set 'camera.position=[-16.5, -7.5, 3.2]' --set 'camera.target=[-8, -1, 2.4]' --set camera.focus=11.5 \
    --set camera.blur=2.2
  draw 17a deep 480 --effects -dof
  draw 17b deep 480 --pass masks
  draw 17c deep 480
  row 17 17a 17b 17c
  publish 17 fig17_depth_of_field
fi
if is_wanted 18; then
  size=400x300
  record motion brick_tower --set 'camera.position=[18, -22, 7]' --set 'camera.target=[0.5, -4, 2.6]' --set camera.focus=24
  draw 18a motion 51 --effects -motion,-dof
  draw 18b motion 51 --effects -dof --pass masks
  draw 18c motion 51 --effects -dof
  row 18 18a 18b 18c
  publish 18 fig18_motion_blur
fi
if is_wanted 19; then
  size=400x300
  record freeze freeze_and_wake
  show=(--show freezing)
  draw 19a freeze 58 "${show[@]}" --pass base
  draw 19b freeze 58 "${show[@]}" --pass masks
  draw 19c freeze 58 "${show[@]}" --pass blurred
  draw 19d freeze 58 "${show[@]}" --pass glow
  row 19x 19a 19c
  row 19y 19b 19d
  column 19 19x 19y
  size=800x600
  draw 19e freeze 58 "${show[@]}"
  row 19z 19 19e
  publish 19z fig19_composition
fi
if is_wanted 20; then
  size=400x300
  record round brick_tower
  record cabin thin_long
  record wall brick_wall
  record sizes size_ratio
  row_of() { draw "20-$1a" "$1" "$2" && draw "20-$1b" "$1" "$3" && draw "20-$1c" "$1" "$4" && row "20-$1" "20-$1"{a,b,c}; }
  row_of round 45 75 300
  row_of cabin 30 60 240
  row_of wall 42 80 300
  row_of sizes 0 90 480
  column 20 20-round 20-cabin 20-wall 20-sizes
  publish 20 fig20_scenarios
fi

from_above=(--set 'camera.position=[0, 14, 70]' --set 'camera.target=[0, 14, 0]' --set camera.fov=36 --set camera.blur=0
  --set 'light.position=[40, -45, 60]' --set 'light.target=[0, 12, 0]')
if is_wanted 21; then
  size=600x400
  record grid tilted_grid
  record above tilted_grid "${from_above[@]}" --set 'camera.target=[0, 8, 0]' --set 'camera.position=[0, 8, 60]'
  draw 21a above 0
  draw 21b grid 0
  row 21 21a 21b
  publish 21 fig21_comparison_scene
fi
coarse=(--set world.dt=0.03333333333333333)
if is_wanted 22; then
  size=400x400
  for n in 1 4 10; do
    record above-$n tilted_grid "${from_above[@]}" "${coarse[@]}" --set world.substeps=$n
    record fine-$n tilted_grid "${from_above[@]}" --set world.substeps=$n
    draw 22-above-$n above-$n 150
    draw 22-fine-$n fine-$n 1500
  done
  row 22a 22-above-{1,4,10}
  row 22b 22-fine-{1,4,10}
  column 22 22a 22b
  publish 22 fig22_400_cubes_from_above
fi
if is_wanted 23; then
  size=400x400
  record clock tilted_grid "${from_above[@]}" "${coarse[@]}" --set world.substeps=1 --realtime
  record substeps tilted_grid "${from_above[@]}" --set world.substeps=200
  draw 23-clock clock 150
  draw 23-substeps substeps 1500
  row 23 23-clock 23-substeps
  publish 23 fig23_real_time
fi
if is_wanted 24; then
  size=400x400
  for n in 40 60 80; do
    many=(--set "grid.rows=$n" --set "grid.cols=$n" --set world.dt=0.03333333333333333)
    record many-$n tilted_grid "${many[@]}" --set "camera.position=[0, $((n * 17 / 40)), $((n * 7 / 2))]" \
      --set "camera.target=[0, $((n * 17 / 40)), 0]" --set camera.fov=22 --set camera.blur=0 \
      --set "light.position=[$((2 * n)), $((-2 * n)), $((3 * n))]" --set "light.target=[0, $((n * 6 / 10)), 0]"
    draw 24-$n many-$n 150 --samples 4
  done
  row 24a 24-40 24-60 24-80
  record aslant tilted_grid "${many[@]}" --set 'camera.position=[38, -50, 30]' --set 'camera.target=[4, 18, 6]' \
    --set camera.fov=38 --set camera.focus=65 --set 'light.position=[120, -120, 200]' --set 'light.target=[0, 45, 0]'
  size=1200x400
  draw 24b aslant 75 --samples 3
  column 24 24a 24b
  publish 24 fig24_numbers_of_cubes
fi

#!/usr/bin/env bash
# Makes the pictures of README.md and docs/thesis.md: records the sessions, draws them, puts them side by side.
# Usage: tools/figures.sh [FOLDER [FIGURE...]]     FOLDER: docs/images unless said; FIGURE: tower, 5, 7, 10, … (all unless said)
# Needs build/release/tools/tumble and ffmpeg.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
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
  draw 7a with 240
  draw 7b without 240
  row 7 7a 7b
  publish 7 fig07_friction
fi
if is_wanted 10; then
  size=400x300
  record freeze freeze_and_wake
  for k in 40 110 470; do draw 10-$k freeze $k --show freezing --effects -bloom; done
  row 10 10-40 10-110 10-470
  publish 10 fig10_freezing
fi
if is_wanted 11; then
  size=800x360
  record stacks stacks
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
  record freeze freeze_and_wake
  draw 14a freeze 110 --effects specular
  draw 14b freeze 110 --effects specular,shadow
  draw 15 freeze 110 --pass depth
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
  draw 21 grid 0
  publish 21 fig21_comparison_scene
fi
if is_wanted 22; then
  size=400x400
  coarse=(--set world.dt=0.03333333333333333)
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
if is_wanted 24; then
  size=400x300
  for n in 6 10 20 40; do
    record many-$n tilted_grid --set grid.rows=$n --set grid.cols=$n --set world.dt=0.03333333333333333 \
      --set "camera.position=[0, $((-n - 8)), $((n + 8))]" --set "camera.target=[0, $((n / 3)), 0]" --set camera.fov=52 \
      --set camera.blur=0 --set "light.position=[$n, -$n, $((3 * n + 10))]" --set "light.target=[0, $((n / 3)), 0]"
    draw 24-$n many-$n 150
  done
  row 24a 24-6 24-10
  row 24b 24-20 24-40
  column 24 24a 24b
  publish 24 fig24_numbers_of_cubes
fi

#!/usr/bin/env bash
# Makes the pictures of README.md and docs/thesis.md: records the sessions, draws them, puts them side by side.
# Usage: tools/scripts/figures/figures.sh [FOLDER [FIGURE...]]     FOLDER: docs/images unless said; FIGURE: tower, 4, 5, 7, 8, … (all unless said)
# Needs build/release/tools/tumble, ffmpeg and gnuplot. Figs. 8 and 9 are tools/scripts/figures/figures_drawn.sh's, Figs. 21 to 25
# tools/scripts/figures/figures_grid.sh's.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/../../.."
# shellcheck source=tools/scripts/figures/figures_lib.sh
source tools/scripts/figures/figures_lib.sh

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

# Fig. 5: a crate falls on a slab that reaches far beyond it. The box of larger volume has the plane: a thin slab is
# smaller than the crate, though it is longer, and its corners behind the crate's plane are nowhere near the crate.
slab_scene() { # thickness of the slab, m; its mass is that of a thick one
  printf '[world]\nmethod = "thesis"\nsteps = 60\nsubsteps = 1\nground = false\n[[box]]\nsize = [7, 2, %s]\nstatic = true\n' "$1"
  printf 'position = [0, 0, %s]\nmaterial = { texture = "concrete" }\n' "$(awk -v t="$1" 'BEGIN { print 1 - t / 2 }')"
  printf '[[box]]\nposition = [2.2, 0, 2.1]\n[camera]\nposition = [2.2, -9.5, 4.2]\ntarget = [0.2, 0, 1.1]\nfov = 31\nblur = 0\n'
  printf '[light]\nposition = [5, -6, 12]\n'
}
# Fig. 6: a crate that meets the ground with four corners, and one that meets it with two, one of them deeper.
drop_scene() { # degrees
  printf '[world]\nmethod = "thesis"\nsteps = 60\nsubsteps = 1\n[[box]]\nposition = [0, 0, 1.6]\naxis = [0.08, 1, 0]\ndegrees = %s\n' "$1"
  printf '[camera]\nposition = [2.0, -4.2, 1.5]\ntarget = [0, 0, 0.45]\nfov = 30\nblur = 0\n[light]\nposition = [5, -6, 12]\n'
}
first_contact() { # session: the step before the first whose state has turned the velocity upwards or stopped it
  "$tumble" dump "$work/$1.tumble" --steps 0:60 --body "$2" --csv |
    awk -F, 'NR > 2 && $12 > -9.81 * ($1 - 0.5) / 60 { print $1; exit }'
}
if is_wanted 5; then
  size=400x300
  slab_scene 0.06 >"$work/thin.toml"
  slab_scene 0.5 >"$work/thick.toml"
  drop_scene 0 >"$work/flat.toml"
  drop_scene 12 >"$work/tilted.toml"
  for scene in thin:2 thick:2 flat:1 tilted:1; do
    record "${scene%:*}" "$work/${scene%:*}.toml"
    draw "5-${scene%:*}" "${scene%:*}" "$(first_contact "${scene%:*}" "${scene#*:}")" --show contacts --effects -motion
  done
  name 5-thin '5 a'
  name 5-thick '5 b'
  name 5-flat '6 a'
  name 5-tilted '6 b'
  row 5x 5-thin 5-thick
  row 5y 5-flat 5-tilted
  column 5 5x 5y
  publish 5 fig05_06_collision_points
fi
if is_wanted 7; then
  size=400x300
  wide=(--camera position=10,-44,22 --camera target=2.5,-3,0.5 --camera fov=33 --effects -dof,-motion)
  record with friction_with
  record without friction_without
  draw 7a with 0 "${wide[@]}"
  draw 7b without 480 "${wide[@]}"
  draw 7c with 480 "${wide[@]}"
  row 7 7a 7b 7c
  publish 7 fig07_friction
fi
if is_wanted 8 || is_wanted 9; then
  tools/scripts/figures/figures_drawn.sh "$out"
fi
if is_wanted 10; then
  size=400x300
  record again freeze_again
  for k in 80 220 1440; do draw 10-$k again $k --show freezing --effects -bloom,-motion; done
  row 10 10-80 10-220 10-1440
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
# A light close to a wide slab: its vertices are far from the light. The slab has the same faint gloss all over.
plain=-shadow,-bloom,-dof,-motion
if is_wanted 12; then
  size=400x300
  {
    printf '[world]\nmethod = "thesis"\nsteps = 1\n[material]\ntexture = "wood"\n[camera]\nposition = [1.6, -6.5, 2.4]\ntarget = [0, 0, 1.0]\nfov = 36\n'
    printf '[light]\nposition = [-0.6, -1.5, 2.0]\ntarget = [0, 0, 1]\n[[box]]\nsize = [3.6, 0.5, 2.2]\nposition = [0, 0, 1.1]\n'
    printf '[[box]]\nposition = [1.1, -1.6, 0.5]\naxis = [0, 0, 1]\ndegrees = 25\n'
  } >"$work/slab.toml"
  record slab "$work/slab.toml"
  draw 12a slab 0 --effects "vertex,$plain,-specular"
  draw 12b slab 0 --effects specular
  row 12 12a 12b
  publish 12 fig12_shading
fi
if is_wanted 13; then
  size=400x300
  record close stacks "${close[@]}"
  draw 13a close 300 --effects "vertex,$plain"
  draw 13b close 300 --effects specular
  row 13 13a 13b
  publish 13 fig13_specular_maps
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
# A plank that turns about its middle, a crate that flies, and one at rest.
if is_wanted 18; then
  size=400x300
  {
    printf '[world]\nmethod = "thesis"\nsteps = 20\n[camera]\nposition = [0.4, -10, 2.6]\ntarget = [0.4, 0, 1.8]\nfov = 38\n'
    printf '[light]\nposition = [-5, -8, 12]\n[[box]]\nposition = [-2.6, 0, 0.5]\n[[box]]\nsize = [3.6, 0.5, 0.5]\nposition = [-0.3, 0, 2.6]\n'
    printf 'spin = [0, 3.0, 0]\nvelocity = [0, 0, 0.8]\n[[box]]\nposition = [3.0, 0, 1.9]\nvelocity = [3, 0, 1]\n'
  } >"$work/turning.toml"
  record turning "$work/turning.toml"
  draw 18a turning 10 --effects -motion,-dof
  draw 18b turning 10 --effects -dof --pass masks
  draw 18c turning 10 --effects -dof
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
  record wall brick_wall
  record cabin thin_long
  record round brick_tower
  record sizes size_ratio --set 'camera.position=[30.0, -66.0, 24.0]' --set 'camera.target=[0.0, 0.0, 20.0]' --set camera.fov=38 --set camera.focus=75
  row_of() { # letter, session, steps
    draw "20-$2a" "$2" "$3" && draw "20-$2b" "$2" "$4" && draw "20-$2c" "$2" "$5" && name "20-$2a" "$1" && row "20-$2" "20-$2"{a,b,c}
  }
  row_of a wall 42 80 300
  row_of b cabin 30 60 240
  row_of c round 45 75 300
  row_of d sizes 0 90 480
  column 20 20-wall 20-cabin 20-round 20-sizes
  publish 20 fig20_scenarios
fi
for n in 21 22 23 24 25; do
  if is_wanted $n; then
    tools/scripts/figures/figures_grid.sh "$out" ${wanted# }
    break
  fi
done

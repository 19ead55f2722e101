#!/usr/bin/env bash
# Makes the files that the readers read.
# Usage: TUMBLE=PROGRAM WORK=FOLDER tests/export/readers/sessions.sh
set -euo pipefail
root=$(realpath "$(dirname "${BASH_SOURCE[0]}")/../../..")
cd "$WORK"
"$TUMBLE" record "$root/golden/cases/layered_inputs/scene.toml" -o session.tumble >/dev/null
last=$("$TUMBLE" info session.tumble --json | sed -n 's/.*"steps": *\([0-9]*\).*/\1/p' | head -n 1)
"$TUMBLE" dump session.tumble --steps "0:$last" --csv >session.csv
"$TUMBLE" export session.tumble -o session.glb >/dev/null

# Every shape, with names, and channels of three kinds.
cat >wedge.obj <<'OBJ'
v -0.5 -0.5 -0.4
v 0.5 -0.5 -0.4
v 0.5 0.5 -0.4
v -0.5 0.5 -0.4
v 0 0 0.8
f 1 3 2
f 1 4 3
f 1 2 5
f 2 3 5
f 3 4 5
f 4 1 5
OBJ
{
  printf '# engine: shapes\n# dt: 0.05\n# camera.position: 0 -9 4\n# camera.target: 0 0 1\n'
  printf 'step,id,position.x,position.y,position.z,orientation.w,orientation.x,orientation.y,orientation.z,'
  printf 'size.x,size.y,size.z,shape,texture\n'
  for step in 0 1 2 3 4; do
    x=-4
    for body in ball:sphere:1,1,1 pill:capsule-z:0.8,0.8,2 tin:cylinder-x:1.6,1,1 wedge:hull:wedge.obj:1,1,1.6 \
                pyramid:mesh:wedge.obj:1,1,1.6 crate:box:1,1.2,1.4; do
      name=${body%%:*} size=${body##*:} shape=${body#*:}
      shape=${shape%:*}
      texture=brick
      [[ $name != crate ]] || texture=crate
      [[ $name != pill ]] || texture=wood
      printf '%s,%s,%s,0,%s,1,0,0,0,%s,%s,%s\n' $step $name $x 1.$step $size $shape $texture
      x=$((x + 2))
      [[ $name != tin ]] || x=$((x - 1))
    done
  done
} >shapes.csv
"$TUMBLE" import shapes.csv -o shapes.tumble >/dev/null
"$TUMBLE" export shapes.tumble -o shapes.glb >/dev/null
"$TUMBLE" export shapes.tumble -o one.glb --steps 2:2 --bodies pill >/dev/null

{
  printf '# engine: robot\n# dt: 0.01\nstep,id,position.x,position.y,position.z,orientation.w,orientation.x,'
  printf 'orientation.y,orientation.z,channel.knee,channel.word,world.seed\n'
  for step in 0 1 2 3 4 5; do
    printf '%s,1,0,0,1,1,0,0,0,0.1%s,up,%s\n%s,2,1,0,1,1,0,0,0,-1.5e-9%s,down,%s\n' $step $step $step $step $step $step
  done
} >channels.csv
"$TUMBLE" import channels.csv -o channels.tumble >/dev/null

#!/usr/bin/env python3
"""A ball on a spring, recorded. demo.py OUT.tumblestream [STIFFNESS [EARLIER.tumblestream]]"""

import sys

from tumble_recorder import Quat, Recorder, State, Vec3

stiffness = float(sys.argv[2]) if len(sys.argv) > 2 else 40.0
rec = Recorder(sys.argv[1], engine="spring", verify=sys.argv[3] if len(sys.argv) > 3 else None)
force = rec.channel("spring.force")
z, v, dt = 1.0, 0.0, 1 / 60
rec.body(1, State(Vec3(0, 0, z), Quat(1), Vec3(), Vec3()), name="ball", mass=2)
for k in range(120):
    pull = stiffness * (1.5 - z)
    v += dt * (pull / 2 - 9.81)
    z += dt * v
    rec.step_begin(dt)
    rec.state(1, State(Vec3(0, 0, z), Quat(1), Vec3(0, 0, v), Vec3()))
    rec.value(force, pull)
    rec.step_end()
sys.exit(rec.close())

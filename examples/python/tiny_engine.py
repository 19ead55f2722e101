"""A physics engine in a few lines, recorded: every command of tumble reads its log.

python3 tiny_engine.py ball.tumble && tumble measure ball.tumble && tumble render ball.tumble -o ball.mp4
"""

import sys

import tumble

BALL = {"shape": tumble.sphere(0.5), "mass": 2.0, "position": (0, 0, 4), "name": "ball"}
CHANNELS = {"energy": "J", "bounces": {"type": "int64"}}

# The engine
z, v, bounces = 4.0, 0.0, 0
with tumble.Recorder(sys.argv[1], engine="tiny", version="1", dt=0.01, bodies=[BALL], channels=CHANNELS) as log:
    for k in range(300):
        v -= 9.81 * 0.01
        z += v * 0.01
        if z < 0.5 and v < 0:
            z, v, bounces = 0.5, -0.9 * v, bounces + 1
        energy = 2.0 * (v * v / 2 + 9.81 * z)
        contacts = [(1, None, (0, 0, 0), (0, 0, 1), 0.0, 0.0)] if z == 0.5 else None
        log.step(position=[(0, 0, z)], velocity=[(0, 0, v)], contacts=contacts,
                 channels={"energy": energy, "bounces": bounces})

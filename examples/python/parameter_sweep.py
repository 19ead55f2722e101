"""How far a crate slides, for several coefficients of friction: a parameter sweep, in parallel."""

from concurrent.futures import ThreadPoolExecutor

import numpy

import tumble

SCENE = tumble.Scene(
    """
    [world]
    dt = 0.005
    seconds = 2
    [[box]]
    size = [1, 1, 0.5]
    position = [0, 0, 0.25]
    velocity = [3, 0, 0]
    """,
    "sliding_crate",
)


def slide(friction):
    settings = {"material.friction": friction, "material.friction_dynamic": friction}
    world = tumble.World.from_scene(SCENE, set=settings)
    world.run()  # other worlds step meanwhile
    return world.position[0, 0], numpy.linalg.norm(world.velocity[0])


FRICTIONS = [0.0, 0.05, 0.1, 0.2, 0.4, 0.8]
print(f"{'friction':>9} {'slid, m':>9} {'speed, m/s':>11}")
with ThreadPoolExecutor() as pool:
    for friction, (distance, speed) in zip(FRICTIONS, pool.map(slide, FRICTIONS)):
        print(f"{friction:9.2f} {distance:9.4f} {speed:11.4f}")

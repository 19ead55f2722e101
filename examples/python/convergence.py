"""How fast the error of a tumbling box falls with the step: a convergence study. No force acts; the turn is what is hard."""

import numpy

import tumble

SCENE = tumble.Scene(
    """
    [world]
    ground = false
    gravity = [0, 0, 0]
    seconds = 1
    [[box]]
    size = [1, 2, 3]
    spin = [1, 2, 0.5]
    """,
    "tumbling_box",
)


def orientation(halvings):
    world = tumble.World.from_scene(SCENE, set={"world.dt": 0.02 / 2**halvings})
    world.run()
    return world.orientation[0]


finest = orientation(9)
print(f"{'dt, s':>9} {'error':>12} {'ratio':>7}")
before = None
for halvings in range(5):
    error = numpy.linalg.norm(orientation(halvings) - finest)
    ratio = "" if before is None else f"{before / error:7.2f}"
    print(f"{0.02 / 2**halvings:9.5f} {error:12.3e} {ratio:>7}")
    before = error

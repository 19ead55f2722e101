"""Two sessions that differ in one number, compared and drawn, as in a notebook."""

# %% Record both.
import tumble
import tumble.plot

SETTINGS = {"grid.rows": 4, "grid.cols": 4}
tumble.record("layered_grid", "a.tumble", seconds=2, set=SETTINGS)
tumble.record("layered_grid", "b.tumble", seconds=2, set={**SETTINGS, "world.gravity": (0, 0, -9.8100001)})

# %% Where do they part?
report = tumble.diff("a.tumble", "b.tumble")
first = report.first
print(f"first different step: {first.step}, phase {first.phase}, {first.field}: {first.expected} and {first.actual}")

# %% Draw it.
axes = tumble.plot.separation("a.tumble", "b.tumble", report=report)
axes.figure.savefig("difference.png", dpi=120)

// Turning, moving and zooming a stage by pointer, wheel and keys.
const kTurn = 0.12;    // radians a key press
const kMove = 0.05;    // heights of the picture a key press
const kDrag = 0.008;   // radians a pixel
const kClickPx = 4;    // a pointer that moved less has clicked

/// The wheel only when the view has the focus: pages scroll. picked(x, y): a click, in shares of width and height.
export function listen(canvas, stage, picked = null) {
  let moved = 0;
  const touches = new Map();
  const spread = () => {
    const [a, b] = [...touches.values()];
    return Math.hypot(a.x - b.x, a.y - b.y);
  };
  canvas.addEventListener("pointerdown", (event) => {
    canvas.setPointerCapture(event.pointerId);
    canvas.focus({ preventScroll: true });
    touches.set(event.pointerId, { x: event.clientX, y: event.clientY });
    moved = 0;
  });
  canvas.addEventListener("pointermove", (event) => {
    if (event.buttons === 0) return;
    moved += Math.abs(event.movementX) + Math.abs(event.movementY);
    if (touches.size === 2) {
      const before = spread();
      touches.set(event.pointerId, { x: event.clientX, y: event.clientY });
      stage.zoom(before / Math.max(1, spread()));
    } else if (event.shiftKey || event.buttons !== 1) {
      stage.pan(event.movementX / canvas.clientHeight, event.movementY / canvas.clientHeight);
    } else {
      stage.turn(-kDrag * event.movementX, kDrag * event.movementY);
    }
    if (touches.has(event.pointerId)) touches.set(event.pointerId, { x: event.clientX, y: event.clientY });
  });
  const end = (event) => touches.delete(event.pointerId);
  canvas.addEventListener("pointerup", (event) => {
    end(event);
    if (moved > kClickPx || event.button !== 0 || !picked) return;
    const place = canvas.getBoundingClientRect();
    picked((event.clientX - place.left) / place.width, (event.clientY - place.top) / place.height);
  });
  canvas.addEventListener("pointercancel", end);
  canvas.addEventListener("contextmenu", (event) => event.preventDefault());
  canvas.addEventListener("wheel", (event) => {
    if (document.activeElement !== canvas) return;
    event.preventDefault();
    stage.zoom(Math.exp(event.deltaY / 800));
  }, { passive: false });
  const actions = {
    ArrowLeft: (moves) => (moves ? stage.pan(kMove, 0) : stage.turn(-kTurn, 0)),
    ArrowRight: (moves) => (moves ? stage.pan(-kMove, 0) : stage.turn(kTurn, 0)),
    ArrowUp: (moves) => (moves ? stage.pan(0, kMove) : stage.turn(0, kTurn)),
    ArrowDown: (moves) => (moves ? stage.pan(0, -kMove) : stage.turn(0, -kTurn)),
    "+": () => stage.zoom(0.85), "=": () => stage.zoom(0.85), "-": () => stage.zoom(1 / 0.85),
  };
  canvas.addEventListener("keydown", (event) => {
    if (!(event.key in actions) || event.ctrlKey || event.metaKey || event.altKey) return;
    event.preventDefault();
    event.stopPropagation();
    actions[event.key](event.shiftKey);
  });
}

/// The middle nine tenths of all places, so that one body that flew off does not make the others invisible.
/// places: [[x…], [y…], [z…]], m. ground: bodies that hang above it, and not far, will fall on it. Returns {centre, radius}.
export function box_around(places, size, ground = false) {
  const ends = places.map((axis) => {
    const sorted = axis.filter((value) => Number.isFinite(value)).sort((a, b) => a - b);
    if (sorted.length === 0) return [0, 0];
    return [sorted[Math.floor(0.05 * (sorted.length - 1))], sorted[Math.ceil(0.95 * (sorted.length - 1))]];
  });
  const low = ends[2][0];
  if (ground && low > 2 * size && low < 10 * Math.max(size, ...ends.map(([from, to]) => to - from))) ends[2][0] = 0;
  const centre = ends.map(([from, to]) => (from + to) / 2);
  const reach = Math.hypot(...ends.map(([low, high]) => high - low));
  return { centre, radius: Math.max(reach / 2 + Math.min(Math.max(size, 0.1), 4), 1e-3) };
}

#include "tumble/render/snapshot.h"

namespace tumble::render {
namespace {

sim::Quat turned_between(const sim::Quat& a, const sim::Quat& b, double part) {
  const double cosine = a.w * b.w + a.x * b.x + a.y * b.y + a.z * b.z;
  const double from = cosine < 0 ? part - 1 : 1 - part;  // q and −q are the same orientation
  return sim::normalised(
      {a.w * from + b.w * part, a.x * from + b.x * part, a.y * from + b.y * part, a.z * from + b.z * part});
}

}  // namespace

Snapshot between(const Snapshot& before, const Snapshot& after, double part, double dt) {
  Snapshot made = after;
  auto old = before.boxes.begin();
  for (BoxLook& box : made.boxes) {
    while (old != before.boxes.end() && old->id < box.id) ++old;
    if (old == before.boxes.end() || old->id != box.id) {
      box.centre -= box.velocity * (dt * (1 - part));
      continue;
    }
    box.centre = old->centre + (box.centre - old->centre) * part;
    box.orientation = turned_between(old->orientation, box.orientation, part);
    box.velocity = old->velocity + (box.velocity - old->velocity) * part;
    box.spin = old->spin + (box.spin - old->spin) * part;
  }
  return made;
}

}  // namespace tumble::render

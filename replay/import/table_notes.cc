#include "replay/import/table_notes.h"

#include "src/base/text.h"

namespace tumble::replay {

void TableNotes::lost(const std::string& place, const NotFinite& found) {
  if (lost_.empty()) {
    first_lost_ = found;
    place_of_lost_ = place;
  }
  lost_.insert(found.body);
  first_lost_.bodies = lost_.size();
}

void TableNotes::rough_rotation(const std::string& place, sim::BodyId body, std::uint64_t step, double length) {
  if (++rough_ > 1) return;
  first_rough_ = place + "body " + std::to_string(body) + ", step " + std::to_string(step) +
                 ": the orientation is a quaternion of length " + significant(length, 9) + ", wanted 1";
}

void TableNotes::short_end(const std::string& place, std::size_t bodies, std::size_t before,
                           sim::BodyId first_missing) {
  short_end_ = place + "the last step has " + std::to_string(bodies) + " of the " + count_text(before, "body") +
               " of the step before; body " + std::to_string(first_missing) +
               (bodies + 1 < before ? " and others count" : " counts") + " as removed, unless the table was cut";
}

std::vector<std::string> TableNotes::texts() const {
  std::vector<std::string> out;
  if (!lost_.empty()) out.push_back(place_of_lost_ + to_string(first_lost_, {}));
  if (rough_ > 0) {
    out.push_back(first_rough_);
    if (rough_ > 1) out.back() += ", and " + count_text(rough_ - 1, "row") + " more likewise";
  }
  if (!short_end_.empty()) out.push_back(short_end_);
  return out;
}

}  // namespace tumble::replay

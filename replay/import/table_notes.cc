#include "replay/import/table_notes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

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
  const auto add = [&out](const std::string& first, std::uint64_t count, const char* one) {
    if (count == 0) return;
    out.push_back(first);
    if (count > 1) out.back() += ", and " + count_text(count - 1, one) + " more likewise";
  };
  add(first_back_, back_, "return");
  add(first_renamed_, renamed_, "row");
  add(first_called_twice_, called_twice_, "body");
  add(first_same_name_, same_names_, "body");
  return out;
}

void TableNotes::renamed(const std::string& place, sim::BodyId body, std::string_view kept, std::string_view now) {
  if (++renamed_ > 1) return;
  first_renamed_ = place + "body " + std::to_string(body) + " is called " + in_quotes(now) +
                   ", and the log keeps what its first row has, " + (kept.empty() ? "no name" : in_quotes(kept));
}

void TableNotes::called_twice(const std::string& place, sim::BodyId body, std::string_view id, std::string_view name) {
  if (++called_twice_ > 1) return;
  first_called_twice_ = place + "the body with the id " + in_quotes(id) + " has the name " + in_quotes(name) +
                        " too; the log keeps that name and the number " + std::to_string(body) + " for the id";
}

void TableNotes::named(const std::string& place, sim::BodyId body, const std::string& name) {
  const auto [known, is_new] = names_.try_emplace(name, body);
  if (is_new || ++same_names_ > 1) return;
  first_same_name_ = place + "bodies " + std::to_string(known->second) + " and " + std::to_string(body) +
                     " are both called " + in_quotes(name) + "; commands that look for one body want its number";
}

void TableNotes::came_back(const std::string& place, sim::BodyId body, std::uint64_t step) {
  if (++back_ > 1) return;
  first_back_ = place + "body " + std::to_string(body) + " comes back in step " + std::to_string(step) +
                " after steps without it; the log removes it and throws it again";
}

void ContactCheck::add(std::uint64_t step, const std::vector<EngineContact>& contacts) {
  constexpr double kLengthOffMax = 1e-2;
  for (const EngineContact& contact : contacts) {
    const std::string place = "step " + std::to_string(step) + ", contact of " + std::to_string(contact.a) + " and " +
                              (contact.b == 0 ? "the world" : std::to_string(contact.b)) + ": ";
    const double where = contact.position.sum(), normal = sim::length(contact.normal);
    const std::array<std::pair<const char*, double>, 4> numbers = {
        {{"depth", contact.depth}, {"impulse", contact.impulse}, {"position", where}, {"normal", normal}}};
    const auto* const lost = std::ranges::find_if(numbers, [](const auto& one) { return !std::isfinite(one.second); });
    if (lost != numbers.end()) {
      if (++not_finite_ == 1) first_not_finite_ = place + lost->first + " is " + exact(lost->second);
    } else if (std::fabs(normal - 1) > kLengthOffMax) {
      if (++no_direction_ > 1) continue;
      first_no_direction_ = place + "the normal has a length of " + significant(normal, 3) + ", wanted 1";
    }
  }
}

std::string ContactCheck::text_of(const std::string& first, std::uint64_t count) {
  return count > 1 ? first + ", and " + std::to_string(count - 1) + " more likewise" : first;
}

}  // namespace tumble::replay

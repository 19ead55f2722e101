#include "replay/import/table_notes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "src/base/text.h"

namespace tumble::replay {

std::string FirstOf::text(const char* one) const {
  if (count_ < 2) return text_;
  return text_ + ", and " + (*one == 0 ? std::to_string(count_ - 1) : count_text(count_ - 1, one)) + " more likewise";
}

void TableNotes::lost(const std::string& place, const NotFinite& found) {
  if (lost_.empty()) {
    first_lost_ = found;
    place_of_lost_ = place;
  }
  lost_.insert(found.body);
  first_lost_.bodies = lost_.size();
}

void TableNotes::rough_rotation(const std::string& place, sim::BodyId body, std::uint64_t step, double length) {
  rough_.add([&] {
    return place + "body " + std::to_string(body) + ", step " + std::to_string(step) +
           ": the orientation is a quaternion of length " + significant(length, 9) + ", wanted 1";
  });
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
  const auto add = [&out](std::string text) {
    if (!text.empty()) out.push_back(std::move(text));
  };
  add(rough_.text("row"));
  add(short_end_);
  add(back_.text("return"));
  add(renamed_.text("row"));
  add(called_twice_.text("body"));
  add(same_name_.text("body"));
  return out;
}

void TableNotes::renamed(const std::string& place, sim::BodyId body, std::string_view kept, std::string_view now) {
  renamed_.add([&] {
    return place + "body " + std::to_string(body) + " is called " + in_quotes(now) +
           ", and the log keeps what its first row has, " + (kept.empty() ? "no name" : in_quotes(kept));
  });
}

void TableNotes::called_twice(const std::string& place, sim::BodyId body, std::string_view id, std::string_view name) {
  called_twice_.add([&] {
    return place + "the body with the id " + in_quotes(id) + " has the name " + in_quotes(name) +
           " too; the log keeps that name and the number " + std::to_string(body) + " for the id";
  });
}

void TableNotes::named(const std::string& place, sim::BodyId body, const std::string& name) {
  const sim::BodyId first = names_.try_emplace(name, body).first->second;
  if (first == body) return;
  same_name_.add([&] {
    return place + "bodies " + std::to_string(first) + " and " + std::to_string(body) + " are both called " +
           in_quotes(name) + "; commands that look for one body want its number";
  });
}

void TableNotes::came_back(const std::string& place, sim::BodyId body, std::uint64_t step) {
  back_.add([&] {
    return place + "body " + std::to_string(body) + " comes back in step " + std::to_string(step) +
           " after steps without it; the log removes it and throws it again";
  });
}

namespace {

std::string place_of(std::uint64_t step, sim::BodyId a, sim::BodyId b) {
  return "step " + std::to_string(step) + ", contact of " + std::to_string(a) + " and " +
         (b == 0 ? "the ground" : std::to_string(b)) + ": ";
}

}  // namespace

void ContactCheck::without_points(std::uint64_t step, sim::BodyId a, sim::BodyId b) {
  pointless_.add([&] {
    return place_of(step, a, b) +
           "has no points, so the log keeps it in a channel, told.contacts or told.ground_contacts";
  });
}

void ContactCheck::add(std::uint64_t step, const std::vector<EngineContact>& contacts) {
  constexpr double kLengthOffMax = 1e-2;
  for (const EngineContact& contact : contacts) {
    const std::string place = place_of(step, contact.a, contact.b);
    const double where = contact.position.sum(), normal = sim::length(contact.normal);
    const std::array<std::pair<const char*, double>, 4> numbers = {
        {{"depth", contact.depth}, {"impulse", contact.impulse}, {"position", where}, {"normal", normal}}};
    const auto* const lost = std::ranges::find_if(numbers, [](const auto& one) { return !std::isfinite(one.second); });
    if (lost != numbers.end()) {
      not_finite_.add([&] { return place + lost->first + " is " + exact(lost->second); });
    } else if (std::fabs(normal - 1) > kLengthOffMax) {
      no_direction_.add([&] { return place + "the normal has a length of " + significant(normal, 3) + ", wanted 1"; });
    }
  }
}

}  // namespace tumble::replay

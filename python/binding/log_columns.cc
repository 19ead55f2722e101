// A column over many steps as one array.
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "python/binding/arrays.h"
#include "python/binding/log_file.h"
#include "src/base/text.h"

namespace tumble::python {
namespace {

/// The steps of an array, in its order.
struct Steps {
  std::uint64_t first;
  std::uint64_t count;
  std::int64_t stride;
  [[nodiscard]] std::uint64_t at(std::uint64_t row) const {
    return static_cast<std::uint64_t>(static_cast<std::int64_t>(first) + static_cast<std::int64_t>(row) * stride);
  }
};

/// The columns of doubles that make one array: x, y, z.
using Parts = std::vector<const std::vector<double>*>;

Parts parts_of(const replay::BodyStates& s, const std::string& column) {
  if (column == "position") return {&s.position.x, &s.position.y, &s.position.z};
  if (column == "orientation") return {&s.orientation.w, &s.orientation.x, &s.orientation.y, &s.orientation.z};
  if (column == "velocity") return {&s.velocity.x, &s.velocity.y, &s.velocity.z};
  return {&s.spin.x, &s.spin.y, &s.spin.z};
}

Error other_bodies(const LogFile& log, std::uint64_t step, std::uint64_t first) {
  return bad_input(log.path() + ": step " + std::to_string(step) + " has other bodies than step " +
                   std::to_string(first) + "; name the bodies, as in log.position.of(ids)[...], or read step by step");
}

/// Fills the array step by step.
class Filler {
 public:
  Filler(const LogFile& log, std::string column, Steps steps, std::optional<std::vector<sim::BodyId>> ids)
      : log_(log), column_(std::move(column)), steps_(steps), ids_(std::move(ids)), given_(ids_.has_value()) {
    width_ = column_ == "orientation" ? 4 : 3;
  }

  /// Allocates at the first step, whose bodies say how many rows there are.
  Status add(std::uint64_t row, const replay::BodyStates& states) {
    if (!ids_) ids_ = states.id;
    if (row == 0) values_.resize(steps_.count * ids_->size() * width_);
    if (!given_ && states.id != *ids_) return other_bodies(log_, steps_.at(row), steps_.at(0));
    const Parts parts = parts_of(states, column_);
    double* out = values_.data() + row * ids_->size() * width_;
    for (std::size_t i = 0; i < ids_->size(); ++i) {
      const std::size_t at = given_ ? place_of((*ids_)[i], states) : i;
      for (const std::vector<double>* part : parts) {
        *out++ = at < states.size() ? (*part)[at] : std::numeric_limits<double>::quiet_NaN();
      }
    }
    return {};
  }

  py::array finish() {
    const auto n = static_cast<py::ssize_t>(ids_ ? ids_->size() : 0);
    return array_of(std::move(values_), {static_cast<py::ssize_t>(steps_.count), n, static_cast<py::ssize_t>(width_)});
  }

 private:
  static std::size_t place_of(sim::BodyId id, const replay::BodyStates& states) {
    const auto found = std::ranges::lower_bound(states.id, id);
    return found != states.id.end() && *found == id ? static_cast<std::size_t>(found - states.id.begin())
                                                    : states.size();
  }

  const LogFile& log_;
  std::string column_;
  Steps steps_;
  std::optional<std::vector<sim::BodyId>> ids_;
  bool given_;
  std::size_t width_ = 3;
  std::vector<double> values_;
};

}  // namespace

py::array read_column(LogFile& log, const std::string& column, std::uint64_t first, std::uint64_t count,
                      std::int64_t stride, const py::object& ids) {
  std::optional<std::vector<sim::BodyId>> wanted;
  if (!ids.is_none()) wanted = ids_of(ids, "ids");
  const Steps steps = {first, count, stride};
  Filler filler(log, column, steps, std::move(wanted));
  bool interrupted = false;
  check(log.read([&](replay::LogReader& /*reader*/) -> Status {
    Interruption interruption;
    for (std::uint64_t row = 0; row < count; ++row) {
      const Result<const replay::StepRecord*> record = log.source().read(steps.at(row));
      if (!record.ok()) return record.error();
      if (Status ok = filler.add(row, (*record)->states); !ok.ok()) return ok;
      interrupted = interruption.came();
      if (interrupted) break;
    }
    return {};
  }));
  if (interrupted) raise_interruption();
  return filler.finish();
}

py::dict channel_rows(LogFile& log, std::size_t channel, std::uint64_t first, std::uint64_t count,
                      std::int64_t stride) {
  const Steps steps = {first, count, stride};
  std::vector<std::uint64_t> step, a, b;
  replay::ChannelValues all;
  bool interrupted = false;
  check(log.read([&](replay::LogReader& reader) -> Status {
    Interruption interruption;
    for (std::uint64_t row = 0; row < count; ++row) {
      const std::uint64_t k = steps.at(row);
      const Result<const replay::StepRecord*> record = reader.read_step(k);
      if (!record.ok()) return record.error();
      const replay::ChannelValues& values = (*record)->extras.values(channel);
      for (const replay::ChannelKey& key : values.keys) {
        step.push_back(k);
        a.push_back(key.a);
        b.push_back(key.b);
      }
      all.bits.insert(all.bits.end(), values.bits.begin(), values.bits.end());
      all.bytes.insert(all.bytes.end(), values.bytes.begin(), values.bytes.end());
      interrupted = interruption.came();
      if (interrupted) break;
    }
    return {};
  }));
  if (interrupted) raise_interruption();
  py::dict rows;
  rows["step"] = array_of(std::move(step));
  rows["a"] = array_of(std::move(a));
  rows["b"] = array_of(std::move(b));
  rows["bits"] = array_of(std::move(all.bits));
  py::list bytes;
  for (const std::string& value : all.bytes) bytes.append(py::bytes(value));
  rows["bytes"] = bytes;
  return rows;
}

}  // namespace tumble::python

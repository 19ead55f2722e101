#include "replay/import/csv/csv_clock.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <string>
#include <utility>

#include "src/base/text.h"
#include "tumble/sim/limits.h"

namespace tumble::replay {
namespace {

constexpr double kFloatPlace = 0x1p-23;  // of a time that a program adds up in float
constexpr double kRoundedOff = 0.99;     // of the last place: two rounded times stay nearer than one whole place
constexpr double kRoughDt = 1e-4;        // of a dt that was written with five digits
constexpr int kShownDigits = 9;
constexpr int kExponentMax = 400;  // beyond that of every double
constexpr double kTen = 10;

std::string text_of(double value) { return number_text(value); }

}  // namespace

Status CsvClock::read_row(const CsvReader& table) {
  if (time_column_ != kNone) {
    const Result<double> time = table.number(time_column_);
    if (!time.ok()) return time.error();
    if (!std::isfinite(*time)) {
      return table.at(time_column_, "time: " + found_wanted(exact(*time), "a finite number of seconds"));
    }
    row_key_ = row_time_ = *time;
  }
  if (step_column_ == kNone) return {};
  const Result<std::uint64_t> step = table.whole(step_column_);
  if (!step.ok()) return step.error();
  if (*step > sim::kStepsMax) {
    return table.at(step_column_, "step: found a number beyond " + std::to_string(sim::kStepsMax));
  }
  row_key_ = static_cast<double>(*step);
  if (in_step() && row_time_ != time_) {
    return table.at(time_column_, "time: " + found_wanted(text_of(row_time_), text_of(time_)) + " as in line " +
                                      std::to_string(line_) + ", where this step begins");
  }
  return {};
}

Result<double> CsvClock::begin_step(const CsvReader& table) {
  const double before = std::exchange(key_, row_key_);
  const double time_before = std::exchange(time_, row_time_);
  line_ = table.line();
  if (time_column_ != kNone) note_digits(table.cell(time_column_));
  if (steps_++ == 0) {
    start_ = time_;
    return 0.0;
  }
  const bool by_time = step_column_ == kNone;
  const auto wrong = [&](const std::string& wanted) {
    return table.at(by_time ? time_column_ : step_column_, std::string(by_time ? "time" : "step") + ": found " +
                                                               text_of(key_) + " after " + text_of(before) +
                                                               ", wanted " + wanted);
  };
  const double apart = key_ - before;
  if (!(apart > 0)) return wrong("a later one: steps in order, and all rows of a step together");
  if (by_time) stride_ = 1;
  if (!by_time && steps_ == 2) stride_ = apart;
  if (!by_time && apart != stride_) {
    return wrong(text_of(before + stride_) +
                 ": steps are equally far apart; one that is missing is a longer step with a " +
                 "column time in place of step");
  }
  if (!dt_ && dt_column_ != kNone) return table.number(dt_column_);
  if (!dt_) return time_ - time_before;
  const double dt = *dt_ * stride_;
  if (time_column_ == kNone) return dt;
  if (Status ok = check_time(table, time_before, dt); !ok.ok()) return ok.error();
  return dt;
}

/// Compares the time with dt, since the step before and since the start: digits that were rounded off explain a
/// difference of one step, but no drift.
Status CsvClock::check_time(const CsvReader& table, double time_before, double dt) const {
  const auto near = [&](double since, double steps) {
    const double magnitude = std::max(std::fabs(since), std::fabs(time_));
    const double allowed = kRoundedOff * last_place() + steps * (kFloatPlace * magnitude + kRoughDt * dt);
    return std::fabs(time_ - since - steps * dt) <= allowed;
  };
  const auto steps = static_cast<double>(steps_ - 1);
  const bool on_time = time_ >= time_before && near(time_before, 1);
  if (on_time && near(start_, steps)) return {};
  const std::string found = on_time ? text_of(time_) + " in step " + text_of(steps) + " after " + text_of(start_)
                                    : text_of(time_) + " after " + text_of(time_before);
  const double wanted = on_time ? start_ + steps * dt : time_before + dt;
  return table.at(time_column_, "time: " + found_wanted(found, significant(wanted, kShownDigits)) + ", because dt is " +
                                    exact(*dt_) +
                                    " s; mend one of them, or give no dt: the differences of time are the dt then");
}

void CsvClock::note_digits(std::string_view cell) {
  const std::size_t end = std::min(cell.find_first_of("eE"), cell.size());
  int exponent = 0;
  if (end < cell.size()) std::from_chars(cell.data() + end + 1, cell.data() + cell.size(), exponent);
  const std::string_view number = cell.substr(0, end);
  const std::size_t point = std::min(number.find('.'), number.size());
  const std::size_t behind = number.size() - std::min(point + 1, number.size());
  const std::size_t first = std::min(number.find_first_of("123456789"), number.size());
  const std::size_t digits = number.size() - first - (first < point && point < number.size() ? 1U : 0U);
  const auto bounded = [](std::size_t count) { return static_cast<int>(std::min<std::size_t>(count, kExponentMax)); };
  decimals_ = std::max(decimals_, bounded(behind) - std::clamp(exponent, -kExponentMax, kExponentMax));
  digits_ = std::max(digits_, bounded(digits));
}

/// The value of one in the last digit of a time, s. 0 for whole seconds, which count as exact.
double CsvClock::last_place() const {
  if (decimals_ <= 0) return 0;
  const double by_point = std::pow(kTen, -decimals_);
  if (time_ == 0) return by_point;
  return std::max(by_point, std::pow(kTen, std::floor(std::log10(std::fabs(time_))) + 1 - digits_));
}

}  // namespace tumble::replay

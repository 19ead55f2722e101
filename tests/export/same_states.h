#pragma once

#include <gtest/gtest.h>

#include <bit>
#include <cstdint>
#include <string>

#include "tests/support/program.h"
#include "tumble/replay/log_reader.h"

namespace tumble::test {

/// Expects the states, lengths of steps, masses and sizes of two logs to be equal to the bit; and every value of every
/// channel.
inline void expect_same_states(const std::string& ours, const std::string& theirs, const std::string& about) {
  Result<replay::LogReader> a = replay::LogReader::open(ours);
  Result<replay::LogReader> b = replay::LogReader::open(theirs);
  ASSERT_TRUE(a.ok() && b.ok()) << about;
  ASSERT_EQ(a->step_count(), b->step_count()) << about;
  const replay::Declared &in_a = a->header().declared, &in_b = b->header().declared;
  EXPECT_EQ(in_a.channels, in_b.channels) << about;
  EXPECT_EQ(in_a.velocity_derived, in_b.velocity_derived) << about;
  EXPECT_EQ(in_a.spin_derived, in_b.spin_derived) << about;
  const auto &boxes_a = a->header().scene.boxes, &boxes_b = b->header().scene.boxes;
  ASSERT_EQ(boxes_a.size(), boxes_b.size()) << about;
  for (std::size_t i = 0; i < boxes_a.size(); ++i) {
    EXPECT_EQ(boxes_a[i].size, boxes_b[i].size) << about;
    EXPECT_EQ(boxes_a[i].mass, boxes_b[i].mass) << about;
    EXPECT_EQ(boxes_a[i].material, boxes_b[i].material) << about;
    EXPECT_EQ(boxes_a[i].is_static, boxes_b[i].is_static) << about;
  }
  for (std::uint64_t k = 0; k <= a->step_count(); ++k) {
    const Result<const replay::StepRecord*> x = a->read_step(a->first_state() + k);
    const Result<const replay::StepRecord*> y = b->read_step(b->first_state() + k);
    ASSERT_TRUE(x.ok() && y.ok()) << about;
    ASSERT_TRUE(same_bits((*x)->states, (*y)->states)) << about << ", step " << k;
    for (std::size_t i = 0; i < in_a.channels.size(); ++i) {
      ASSERT_EQ((*x)->extras.values(i), (*y)->extras.values(i)) << about << ", " << in_a.channels[i].name;
    }
    if (k == 0) continue;
    ASSERT_EQ(std::bit_cast<std::uint64_t>((*x)->dt), std::bit_cast<std::uint64_t>((*y)->dt)) << about << ' ' << k;
  }
}

/// Exports `log` to a file of this ending, imports that, and compares.
inline void expect_round_trip(const Workshop& shop, const std::string& log, const std::string& ending) {
  const std::string file = log + ending, back = log + ending + ".back.tumble";
  const Outcome written = shop.run({"export", log, "-o", file});
  ASSERT_EQ(written.exit, 0) << log << ending << ": " << written.err;
  const Outcome read = shop.run({"import", file, "-o", back});
  ASSERT_EQ(read.exit, 0) << log << ending << ": " << read.err;
  expect_same_states(shop.path(log), shop.path(back), log + ending);
}

}  // namespace tumble::test

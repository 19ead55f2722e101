// What the session page is sent: the ways of bodies, the timeline of a long session.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>
#include <vector>

#include "replay/format/not_finite.h"
#include "tools/view/body_ways.h"
#include "tools/view/thinned_rows.h"
#include "tools/view/view_json.h"

namespace tumble::tools {
namespace {

using replay::TimelineRow;

TEST(BodyWays, EveryPlaceStaysWhenSomeStepsAreLeftOut) {
  BodyWays ways;
  replay::BodyStates states;
  states.id = {7};
  states.frozen = {0};
  for (std::vector<double>* column : replay::columns_of(states)) column->assign(1, 0);
  states.orientation.w[0] = 1;
  for (std::uint64_t step = 0; step < 1000; ++step) {
    states.position.x[0] = static_cast<double>(step);
    ways.add(step, states);
  }
  const BodyWays::Way way = ways.way(7);
  ASSERT_GT(way.step.size(), 100U);
  ASSERT_EQ(way.at.size(), 3 * way.step.size());
  for (std::size_t i = 0; i < way.step.size(); ++i) {
    EXPECT_EQ(way.at[3 * i], static_cast<float>(way.step[i])) << "place " << i;
  }
}

TimelineRow row_of(std::uint64_t step) {
  TimelineRow row;
  row.step = step;
  row.read = true;
  row.potential = 10;
  return row;
}

TEST(ThinnedRows, WhatStandsOutInAStepIsInTheRowOfItsRun) {
  std::vector<TimelineRow> rows = {row_of(0), row_of(1), row_of(2), row_of(3)};
  for (TimelineRow& row : rows) row.channels = {replay::kNotANumber, 1};
  rows[1].channels = {-5, 9};
  rows[1].kinetic = 30;
  rows[1].potential = 4;
  rows[1].frozen = 2;
  rows[1].bodies = 3;
  rows[1].contacts = 8;
  rows[1].not_finite = 1;
  rows[1].speed_max = 6;
  rows[1].speed_body = 12;
  rows[1].height_max = 5;
  rows[1].overlap = 0.25;
  rows[1].inputs = 2;
  rows[0].inputs = 1;
  const std::vector<TimelineRow> thin = thinned_rows(rows, 2);
  ASSERT_EQ(thin.size(), 2U);
  EXPECT_EQ(thin[0].step, 0U);
  EXPECT_EQ(thin[0].channels, (std::vector<double>{-5, 9}));
  EXPECT_EQ(thin[0].kinetic, 30);
  EXPECT_EQ(thin[0].potential, 4);  // of the same state
  EXPECT_EQ(thin[0].frozen, 2U);
  EXPECT_EQ(thin[0].bodies, 3U);
  EXPECT_EQ(thin[0].contacts, 8U);
  EXPECT_EQ(thin[0].not_finite, 1U);
  EXPECT_EQ(thin[0].speed_max, 6);
  EXPECT_EQ(thin[0].speed_body, 12U);
  EXPECT_EQ(thin[0].height_max, 5);
  EXPECT_EQ(thin[0].overlap, 0.25);
  EXPECT_EQ(thin[0].inputs, 3);
  EXPECT_EQ(thin[1].step, 2U);
  EXPECT_TRUE(std::isnan(thin[1].channels[0]));
}

TEST(ThinnedRows, ANumberThatIsNoneStays) {
  std::vector<TimelineRow> rows = {row_of(0), row_of(1), row_of(2)};
  rows[1].kinetic = rows[1].overlap = replay::kNotANumber;
  rows[2].kinetic = 5;
  const std::vector<TimelineRow> thin = thinned_rows(rows, 3);
  EXPECT_TRUE(std::isnan(thin[0].kinetic));
  EXPECT_TRUE(std::isnan(thin[0].overlap));
}

TEST(ThinnedRows, AStepThatWasNotReadOrABrokenBoundStays) {
  std::vector<TimelineRow> rows = {row_of(0), row_of(1), row_of(2), row_of(3), row_of(4)};
  rows[1].read = false;
  for (const std::size_t k : {2U, 3U, 4U}) rows[k].bounds = {{1.0, k != 3, true}};
  const std::vector<TimelineRow> thin = thinned_rows(rows, 2);
  ASSERT_EQ(thin.size(), 3U);
  EXPECT_FALSE(thin[0].read);
  EXPECT_TRUE(thin[1].read);
  EXPECT_FALSE(thin[1].bounds.at(0).holds);
  EXPECT_TRUE(thin[2].bounds.at(0).holds);
}

TEST(ViewJson, AnInfiniteValueOfABoundIsTold) {
  TimelineRow row = row_of(0);
  const double infinity = std::numeric_limits<double>::infinity();
  row.bounds = {{infinity, false, true}, {std::nullopt, false, true}, {0.5, true, true}};
  const Json bounds = timeline_json(std::vector{row})["bounds"];
  EXPECT_EQ(bounds[0]["value"][0], "Infinity");
  EXPECT_TRUE(bounds[1]["value"][0].is_null());
  EXPECT_EQ(bounds[2]["value"][0], 0.5);
}

}  // namespace
}  // namespace tumble::tools

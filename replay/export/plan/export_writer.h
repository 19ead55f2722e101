#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "replay/export/plan/export_plan.h"
#include "tumble/replay/step_record.h"
#include "tumble/sim/result.h"

namespace tumble::replay {

/// One exported step.
struct ExportStep {
  static constexpr std::uint32_t kAbsent = ~std::uint32_t{0};
  std::size_t index = 0;  ///< into ExportPlan::steps
  double time = 0;        ///< s, since state 0
  const StepRecord& record;
  std::span<const std::uint32_t> rows;  ///< for each body of the plan its row in record.states, or kAbsent
};

/// Writes one format, step by step. Each method is called in this order: begin once, look for every step where the
/// writer asks for it, add for every step of the plan, finish once. Memory does not grow with the number of steps. The
/// plan outlives the writer.
class ExportWriter {
 public:
  ExportWriter() = default;
  ExportWriter(const ExportWriter&) = delete;
  ExportWriter& operator=(const ExportWriter&) = delete;
  virtual ~ExportWriter() = default;

  /// Errors: kBadInput: a session that the format cannot hold; kCannotFinish: the disk.
  virtual Status begin(const ExportPlan& plan) = 0;
  /// Whether look() is to be called for every step before the first add(): for sizes that the plan does not have.
  [[nodiscard]] virtual bool looks_first() const { return false; }
  virtual void look(const ExportStep& /*step*/) {}
  /// Errors. kBadInput: a value that the format cannot hold, with body and step; kCannotFinish: the disk.
  virtual Status add(const ExportStep& step) = 0;
  virtual Status finish() = 0;

  /// The parts of the log that the format has no place for, each with its reason; complete after finish().
  [[nodiscard]] const std::vector<std::string>& left_out() const { return left_out_; }

 protected:
  std::vector<std::string> left_out_;
};

}  // namespace tumble::replay

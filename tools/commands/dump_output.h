#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <utility>

#include "tools/output/extras_output.h"
#include "tumble/replay/step_record.h"

namespace tumble::tools {

/// Prints the rows of a dump in one of three forms, step by step.
class DumpOutput {
 public:
  explicit DumpOutput(Told told) : told_(std::move(told)) {}
  virtual ~DumpOutput() = default;
  DumpOutput(const DumpOutput&) = delete;
  DumpOutput& operator=(const DumpOutput&) = delete;
  virtual void begin_step(const replay::StepRecord& /*step*/) {}
  virtual void add(const replay::StepRecord& step, std::size_t row) = 0;
  virtual void end_step(const replay::StepRecord& /*step*/, std::uint64_t /*body*/) {}
  /// After the last step. False: all steps have to come again.
  virtual bool end() = 0;

 protected:
  Told told_;
};

/// head: of the table. with_dt: the steps differ in length, which the last column then tells.
std::unique_ptr<DumpOutput> csv_dump(Told told, const std::string& head, bool with_dt);
/// One object, or a list of them; a line a body, so that text tools can look at it too.
std::unique_ptr<DumpOutput> json_dump(Told told, bool is_list);
/// For people: rounded, aligned, in bounded memory.
std::unique_ptr<DumpOutput> text_dump(Told told);

}  // namespace tumble::tools

#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "tumble/replay/log_reader.h"
#include "tumble/replay/progress.h"
#include "tumble/replay/shape.h"
#include "tumble/sim/result.h"
#include "tumble/sim/scene.h"

/// The extent of an export, known before the first state is read: steps, times, bodies. A writer that streams needs the
/// sizes of its arrays first.
namespace tumble::replay {

/// The steps and bodies that a user asked for.
struct ExportChoice {
  std::uint64_t first = 0, last = 0;  ///< steps of the log, both included
  std::uint64_t every = 1;            ///< first, first + every, …
  /// Whether a body is exported; empty: all are.
  std::function<bool(const sim::BoxDef& box, const std::string& name)> holds = {};
};

/// A run of exported steps, by index into ExportPlan::steps.
struct ExportRun {
  std::size_t begin = 0, end = 0;  ///< end: behind the last
};

/// A body that is there in at least one exported step.
struct ExportBody {
  sim::BoxDef box;               ///< as the scene or the first throw defines it
  std::string name;              ///< empty: none
  const Shape* shape = nullptr;  ///< null: the box of its size; lives as long as the log's reader
  std::vector<ExportRun> runs;   ///< the steps with the body, ascending, apart from one another
  [[nodiscard]] bool at(std::size_t index) const;
};

struct ExportPlan {
  LogHeader header;
  std::string log_name;  ///< for messages
  std::uint64_t every = 1;
  std::vector<std::uint64_t> steps;
  std::vector<double> times;       ///< s, since the first state of the log
  std::vector<double> dts;         ///< s, since the exported state before; the first: 0
  std::optional<double> dt;        ///< s, of one step of the log where all have one
  std::vector<ExportBody> bodies;  ///< ascending id
  bool chosen = false;             ///< the log has bodies that are not exported
  /// Bodies that came in lost steps of a recovered log: their sizes are not known, and they are not exported.
  std::vector<sim::BodyId> undefined;  ///< ascending
  std::vector<std::string> left_out;   ///< for messages, what the log itself lacks

  [[nodiscard]] std::uint64_t body_steps() const;  ///< states to be written
  [[nodiscard]] bool all_present() const;          ///< every body is there in every step
  [[nodiscard]] bool named() const;                ///< some body has a name
  /// For messages: "body 7 (wheel) at step 12".
  [[nodiscard]] std::string place(std::size_t body, std::uint64_t step) const;
};

/// Reads the inputs of all steps up to the last one, which is far cheaper than reading their states; of a recovered log
/// also the state behind lost steps. Errors
/// (kBadInput): steps that a recovered log lacks, no body left by the choice; kDamaged: a step that cannot be read;
/// kCannotFinish where `progress` stops.
Result<ExportPlan> plan_export(LogReader& log, const ExportChoice& choice, const Progress& progress = {});

/// An error of a step that cannot be read; of a damaged log with the advice of what can be exported.
Error with_advice(const Error& error, const LogReader& log, std::uint64_t step);

}  // namespace tumble::replay

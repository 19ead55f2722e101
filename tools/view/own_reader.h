#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <utility>

#include "tumble/replay/log_reader.h"
#include "tumble/sim/result.h"

namespace tumble::tools {

/// A reader of a served log for one kind of question, and what answers from it, so that no other kind waits for a
/// question that takes long. Opened with the first question, and again where a log that is being recorded was asked for
/// more.
template <class Source>
class OwnReader {
 public:
  /// open: as ServedLog opens its log.
  explicit OwnReader(std::function<Result<replay::LogReader>()> open) : open_(std::move(open)) {}

  /// Makes the two ready for questions about step k. Errors: open's.
  Status prepare(std::uint64_t k) {
    if (log_ && (k <= log_->last_step() || log_->condition().finished)) return {};
    source_.reset();
    log_.reset();
    Result<replay::LogReader> log = open_();
    if (!log.ok()) return log.error();
    log_.emplace(*std::move(log));
    source_.emplace(*log_);
    return {};
  }

  /// Both only after prepare().
  replay::LogReader& log() { return *log_; }
  Source& source() { return *source_; }

 private:
  std::function<Result<replay::LogReader>()> open_;
  std::optional<replay::LogReader> log_;
  std::optional<Source> source_;  // reads from log_
};

}  // namespace tumble::tools

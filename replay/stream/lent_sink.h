#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <system_error>
#include <utility>

#include "tumble/replay/byte_io.h"

namespace tumble::replay {

/// A sink that outlives the log that is written to it, so that the log can be written again.
class LentSink : public ByteSink {
 public:
  explicit LentSink(std::shared_ptr<ByteSink> sink) : sink_(std::move(sink)) {}
  Result<std::size_t> write_some(std::span<const std::byte> bytes) override { return sink_->write_some(bytes); }
  void truncate(std::uint64_t size) override { sink_->truncate(size); }
  Status sync() override { return sink_->sync(); }
  [[nodiscard]] std::string name() const override { return sink_->name(); }
  [[nodiscard]] bool whole_or_nothing() const override { return sink_->whole_or_nothing(); }

 private:
  std::shared_ptr<ByteSink> sink_;
};

/// Lends `kept`, which is made at the first call. Errors: those of `make`.
inline Result<std::unique_ptr<ByteSink>> lend_sink(std::shared_ptr<ByteSink>& kept,
                                                   const std::function<Result<std::unique_ptr<ByteSink>>()>& make) {
  if (kept == nullptr) {
    Result<std::unique_ptr<ByteSink>> sink = make();
    if (!sink.ok()) return sink.error();
    kept = *std::move(sink);
  }
  return std::unique_ptr<ByteSink>(std::make_unique<LentSink>(kept));
}

/// A file or memory can; a device or a pipe keeps what was written.
inline bool can_write_again(const ByteSink& sink) {
  std::error_code error;
  const auto kind = std::filesystem::status(sink.name(), error).type();
  return kind == std::filesystem::file_type::regular || kind == std::filesystem::file_type::not_found;
}

}  // namespace tumble::replay

#pragma once

#include <algorithm>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "replay/stream/import_stream.h"
#include "tests/recorder/recorded.h"
#include "tests/support/log_memory.h"
#include "tumble/replay/log_reader.h"

namespace tumble::test {

/// A stream turned into a log in memory.
struct Imported {
  replay::StreamImport import;
  replay::LogReader log;
};

inline Result<Imported> import_bytes(StreamBytes bytes) {
  const Result<replay::StreamReader> stream = open_stream(std::move(bytes));
  if (!stream.ok()) return stream.error();
  const auto disk = std::make_shared<replay::Disk>();
  Result<replay::StreamImport> done = import_stream(*stream, [&]() -> Result<std::unique_ptr<replay::ByteSink>> {
    return std::unique_ptr<replay::ByteSink>(std::make_unique<replay::MemorySink>(disk));
  });
  if (!done.ok()) return done.error();
  Result<replay::LogReader> log = replay::open_memory(disk->bytes);
  if (!log.ok()) return log.error();
  return Imported{*std::move(done), *std::move(log)};
}

inline bool mentions(const std::vector<std::string>& texts, const std::string& part) {
  return std::ranges::any_of(texts, [&](const std::string& text) { return text.find(part) != std::string::npos; });
}

}  // namespace tumble::test

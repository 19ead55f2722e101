#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "tumble/replay/byte_io.h"
#include "tumble/replay/log_reader.h"
#include "tumble/replay/recorder.h"
#include "tumble/sim/scene.h"

/// Logs in memory, with the faults that a file can have.
namespace tumble::replay {

using Bytes = std::vector<std::byte>;

/// What a MemorySink may do wrong, and what came of it; shared, so that a test sees it after the writer is gone.
struct Disk {
  Bytes bytes;
  std::uint64_t capacity = ~std::uint64_t{0};  ///< bytes; beyond, writing fails like a full disk
  std::size_t write_max = ~std::size_t{0};     ///< bytes taken by one write
  bool sync_fails = false;
};

class MemorySink : public ByteSink {
 public:
  explicit MemorySink(std::shared_ptr<Disk> disk) : disk_(std::move(disk)) {}
  Result<std::size_t> write_some(std::span<const std::byte> bytes) override;
  void truncate(std::uint64_t size) override { disk_->bytes.resize(size); }
  Status sync() override;
  [[nodiscard]] std::string name() const override { return "memory.tumble"; }

 private:
  std::shared_ptr<Disk> disk_;
};

class MemorySource : public ByteSource {
 public:
  explicit MemorySource(Bytes bytes) : bytes_(std::move(bytes)) {}
  [[nodiscard]] std::uint64_t size() const override { return bytes_.size(); }
  Status read(std::uint64_t offset, std::span<std::byte> bytes) const override;
  [[nodiscard]] std::string name() const override { return "memory.tumble"; }

 private:
  Bytes bytes_;
};

/// Three boxes that fall on each other and on the ground, the lowest one frozen, dt 1/60.
sim::SceneDef small_scene(std::uint64_t steps = 20, sim::Method method = sim::Method::kThesis);

/// The same with an input of every kind, some of them in the middle of a chunk.
sim::SceneDef scene_with_inputs(std::uint64_t steps = 40, sim::Method method = sim::Method::kThesis);

inline constexpr std::array<sim::Method, 2> kMethods = {sim::Method::kThesis, sim::Method::kLayered};

/// Records scene.steps steps; a chunk is closed after every `flush_every` steps.
Bytes record_to_memory(const sim::SceneDef& scene, const RecordOptions& options = {}, std::uint64_t flush_every = 1000);

Result<LogReader> open_memory(Bytes bytes);

/// What a session without a log looks like: states 0 … scene.steps.
std::vector<BodyStates> simulate(const sim::SceneDef& scene);

}  // namespace tumble::replay

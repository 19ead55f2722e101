#include <algorithm>
#include <cstring>
#include <memory>
#include <random>

#include "replay/log/byte_memory.h"
#include "replay/log/verify.h"
#include "replay/recover/recover.h"
#include "tests/trial/trial.h"
#include "tumble/replay/log_reader.h"

namespace tumble::trial {
namespace {

using replay::ChunkPlace;
using replay::LogReader;

constexpr std::uint64_t kRecoverEvery = 100;
constexpr std::size_t kFailuresKept = 10;

/// One harm to a file: a byte changed, or its end gone, with or without zeros in its place.
struct Harm {
  std::uint64_t byte = 0;
  std::byte flip{0};  // 0: a cut before `byte`
  std::uint64_t zeros = 0;
  [[nodiscard]] bool is_cut() const { return flip == std::byte{0}; }
};

/// A file in memory with a harm, without a copy.
class HarmedSource : public replay::ByteSource {
 public:
  HarmedSource(const std::vector<std::byte>& bytes, const Harm& harm) : bytes_(bytes), harm_(harm) {}
  std::uint64_t size() const override { return harm_.is_cut() ? harm_.byte + harm_.zeros : bytes_.size(); }
  Status read(std::uint64_t offset, std::span<std::byte> out) const override {
    if (offset > size() || out.size() > size() - offset) return damaged("read past the end");
    const std::uint64_t end = harm_.is_cut() ? harm_.byte : bytes_.size();
    const std::uint64_t there = offset < end ? std::min<std::uint64_t>(out.size(), end - offset) : 0;
    if (there > 0) std::memcpy(out.data(), bytes_.data() + offset, there);
    std::fill(out.begin() + static_cast<std::ptrdiff_t>(there), out.end(), std::byte{0});
    if (!harm_.is_cut() && harm_.byte >= offset && harm_.byte - offset < out.size()) {
      out[harm_.byte - offset] ^= harm_.flip;
    }
    return {};
  }
  std::string name() const override { return "harmed.tumble"; }

 private:
  const std::vector<std::byte>& bytes_;
  Harm harm_;
};

class Flipper {
 public:
  Flipper(std::vector<std::byte> bytes, const LogReader& log, std::uint64_t seed)
      : bytes_(std::move(bytes)), chunks_(log.chunks()), random_(seed) {
    index_ = chunks_.back().offset + chunks_.back().length;
  }

  Counts run(std::uint64_t trials) {
    for (std::uint64_t i = 0; i < trials; ++i) {
      const Harm harm = choose();
      harm.is_cut() ? check_cut(harm) : check_flip(harm);
      if (i % kRecoverEvery == 0) check_recovery(harm);
      ++counts_.trials;
    }
    return std::move(counts_);
  }

 private:
  Harm choose() {
    Harm harm;
    harm.byte = random_() % bytes_.size();
    const bool is_cut = random_() % 4 == 0;
    if (is_cut) harm.zeros = random_() % 2 * (random_() % 5000);
    if (!is_cut) harm.flip = random_() % 2 == 0 ? static_cast<std::byte>(1U << random_() % 8) : any_flip();
    return harm;
  }
  std::byte any_flip() { return static_cast<std::byte>(1 + random_() % 255); }

  void fail(std::uint64_t& count, const Harm& harm, const std::string& what) {
    ++count;
    if (counts_.failures.size() >= kFailuresKept) return;
    counts_.failures.push_back((harm.is_cut() ? "cut before byte " : "flip of byte ") + std::to_string(harm.byte) +
                               ": " + what);
  }

  [[nodiscard]] bool in_header(const Harm& harm) const { return harm.byte < chunks_.front().offset; }
  /// Not one byte of the chunk was touched.
  [[nodiscard]] static bool survives(const ChunkPlace& place, const Harm& harm) {
    const std::uint64_t end = place.offset + place.length;
    return harm.byte >= end || (!harm.is_cut() && harm.byte < place.offset);
  }

  /// All chunks that survive are offered as they were.
  void check_survivors(const LogReader& log, const Harm& harm) {
    for (const ChunkPlace& place : chunks_) {
      if (survives(place, harm) && std::ranges::find(log.chunks(), place) == log.chunks().end()) {
        fail(counts_.lost, harm, "the chunk at byte " + std::to_string(place.offset) + " is not offered");
      }
    }
  }

  void check_header_error(const Result<LogReader>& log, const Harm& harm) {
    if (log.ok()) return fail(counts_.undetected, harm, "a damaged header was accepted");
    const bool hardly_begun = harm.is_cut() && harm.byte < replay::kMagicEnd;  // nothing says that it was a log
    if (log.error().kind != ErrorKind::kDamaged && !hardly_begun) {
      fail(counts_.undetected, harm, log.error().message);
    }
  }

  void check_flip(const Harm& harm) {
    Result<LogReader> log = LogReader::open(std::make_unique<HarmedSource>(bytes_, harm));
    if (in_header(harm)) return check_header_error(log, harm);
    if (!log.ok()) return fail(counts_.lost, harm, log.error().message);
    check_survivors(*log, harm);
    if (harm.byte >= index_) {
      const auto& damages = log->condition().damages;
      if (damages.empty() || damages.front().offset < index_) fail(counts_.undetected, harm, "in index or footer");
      return;
    }
    const auto hurt = std::ranges::find_if(chunks_, [&](const ChunkPlace& place) { return !survives(place, harm); });
    const auto offered = std::ranges::find(log->chunks(), hurt->offset, &ChunkPlace::offset);
    if (offered == log->chunks().end()) {
      if (log->condition().whole()) fail(counts_.undetected, harm, "a chunk is missing");
      return;
    }
    const Result<const replay::StepRecord*> step = log->read_step(offered->first_step);
    const std::string place = "at byte " + std::to_string(hurt->offset);
    if (step.ok() || step.error().message.find(place) == std::string::npos) {
      fail(counts_.undetected, harm, step.ok() ? "a damaged chunk was read" : step.error().message);
    }
  }

  void check_cut(const Harm& harm) {
    const Result<LogReader> log = LogReader::open(std::make_unique<HarmedSource>(bytes_, harm));
    if (in_header(harm)) return check_header_error(log, harm);
    if (!log.ok()) return fail(counts_.lost, harm, log.error().message);
    check_survivors(*log, harm);
    if (!log->condition().torn && log->condition().damages.empty()) fail(counts_.undetected, harm, "not called torn");
  }

  /// Every chunk that survives is in what recovery writes, and what it writes verifies.
  void check_recovery(const Harm& harm) {
    ++counts_.recoveries;
    std::uint64_t steps = 0;
    for (const ChunkPlace& place : chunks_) steps += survives(place, harm) ? place.step_count : 0;
    const auto written = std::make_shared<std::vector<std::byte>>();
    const Result<replay::RecoverReport> report =
        recover_log(HarmedSource(bytes_, harm), std::make_unique<replay::MemoryByteSink>(written, "recovered.tumble"));
    if (!report.ok()) {
      if (steps > 0) fail(counts_.lost, harm, report.error().message);
      return;
    }
    if (report->steps < steps) fail(counts_.lost, harm, "recovery lost steps");
    Result<LogReader> log = LogReader::open(std::make_unique<replay::MemoryByteSource>(written, "recovered.tumble"));
    if (!log.ok() || !verify(*log).condition.sound()) fail(counts_.undetected, harm, "recovery wrote a bad log");
  }

  std::vector<std::byte> bytes_;
  std::vector<ChunkPlace> chunks_;
  std::uint64_t index_;  // offset
  std::mt19937_64 random_;
  Counts counts_;
};

}  // namespace

Result<Counts> flip_and_cut(const std::string& path, std::uint64_t trials, std::uint64_t seed) {
  Result<std::unique_ptr<replay::ByteSource>> source = replay::open_file_source(path);
  if (!source.ok()) return source.error();
  std::vector<std::byte> bytes((*source)->size());
  if (Status ok = (*source)->read(0, bytes); !ok.ok()) return ok.error();
  Result<LogReader> log = LogReader::open(path);
  if (!log.ok()) return log.error();
  if (!verify(*log).condition.whole()) return damaged(path + ": not whole to begin with");
  return Flipper(std::move(bytes), *log, seed).run(trials);
}

}  // namespace tumble::trial

// The log: its cost to the stepping thread, its size, the speed of writing and reading it.
// The scene is the thesis's tilted grid (Fig. 21): 20 × 20 cubes, 5 s at 1/300.
#include <benchmark/benchmark.h>

#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <string>
#include <thread>

#include "replay/codec/chunk_codec.h"
#include "replay/codec/zstd_frame.h"
#include "replay/diff/separation.h"
#include "replay/format/limits.h"
#include "replay/log/verify.h"
#include "tumble/replay/compare.h"
#include "tumble/replay/log_reader.h"
#include "tumble/replay/player.h"
#include "tumble/replay/recorder.h"
#include "tumble/replay/replayer.h"

namespace tumble::replay {
namespace {

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point start) { return std::chrono::duration<double>(Clock::now() - start).count(); }

sim::SceneDef tilted_grid(std::uint64_t steps, sim::Method method = sim::Method::kThesis) {
  constexpr double kHalfRoot = 0.70710678118654757;
  sim::SceneDef scene;
  scene.name = "tilted_grid";
  scene.world.method = method;
  scene.world.dt = 1.0 / 300;
  scene.steps = steps;
  for (std::uint32_t k = 0; k < 400; ++k) {
    const std::uint32_t row = k / 20;
    const std::uint32_t column = k % 20;
    sim::BoxDef box;
    box.id = k + 1;
    box.position = {(column - 9.5) * 1.25, row * 1.25 * kHalfRoot, 0.5 + kHalfRoot + row * 1.25 * kHalfRoot};
    box.orientation = {0.92387953251128674, 0.38268343236508978, 0, 0};  // 45° about x
    scene.boxes.push_back(box);
  }
  return scene;
}

/// The scene with as many frozen cubes a long way off.
sim::SceneDef with_frozen_bodies(sim::SceneDef scene) {
  for (std::uint32_t k = 0; k < 400; ++k) {
    sim::BoxDef box;
    box.id = 1001 + k;
    const std::uint32_t row = k / 20;
    box.position = {2.0 * (k % 20), 1000 + 2.0 * row, 0.5};
    box.frozen = true;
    scene.boxes.push_back(box);
  }
  return scene;
}

std::string recorded(const sim::SceneDef& scene, const std::string& name) {
  std::string path = (std::filesystem::temp_directory_path() / (name + ".tumble")).string();
  const Result<LogSummary> summary = record_session(path, scene, {});
  if (summary.ok()) return path;
  std::fprintf(stderr, "%s\n", summary.error().message.c_str());
  std::exit(4);
}

LogReader opened(const std::string& path) {
  Result<LogReader> log = LogReader::open(path);
  if (log.ok()) return *std::move(log);
  std::fprintf(stderr, "%s\n", log.error().message.c_str());
  std::exit(3);
}

/// The whole session, recorded once for all benchmarks.
const std::string& grid_log() {
  static const std::string path = recorded(tilted_grid(1500), "tumble_log_bench");
  return path;
}

/// 64 steps from the middle of the session, when the grid has met the ground.
struct MiddleChunk {
  Keyframe keyframe;
  std::vector<StepRecord> steps;
  std::vector<sim::WorldState> states;
};

const MiddleChunk& middle_chunk() {
  static const MiddleChunk made = [] {
    MiddleChunk chunk;
    LogReader log = opened(grid_log());
    Result<Player> player = Player::at(log, 700);
    chunk.keyframe.state = player->world().state();
    for (int k = 0; k < 64; ++k) {
      chunk.steps.push_back(**player->step());
      chunk.states.push_back(player->world().state());
    }
    return chunk;
  }();
  return made;
}

std::int64_t state_bytes(const MiddleChunk& chunk) {
  return static_cast<std::int64_t>(chunk.steps.size() * chunk.keyframe.state.bodies.size() * kBodyStateBytes);
}

/// The cost of append() to the stepping thread when steps come every 200 µs, as they do at 400 bodies.
void append_400_bodies(benchmark::State& bench) {
  const MiddleChunk& chunk = middle_chunk();
  const std::string path = (std::filesystem::temp_directory_path() / "tumble_append_bench.tumble").string();
  auto writer = LogWriter::create(path, header_for(tilted_grid(1500)), chunk.keyframe.state);
  sim::WorldState state = chunk.states[0];
  std::uint64_t step = chunk.keyframe.state.step;
  for (auto _ : bench) {
    const StepRecord& record = chunk.steps[step % chunk.steps.size()];
    state.bodies = chunk.states[step % chunk.states.size()].bodies;  // another state, outside of the clock
    state.step = ++step;
    const Clock::time_point start = Clock::now();
    const Status ok = (*writer)->append({record.dt, {}, record.phase_words, record.counters}, state);
    bench.SetIterationTime(seconds_since(start));
    if (!ok.ok()) bench.SkipWithError(ok.error().message.c_str());
    std::this_thread::sleep_until(start + std::chrono::microseconds(200));
  }
  (void)(*writer)->finish().ok();
  std::filesystem::remove(path);
}
BENCHMARK(append_400_bodies)->UseManualTime()->Unit(benchmark::kMicrosecond)->Iterations(5000);

void encode_chunk(benchmark::State& bench) {
  const MiddleChunk& chunk = middle_chunk();
  ChunkEncoder encoder;
  Compressor compressor;
  std::vector<std::byte> stored;
  for (auto _ : bench) {
    const Result<MessageBytes> message = encoder.encode(chunk.keyframe, chunk.steps);
    if (!message.ok() || !compressor.compress(message->bytes(), stored).ok()) bench.SkipWithError("cannot encode");
  }
  bench.SetBytesProcessed(static_cast<std::int64_t>(bench.iterations()) * state_bytes(chunk));
  bench.counters["stored_bytes"] = static_cast<double>(stored.size());
}
BENCHMARK(encode_chunk)->Unit(benchmark::kMillisecond);

void decode_chunk(benchmark::State& bench) {
  const MiddleChunk& chunk = middle_chunk();
  ChunkEncoder encoder;
  Compressor compressor;
  std::vector<std::byte> stored;
  const Result<MessageBytes> message = encoder.encode(chunk.keyframe, chunk.steps);
  if (!message.ok() || !compressor.compress(message->bytes(), stored).ok()) bench.SkipWithError("cannot encode");
  for (auto _ : bench) {
    const Result<MessageBytes> raw = decompress(stored, message->bytes().size(), kChunkBytesMax);
    Result<ChunkDecoder> decoder = ChunkDecoder::open(*raw);
    benchmark::DoNotOptimize(decoder->step(decoder->step_count() - 1));
  }
  bench.SetBytesProcessed(static_cast<std::int64_t>(bench.iterations()) * state_bytes(chunk));
}
BENCHMARK(decode_chunk)->Unit(benchmark::kMillisecond);

void open_and_read_middle_step(benchmark::State& bench) {
  const std::string& path = grid_log();
  for (auto _ : bench) {
    LogReader log = opened(path);
    benchmark::DoNotOptimize(log.read_step(750));
  }
}
BENCHMARK(open_and_read_middle_step)->Unit(benchmark::kMillisecond);

/// The session with one more push before step 1000.
const std::string& other_log() {
  static const std::string path = [] {
    sim::SceneDef scene = tilted_grid(1500);
    scene.inputs.push_back({1000, sim::Push{200, {0, 0, 0.001}, true, {0, 0, 0}}});
    return recorded(scene, "tumble_log_bench_other");
  }();
  return path;
}

/// Opens both, and finds step, phase, body and field.
void find_first_difference(benchmark::State& bench) {
  const std::string& path = grid_log();
  const std::string& other = other_log();
  std::uint64_t chunks = 0;
  for (auto _ : bench) {
    LogReader a = opened(path), b = opened(other);
    const Result<DiffReport> report = diff_logs(a, b);
    if (!report.ok() || !report->first || report->first->step != 1000) bench.SkipWithError("not found");
    chunks = a.chunks_opened() + b.chunks_opened();
  }
  bench.counters["chunks_opened"] = static_cast<double>(chunks);
}
BENCHMARK(find_first_difference)->Unit(benchmark::kMillisecond);

/// Finds the first difference and measures the separation in the 500 steps that follow.
void follow_first_difference(benchmark::State& bench) {
  const std::string& path = grid_log();
  const std::string& other = other_log();
  for (auto _ : bench) {
    LogReader a = opened(path), b = opened(other);
    const auto feed = [](LogReader& log) {
      return SessionSteps{log.name(), [&log](std::uint64_t k) { return log.read_step(k); }};
    };
    const Result<DiffReport> report = diff_logs(a, b);
    if (!report.ok() || !measure_separation(feed(a), feed(b), report->first->step, 1500).ok())
      bench.SkipWithError("no separation");
  }
}
BENCHMARK(follow_first_difference)->Unit(benchmark::kMillisecond);

void verify_log(benchmark::State& bench) {
  LogReader log = opened(grid_log());
  for (auto _ : bench) {
    if (!verify(log).condition.whole()) bench.SkipWithError("not whole");
  }
}
BENCHMARK(verify_log)->Unit(benchmark::kMillisecond);

/// The size of a log's chunks of equally many steps. The writer cuts by the clock, so that a file has another size each
/// time, and it cuts later where bodies rest, which would hide their cost.
std::uint64_t size_in_chunks(LogReader& log) {
  ChunkEncoder encoder;
  Compressor compressor;
  std::vector<std::byte> stored;
  std::uint64_t bytes = 0;
  Result<Player> player = Player::at(log, 0);
  std::vector<StepRecord> steps;
  Keyframe keyframe;
  for (std::uint64_t k = 1; k <= log.step_count(); ++k) {
    if (steps.empty()) keyframe.state = player->world().state();
    steps.push_back(**player->step());
    if (steps.size() < kChunkBusySteps && k < log.step_count()) continue;
    const Result<MessageBytes> message = encoder.encode(keyframe, steps);
    if (!message.ok() || !compressor.compress(message->bytes(), stored).ok()) std::exit(4);
    bytes += kPreludeBytes + stored.size();
    steps.clear();
  }
  return bytes;
}

/// No time: bytes over the body-steps that are not frozen, and the bytes that a frozen body-step adds. Argument: the
/// method.
void log_size(benchmark::State& bench) {
  const sim::SceneDef scene = tilted_grid(1500, static_cast<sim::Method>(bench.range(0)));
  LogReader log = opened(recorded(scene, "tumble_log_bench_size"));
  LogReader more = opened(recorded(with_frozen_bodies(scene), "tumble_log_bench_frozen"));
  double moving = 0, bytes = 0, bytes_more = 0;
  for (auto _ : bench) {
    for (std::uint64_t k = 1; k <= log.step_count(); ++k) {
      for (const std::uint8_t frozen : (*log.read_step(k))->states.frozen) moving += frozen == 0 ? 1 : 0;
    }
    bytes = static_cast<double>(size_in_chunks(log));
    bytes_more = static_cast<double>(size_in_chunks(more));
  }
  bench.SetLabel(name_of(scene.world.method));
  bench.counters["file_bytes"] = static_cast<double>(log.file_bytes());
  bench.counters["bytes_per_moving_body_step"] = bytes / moving;
  bench.counters["bytes_per_frozen_body_step"] = (bytes_more - bytes) / (400.0 * 1500);
  std::filesystem::remove(log.name());
  std::filesystem::remove(more.name());
}
BENCHMARK(log_size)->Arg(0)->Arg(1)->Iterations(1)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace tumble::replay

int main(int argc, char** argv) {
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 2;
  benchmark::RunSpecifiedBenchmarks();
  std::filesystem::remove(tumble::replay::grid_log());
  std::filesystem::remove(tumble::replay::other_log());
  return 0;
}

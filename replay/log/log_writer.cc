#include "tumble/replay/log_writer.h"

#include <algorithm>
#include <chrono>
#include <condition_variable>
#include <deque>
#include <mutex>
#include <system_error>
#include <thread>
#include <utility>
#include <vector>

#include "replay/format/limits.h"
#include "replay/log/record_writer.h"
#include "src/base/check.h"

namespace tumble::replay {

/// The chunk that the caller of LogWriter fills, buffer by buffer: how much of it is there, and whether it is full.
struct OpenChunk {
  using Clock = std::chrono::steady_clock;
  static constexpr std::chrono::seconds kAgeMax{1};

  std::uint64_t first_state = 0;  ///< the state before its first step
  std::uint64_t steps = 0;
  std::uint64_t busy_rows = 0;  ///< body-steps that moved
  std::uint64_t bytes = 0;
  std::size_t channels = 0;  ///< of the step with the most
  Clock::time_point begun = Clock::now();

  [[nodiscard]] std::uint64_t last_state() const { return first_state + steps; }  ///< after the last added step

  /// Adds a step; its bytes in memory.
  std::uint64_t add(const StepInfo& info, const sim::Bodies& bodies) {
    const std::uint64_t before = bytes;
    ++steps;
    if (info.extras != nullptr) {
      bytes += bytes_of(*info.extras);
      channels = std::max(channels, info.extras->channels.size());
    }
    busy_rows += static_cast<std::uint64_t>(std::count(bodies.frozen.begin(), bodies.frozen.end(), 0));
    bytes += bodies.size() * kBodyStateBytes + info.phase_words.size() * 8;
    return bytes - before;
  }

  [[nodiscard]] bool full(std::size_t bodies) const {
    return steps >= kChunkStepsMax || busy_rows >= kChunkBusySteps * std::max<std::size_t>(bodies, 1) ||
           (steps + 1) * channels > kChannelStepsMax || bytes >= kChunkStateBytes || Clock::now() - begun >= kAgeMax;
  }
};

/// How many steps a buffer of LogWriter holds, and how many buffers there are, in a world of so many bodies.
struct BufferSizes {
  static constexpr std::uint64_t kBytes = 1 << 20;        // of a buffer, but for one step at least
  static constexpr std::uint64_t kStepsAhead = 128;       // as long as the thread may take for the end of a chunk
  static constexpr std::uint64_t kBytesAhead = 64 << 20;  // of all buffers, but for three at least
  static constexpr std::uint64_t kManyBodies = 1 << 19;   // a keyframe takes 0.5 kB of each: one must do

  explicit BufferSizes(std::uint64_t bodies) {
    const std::uint64_t of_step = kBodyStateBytes * std::max<std::uint64_t>(bodies, 1);
    steps = std::clamp<std::uint64_t>(kBytes / of_step, 1, kChunkBusySteps);
    const std::uint64_t ahead = std::min(kStepsAhead / steps, kBytesAhead / (steps * of_step));
    buffers = bodies < kManyBodies ? std::max<std::uint64_t>(ahead, 3) : 1;
    bytes_ahead = std::max(3 * kChunkStateBytes, 3 * steps * of_step);
  }

  std::uint64_t steps, buffers;
  std::uint64_t bytes_ahead;  ///< that full buffers may hold: snapshots and channels of an engine can be large
};

/// Some steps of one chunk, filled by the caller and encoded by the thread. Buffers circulate between the two threads
/// and keep their memory: allocating its pages costs more than filling them.
struct LogWriter::Buffer {
  std::unique_ptr<Keyframe> keyframe;  ///< the state before the first step, where that begins a chunk
  bool ends_chunk = false;
  std::vector<StepRecord> steps;  ///< of which `used` are filled
  std::size_t used = 0;
  std::uint64_t bytes = 0;  ///< of the filled steps

  /// Allocates the memory of `count` steps and touches it.
  void reserve(const sim::Bodies& bodies, std::size_t count) {
    steps.resize(count);
    for (StepRecord& step : steps) copy_visible(bodies, step.states);
  }

  void add(const StepInfo& info, const sim::WorldState& after) {
    if (used == steps.size()) steps.emplace_back();
    StepRecord& step = steps[used++];
    step.step = after.step;
    step.dt = info.dt;
    step.inputs.assign(info.inputs.begin(), info.inputs.end());
    step.phase_words.assign(info.phase_words.begin(), info.phase_words.end());
    step.counters = info.counters;
    if (info.extras != nullptr) {
      step.extras = *info.extras;
    } else if (!step.extras.empty()) {
      step.extras.clear();
    }
    copy_visible(after.bodies, step.states);
  }
};

struct LogWriter::Shared {
  Shared(std::unique_ptr<ByteSink> sink, std::size_t bodies) : records(std::move(sink)), sizes(bodies) {
    for (std::uint64_t i = 1; i < sizes.buffers; ++i) free.push_back(std::make_unique<Buffer>());
  }

  void begin_chunk(const sim::WorldState& state);
  Status hand_over(const sim::WorldState& now, bool ends_chunk);
  void run(const sim::Bodies& bodies, std::uint64_t planned);
  void reserve(const sim::Bodies& bodies, std::uint64_t planned);
  Status write(Buffer& buffer);
  void stop();

  RecordWriter records;               // the thread's, while it runs
  std::unique_ptr<Keyframe> written;  // the thread's: of the chunk that it encodes
  BufferSizes sizes;
  bool finished = false;                                     // the caller's
  bool begins = true;                                        // the caller's: no chunk was handed over yet
  OpenChunk chunk;                                           // the caller's
  std::unique_ptr<Buffer> open{std::make_unique<Buffer>()};  // the caller's

  std::mutex mutex;  // guards what follows
  std::condition_variable changed;
  std::deque<std::unique_ptr<Buffer>> full;
  std::deque<std::unique_ptr<Buffer>> free;
  std::uint64_t bytes_ahead = 0;  // in full buffers and in the one that the thread encodes
  std::vector<std::unique_ptr<Keyframe>> free_keyframes;
  Status status;
  bool stopping = false;

  std::thread thread;
};

/// Begins a chunk at `state`. Its first buffer is open and empty.
void LogWriter::Shared::begin_chunk(const sim::WorldState& state) {
  std::unique_ptr<Keyframe>& keyframe = open->keyframe;
  {
    const std::lock_guard lock(mutex);
    if (!free_keyframes.empty()) {
      keyframe = std::move(free_keyframes.back());
      free_keyframes.pop_back();
    }
  }
  if (keyframe == nullptr) keyframe = std::make_unique<Keyframe>();
  keyframe->state = state;
  chunk = {.first_state = state.step};
}

/// Moves the open buffer to `full` and opens the next one, of a new chunk that begins at `now` if the chunk ends.
/// Waits while no buffer is free, or the full ones hold too much.
Status LogWriter::Shared::hand_over(const sim::WorldState& now, bool ends_chunk) {
  SIM_CHECK(now.step == chunk.last_state(), now.step, chunk.last_state());
  open->ends_chunk = ends_chunk;
  Status so_far;
  {
    std::unique_lock lock(mutex);
    bytes_ahead += open->bytes;
    full.push_back(std::move(open));
    changed.notify_all();
    changed.wait(lock, [this] { return !free.empty() && bytes_ahead <= sizes.bytes_ahead; });
    open = std::move(free.front());
    free.pop_front();
    so_far = status;
  }
  open->used = open->bytes = 0;
  if (ends_chunk) {
    begins = false;
    begin_chunk(now);
  }
  return so_far;
}

/// Runs first on the writing thread: allocates and touches the memory of the free buffers that a session of `planned`
/// steps will fill, so that the caller need not.
void LogWriter::Shared::reserve(const sim::Bodies& bodies, std::uint64_t planned) {
  std::unique_lock lock(mutex);
  const std::uint64_t wanted = std::min<std::uint64_t>(free.size(), planned / sizes.steps);
  for (std::uint64_t k = 0; k < wanted && !free.empty(); ++k) {
    std::unique_ptr<Buffer> buffer = std::move(free.back());  // the caller takes from the front
    free.pop_back();
    lock.unlock();
    if (buffer->steps.empty()) buffer->reserve(bodies, sizes.steps);
    lock.lock();
    free.push_front(std::move(buffer));
    changed.notify_all();
  }
}

/// Runs on the writing thread: writes the buffers of `full` and moves each to `free`. bodies, planned: of reserve().
void LogWriter::Shared::run(const sim::Bodies& bodies, std::uint64_t planned) {
  reserve(bodies, planned);
  std::unique_lock lock(mutex);
  for (;;) {
    changed.wait(lock, [this] { return stopping || !full.empty(); });
    if (full.empty()) return;
    std::unique_ptr<Buffer> buffer = std::move(full.front());
    full.pop_front();
    lock.unlock();
    const Status done = write(*buffer);
    lock.lock();
    if (status.ok() && !done.ok()) status = done;
    bytes_ahead -= std::min(bytes_ahead, buffer->bytes);  // the last one was not counted
    if (buffer->ends_chunk) free_keyframes.push_back(std::move(written));
    free.push_back(std::move(buffer));
    changed.notify_all();
  }
}

/// Runs on the writing thread: hashes and encodes the steps of a buffer; writes the chunk that ends with it.
Status LogWriter::Shared::write(Buffer& buffer) {
  if (buffer.keyframe != nullptr) {
    written = std::move(buffer.keyframe);
    if (Status ok = records.begin_chunk(*written); !ok.ok()) return ok;
  }
  if (Status ok = records.add_steps(std::span(buffer.steps).first(buffer.used)); !ok.ok()) return ok;
  return buffer.ends_chunk ? records.end_chunk() : Status();
}

/// Waits until the thread has written all full buffers, and ends it.
void LogWriter::Shared::stop() {
  if (!thread.joinable()) return;
  {
    const std::lock_guard lock(mutex);
    stopping = true;
  }
  changed.notify_all();
  thread.join();
}

LogWriter::LogWriter(std::unique_ptr<Shared> shared) : shared_(std::move(shared)) {}

LogWriter::~LogWriter() {
  if (shared_->thread.joinable() && shared_->chunk.steps > 0) {
    shared_->open->ends_chunk = true;
    const std::lock_guard lock(shared_->mutex);
    shared_->full.push_back(std::move(shared_->open));
  }
  shared_->stop();
}

Result<std::unique_ptr<LogWriter>> LogWriter::create(const std::string& path, const LogHeader& header,
                                                     const sim::WorldState& initial) {
  Result<std::unique_ptr<ByteSink>> sink = open_file_sink(path);
  if (!sink.ok()) return sink.error();
  return create(*std::move(sink), header, initial);
}

Result<std::unique_ptr<LogWriter>> LogWriter::create(std::unique_ptr<ByteSink> sink, const LogHeader& header,
                                                     const sim::WorldState& initial) {
  auto shared = std::make_unique<Shared>(std::move(sink), initial.bodies.size());
  if (Status ok = shared->records.write_header(header, initial); !ok.ok()) return ok.error();
  shared->begin_chunk(initial);
  Shared* running = shared.get();
  // The first chunk's keyframe stays as it is until the thread itself writes it.
  const sim::Bodies& bodies = shared->open->keyframe->state.bodies;
  const std::uint64_t planned = std::max(header.scene.steps, initial.step) - initial.step;
  try {
    shared->thread = std::thread([running, &bodies, planned] { running->run(bodies, planned); });
  } catch (const std::system_error& error) {
    return cannot_finish(shared->records.name() + ": no thread to write it with: " + error.what());
  }
  return std::unique_ptr<LogWriter>(new LogWriter(std::move(shared)));
}

Status LogWriter::append(const StepInfo& info, const sim::WorldState& after) {
  Shared& s = *shared_;
  SIM_CHECK(after.step == s.chunk.last_state() + 1, after.step, s.chunk.last_state());
  s.open->add(info, after);
  s.open->bytes += s.chunk.add(info, after.bodies);
  const bool ends_chunk = s.chunk.full(after.bodies.size());
  return ends_chunk || s.open->used >= s.sizes.steps ? s.hand_over(after, ends_chunk) : Status();
}

Status LogWriter::flush(const sim::WorldState& now) {
  if (shared_->chunk.steps > 0) {
    if (Status ok = shared_->hand_over(now, true); !ok.ok()) return ok;
  }
  std::unique_lock lock(shared_->mutex);
  shared_->changed.wait(lock, [this] { return shared_->free.size() + 1 == shared_->sizes.buffers; });
  return shared_->status;
}

Result<LogSummary> LogWriter::finish() {
  SIM_CHECK(!shared_->finished);
  shared_->finished = true;
  Shared& s = *shared_;
  if (s.chunk.steps > 0 || s.begins) {  // a log without steps has one chunk, for state 0
    s.open->ends_chunk = true;
    const std::lock_guard lock(s.mutex);
    s.full.push_back(std::move(s.open));
  }
  s.stop();
  if (!s.status.ok()) return s.status.error();
  RecordWriter& records = s.records;
  if (Status ok = records.finish(); !ok.ok()) return ok.error();
  return LogSummary{records.steps(), records.chunks(), records.bytes(), records.final_hash(), records.chain()};
}

}  // namespace tumble::replay

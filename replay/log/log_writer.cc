#include "tumble/replay/log_writer.h"

#include <algorithm>
#include <chrono>
#include <condition_variable>
#include <deque>
#include <mutex>
#include <thread>
#include <utility>
#include <vector>

#include "replay/format/limits.h"
#include "replay/log/record_writer.h"
#include "src/base/check.h"

namespace tumble::replay {
namespace {

using Clock = std::chrono::steady_clock;

constexpr std::size_t kBuffers = 3;  // one is filled while one is written and one waits or comes back
constexpr std::size_t kManyBodies = std::size_t{1} << 19U;  // a buffer holds a state, 0.5 kB of each: one must do
constexpr std::chrono::seconds kChunkAgeMax(1);

/// The steps whose states fill a chunk.
std::uint64_t steps_of_chunk(const sim::Bodies& bodies) {
  return kChunkStateBytes / (kBodyStateBytes * std::max<std::size_t>(bodies.size(), 1)) + 1;
}

}  // namespace

/// The steps of one chunk, filled by the caller and written by the thread.
///
/// Buffers circulate between the two threads and keep their memory: allocating the pages of a chunk costs more than
/// filling them. With three of them the caller fills one while the thread writes another, and the third covers the time
/// until a buffer comes back.
struct LogWriter::Buffer {
  Keyframe keyframe;
  std::vector<StepRecord> steps;  // of which `used` are filled
  std::size_t used = 0;
  std::uint64_t busy_rows = 0;  // body-steps that moved
  std::uint64_t bytes = 0;
  std::size_t channels = 0;  // of the step with the most
  Clock::time_point begun;

  /// Allocates the memory of `count` steps and touches it.
  void reserve(const sim::Bodies& bodies, std::size_t count) {
    const std::size_t had = steps.size();
    if (count <= had) return;
    steps.resize(count);
    for (StepRecord& step : std::span(steps).subspan(had)) copy_visible(bodies, step.states);
  }

  void begin(const sim::WorldState& state) {
    keyframe.state = state;
    used = 0;
    busy_rows = bytes = 0;
    channels = 0;
    begun = Clock::now();
  }

  /// The number of the state after the last added step.
  [[nodiscard]] std::uint64_t last_state() const { return keyframe.state.step + used; }

  void add(const StepInfo& info, const sim::WorldState& after) {
    SIM_CHECK(after.step == last_state() + 1, after.step, last_state());
    if (used == steps.size()) steps.emplace_back();
    StepRecord& step = steps[used++];
    step.step = after.step;
    step.dt = info.dt;
    step.inputs.assign(info.inputs.begin(), info.inputs.end());
    step.phase_words.assign(info.phase_words.begin(), info.phase_words.end());
    step.counters = info.counters;
    if (info.extras != nullptr) {
      step.extras = *info.extras;
      bytes += bytes_of(step.extras);
      channels = std::max(channels, step.extras.channels.size());
    } else if (!step.extras.empty()) {
      step.extras.clear();
    }
    copy_visible(after.bodies, step.states);
    busy_rows += static_cast<std::uint64_t>(std::count(after.bodies.frozen.begin(), after.bodies.frozen.end(), 0));
    bytes += after.bodies.size() * kBodyStateBytes + info.phase_words.size() * 8;
  }

  [[nodiscard]] bool full(std::size_t bodies) const {
    return used >= kChunkStepsMax || busy_rows >= kChunkBusySteps * std::max<std::size_t>(bodies, 1) ||
           (used + 1) * channels > kChannelStepsMax || bytes >= kChunkStateBytes ||
           Clock::now() - begun >= kChunkAgeMax;
  }
};

struct LogWriter::Shared {
  Shared(std::unique_ptr<ByteSink> sink, std::size_t bodies)
      : records(std::move(sink)), buffers(bodies < kManyBodies ? kBuffers : 1) {
    for (std::size_t i = 1; i < buffers; ++i) free.push_back(std::make_unique<Buffer>());
  }

  void run();
  void reserve(const sim::Bodies& bodies, std::uint64_t planned);
  void make_room(std::unique_lock<std::mutex>& lock, std::size_t chunks, const sim::Bodies* bodies, std::size_t steps);
  Status hand_over(const sim::WorldState& now);
  void stop();

  RecordWriter records;  // the thread's, while it runs
  std::size_t buffers;
  std::uint64_t planned_end = 0;                             // the last planned step
  bool finished = false;                                     // the caller's
  std::unique_ptr<Buffer> open{std::make_unique<Buffer>()};  // the caller's

  std::mutex mutex;  // guards what follows
  std::condition_variable changed;
  std::deque<std::unique_ptr<Buffer>> full;
  std::vector<std::unique_ptr<Buffer>> free;
  Status status;
  bool stopping = false;

  std::thread thread;
};

/// Runs first on the writing thread: allocates the free buffers that a session of `planned` steps will fill.
void LogWriter::Shared::reserve(const sim::Bodies& bodies, std::uint64_t planned) {
  const std::uint64_t steps = std::min(steps_of_chunk(bodies), kChunkBusySteps);
  std::unique_lock lock(mutex);
  make_room(lock, std::min<std::uint64_t>(free.size(), planned / steps), &bodies, steps);
}

/// Runs on the writing thread: allocates and touches memory for `steps` steps in the free buffers, in as many as
/// `chunks`, so that the caller need not. bodies: to take the memory for; null: those of the buffer's last chunk.
/// Called with the lock held; gives it up in between.
void LogWriter::Shared::make_room(std::unique_lock<std::mutex>& lock, std::size_t chunks, const sim::Bodies* bodies,
                                  std::size_t steps) {
  for (std::size_t k = 0; k < chunks && !free.empty(); ++k) {
    std::unique_ptr<Buffer> buffer = std::move(free.front());  // the caller takes from the back
    free.erase(free.begin());
    lock.unlock();
    buffer->reserve(bodies != nullptr ? *bodies : buffer->keyframe.state.bodies, steps);
    lock.lock();
    free.push_back(std::move(buffer));
    changed.notify_all();
  }
}

/// Runs on the writing thread: writes the buffers of `full` and moves each to `free`.
void LogWriter::Shared::run() {
  std::unique_lock lock(mutex);
  for (;;) {
    changed.wait(lock, [this] { return stopping || !full.empty(); });
    if (full.empty()) return;
    std::unique_ptr<Buffer> buffer = std::move(full.front());
    full.pop_front();
    lock.unlock();
    Status written = records.write_chunk(buffer->keyframe, std::span(buffer->steps).first(buffer->used));
    const std::uint64_t used = buffer->used, left = planned_end - std::min(planned_end, buffer->last_state());
    const std::uint64_t most = std::min(kChunkStepsMax, steps_of_chunk(buffer->keyframe.state.bodies));
    lock.lock();
    if (status.ok() && !written.ok()) status = written;
    free.push_back(std::move(buffer));
    changed.notify_all();
    // Chunks grow while ever more bodies rest. The caller would touch the pages of the next one in its own time.
    const bool longer = used > kChunkBusySteps && left > used && full.empty();
    if (longer) make_room(lock, free.size(), nullptr, std::min(most, 2 * used));
  }
}

/// Moves the open buffer to `full` and begins the next one at `now`. Waits while no buffer is free.
Status LogWriter::Shared::hand_over(const sim::WorldState& now) {
  SIM_CHECK(now.step == open->last_state(), now.step, open->last_state());
  std::unique_lock lock(mutex);
  full.push_back(std::move(open));
  changed.notify_all();
  changed.wait(lock, [this] { return !free.empty(); });
  open = std::move(free.back());
  free.pop_back();
  open->begin(now);
  return status;
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
  if (shared_->thread.joinable() && shared_->open->used > 0) {
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
  shared->open->begin(initial);
  Shared* running = shared.get();
  // The first chunk's keyframe stays as it is until the thread itself writes it.
  const sim::Bodies& bodies = shared->open->keyframe.state.bodies;
  const std::uint64_t planned = std::max(header.scene.steps, initial.step) - initial.step;
  shared->planned_end = header.scene.steps;
  shared->thread = std::thread([running, &bodies, planned] {
    running->reserve(bodies, planned);
    running->run();
  });
  return std::unique_ptr<LogWriter>(new LogWriter(std::move(shared)));
}

Status LogWriter::append(const StepInfo& info, const sim::WorldState& after) {
  shared_->open->add(info, after);
  if (!shared_->open->full(after.bodies.size())) return {};
  return shared_->hand_over(after);
}

Status LogWriter::flush(const sim::WorldState& now) {
  if (shared_->open->used > 0) {
    if (Status ok = shared_->hand_over(now); !ok.ok()) return ok;
  }
  std::unique_lock lock(shared_->mutex);
  shared_->changed.wait(lock, [this] { return shared_->free.size() + 1 == shared_->buffers; });
  return shared_->status;
}

Result<LogSummary> LogWriter::finish() {
  SIM_CHECK(!shared_->finished);
  shared_->finished = true;
  shared_->stop();
  RecordWriter& records = shared_->records;
  Buffer& open = *shared_->open;
  if (open.used > 0 || records.chunks() == 0) {  // a log without steps has one chunk, for state 0
    if (Status ok = records.write_chunk(open.keyframe, std::span(open.steps).first(open.used)); !ok.ok()) {
      return ok.error();
    }
  }
  if (Status ok = records.finish(); !ok.ok()) return ok.error();
  return LogSummary{records.steps(), records.chunks(), records.bytes(), records.final_hash(), records.chain()};
}

}  // namespace tumble::replay

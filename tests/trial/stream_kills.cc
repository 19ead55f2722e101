// stream_trial COUNT SEED FOLDER: records with the recorder in a child, kills the child with SIGKILL at a random
// instant, and reads what is left. Every step whose step_end() returned must be there, and nothing may be damaged.
// Exit status: 0 no complete frame lost, 1 one was, 2 bad usage.
#include <sys/mman.h>
#include <sys/wait.h>
#include <unistd.h>

#include <atomic>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <iostream>
#include <random>
#include <string>
#include <thread>

#include "replay/recorder/tumble_recorder.h"
#include "replay/stream/stream_reader.h"
#include "replay/stream/stream_tail.h"

namespace tumble::trial {
namespace {

using Counter = std::atomic<std::uint64_t>;

constexpr std::uint64_t kBodies = 40;
constexpr double kSecondsMax = 0.03;  // until the kill
constexpr std::uint64_t kNotBegun = ~std::uint64_t{0};

/// Records steps for ever; `done` follows the last step that was ended.
[[noreturn]] void record_for_ever(const std::string& path, Counter& done) {
  TumbleRecDef def = {};
  def.engine = "trial";
  def.precision_bits = 53;
  def.path = path.c_str();
  TumbleRec* rec = tumble_rec_create(&def);
  TumbleRecBody body = {};
  body.mass = body.size[0] = body.size[1] = body.size[2] = body.state.orientation[0] = 1;
  for (body.id = 1; body.id <= kBodies; ++body.id) tumble_rec_body(rec, &body);
  for (std::uint64_t k = 1;; ++k) {
    tumble_rec_step_begin(rec, 0.01);
    for (std::uint64_t id = 1; id <= kBodies; ++id) {
      body.state.position[0] = 1.0 / static_cast<double>(k * id);
      tumble_rec_state(rec, id, &body.state);
    }
    if (tumble_rec_step_end(rec) != TUMBLE_REC_OK) ::_exit(3);
    done.store(k);
  }
}

/// The steps that are there, or an empty text and the reason.
std::string lost_of(const std::string& path, std::uint64_t done) {
  if (done == kNotBegun) return "";
  Result<std::unique_ptr<replay::ByteSource>> source = replay::open_stream_source(path);
  if (!source.ok()) return source.error().message;
  const Result<replay::StreamReader> stream = replay::StreamReader::open(*std::move(source));
  if (!stream.ok()) return stream.error().message;
  if (stream->condition().damage) return *stream->condition().damage;
  const std::uint64_t found = stream->steps().empty() ? 0 : stream->steps().back().step;
  if (found >= done && found <= done + 1) return "";
  return "found step " + std::to_string(found) + ", wanted step " + std::to_string(done);
}

int run(std::uint64_t count, std::uint64_t seed, const std::string& folder) {
  void* shared = ::mmap(nullptr, sizeof(Counter), PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
  if (shared == MAP_FAILED) return 2;
  auto& done = *new (shared) Counter(0);
  std::filesystem::create_directories(folder);
  const std::string path = folder + "/killed.tumblestream";
  std::mt19937_64 random(seed);
  std::uint64_t lost = 0, steps = 0;
  for (std::uint64_t k = 0; k < count; ++k) {
    std::filesystem::remove(path);
    done.store(kNotBegun);
    const pid_t child = ::fork();
    if (child == 0) record_for_ever(path, done);
    std::this_thread::sleep_for(
        std::chrono::duration<double>(std::uniform_real_distribution<double>(0, kSecondsMax)(random)));
    ::kill(child, SIGKILL);
    int status = 0;
    ::waitpid(child, &status, 0);
    const std::string why = WIFSIGNALED(status) ? lost_of(path, done.load()) : "the recorder stopped by itself";
    if (done.load() != kNotBegun) steps += done.load();
    if (why.empty()) continue;
    ++lost;
    std::cerr << "stream_trial: " << why << '\n';
  }
  std::filesystem::remove(path);
  std::cout << count << " kills, " << steps << " steps recorded: " << lost << " with a complete frame lost\n";
  return lost == 0 ? 0 : 1;
}

}  // namespace
}  // namespace tumble::trial

int main(int argc, char** argv) {
  if (argc != 4) {
    std::cerr << "usage: stream_trial COUNT SEED FOLDER\n";
    return 2;
  }
  return tumble::trial::run(std::strtoull(argv[1], nullptr, 10), std::strtoull(argv[2], nullptr, 10), argv[3]);
}

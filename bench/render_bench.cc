// Pictures: the cost of a frame and of each of its passes; for passes the processor time, the least of 20.
// Usage: render_bench LOG STEP [WIDTH HEIGHT SAMPLES]
#include <algorithm>
#include <array>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <ctime>

#include "replay/picture/picture_source.h"
#include "tumble/render/renderer.h"

namespace {

using namespace tumble;  // NOLINT(google-build-using-namespace): a program of one file
using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point start) { return std::chrono::duration<double>(Clock::now() - start).count(); }

int fail(const Error& error) {
  std::fprintf(stderr, "render_bench: %s\n", error.message.c_str());
  return 2;
}

// A picture that cannot be drawn has no time: ends the program.
void draw(render::Renderer& renderer, const render::Snapshot& snapshot) {
  if (const auto picture = renderer.draw(snapshot); !picture.ok()) std::exit(fail(picture.error()));
}

// Frames without waiting for each pass: wall and CPU milliseconds a frame.
void print_frames(render::Renderer& renderer, const render::Snapshot& snapshot, int frames) {
  renderer.measure_passes(false);
  const Clock::time_point start = Clock::now();
  const std::clock_t cpu_start = std::clock();
  for (int i = 0; i < frames; ++i) draw(renderer, snapshot);
  const double cpu = static_cast<double>(std::clock() - cpu_start) / CLOCKS_PER_SEC;
  std::printf("frame      %7.2f ms, CPU %7.2f ms\n", seconds_since(start) * 1000 / frames, cpu * 1000 / frames);
}

void print_passes(render::Renderer& renderer, const render::Snapshot& snapshot, int frames) {
  constexpr std::array<const char*, 6> kNames = {"1 depth",  "2 base",   "3 shrink",
                                                 "4 blur x", "5 blur y", "6 composite"};
  std::array<double, 6> least{};
  least.fill(1e9);
  renderer.measure_passes(true);
  for (int i = 0; i < frames; ++i) {
    draw(renderer, snapshot);
    for (std::size_t k = 0; k < 6; ++k) least[k] = std::min(least[k], renderer.pass_seconds()[k]);
  }
  for (std::size_t k = 0; k < 6; ++k) std::printf("%-11s %6.2f ms\n", kNames[k], least[k] * 1000);
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 3 && argc != 6) {
    std::fputs("usage: render_bench LOG STEP [WIDTH HEIGHT SAMPLES]\n", stderr);
    return 2;
  }
  const Clock::time_point start = Clock::now();
  render::Settings settings;
  if (argc == 6) settings = {std::atoi(argv[3]), std::atoi(argv[4]), std::atoi(argv[5]), {}};
  Result<replay::LogReader> log = replay::LogReader::open(argv[1]);
  if (!log.ok()) return fail(log.error());
  const Result<replay::Picture> picture = replay::PictureSource(*log).read(std::strtoull(argv[2], nullptr, 10));
  if (!picture.ok()) return fail(picture.error());
  const Result<std::unique_ptr<render::Renderer>> renderer = render::Renderer::create(settings);
  if (!renderer.ok()) return fail(renderer.error());
  if (const auto first = (*renderer)->draw(picture->snapshot); !first.ok()) return fail(first.error());
  std::printf("%zu boxes, %d x %d, %d samples\nfirst image %6.2f ms after the start\n", picture->snapshot.boxes.size(),
              settings.width, settings.height, settings.samples, seconds_since(start) * 1000);
  print_frames(**renderer, picture->snapshot, 20);
  print_passes(**renderer, picture->snapshot, 20);
  return 0;
}

#include "tools/output/frames.h"

#include <algorithm>
#include <string>
#include <utility>

#include "src/base/check.h"

namespace tumble::tools {

using replay::Picture;

std::vector<Frame> frames_of_states(std::uint64_t first, std::uint64_t last, std::uint64_t every) {
  SIM_CHECK(every > 0);
  std::vector<Frame> frames;
  for (std::uint64_t k = first; k <= last; k += every) frames.push_back({k, 1});
  return frames;
}

namespace {

// Told before memory is: a slow speed, or a pause that a log claims, may mean any number.
Error too_many_frames(const char* options) {
  return bad_input(std::string(options) + ": found more than " + std::to_string(kFilmFramesMax) +
                   " frames, wanted at most so many");
}

}  // namespace

Result<std::vector<Frame>> frames_in_time(replay::LogReader& log, std::uint64_t first, std::uint64_t last,
                                          double seconds_each) {
  SIM_CHECK(seconds_each >= 0, seconds_each);
  constexpr double kSameMoment = 1e-6;  // of a step: times are sums, which round
  std::vector<Frame> frames = {{first, 1}};
  double end = 0;  // of step k, from state `first` on, s
  for (std::uint64_t k = first + 1; k <= last; ++k) {
    const Result<const replay::StepRecord*> record = log.read_hashes(k);
    if (!record.ok()) return record.error();
    const double dt = (*record)->dt, start = end;
    end += dt;
    for (double at = static_cast<double>(frames.size()) * seconds_each; at <= end + dt * kSameMoment;
         at = static_cast<double>(frames.size()) * seconds_each) {
      if (frames.size() == kFilmFramesMax) return too_many_frames("--speed, --fps");
      const double part = (at - start) / dt;
      frames.push_back({k, part > 1 - kSameMoment ? 1 : part});
    }
  }
  return frames;
}

namespace {

struct SeenAt {
  double time = 0;  // s
  Frame frame;
};

Result<std::vector<SeenAt>> views_of(replay::LogReader& log, std::uint64_t first, std::uint64_t last) {
  std::vector<SeenAt> views;
  for (std::uint64_t k = first + 1; k <= last; ++k) {
    const Result<const replay::StepRecord*> record = log.read_hashes(k);
    if (!record.ok()) return record.error();
    for (const replay::View& view : (*record)->extras.views) {
      const Result<render::Effects> effects = render::parse_effects(view.effects.empty() ? "all" : view.effects);
      if (!effects.ok()) return damaged(log.name() + ": step " + std::to_string(k) + ": " + effects.error().message);
      const Frame frame = view.part > 0 ? Frame{k, view.part} : Frame{k - 1, 1};
      views.push_back({view.wall_time, {frame.step, frame.part, Seen{view.camera, *effects}}});
    }
  }
  return views;
}

}  // namespace

Result<std::vector<Frame>> frames_as_seen(replay::LogReader& log, std::uint64_t first, std::uint64_t last,
                                          double seconds_each) {
  SIM_CHECK(seconds_each > 0, seconds_each);
  const Result<std::vector<SeenAt>> views = views_of(log, first, last);
  if (!views.ok()) return views.error();
  if (views->empty()) {
    return bad_input("--as-seen: " + log.name() +
                     " has no views; only sessions of 'tumble live' have, and only steps " +
                     "that were taken while a window showed them");
  }
  std::vector<Frame> frames;
  std::size_t at = 0;
  const double begin = views->front().time, end = std::max(begin, views->back().time);
  for (double time = begin; time <= end; time = begin + static_cast<double>(frames.size()) * seconds_each) {
    if (frames.size() == kFilmFramesMax) return too_many_frames("--as-seen, --fps");
    while (at + 1 < views->size() && (*views)[at + 1].time <= time) ++at;
    frames.push_back((*views)[at].frame);
  }
  return frames;
}

FrameMaker::FrameMaker(replay::LogReader& log, replay::LogReader* other, replay::PictureOptions options)
    : options_(std::move(options)), ours_(log) {
  if (other != nullptr) theirs_.emplace(*other);
}

Result<const Picture*> FrameMaker::read(Source& source, std::uint64_t step) const {
  for (const std::optional<Picture>* kept : {&source.newer, &source.older}) {
    if (*kept && (*kept)->step == step) return &**kept;
  }
  Result<Picture> picture = source.pictures.read(step, options_);
  if (!picture.ok()) return picture.error();
  source.older = std::exchange(source.newer, *std::move(picture));
  return &*source.newer;
}

Result<Picture> FrameMaker::make_of(Source& source, const Frame& frame) const {
  if (frame.is_state()) {
    const Result<const Picture*> picture = read(source, frame.step);
    if (!picture.ok()) return picture.error();
    return **picture;
  }
  const Result<const Picture*> found = read(source, frame.step - 1);
  if (!found.ok()) return found.error();
  const render::Snapshot before = (*found)->snapshot;
  const Result<const Picture*> after = read(source, frame.step);
  if (!after.ok()) return after.error();
  Picture picture = **after;
  picture.snapshot = render::between(before, picture.snapshot, frame.part, picture.dt);
  return picture;
}

Result<Picture> FrameMaker::make(const Frame& frame) {
  Result<Picture> picture = make_both(frame);
  if (picture.ok() && frame.seen) picture->snapshot.camera = frame.seen->camera;
  return picture;
}

Result<Picture> FrameMaker::make_both(const Frame& frame) {
  SIM_CHECK(frame.part > 0 && frame.part <= 1, frame.step, frame.part);
  Result<Picture> picture = make_of(ours_, frame);
  if (!picture.ok() || !theirs_) return picture;
  const Result<Picture> other = make_of(*theirs_, frame);
  if (!other.ok()) return other.error();
  picture->snapshot = replay::overlay(picture->snapshot, other->snapshot);
  if (!picture->not_finite) picture->not_finite = other->not_finite;
  return picture;
}

}  // namespace tumble::tools

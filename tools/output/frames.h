#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "replay/picture/picture_source.h"
#include "tumble/render/renderer.h"
#include "tumble/sim/result.h"

/// The moments of a session that are drawn, and their pictures.
namespace tumble::tools {

/// What a moment was seen with, in a session that was played.
struct Seen {
  sim::Camera camera;
  render::Effects effects;
};

/// A moment: `part` (above 0, up to 1) of the way from state step − 1 to state `step`. 1 is the state itself.
struct Frame {
  std::uint64_t step = 0;
  double part = 1;
  std::optional<Seen> seen = {};  ///< instead of the camera and the effects of all frames
  [[nodiscard]] bool is_state() const { return part == 1; }
};

/// States first, first + every, … up to last.
std::vector<Frame> frames_of_states(std::uint64_t first, std::uint64_t last, std::uint64_t every);

/// The most frames of a movie.
inline constexpr std::uint64_t kFilmFramesMax = 1'000'000;

/// Moments that are `seconds_each` of simulated time apart, from state first to state last. Errors (kBadInput): more
/// than kFilmFramesMax; the log's.
Result<std::vector<Frame>> frames_in_time(replay::LogReader& log, std::uint64_t first, std::uint64_t last,
                                          double seconds_each);

/// Moments of a played session as its window showed them, `seconds_each` apart on the clock of the one who played, with
/// pauses, slow motion, camera and effects. Errors (kBadInput): no view in the log; more than
/// kFilmFramesMax; the log's.
Result<std::vector<Frame>> frames_as_seen(replay::LogReader& log, std::uint64_t first, std::uint64_t last,
                                          double seconds_each);

/// Snapshots of a log's frames, alone or laid over those of another log.
class FrameMaker {
 public:
  /// The logs must outlive it; `other` may be null.
  FrameMaker(replay::LogReader& log, replay::LogReader* other, replay::PictureOptions options);

  /// A picture at the frame; its state hash is the one of `frame.step`. Errors: PictureSource::read's.
  Result<replay::Picture> make(const Frame& frame);

 private:
  // The pictures of a log. The last two are kept, for interpolation asks for each twice.
  struct Source {
    replay::PictureSource pictures;
    std::optional<replay::Picture> newer, older;
    explicit Source(replay::LogReader& log) : pictures(log) {}
  };
  Result<const replay::Picture*> read(Source& source, std::uint64_t step) const;
  Result<replay::Picture> make_both(const Frame& frame);
  Result<replay::Picture> make_of(Source& source, const Frame& frame) const;

  replay::PictureOptions options_;
  Source ours_;
  std::optional<Source> theirs_;
};

}  // namespace tumble::tools

#pragma once

#include <cstdint>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "tumble/replay/body_table.h"
#include "tumble/replay/channel.h"
#include "tumble/replay/step_record.h"

/// What a golden keeps of the channels and contacts of another engine's session.
namespace tumble::golden {

/// The values of a channel in one state.
struct KeptValues {
  std::uint64_t step = 0;
  replay::ChannelValues values;
  friend bool operator==(const KeptValues&, const KeptValues&) = default;
};

struct ExpectedChannel {
  replay::Channel channel;
  std::vector<std::uint32_t> hashes;  ///< of states 0 … N: hash_of_values()
  std::vector<KeptValues> values;     ///< ascending step: of all states where they are few
  friend bool operator==(const ExpectedChannel&, const ExpectedChannel&) = default;
};

struct ExpectedExtras {
  std::vector<ExpectedChannel> channels;      ///< ascending names
  std::vector<std::uint32_t> contact_hashes;  ///< of states 0 … N; empty: no state has a contact
  friend bool operator==(const ExpectedExtras&, const ExpectedExtras&) = default;
};

/// A body that is no box.
struct BodyShape {
  sim::BodyId id = 0;
  Hash128 shape;
  std::string text;  ///< for people: "sphere of radius 0.5 m"
  friend bool operator==(const BodyShape&, const BodyShape&) = default;
};

/// Collects the shapes of a session of another engine: of the bodies of the start, and of those that appear in a step.
class ShapesKeeper {
 public:
  explicit ShapesKeeper(const replay::LogHeader& header);
  void add(const replay::StepRecord& record);
  /// Ascending ids; none for a session of Tumble, whose bodies are boxes.
  [[nodiscard]] std::optional<std::vector<BodyShape>> shapes() const;
  /// Every body of the session.
  [[nodiscard]] const std::set<sim::BodyId>& ids() const { return ids_; }
  [[nodiscard]] const replay::BodyTable& names() const { return bodies_; }

 private:
  bool is_engine_;
  replay::BodyTable bodies_;
  std::set<sim::BodyId> ids_;
  std::vector<sim::BodyId> last_;  // of the step before: ids change seldom
};

struct Expected;

/// The bodies whose shapes are not those of the golden, a sentence each: "another shape: body 4: expected sphere of
/// radius 0.5 m, actual box", "body 100 is not in the golden". At most six, and one that counts the rest. Empty for a
/// golden or a session without shapes.
std::vector<std::string> other_shapes(const Expected& expected, const ShapesKeeper& actual);

/// Low half of XXH3-128's low word; 0 without a value. A whole number has one hash, whether its kind is an integer or a
/// double: a table's column may be either.
std::uint32_t hash_of_values(const replay::ChannelValues& values, replay::ChannelKind kind);

/// Collects them from a session: state 0, then every step in order.
class ExtrasKeeper {
 public:
  explicit ExtrasKeeper(const std::vector<replay::Channel>& channels);
  void add(const replay::StepRecord& record);
  ExpectedExtras finish();

 private:
  void thin_out();

  ExpectedExtras extras_;
  bool any_contact_ = false;
  std::uint64_t stride_ = 1;  // values are kept of the steps that it divides
  std::size_t bytes_ = 0;     // of the values kept
};

/// Compares the channels and contacts of a session with a golden's, step by step.
class ExtrasComparer {
 public:
  /// Both must outlive this.
  ExtrasComparer(const ExpectedExtras& expected, const std::vector<replay::Channel>& channels);

  /// The fields of a step that differ, by name; the contacts last.
  [[nodiscard]] std::vector<std::string> differing(const replay::StepRecord& record) const;

  /// Both values of a field, where the golden keeps that step's and they differ: "at step 12, channel.knee of body 2
  /// (shin): expected 0.22, actual 0.2200001 (3602879702 ULPs apart)". Else empty.
  [[nodiscard]] std::string detail(const std::string& field, const replay::StepRecord& record,
                                   const replay::BodyTable& names) const;

  /// The golden's channels that the session lacks or has in another type, a sentence each: "channel.knee: the session
  /// has no such channel"; and inputs by name that the golden lacks. What a bound judges may be gone with them.
  [[nodiscard]] std::vector<std::string> lost() const;

  /// What is compared: "2 channels (knee, seed)", "contacts of the engine".
  [[nodiscard]] std::vector<std::string> compared() const;

 private:
  struct Pair {
    const ExpectedChannel* expected = nullptr;  // null: the golden has no such channel
    std::optional<std::size_t> actual;          // index in the session; none: the session has no such channel
    replay::Channel channel;
  };
  const ExpectedExtras& expected_;
  std::vector<replay::Channel> channels_;
  std::vector<Pair> pairs_;  // ascending names
};

}  // namespace tumble::golden

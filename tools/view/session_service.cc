#include "tools/view/session_service.h"

#include <algorithm>
#include <charconv>
#include <nlohmann/json.hpp>
#include <utility>

#include "src/base/check.h"
#include "tools/view/difference_data.h"
#include "tools/view/session_page.h"
#include "tools/view/view_json.h"
#include "tumble/replay/body_states.h"
#include "tumble/sim/limits.h"

namespace tumble::tools {
namespace {

constexpr std::uint64_t kFramesMax = 512;
constexpr std::uint64_t kAnswersMax = 100;

Reply refusal(int status, const std::string& words) { return {status, "application/json", dumped({{"error", words}})}; }

/// The whole numbers and words of a request. Notes the first that is missing or out of range.
class Numbers {
 public:
  explicit Numbers(const SessionService::Parameters& parameters) : parameters_(parameters) {}

  std::uint64_t take(const char* name, std::uint64_t most) {
    const auto found = parameters_.find(name);
    std::uint64_t number = 0;
    const std::string text = found == parameters_.end() ? "" : found->second;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
    if (text.empty() || error != std::errc() || end != text.data() + text.size() || number > most) {
      if (wrong_.empty()) wrong_ = std::string(name) + ": wanted a whole number up to " + std::to_string(most);
      return 0;
    }
    return number;
  }
  /// One of some words.
  std::string word(const char* name, const std::vector<std::string>& words) {
    const auto found = parameters_.find(name);
    if (found != parameters_.end() && std::ranges::find(words, found->second) != words.end()) return found->second;
    if (wrong_.empty()) wrong_ = std::string(name) + ": wanted one of the names that a body's numbers have";
    return "";
  }
  [[nodiscard]] const std::string& wrong() const { return wrong_; }

 private:
  const SessionService::Parameters& parameters_;
  std::string wrong_;
};

using Question = std::function<Reply(ServedLog& log, Numbers& numbers)>;

/// Wraps a question whose numbers are all taken before it is asked.
Reply json_of(const Numbers& numbers, const std::function<Json()>& ask) {
  if (!numbers.wrong().empty()) return refusal(400, numbers.wrong());
  return {200, "application/json", dumped(ask())};
}

Reply frames_of(ServedLog& log, Numbers& numbers) {
  const std::uint64_t first = numbers.take("first", sim::kStepsMax), count = numbers.take("count", kFramesMax);
  const std::uint64_t stride = numbers.take("stride", sim::kStepsMax);
  if (!numbers.wrong().empty()) return refusal(400, numbers.wrong());
  if (stride == 0) return refusal(400, "stride: wanted at least 1");
  return {200, "application/octet-stream", log.frames(first, count, stride)};
}

/// The values of a body that can be asked about.
std::vector<std::string> value_names() {
  std::vector<std::string> names(replay::kColumnNames.begin(), replay::kColumnNames.end());
  names.emplace_back("frozen");
  return names;
}

Reply blame_of(ServedLog& log, Numbers& numbers) {
  const std::uint64_t step = numbers.take("step", sim::kStepsMax), id = numbers.take("id", sim::kBodyIdMax);
  const std::uint64_t back = numbers.take("back", kAnswersMax);
  const std::string field = numbers.word("field", value_names());
  return json_of(numbers, [&] { return log.blame(step, id, field, static_cast<std::uint32_t>(back)); });
}

const std::map<std::string, Question>& questions() {
  static const std::map<std::string, Question> kQuestions = {
      {"head", [](ServedLog& log, Numbers& n) { return json_of(n, [&] { return log.head(); }); }},
      {"news", [](ServedLog& log, Numbers& n) { return json_of(n, [&] { return log.news(); }); }},
      {"bodies", [](ServedLog& log, Numbers& n) { return json_of(n, [&] { return log.bodies(); }); }},
      {"timeline",
       [](ServedLog& log, Numbers& n) {
         const std::uint64_t from = n.take("from", sim::kStepsMax);
         return json_of(n, [&] { return log.timeline(from); });
       }},
      {"begun",
       [](ServedLog& log, Numbers& n) {
         const std::uint64_t from = n.take("from", sim::kStepsMax);
         return json_of(n, [&] { return log.begun(from); });
       }},
      {"frames", frames_of},
      {"contacts",
       [](ServedLog& log, Numbers& n) {
         const std::uint64_t step = n.take("step", sim::kStepsMax);
         return json_of(n, [&] { return log.contacts(step); });
       }},
      {"body",
       [](ServedLog& log, Numbers& n) {
         const std::uint64_t step = n.take("step", sim::kStepsMax), id = n.take("id", sim::kBodyIdMax);
         return json_of(n, [&] { return log.body(step, id); });
       }},
      {"blame", blame_of},
      {"history",
       [](ServedLog& log, Numbers& n) {
         const std::uint64_t id = n.take("id", sim::kBodyIdMax), from = n.take("from", sim::kStepsMax);
         return json_of(n, [&] { return log.history(id, from); });
       }},
      {"channel",
       [](ServedLog& log, Numbers& n) {
         if (log.channels() == 0) return refusal(400, "channel: the log has no channels of numbers");
         const std::uint64_t channel = n.take("channel", log.channels() - 1), from = n.take("from", sim::kStepsMax);
         const replay::ChannelKey owner{n.take("a", sim::kBodyIdMax), n.take("b", sim::kBodyIdMax)};
         return json_of(n, [&] { return log.channel(channel, owner, from); });
       }},
      {"way",
       [](ServedLog& log, Numbers& n) {
         const std::uint64_t id = n.take("id", sim::kBodyIdMax);
         return json_of(n, [&] { return log.way(id); });
       }},
  };
  return kQuestions;
}

}  // namespace

SessionService::SessionService(std::vector<replay::LogReader> logs, const std::vector<replay::ViewedBound>& bounds) {
  for (const replay::ViewedBound& bound : bounds) bounds_.push_back(printable(bound.bound.text));
  SIM_CHECK(!logs.empty() && logs.size() <= 2, logs.size());
  for (replay::LogReader& log : logs) {
    paths_.push_back(log.name());
    logs_.push_back(std::make_unique<ServedLog>(std::move(log), bounds));
  }
  if (logs_.size() < 2) return;
  thread_ = std::thread([this] { compare(); });
}

SessionService::~SessionService() {
  stop_ = true;
  if (thread_.joinable()) thread_.join();
}

void SessionService::compare() {
  const auto compared = [this]() -> Result<Json> {
    Result<replay::LogReader> a = replay::LogReader::open(paths_[0]);
    if (!a.ok()) return a.error();
    Result<replay::LogReader> b = replay::LogReader::open(paths_[1]);
    if (!b.ok()) return b.error();
    return difference_data(*a, *b, [this](std::uint64_t done, std::uint64_t total) {
      const std::lock_guard lock(found_);
      compared_ = total == 0 ? 0.0 : static_cast<double>(done) / static_cast<double>(total);
      return !stop_;
    });
  };
  Result<Json> found = compared();
  const std::lock_guard lock(found_);
  difference_ = dumped(found.ok() ? *found : Json{{"state", "failed"}, {"why", printable(found.error().message)}});
}

std::string SessionService::difference() {
  const std::lock_guard lock(found_);
  return difference_.empty() ? dumped({{"state", "working"}, {"done", compared_}}) : difference_;
}

Reply SessionService::page() {
  SessionPage page;
  page.head = {{"mode", "served"}, {"bounds", bounds_}, {"logs", Json::array()}};
  for (const auto& log : logs_) page.head["logs"].push_back(log->head());
  return {200, "text/html; charset=utf-8", page.html()};
}

Reply SessionService::answer(const std::string& path, const Parameters& parameters) {
  if (path.empty()) return page();
  if (path == "difference") return {200, "application/json", difference()};
  const auto question = questions().find(path);
  if (question == questions().end()) return refusal(404, "there is nothing here");
  Numbers numbers(parameters);
  const std::uint64_t which = numbers.take("log", logs_.size() - 1);
  if (!numbers.wrong().empty()) return refusal(400, numbers.wrong());
  return question->second(*logs_[which], numbers);
}

}  // namespace tumble::tools

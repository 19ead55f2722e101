#include "tools/bisect/ask_all.h"

#include <chrono>
#include <thread>
#include <utility>

#include "src/base/check.h"
#include "tools/bisect/asked_sessions.h"

namespace tumble::tools::bisect {

AskAll::Part::Part(const Settings& settings, const Workplace& all, std::uint64_t k, const BuildCache* cache,
                   const Asker::Cancel& cancel)
    : place(all.part(k)),
      git(settings.repository, place.file("")),
      asker(settings, place, git, cache, settings.jobs > 1, cancel) {}

AskAll::AskAll(const Settings& settings, const Workplace& place, Asker::Cancel cancel)
    : settings_(settings), place_(place), cancel_(std::move(cancel)) {}

Status AskAll::prepare() {
  if (!settings_.cache.empty()) {
    Result<BuildCache> cache = BuildCache::open(settings_);
    if (!cache.ok()) return cache.error();
    cache_ = *std::move(cache);
  }
  return add_part();
}

Status AskAll::add_part() {
  const auto ended = [this] { return failed_.load() || (cancel_ && cancel_()); };
  parts_.push_back(
      std::make_unique<Part>(settings_, place_, parts_.size(), cache_ ? &*cache_ : nullptr, Asker::Cancel(ended)));
  return parts_.back()->asker.prepare();
}

Result<std::vector<Asked>> AskAll::ask(const std::vector<std::string>& commits) {
  SIM_CHECK(commits.size() <= settings_.jobs, commits.size(), settings_.jobs);
  while (parts_.size() < commits.size()) {
    if (Status ok = add_part(); !ok.ok()) return ok.error();
  }
  std::vector<Asked> answers(commits.size());
  std::vector<std::optional<Error>> errors(commits.size());
  const auto work = [&](std::size_t k) {
    const auto begin = std::chrono::steady_clock::now();
    Result<Answer> answer = parts_[k]->asker.ask(commits[k]);
    answers[k].seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
    if (answer.ok()) {
      answers[k].answer = *std::move(answer);
    } else {
      if (!failed_.exchange(true)) errors[k] = answer.error();
    }
  };
  {
    std::vector<std::jthread> others;
    for (std::size_t k = 1; k < commits.size(); ++k) others.emplace_back(work, k);
    if (!commits.empty()) work(0);
  }
  for (const std::optional<Error>& error : errors) {
    if (error) return *error;
  }
  return answers;
}

Status AskAll::ask_again(const std::string& commit, Answer& answer) {
  if (settings_.asks > 1) return {};
  AskedSessions sessions(place_.session(commit), "first");  // ask() itself keeps others
  sessions.add();
  const Result<std::vector<Asked>> asked = ask({commit});
  if (!asked.ok()) return asked.error();
  sessions.add();
  sessions.keep(0);
  answer.sessions_differ = sessions.difference();
  const Answer& again = asked->front().answer;
  if (again.asked != answer.asked || again.yes != answer.yes) {
    answer.not_repeatable = "the first time: " + answer.message + "; the second time: " + again.message;
  }
  return {};
}

}  // namespace tumble::tools::bisect

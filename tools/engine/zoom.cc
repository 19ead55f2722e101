#include "tools/engine/zoom.h"

#include <algorithm>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <optional>
#include <system_error>
#include <utility>
#include <vector>

#include "golden/engine/engine_run.h"
#include "golden/suite/temporary_folder.h"
#include "src/process/interrupt.h"
#include "tools/engine/engine_session.h"
#include "tools/files/log_files.h"
#include "tumble/replay/compare.h"

namespace tumble::tools {
namespace {

namespace fs = std::filesystem;

/// One run with probes.
struct Probed {
  replay::ProbeFile probes;
  std::string command;
  std::string stray;
};

std::string this_program() {
  std::error_code error;
  return fs::read_symlink("/proc/self/exe", error).string();
}

/// "--engine-b: found …".
Error no_engine(const char* option, const std::string& found) {
  return bad_input(
      std::string(option) + ": " +
      found_wanted(in_quotes(found), "a folder with a tumble.toml, that file, or a command line with {log}"));
}

Result<golden::EngineProject> project_of(const replay::LogReader& log, const std::string& given, const char* option) {
  if (given.empty()) return project_for(log);
  std::error_code error;
  if (fs::is_directory(given, error)) {
    const fs::path file = fs::path(given) / golden::kProjectFile;
    return fs::exists(file, error) ? golden::read_project(file)
                                   : Result<golden::EngineProject>(no_engine(option, given));
  }
  if (fs::is_regular_file(given, error)) return golden::read_project(given);
  if (given.find("{log}") == std::string::npos) return no_engine(option, given);
  return golden::project_of_command(given, fs::current_path(error), false);
}

/// Where the new session of a program first differs from its log, if that is before `step` is over.
Result<std::string> stray_of(replay::LogReader& log, const std::string& session, std::uint64_t step) {
  Result<replay::LogReader> again = open_log(session);
  if (!again.ok()) return again.error();
  const Result<replay::DiffReport> report = replay::diff_logs(log, *again, {}, {}, replay::Reading::kHashes);
  if (!report.ok()) return report.error();
  if (!report->first || report->first->step > step) return std::string();
  return replay::describe(*report->first);
}

Result<Probed> probe_engine(replay::LogReader& log, const golden::EngineProject& project, std::uint64_t step,
                            const fs::path& folder) {
  EngineSessionOptions how;
  how.probed = ProbedStep{step, (folder / "probes").string()};
  Result<EngineSession> session = run_engine_session(log, project, how, folder);
  if (!session.ok()) return session.error();
  Result<replay::ProbeFile> probes = replay::read_probes(how.probed->file);
  if (!probes.ok()) {
    std::error_code error;
    if (fs::exists(how.probed->file, error)) return probes.error();
    return bad_input("the engine's command \"" + project.run +
                     "\" wrote no probes: wanted tumble_probes_from_environment() in the engine, and "
                     "tumble_probes_step() before each step (docs/zoom.md)");
  }
  Result<std::string> stray = stray_of(log, session->log, step);
  if (!stray.ok()) return stray.error();
  return Probed{*std::move(probes), session->command, *std::move(stray)};
}

/// A build of this program takes the step again from the log's own state, so it cannot stray before.
Result<Probed> probe_ours(const replay::LogReader& log, const std::string& program, std::uint64_t step,
                          const fs::path& folder) {
  const std::string file = (folder / "probes").string();
  process::Program task;
  task.words = {program, "replay", log.name(), "--probes", file, "--probe-step", std::to_string(step)};
  task.out = task.err = (folder / "output.txt").string();
  const Result<process::ChildEnd> end =
      process::run_child(task, 0, [] { return process::InterruptGuard::interrupted(); });
  if (!end.ok()) return end.error();
  if (end->stopped) return cannot_finish("interrupted");
  if (!end->well()) return cannot_finish(program + " " + end->text() + golden::end_of_output(task.out));
  Result<replay::ProbeFile> probes = replay::read_probes(file);
  if (!probes.ok()) return probes.error();
  return Probed{*std::move(probes), golden::engine_words_text(task.words), ""};
}

Result<Probed> probe(replay::LogReader& log, const std::string& given, const char* option, std::uint64_t step,
                     const fs::path& folder) {
  std::error_code error;
  fs::create_directory(folder, error);
  if (!log.header().engine) return probe_ours(log, given.empty() ? this_program() : given, step, folder);
  const Result<golden::EngineProject> project = project_of(log, given, option);
  if (!project.ok()) return project.error();
  return probe_engine(log, *project, step, folder);
}

Status check_probes(const replay::ProbeFile& file, const std::string& command, std::uint64_t step) {
  if (!file.probes.empty()) return {};
  return bad_input("no probe in step " + std::to_string(step) + ": " +
                   (file.cut.empty() ? "the step passes none" : file.cut) + "; command: " + command);
}

/// The step to compute again. Where inputs are the first difference, nothing was computed otherwise yet: the step is
/// the next one whose phases or state have another hash.
Result<std::uint64_t> step_to_zoom(replay::LogReader& a, replay::LogReader& b, const replay::Divergence& first) {
  if (first.phase != "inputs") return first.step;
  const std::uint64_t last = std::min(a.last_step(), b.last_step());
  for (std::uint64_t k = first.step; k <= last; ++k) {
    if (!a.holds(k) || !b.holds(k)) continue;
    const Result<const replay::StepRecord*> in_a = a.read_hashes(k);
    if (!in_a.ok()) return in_a.error();
    const Result<const replay::StepRecord*> in_b = b.read_hashes(k);
    if (!in_b.ok()) return in_b.error();
    const bool by_phase = replay::same_phase_words(a.header(), b.header(), k);
    if ((*in_a)->state_hash != (*in_b)->state_hash) return k;
    if (by_phase && (*in_a)->phase_words != (*in_b)->phase_words) return k;
  }
  return bad_input(
      "--zoom: the sessions differ in their inputs alone: no state and no phase has another hash, so no "
      "line computed another value");
}

}  // namespace

Result<Zoom> zoom_into(replay::LogReader& a, replay::LogReader& b, const replay::Divergence& first,
                       const ZoomPrograms& programs) {
  const Result<std::uint64_t> found = step_to_zoom(a, b, first);
  if (!found.ok()) return found.error();
  const std::uint64_t step = *found;
  if (step <= a.first_state() || step <= b.first_state()) {
    return bad_input("--zoom: the sessions differ at their start, before any step that could write probes");
  }
  if (step > a.last_step() || step > b.last_step()) {
    return bad_input("--zoom: one log ends before step " + std::to_string(step) + ", in which the other goes on");
  }
  const golden::TemporaryFolder folder("tumble-zoom");
  if (folder.path().empty()) return cannot_finish("--zoom: no temporary folder");
  Result<Probed> in_a = probe(a, programs.a, "--engine-a", step, folder.path() / "a");
  if (!in_a.ok()) return in_a.error();
  Result<Probed> in_b = probe(b, programs.b, "--engine-b", step, folder.path() / "b");
  if (!in_b.ok()) return in_b.error();
  if (Status ok = check_probes(in_a->probes, in_a->command, step); !ok.ok()) return ok.error();
  if (Status ok = check_probes(in_b->probes, in_b->command, step); !ok.ok()) return ok.error();
  Zoom zoom;
  zoom.step = step;
  zoom.after_inputs = step != first.step;
  zoom.compared = replay::compare_probes(in_a->probes, in_b->probes);
  zoom.a = std::move(in_a->probes);
  zoom.b = std::move(in_b->probes);
  zoom.command_a = std::move(in_a->command);
  zoom.command_b = std::move(in_b->command);
  zoom.stray_a = std::move(in_a->stray);
  zoom.stray_b = std::move(in_b->stray);
  return zoom;
}

}  // namespace tumble::tools

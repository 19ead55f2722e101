#include "tumble/replay/step_record.h"

#include <algorithm>
#include <charconv>

#include "replay/format/limits.h"
#include "tumble/replay/prelude.h"

#ifndef TUMBLE_VERSION
#error "TUMBLE_VERSION comes from replay/CMakeLists.txt"
#endif

namespace tumble::replay {
namespace {

std::string compiler() {
#if defined(__clang__)
  return "clang " __clang_version__;
#elif defined(__GNUC__)
  return "g++ " __VERSION__;
#else
  return "unknown compiler";
#endif
}

}  // namespace

Result<StatesMode> parse_states_mode(const std::string& text) {
  if (text == "all") return StatesMode{1};
  if (text == "hashes") return StatesMode{0};
  const std::string prefix = "every:";
  if (text.rfind(prefix, 0) == 0) {
    std::uint32_t every = 0;
    const char* end = text.data() + text.size();
    const auto [stop, error] = std::from_chars(text.data() + prefix.size(), end, every);
    if (error == std::errc() && stop == end && every >= 1) return StatesMode{every};
  }
  return bad_input("states: found \"" + text + "\", wanted all, every:N (N from 1) or hashes");
}

std::string to_string(const StatesMode& mode) {
  if (mode.every == 0) return "hashes";
  return mode.every == 1 ? "all" : "every:" + std::to_string(mode.every);
}

std::string to_string(const MissingSteps& run) {
  if (run.step_count == 1) return "step " + std::to_string(run.first_step);
  return "steps " + std::to_string(run.first_step) + " to " + std::to_string(run.end_step() - 1);
}

std::uint64_t step_after(std::uint64_t end, const std::vector<MissingSteps>& missing) {
  const auto run = std::ranges::lower_bound(missing, end, {}, &MissingSteps::first_step);
  return run != missing.end() && run->first_step == end ? run->end_step() : end;
}

const std::vector<MissingSteps>& LogHeader::missing() const {
  static const std::vector<MissingSteps> kNone;
  return recovered ? recovered->missing : kNone;
}

bool same_phase_words(const LogHeader& a, const LogHeader& b) {
  return a.phases == b.phases && a.phase_rows_max == b.phase_rows_max && a.phase_hash_version == b.phase_hash_version;
}

void leave_out_phase_words(const StepRecord& of, StepRecord& record) {
  record.phase_words = of.phase_words;
  record.counters.contacts = of.counters.contacts;
}

std::string phase_hash_note(const LogHeader& a, const LogHeader& b) {
  if (a.phase_hash_version == b.phase_hash_version) return "";
  return "phase hashes: version " + std::to_string(a.phase_hash_version) + " and " +
         std::to_string(b.phase_hash_version) +
         ", which cover different fields; phase words and contact counts were not compared, all else was";
}

const char* name_of(sim::Method method) {
  switch (method) {
    case sim::Method::kThesis:
      return "thesis";
    case sim::Method::kLayered:
      return "layered";
  }
  return "unknown";
}

std::string to_string(const EngineName& engine) {
  return engine.name + (engine.version.empty() ? "" : " " + engine.version);
}

LogHeader header_for(const sim::SceneDef& scene) {
  LogHeader header;
  header.format_major = kFormatMajor;
  header.format_minor = kFormatMinor;
  header.tool_version = TUMBLE_VERSION;
  header.tool_build = compiler();
  header.method = name_of(scene.world.method);
  header.method_version = sim::method_version(scene.world.method);
  for (const sim::Phase& phase : sim::phase_table(scene.world.method).phases) header.phases.emplace_back(phase.name);
  header.phase_rows_max = sim::PhaseHashes::kRowsMax;
  header.phase_hash_version = sim::PhaseHashes::kVersion;
  header.scene = scene;
  header.chunk_steps_max = kChunkStepsMax;
  header.chunk_bytes_max = kChunkStateBytes;
  return header;
}

}  // namespace tumble::replay

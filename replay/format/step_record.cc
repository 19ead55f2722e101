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

/// "all" is 1, "every:N" is N, the word `none` is 0.
std::optional<std::uint32_t> parse_every(const std::string& text, const char* none) {
  if (text == "all") return 1;
  if (text == none) return 0;
  const std::string prefix = "every:";
  std::uint32_t every = 0;
  if (!text.starts_with(prefix)) return std::nullopt;
  const char* end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data() + prefix.size(), end, every);
  if (error != std::errc() || stop != end || every == 0) return std::nullopt;
  return every;
}

std::string every_text(std::uint32_t every, const char* none) {
  if (every == 0) return none;
  return every == 1 ? "all" : "every:" + std::to_string(every);
}

}  // namespace

Result<StatesMode> parse_states_mode(const std::string& text) {
  if (const std::optional<std::uint32_t> every = parse_every(text, "hashes")) return StatesMode{*every};
  return bad_input("states: found \"" + text + "\", wanted all, every:N (N from 1) or hashes");
}

std::string to_string(const StatesMode& mode) { return every_text(mode.every, "hashes"); }

Result<HashesMode> parse_hashes_mode(const std::string& text) {
  if (const std::optional<std::uint32_t> every = parse_every(text, "states")) return HashesMode{*every};
  return bad_input("hashes: found \"" + text + "\", wanted all, every:N (N from 1) or states");
}

std::string to_string(const HashesMode& mode) { return every_text(mode.every, "states"); }

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

bool same_phase_words(const LogHeader& a, const LogHeader& b, std::uint64_t step) {
  return same_phase_words(a, b) && a.hashes.holds(step) && b.hashes.holds(step);
}

void leave_out_phase_words(const LogHeader& a, const LogHeader& b, const StepRecord& of, StepRecord& record) {
  if (!same_phase_words(a, b)) record.counters.contacts = of.counters.contacts;
  if (!same_phase_words(a, b, of.step)) record.phase_words = of.phase_words;
}

std::string phase_hash_note(const LogHeader& a, const LogHeader& b) {
  if (a.phase_hash_version == b.phase_hash_version) return "";
  return "phase hashes: version " + std::to_string(a.phase_hash_version) + " and " +
         std::to_string(b.phase_hash_version) +
         ", which cover different fields; phase words and contact counts were not compared, all else was";
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

TableSettings precision_settings(const LogHeader& header) {
  if (!header.engine || header.engine->precision_bits != kBinary32Bits) return {};
  return {{"precision", "float32"}, {"cells", "float64"}};  // the log keeps doubles
}

std::string derived_columns(const Declared& declared) {
  std::string names = declared.velocity_derived ? "velocity" : "";
  if (declared.spin_derived) names += names.empty() ? "spin" : " spin";
  return names;
}

std::string setting_lines(const TableSettings& settings) {
  std::string lines;
  for (const auto& [key, value] : settings) lines.append("# ").append(key).append(": ").append(value).append("\n");
  return lines;
}

}  // namespace tumble::replay

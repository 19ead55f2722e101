#include "replay/import/csv/csv_format.h"

#include <algorithm>
#include <map>
#include <string_view>
#include <utility>

#include "replay/format/limits.h"
#include "replay/import/shape_text.h"
#include "src/base/text.h"

namespace tumble::replay {
namespace {

/// A key, the values that it accepts, and the function that stores a value.
struct Key {
  const char* name;
  const char* wanted;
  bool (*take)(const std::string& value, CsvSettings& out);
};

constexpr std::array kKeys = {
    Key{"engine", "a name", [](const std::string& v, CsvSettings& out) { return !(out.engine.name = v).empty(); }},
    Key{"version", "a text",
        [](const std::string& v, CsvSettings& out) {
          out.engine.version = v;
          return true;
        }},
    Key{"scene", "a name", [](const std::string& v, CsvSettings& out) { return !(out.scene.name = v).empty(); }},
    Key{"precision", "float32 or float64",
        [](const std::string& v, CsvSettings& out) {
          out.engine.precision_bits = v == "float32" ? kBinary32Bits : kBinary64Bits;
          return v == "float32" || v == "float64";
        }},
    Key{"up", "x, y or z",
        [](const std::string& v, CsvSettings& out) {
          if (v != "x" && v != "y" && v != "z") return false;
          out.axes.up = v[0] - 'x';
          return true;
        }},
    Key{"handed", "right or left",
        [](const std::string& v, CsvSettings& out) {
          out.axes.left_handed = v == "left";
          return v == "left" || v == "right";
        }},
    Key{"length", "m, cm, mm or a number of metres > 0",
        [](const std::string& v, CsvSettings& out) {
          double& metres = out.axes.metres;
          if (v == "m" || v == "cm" || v == "mm") {
            metres = v == "m" ? 1 : (v == "cm" ? 0.01 : 0.001);
            return true;
          }
          return take_number(v, metres) && metres > 0;
        }},
    Key{"euler", "three axes, as in XYZ (about the body's axes) or xyz (about the world's)",
        [](const std::string& v, CsvSettings& out) {
          const std::optional<EulerOrder> order = parse_euler(v);
          out.euler = order.value_or(EulerOrder());
          return order.has_value();
        }},
    Key{"angles", "degrees or radians",
        [](const std::string& v, CsvSettings& out) {
          out.radians = v == "radians";
          return v == "radians" || v == "degrees";
        }},
    Key{"cells", "float64", [](const std::string& v, CsvSettings& out) { return out.wide_cells = v == "float64"; }},
    Key{"derived", "velocity, spin or both",
        [](const std::string& v, CsvSettings& out) {
          out.velocity_derived = v == "velocity spin" || v == "velocity";
          out.spin_derived = v == "velocity spin" || v == "spin";
          return out.velocity_derived || out.spin_derived;
        }},
    Key{"kinds", "float64, float32, int64, uint64 or text for each channel, in the order of their columns",
        [](const std::string& v, CsvSettings& out) { return !(out.kinds = parse_kinds(v)).empty(); }},
    Key{"dt", "a number of seconds > 0",
        [](const std::string& v, CsvSettings& out) { return take_number(v, out.dt.emplace()) && *out.dt > 0; }},
    Key{"gravity", "three numbers",
        [](const std::string& v, CsvSettings& out) { return take_vector(v, out.scene.world.gravity); }},
    Key{"ground", "yes or no",
        [](const std::string& v, CsvSettings& out) {
          out.scene.world.ground = v == "yes";
          return v == "yes" || v == "no";
        }},
    Key{"size", "three numbers above 0",
        [](const std::string& v, CsvSettings& out) {
          sim::Vec3& size = out.box.size;
          return take_vector(v, size) && size.x() > 0 && size.y() > 0 && size.z() > 0;
        }},
    Key{"mass", "a number of kg", [](const std::string& v, CsvSettings& out) { return take_number(v, out.box.mass); }},
    Key{"friction", "a number",
        [](const std::string& v, CsvSettings& out) {
          const bool taken = take_number(v, out.box.material.friction);
          out.box.material.friction_dynamic = out.box.material.friction;
          return taken;
        }},
    Key{"restitution", "a number",
        [](const std::string& v, CsvSettings& out) { return take_number(v, out.box.material.restitution); }},
};

constexpr std::string_view kCameraKeys = "camera.";

std::string all_keys() {
  std::string text;
  for (const Key& key : kKeys) text += (text.empty() ? "" : ", ") + std::string(key.name);
  return text + ", camera.position, camera.target, camera.fov, camera.focus, camera.blur";
}

/// Stores a setting. Returns "" or the error.
std::string take(const std::string& name, const std::string& value, CsvSettings& out) {
  if (name.starts_with(kCameraKeys)) {
    const Status set = out.camera.set(name.substr(kCameraKeys.size()), value);
    return set.ok() ? "" : set.error().message;
  }
  for (const Key& key : kKeys) {
    if (name != key.name) continue;
    if (key.take(value, out)) return "";
    std::string wrong = name;
    return wrong.append(": found \"").append(value).append("\", wanted ").append(key.wanted);
  }
  return "found key \"" + name + "\", wanted one of " + all_keys() + "; a remark has no colon, a key has one behind it";
}

Error wrong_argument(const std::string& setting, const std::string& wrong) {
  return bad_input("\"" + setting + "\": " + wrong);
}

/// The error for a camera, with the place of the key that it names, or of the last key of a camera. message: begins
/// with "camera KEY: ".
Error wrong_camera(const CsvReader& table, const std::map<std::string, std::uint64_t>& lines,
                   const std::map<std::string, std::string>& arguments, const std::string& message) {
  std::string key(kCameraKeys);
  key += message.substr(kCameraKeys.size(), message.find(':') - kCameraKeys.size());
  if (const auto argument = arguments.find(key); argument != arguments.end()) {
    return wrong_argument(argument->second, message);
  }
  if (const auto line = lines.find(key); line != lines.end()) return table.at_line(line->second, message);
  for (const auto& [other, setting] : arguments) {
    if (other.starts_with(kCameraKeys)) return wrong_argument(setting, message);
  }
  std::uint64_t last = 1;
  for (const auto& [other, line] : lines) {
    if (other.starts_with(kCameraKeys)) last = std::max(last, line);
  }
  return table.at_line(last, message);
}

/// The columns of the format: name, and destination of the number.
using Places = std::vector<std::pair<std::string, std::size_t*>>;

Error unknown_column(const CsvReader& table, std::size_t column, const Places& places) {
  std::vector<std::string_view> known(places.size());
  std::ranges::transform(places, known.begin(), [](const auto& place) { return std::string_view(place.first); });
  const std::string near(nearest_word(table.columns()[column], known));
  return table.at(column, "found column " + in_quotes(table.columns()[column]) + ", wanted step, id, position.x or " +
                              "another of the format" + (near.empty() ? "" : " (is " + near + " meant?)") +
                              "; 'tumble import --help' lists them; --map FIELD=COLUMN names it, --channels makes a "
                              "channel of it, a name that begins with _ is passed over");
}

template <std::size_t N>
void add_vector(Places& places, const std::string& name, const char* letters, std::array<std::size_t, N>& out) {
  out.fill(CsvColumns::kNone);
  for (std::size_t k = 0; k < N; ++k) places.emplace_back(name + '.' + letters[k], &out[k]);
}

/// Errors (kBadInput): a vector has only some of its columns, or lacks all and is needed.
template <std::size_t N>
Status check_vector(const CsvReader& table, const char* name, const std::array<std::size_t, N>& columns, bool needed) {
  std::size_t there = 0;
  for (const std::size_t column : columns) there += column != CsvColumns::kNone ? 1U : 0U;
  if (there == N || (there == 0 && !needed)) return {};
  const char* points = N == 4 && there == 0 ? " (where nothing turns, 1 in .w and 0 in the others)" : "";
  return table.at_line(table.line(), "found " + std::to_string(there) + " columns of " + name + ", wanted " +
                                         std::to_string(N) + ": " + name + (N == 4 ? ".w, " : ".x, ") + "…" + points);
}

/// Takes a column that is a channel; false for any other.
bool take_channel(const std::string& name, std::size_t column, bool others_are_channels, CsvColumns& columns) {
  const auto add = [&](std::size_t prefix, ChannelScope scope) {
    columns.channels.push_back({column, name.substr(prefix), scope});
    return true;
  };
  if (name.starts_with("channel.")) return add(8, ChannelScope::kBody);
  if (name.starts_with("world.")) return add(6, ChannelScope::kWorld);
  if (name.starts_with("pair.")) return add(5, ChannelScope::kPair);
  return others_are_channels && add(0, ChannelScope::kBody);
}

/// Errors (kBadInput): a needed vector is missing, or a vector lacks components.
Status check_vectors(const CsvReader& table, const CsvColumns& columns) {
  if (Status ok = check_vector(table, "position", columns.position, true); !ok.ok()) return ok;
  const bool by_angles = columns.euler[0] != CsvColumns::kNone;
  if (Status ok = check_vector(table, "orientation", columns.orientation, !by_angles); !ok.ok()) return ok;
  if (by_angles && columns.orientation[0] != CsvColumns::kNone) {
    return table.at(columns.euler[0], "found columns of orientation and of euler, wanted one of the two");
  }
  if (Status ok = check_vector(table, "euler", columns.euler, false); !ok.ok()) return ok;
  if (Status ok = check_vector(table, "velocity", columns.velocity, false); !ok.ok()) return ok;
  if (Status ok = check_vector(table, "spin", columns.spin, false); !ok.ok()) return ok;
  return check_vector(table, "size", columns.size, false);
}

}  // namespace

bool is_setting(std::string_view key) {
  if (key.starts_with(kCameraKeys)) return true;
  return std::ranges::any_of(kKeys, [key](const Key& known) { return known.name == key; });
}

Result<CsvSettings> read_settings(const CsvReader& table, std::span<const std::string> more, CsvSettings start) {
  const sim::Vec3 gravity = start.scene.world.gravity;
  bool given = false;  // gravity and size in the engine's axes and units
  bool sized = false;
  std::map<std::string, std::uint64_t> lines;  // by key
  for (const CsvSetting& setting : table.settings()) {
    const auto [first, is_new] = lines.emplace(setting.key, setting.line);
    if (!is_new) {
      return table.at_line(setting.line, setting.key + ": found a second time, first in line " +
                                             std::to_string(first->second) + "; wanted one line for each key");
    }
    if (const std::string wrong = take(setting.key, setting.value, start); !wrong.empty()) {
      return table.at_line(setting.line, wrong);
    }
    given = given || setting.key == "gravity";
    sized = sized || setting.key == "size";
  }
  std::map<std::string, std::string> arguments;  // by key
  for (const std::string& setting : more) {
    const std::size_t colon = std::min(setting.find(':'), setting.size());
    const std::string key = setting.substr(0, colon);
    const std::size_t value = setting.find_first_not_of(' ', std::min(colon + 1, setting.size()));
    const std::string wrong = take(key, value == std::string::npos ? "" : setting.substr(value), start);
    if (!wrong.empty()) return wrong_argument(setting, wrong);
    if (!arguments.emplace(key, setting).second)
      return wrong_argument(setting, key + ": found a second time, wanted it once");
    given = given || key == "gravity";
    sized = sized || key == "size";
  }
  start.scene.world.gravity = given ? start.axes.length(start.scene.world.gravity) : gravity;
  if (sized) start.box.size = start.axes.extents(start.box.size);
  for (std::optional<sim::Vec3>* place : {&start.camera.position, &start.camera.target}) {
    if (*place) *place = start.axes.length(**place);
  }
  if (start.camera.focus) *start.camera.focus *= start.axes.metres;
  const Result<sim::Camera> camera = start.camera.applied_to(start.scene.camera);
  if (!camera.ok()) return wrong_camera(table, lines, arguments, camera.error().message);
  start.scene.camera = *camera;
  return start;
}

Result<CsvColumns> find_columns(const CsvReader& table, bool others_are_channels) {
  CsvColumns columns;
  Places places = {{"step", &columns.step},
                   {"time", &columns.time},
                   {"id", &columns.id},
                   {"name", &columns.name},
                   {"shape", &columns.shape},
                   {"dt", &columns.dt},
                   {"friction_dynamic", &columns.friction_dynamic},
                   {"texture", &columns.texture},
                   {"frozen", &columns.frozen},
                   {"mass", &columns.mass},
                   {"static", &columns.is_static},
                   {"friction", &columns.friction},
                   {"restitution", &columns.restitution},
                   {"row", &columns.row},
                   {"column", &columns.column}};
  add_vector(places, "position", "xyz", columns.position);
  add_vector(places, "orientation", "wxyz", columns.orientation);
  add_vector(places, "velocity", "xyz", columns.velocity);
  add_vector(places, "spin", "xyz", columns.spin);
  add_vector(places, "size", "xyz", columns.size);
  add_vector(places, "euler", "123", columns.euler);
  for (std::size_t k = 0; k < table.columns().size(); ++k) {
    const std::string& name = table.columns()[k];
    if (name.starts_with('_')) {
      if (name.size() > kColumnNameBytesMax) {
        return table.at(k, "found a name of " + std::to_string(name.size()) + " bytes, wanted at most " +
                               std::to_string(kColumnNameBytesMax));
      }
      columns.passed_over.push_back(name);
      continue;
    }
    const auto place = std::ranges::find(places, name, &Places::value_type::first);
    if (place == places.end()) {
      if (take_channel(name, k, others_are_channels, columns)) continue;
      return unknown_column(table, k, places);
    }
    if (*place->second != CsvColumns::kNone) return table.at(k, "found column \"" + name + "\" twice");
    *place->second = k;
  }
  if (columns.step == CsvColumns::kNone && columns.time == CsvColumns::kNone) {
    return table.at_line(table.line(), "found neither a column step nor a column time, wanted one of them");
  }
  if (columns.id == CsvColumns::kNone) return table.at_line(table.line(), "found no column id, wanted one");
  if (Status ok = check_vectors(table, columns); !ok.ok()) return ok.error();
  return columns;
}

}  // namespace tumble::replay

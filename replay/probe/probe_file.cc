#include "replay/probe/probe_file.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstring>
#include <fstream>
#include <string_view>

#include "replay/probe/tumble_probe.h"
#include "src/base/text.h"

namespace tumble::replay {
namespace {

constexpr std::string_view kMagic = "TMBLPRB1";
constexpr std::size_t kProbesMax = 50'000'000;
constexpr std::size_t kSitesMax = 1'000'000;
constexpr std::size_t kTextMax = 1000;  // of a name, of a path

/// Reads little-endian numbers; every read after the file's end fails.
class Bytes {
 public:
  explicit Bytes(const std::string& path) : in_(path, std::ios::binary) {}

  [[nodiscard]] bool is_open() const { return in_.is_open(); }
  bool number(int size, std::uint64_t& value) {
    std::array<unsigned char, 8> bytes = {};
    if (!in_.read(reinterpret_cast<char*>(bytes.data()), size)) return false;
    value = 0;
    for (int i = size; i-- > 0;) value = value << 8 | bytes[static_cast<std::size_t>(i)];
    return true;
  }
  bool text(std::size_t size, std::string& value) {
    value.assign(size, '\0');
    return static_cast<bool>(in_.read(value.data(), static_cast<std::streamsize>(size)));
  }

 private:
  std::ifstream in_;
};

/// Reads one file, record by record.
class Reader {
 public:
  explicit Reader(const std::string& path) : path_(path), bytes_(path) {}

  Result<ProbeFile> read() {
    std::string magic;
    if (!bytes_.is_open()) return bad_input(path_ + ": cannot be opened; the engine wrote no probes");
    if (!bytes_.text(kMagic.size(), magic) || magic != kMagic) {
      return bad_input(path_ + ": " + found_wanted(in_quotes(magic), "a file of probes"));
    }
    file_.cut = "the engine never reached that step with its probes on";
    for (std::uint64_t letter = 0; bytes_.number(1, letter);) {
      const Status status = record(static_cast<char>(letter));
      if (!status.ok()) return status.error();
      if (torn_) break;
    }
    return std::move(file_);
  }

 private:
  Status record(char letter) {
    switch (letter) {
      case 'S':
        return site();
      case 'B':
        file_.probes.clear();
        torn_ = !bytes_.number(8, file_.step);
        file_.cut = "the engine ended within the step";
        return {};
      case 'P':
        return probe();
      case 'E':
        return end();
      default:
        return bad_input(path_ + ": found a record " + in_quotes(std::string(1, letter)) + ", wanted S, B, P or E");
    }
  }

  Status site() {
    std::uint64_t number = 0, line = 0, name = 0, place = 0;
    torn_ = !(bytes_.number(4, number) && bytes_.number(4, line) && bytes_.number(2, name) && bytes_.number(2, place));
    if (torn_) return {};
    if (number != file_.sites.size() || number >= kSitesMax || name > kTextMax || place > kTextMax) {
      return bad_input(path_ + ": found site " + std::to_string(number) + ", wanted " +
                       std::to_string(file_.sites.size()) + ", with a name of at most 1000 bytes");
    }
    ProbeSite site;
    site.line = static_cast<std::uint32_t>(line);
    torn_ = !(bytes_.text(name, site.name) && bytes_.text(place, site.file));
    if (!torn_) file_.sites.push_back(std::move(site));
    return {};
  }

  Status probe() {
    Probe probe;
    std::uint64_t number = 0, kind = 0;
    torn_ = !(bytes_.number(4, number) && bytes_.number(1, kind) && bytes_.number(8, probe.a));
    probe.of_pair = (kind & TUMBLE_PROBE_OF_PAIR) != 0;
    probe.kind = static_cast<std::uint8_t>(kind & ~std::uint64_t{TUMBLE_PROBE_OF_PAIR});
    probe.site = static_cast<std::uint32_t>(number);
    if (!torn_ && probe.of_pair) torn_ = !bytes_.number(8, probe.b);
    if (!torn_) torn_ = !bytes_.number(8, probe.bits);
    if (torn_) return {};
    if (probe.site >= file_.sites.size() || probe.kind > TUMBLE_PROBE_I64) {
      return bad_input(path_ + ": found a probe of site " + std::to_string(number) + " and kind " +
                       std::to_string(kind) + ", wanted a site named before and kind 0, 1 or 2");
    }
    if (file_.probes.size() >= kProbesMax) return bad_input(path_ + ": found more than 50 million probes in a step");
    file_.probes.push_back(probe);
    return {};
  }

  Status end() {
    std::uint64_t count = 0;
    torn_ = !bytes_.number(8, count);
    if (torn_) return {};
    file_.cut = count == file_.probes.size()
                    ? ""
                    : "the step had " + std::to_string(count) + " probes, of which the first " +
                          std::to_string(file_.probes.size()) + " were kept";
    return {};
  }

  std::string path_;
  Bytes bytes_;
  ProbeFile file_;
  bool torn_ = false;
};

}  // namespace

Result<ProbeFile> read_probes(const std::string& path) { return Reader(path).read(); }

std::string value_text(const Probe& probe) {
  if (probe.kind == TUMBLE_PROBE_F64) return exact_bits(std::bit_cast<double>(probe.bits));
  return probe.kind == TUMBLE_PROBE_U64 ? std::to_string(probe.bits)
                                        : std::to_string(static_cast<std::int64_t>(probe.bits));
}

std::string key_text(const Probe& probe) {
  return std::to_string(probe.a) + (probe.of_pair ? " and " + std::to_string(probe.b) : "");
}

}  // namespace tumble::replay

#include "golden/run/engine_files.h"

#include <span>
#include <vector>

#include "golden/suite/file_changes.h"
#include "golden/suite/text_files.h"

namespace tumble::golden {
namespace {

template <class Bytes>
Hash128 hash_of(const Bytes& bytes) {
  Hasher hasher;
  hasher.add(std::span(reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size()));
  return hasher.digest();
}

}  // namespace

Result<std::string> engine_files_text(const CaseFolder& folder, const EngineCase& engine) {
  std::string text, contents;
  for (const std::string& name : engine.all_files()) {
    const Result<std::vector<std::byte>> bytes = read_bytes(folder.path / name);
    if (!bytes.ok()) return bad_input("[engine]: " + bytes.error().message);
    text += name + " = " + to_string(hash_of(*bytes)) + '\n';
    contents += text_to_keep(name, {reinterpret_cast<const char*>(bytes->data()), bytes->size()});
  }
  return contents.empty() ? text : text + '\n' + contents;
}

Hash128 engine_files_hash(const std::string& text) { return hash_of(hash_lines(text)); }

}  // namespace tumble::golden

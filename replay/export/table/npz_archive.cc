#include "replay/export/table/npz_archive.h"

#include <zlib.h>

#include <algorithm>
#include <utility>

#include "replay/export/plan/little_bytes.h"
#include "src/base/check.h"

namespace tumble::replay {
namespace {

constexpr std::size_t kBlock = std::size_t{1} << 20U;  // of each array, before it is written
constexpr std::size_t kAlignment = 64;                 // of an array's data behind its head, as numpy has it
constexpr std::uint64_t kLocalHeader = 30, kZip64Extra = 20, kDirectoryExtra = 28;
constexpr std::uint32_t kIn64 = 0xffffffffU;  // the number is in the ZIP64 field
constexpr std::uint16_t kVersion = 45;        // of the format: ZIP64
constexpr std::uint16_t kUtf8 = 0x0800;       // the name is UTF-8
constexpr std::uint16_t kDate = 0x0021;       // 1 January 1980: an export has the same bytes on every day

std::string array_head(const ItemType& type, const std::vector<std::uint64_t>& shape) {
  std::string sizes;
  for (const std::uint64_t size : shape) sizes += std::to_string(size) + (shape.size() == 1 ? "," : ", ");
  if (shape.size() > 1) sizes.resize(sizes.size() - 2);
  std::string text = "{'descr': '" + type.name + "', 'fortran_order': False, 'shape': (" + sizes + "), }";
  constexpr std::size_t kBefore = 10;  // magic, version, length
  text.append(kAlignment - (kBefore + text.size() + 1) % kAlignment, ' ');
  text += '\n';
  std::string head("\x93NUMPY\x01\x00", 8);
  append_little(text.size(), 2, head);
  return head + text;
}

std::uint32_t crc_of(std::uint32_t crc, std::string_view bytes) {
  return static_cast<std::uint32_t>(
      crc32_z(crc, reinterpret_cast<const Bytef*>(bytes.data()), static_cast<z_size_t>(bytes.size())));
}

}  // namespace

std::uint64_t NpzArchive::Entry::local_bytes() const { return kLocalHeader + name.size() + kZip64Extra; }

std::size_t NpzArchive::add(std::string name, const ItemType& type, const std::vector<std::uint64_t>& shape) {
  Entry entry;
  entry.name = std::move(name) + ".npy";
  entry.head = array_head(type, shape);
  entry.data_bytes = type.bytes;
  for (const std::uint64_t size : shape) entry.data_bytes *= size;
  entry.place = end_;
  entry.crc = crc_of(0, entry.head);
  end_ += entry.local_bytes() + entry.size();
  entries_.push_back(std::move(entry));
  return entries_.size() - 1;
}

Status NpzArchive::flush(Entry& entry) {
  if (entry.buffer.empty()) return {};
  entry.crc = crc_of(entry.crc, entry.buffer);
  const std::uint64_t at = entry.place + entry.local_bytes() + entry.head.size() + entry.written;
  entry.written += entry.buffer.size();
  Status ok = file_.write_at(at, entry.buffer);
  entry.buffer.clear();
  return ok;
}

Status NpzArchive::append(std::size_t array, std::string_view bytes) {
  Entry& entry = entries_[array];
  SIM_CHECK(entry.written + entry.buffer.size() + bytes.size() <= entry.data_bytes, array, entry.data_bytes);
  entry.buffer += bytes;
  return entry.buffer.size() < kBlock ? Status() : flush(entry);
}

Status NpzArchive::add_whole(const std::string& name, const ItemType& type, const std::vector<std::uint64_t>& shape,
                             std::string_view bytes) {
  return append(add(name, type, shape), bytes);
}

std::string NpzArchive::local_header(const Entry& entry) {
  std::string bytes;
  append_little(0x04034b50, 4, bytes);
  append_little(kVersion, 2, bytes);
  append_little(kUtf8, 2, bytes);
  append_little(0, 4, bytes);  // stored; midnight
  append_little(kDate, 2, bytes);
  append_little(entry.crc, 4, bytes);
  append_little(kIn64, 4, bytes);
  append_little(kIn64, 4, bytes);
  append_little(entry.name.size(), 2, bytes);
  append_little(kZip64Extra, 2, bytes);
  bytes += entry.name;
  append_little(1, 2, bytes);
  append_little(16, 2, bytes);
  append_little(entry.size(), 8, bytes);
  append_little(entry.size(), 8, bytes);
  return bytes + entry.head;
}

std::string NpzArchive::directory_row(const Entry& entry) {
  std::string bytes;
  append_little(0x02014b50, 4, bytes);
  append_little(kVersion, 2, bytes);
  append_little(kVersion, 2, bytes);
  append_little(kUtf8, 2, bytes);
  append_little(0, 4, bytes);
  append_little(kDate, 2, bytes);
  append_little(entry.crc, 4, bytes);
  append_little(kIn64, 4, bytes);
  append_little(kIn64, 4, bytes);
  append_little(entry.name.size(), 2, bytes);
  append_little(kDirectoryExtra, 2, bytes);
  append_little(0, 10, bytes);  // no comment; volume 0; no attributes
  append_little(kIn64, 4, bytes);
  bytes += entry.name;
  append_little(1, 2, bytes);
  append_little(24, 2, bytes);
  append_little(entry.size(), 8, bytes);
  append_little(entry.size(), 8, bytes);
  append_little(entry.place, 8, bytes);
  return bytes;
}

Status NpzArchive::finish() {
  std::string directory;
  for (Entry& entry : entries_) {
    if (Status ok = flush(entry); !ok.ok()) return ok;
    SIM_CHECK(entry.written == entry.data_bytes, entry.written, entry.data_bytes);
    if (Status ok = file_.write_at(entry.place, local_header(entry)); !ok.ok()) return ok;
    directory += directory_row(entry);
  }
  const std::uint64_t size = directory.size(), count = entries_.size();
  append_little(0x06064b50, 4, directory);  // the end in ZIP64
  append_little(44, 8, directory);
  append_little(kVersion, 2, directory);
  append_little(kVersion, 2, directory);
  append_little(0, 8, directory);
  append_little(count, 8, directory);
  append_little(count, 8, directory);
  append_little(size, 8, directory);
  append_little(end_, 8, directory);
  append_little(0x07064b50, 4, directory);  // where that end is
  append_little(0, 4, directory);
  append_little(end_ + size, 8, directory);
  append_little(1, 4, directory);
  append_little(0x06054b50, 4, directory);  // the end, for readers of small archives
  append_little(0, 4, directory);
  append_little(std::min<std::uint64_t>(count, 0xffff), 2, directory);
  append_little(std::min<std::uint64_t>(count, 0xffff), 2, directory);
  append_little(std::min<std::uint64_t>(size, kIn64), 4, directory);
  append_little(std::min<std::uint64_t>(end_, kIn64), 4, directory);
  append_little(0, 2, directory);
  return file_.write_at(end_, directory);
}

}  // namespace tumble::replay

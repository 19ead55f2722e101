#include "replay/arrays/npz.h"

#include <zlib.h>

#include <algorithm>
#include <optional>

#include "replay/arrays/little_numbers.h"
#include "src/base/text.h"

namespace tumble::replay {
namespace {

constexpr std::size_t kEndBytes = 22;  // of the end record without its comment
constexpr std::size_t kCommentMax = 65535;
constexpr std::uint64_t kDeflateRatioMax = 1032;  // deflate cannot expand by more
constexpr std::uint32_t kIn64 = 0xffffffffU;      // the number is in the zip64 extra field
constexpr std::size_t kArraysMax = 10000;

/// One file of the archive, as the central directory names it.
struct Entry {
  std::string name;
  std::uint64_t method = 0, crc = 0, packed = 0, size = 0, offset = 0;
  bool encrypted = false;
};

/// Sizes beyond 4 GiB, and those that a writer puts there anyway, are in extra field 1.
void read_zip64(std::string_view extra, Entry& entry) {
  for (std::size_t at = 0; holds(extra, at, 4);) {
    const std::uint64_t id = number_at(extra, at, 2), size = number_at(extra, at + 2, 2);
    if (!holds(extra, at + 4, size)) return;
    std::size_t next = at + 4;
    for (std::uint64_t* value : {&entry.size, &entry.packed, &entry.offset}) {
      if (id != 1 || *value != kIn64 || next + 8 > at + 4 + size) continue;
      *value = number_at(extra, next, 8);
      next += 8;
    }
    at += 4 + size;
  }
}

Result<std::vector<Entry>> read_directory(std::string_view zip) {
  if (zip.size() < kEndBytes) return bad_input("is no archive of arrays: it is shorter than one");
  std::optional<std::size_t> end;
  const std::size_t first = zip.size() - std::min(zip.size(), kEndBytes + kCommentMax);
  for (std::size_t at = zip.size() - kEndBytes + 1; at-- > first && !end;) {
    if (number_at(zip, at, 4) == 0x06054b50U) end = at;
  }
  if (!end) return bad_input("is no archive of arrays (.npz): found no end of a zip archive");
  const std::uint64_t count = number_at(zip, *end + 10, 2);
  std::uint64_t at = number_at(zip, *end + 16, 4);
  if (at == kIn64 || count == 0xffff) return bad_input("found an archive of more than 65,534 arrays or 4 GiB");
  if (count > kArraysMax) {
    return bad_input("found " + std::to_string(count) + " arrays, wanted at most " + std::to_string(kArraysMax));
  }
  std::vector<Entry> entries;
  for (std::uint64_t i = 0; i < count; ++i) {
    if (!holds(zip, at, 46) || number_at(zip, at, 4) != 0x02014b50U) {
      return bad_input("the directory of the archive is cut or damaged at byte " + std::to_string(at));
    }
    const std::uint64_t name = number_at(zip, at + 28, 2), extra = number_at(zip, at + 30, 2);
    if (!holds(zip, at + 46, name + extra)) return bad_input("the directory of the archive is cut");
    Entry entry;
    entry.encrypted = (number_at(zip, at + 8, 2) & 1U) != 0;
    entry.method = number_at(zip, at + 10, 2);
    entry.crc = number_at(zip, at + 16, 4);
    entry.packed = number_at(zip, at + 20, 4);
    entry.size = number_at(zip, at + 24, 4);
    entry.offset = number_at(zip, at + 42, 4);
    entry.name = zip.substr(at + 46, name);
    read_zip64(zip.substr(at + 46 + name, extra), entry);
    entries.push_back(std::move(entry));
    at += 46 + name + extra + number_at(zip, at + 32, 2);
  }
  return entries;
}

Status inflate_all(std::string_view packed, std::string& out) {
  z_stream stream = {};
  if (inflateInit2(&stream, -MAX_WBITS) != Z_OK) return cannot_finish("out of memory");
  stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(packed.data()));  // zlib does not write there
  std::size_t in_left = packed.size(), out_left = out.size();
  stream.next_out = reinterpret_cast<Bytef*>(out.data());
  int result = Z_OK;
  constexpr std::size_t kPiece = std::size_t{1} << 30U;
  while (result == Z_OK) {
    stream.avail_in = static_cast<uInt>(std::min(in_left, kPiece));
    stream.avail_out = static_cast<uInt>(std::min(out_left, kPiece));
    const uInt in_before = stream.avail_in, out_before = stream.avail_out;
    result = inflate(&stream, Z_NO_FLUSH);
    in_left -= in_before - stream.avail_in;
    out_left -= out_before - stream.avail_out;
    if (in_before == stream.avail_in && out_before == stream.avail_out) break;
  }
  inflateEnd(&stream);
  if (result == Z_STREAM_END && out_left == 0) return {};
  return bad_input("its compressed bytes are damaged");
}

Result<std::string> unpack(std::string_view zip, const Entry& entry) {
  if (entry.encrypted) return bad_input("is encrypted");
  if (!holds(zip, entry.offset, 30) || number_at(zip, entry.offset, 4) != 0x04034b50U) {
    return bad_input("the archive is cut or damaged at byte " + std::to_string(entry.offset));
  }
  const std::uint64_t begin =
      entry.offset + 30 + number_at(zip, entry.offset + 26, 2) + number_at(zip, entry.offset + 28, 2);
  if (!holds(zip, begin, entry.packed)) return bad_input("the archive ends inside it");
  const std::string_view packed = zip.substr(begin, entry.packed);
  const bool fits = entry.method == 0 ? entry.size == entry.packed : entry.size / kDeflateRatioMax <= entry.packed + 64;
  if (!fits)
    return bad_input("found a size of " + std::to_string(entry.size) + " bytes in " + std::to_string(entry.packed));
  std::string out;
  if (entry.method == 0) {
    out = packed;
  } else if (entry.method == 8) {
    out.resize(entry.size);
    if (Status ok = inflate_all(packed, out); !ok.ok()) return ok.error();
  } else {
    return bad_input("is compressed by method " + std::to_string(entry.method) + ", wanted stored or deflate");
  }
  std::uint64_t crc = crc32(0, nullptr, 0);
  constexpr std::size_t kPiece = std::size_t{1} << 30U;
  for (std::size_t at = 0; at < out.size(); at += kPiece) {
    crc = crc32(static_cast<uLong>(crc), reinterpret_cast<const Bytef*>(out.data()) + at,
                static_cast<uInt>(std::min(kPiece, out.size() - at)));
  }
  if (crc == entry.crc) return out;
  return bad_input("its bytes are not those that were written: the CRC differs");
}

}  // namespace

Result<std::vector<Array>> read_npz(std::string_view bytes, const std::string& name) {
  const Result<std::vector<Entry>> entries = read_directory(bytes);
  if (!entries.ok()) return Error{entries.error().kind, name + ": " + entries.error().message};
  std::vector<Array> arrays;
  std::uint64_t total = 0;
  for (const Entry& entry : *entries) {
    const std::string array = entry.name.ends_with(".npy") ? entry.name.substr(0, entry.name.size() - 4) : entry.name;
    const auto wrong = [&](const Error& error) {
      return Error{error.kind, name + ": array " + in_quotes(array) + ": " + error.message};
    };
    if (std::ranges::find(arrays, array, &Array::name) != arrays.end()) {
      return wrong(bad_input("found twice in the archive, wanted once"));
    }
    total += entry.size;
    if (total > kArrayBytesMax) return wrong(bad_input("found more than 4 GiB of arrays"));
    const Result<std::string> unpacked = unpack(bytes, entry);
    if (!unpacked.ok()) return wrong(unpacked.error());
    Result<Array> read = read_npy(*unpacked, array);
    if (!read.ok()) return wrong(read.error());
    arrays.push_back(*std::move(read));
  }
  return arrays;
}

}  // namespace tumble::replay

#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "src/files/output_file.h"
#include "tumble/sim/result.h"

/// Writes an archive of arrays, as numpy.savez() does: zip, each array stored, with ZIP64 fields. All arrays whose
/// sizes are known at the start grow at the same time, each at its own place in the file, so that one pass over a
/// session fills them. Formats: PKWARE's APPNOTE.TXT;
/// https://numpy.org/doc/stable/reference/generated/numpy.lib.format.html
namespace tumble::replay {

/// The type of an array's items as numpy names it ("<f8", "|b1", "<U12"), with their size.
struct ItemType {
  std::string name;
  std::size_t bytes = 8;
};

class NpzArchive {
 public:
  explicit NpzArchive(files::OutputFile& file) : file_(file) {}

  /// Plans an array in C order; returns its number. Places are given in the order of the calls.
  std::size_t add(std::string name, const ItemType& type, const std::vector<std::uint64_t>& shape);

  /// Appends to an array. Errors: the disk.
  Status append(std::size_t array, std::string_view bytes);

  /// A whole array at once, behind all others.
  Status add_whole(const std::string& name, const ItemType& type, const std::vector<std::uint64_t>& shape,
                   std::string_view bytes);

  /// Writes what is buffered, the headers and the directory. Precondition (SIM_CHECK): every array is full.
  Status finish();

 private:
  struct Entry {
    std::string name;              // with ".npy"
    std::string head;              // of the array: type and shape
    std::uint64_t place = 0;       // of the local header
    std::uint64_t data_bytes = 0;  // behind the head
    std::uint64_t written = 0;     // of them, without the buffer
    std::uint32_t crc = 0;
    std::string buffer;
    [[nodiscard]] std::uint64_t local_bytes() const;
    [[nodiscard]] std::uint64_t size() const { return head.size() + data_bytes; }
  };
  Status flush(Entry& entry);
  static std::string local_header(const Entry& entry);
  static std::string directory_row(const Entry& entry);

  files::OutputFile& file_;
  std::vector<Entry> entries_;
  std::uint64_t end_ = 0;  // behind the last planned entry
};

}  // namespace tumble::replay

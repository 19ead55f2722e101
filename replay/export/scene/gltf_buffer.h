#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <nlohmann/json_fwd.hpp>
#include <span>
#include <string>
#include <string_view>
#include <vector>

/// The binary part of a glTF file and the lists that describe it.
namespace tumble::replay {

using GltfJson = nlohmann::ordered_json;

/// Numbers of the glTF specification.
enum GltfType : int { kGltfFloat = 5126, kGltfUnsigned = 5125, kGltfVertices = 34962, kGltfIndices = 34963 };

/// Room for arrays of floats, each of `count` items of `width` numbers, one behind another.
struct GltfRoom {
  std::uint64_t begin = 0;   ///< in the buffer
  std::size_t accessor = 0;  ///< of the first array; the others follow
  std::size_t count = 0, width = 0;
  [[nodiscard]] std::uint64_t place(std::size_t array, std::size_t item) const {
    return begin + 4 * (std::uint64_t{array} * count + item) * width;
  }
};

/// Bytes that are known at the start, then room for those that come step by step.
class GltfBuffer {
 public:
  GltfBuffer();
  ~GltfBuffer();
  GltfBuffer(const GltfBuffer&) = delete;
  GltfBuffer& operator=(const GltfBuffer&) = delete;

  /// Adds floats, or indices, and their accessor. width: 1 … 4 numbers an item. bounds: with least and largest values.
  /// target: of the GPU, 0 for none. Returns the accessor's number.
  std::size_t add(std::span<const float> numbers, std::size_t width, bool bounds, int target = 0);
  std::size_t add(std::span<const std::uint32_t> indices);
  /// Adds any bytes; returns the number of the view.
  std::size_t add_view(std::string_view bytes, int target = 0);

  /// Plans room behind everything that was added, for arrays that come later. Nothing may be added after.
  GltfRoom reserve(std::size_t arrays, std::size_t count, std::size_t width);

  [[nodiscard]] std::uint64_t size() const { return size_; }  ///< with the room
  [[nodiscard]] const std::string& bytes() const { return bytes_; }
  /// Adds accessors, bufferViews and buffers.
  void describe(GltfJson& json) const;

 private:
  struct Lists;

  std::string bytes_;
  std::uint64_t size_ = 0;
  std::unique_ptr<Lists> lists_;
};

}  // namespace tumble::replay

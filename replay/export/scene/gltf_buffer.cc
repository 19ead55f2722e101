#include "replay/export/scene/gltf_buffer.h"

#include <algorithm>
#include <bit>
#include <memory>
#include <nlohmann/json.hpp>
#include <string_view>

#include "replay/export/plan/little_bytes.h"

namespace tumble::replay {
namespace {

constexpr const char* kTypes[] = {"", "SCALAR", "VEC2", "VEC3", "VEC4"};

}  // namespace

struct GltfBuffer::Lists {
  GltfJson accessors = GltfJson::array(), views = GltfJson::array();
};

GltfBuffer::GltfBuffer() : lists_(std::make_unique<Lists>()) {}
GltfBuffer::~GltfBuffer() = default;

std::size_t GltfBuffer::add_view(std::string_view bytes, int target) {
  bytes_.append((4 - bytes_.size() % 4) % 4, '\0');
  GltfJson view = {{"buffer", 0}, {"byteOffset", bytes_.size()}, {"byteLength", bytes.size()}};
  if (target != 0) view["target"] = target;
  bytes_ += bytes;
  size_ = bytes_.size();
  lists_->views.push_back(std::move(view));
  return lists_->views.size() - 1;
}

std::size_t GltfBuffer::add(std::span<const float> numbers, std::size_t width, bool bounds, int target) {
  std::string bytes;
  bytes.reserve(numbers.size() * 4);
  for (const float number : numbers) append_little(std::bit_cast<std::uint32_t>(number), 4, bytes);
  GltfJson accessor = {{"bufferView", add_view(bytes, target)},
                       {"componentType", static_cast<int>(kGltfFloat)},
                       {"count", numbers.size() / width},
                       {"type", kTypes[width]}};
  for (std::size_t c = 0; bounds && c < width; ++c) {
    float least = numbers[c], largest = numbers[c];
    for (std::size_t i = c; i < numbers.size(); i += width) {
      least = std::min(least, numbers[i]);
      largest = std::max(largest, numbers[i]);
    }
    accessor["min"].push_back(least);
    accessor["max"].push_back(largest);
  }
  lists_->accessors.push_back(std::move(accessor));
  return lists_->accessors.size() - 1;
}

std::size_t GltfBuffer::add(std::span<const std::uint32_t> indices) {
  std::string bytes;
  for (const std::uint32_t index : indices) append_little(index, 4, bytes);
  lists_->accessors.push_back({{"bufferView", add_view(bytes, kGltfIndices)},
                               {"componentType", static_cast<int>(kGltfUnsigned)},
                               {"count", indices.size()},
                               {"type", "SCALAR"}});
  return lists_->accessors.size() - 1;
}

GltfRoom GltfBuffer::reserve(std::size_t arrays, std::size_t count, std::size_t width) {
  size_ += (4 - size_ % 4) % 4;
  const GltfRoom room = {size_, lists_->accessors.size(), count, width};
  const std::uint64_t bytes = 4 * std::uint64_t{arrays} * count * width;
  lists_->views.push_back({{"buffer", 0}, {"byteOffset", size_}, {"byteLength", bytes}});
  for (std::size_t i = 0; i < arrays; ++i) {
    lists_->accessors.push_back({{"bufferView", lists_->views.size() - 1},
                                 {"byteOffset", room.place(i, 0) - room.begin},
                                 {"componentType", static_cast<int>(kGltfFloat)},
                                 {"count", count},
                                 {"type", kTypes[width]}});
  }
  size_ += bytes;
  return room;
}

void GltfBuffer::describe(GltfJson& json) const {
  json["accessors"] = lists_->accessors;
  json["bufferViews"] = lists_->views;
  json["buffers"] = GltfJson::array({{{"byteLength", size_}}});
}

}  // namespace tumble::replay

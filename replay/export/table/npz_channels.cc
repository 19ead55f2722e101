#include "replay/export/table/npz_channels.h"

#include <algorithm>
#include <array>
#include <cstring>

#include "replay/export/table/npz_texts.h"
#include "replay/export/table/table_frame.h"
#include "src/base/text.h"

namespace tumble::replay {
namespace {

constexpr std::uint64_t kTextBytesMax = std::uint64_t{64} << 20U;  // of the array of a channel's different texts

bool is_text(ChannelKind kind) { return !is_number(kind); }

ItemType item_type(ChannelKind kind) {
  switch (kind) {
    case ChannelKind::kFloat64:
      return {"<f8", 8};
    case ChannelKind::kFloat32:
      return {"<f4", 4};
    case ChannelKind::kInt64:
      return {"<i8", 8};
    case ChannelKind::kUint64:
      return {"<u8", 8};
    case ChannelKind::kBytes:
    case ChannelKind::kText:
      break;
  }
  return {"<u4", 4};
}

}  // namespace

void NpzChannels::begin(const ExportPlan& plan, NpzArchive& archive) {
  plan_ = &plan;
  for (const std::size_t i : table_channels(plan.header.declared)) {
    const Channel& channel = plan.header.declared.channels[i];
    const bool world = channel.type.scope == ChannelScope::kWorld;
    std::vector<std::uint64_t> shape = {plan.steps.size()};
    if (!world) shape.push_back(plan.bodies.size());
    Column column;
    column.channel = i;
    column.type = channel.type;
    column.name = (world ? "world." : "channel.") + channel.name;
    const ItemType type = item_type(channel.type.kind);
    column.item_bytes = type.bytes;
    column.values = archive.add(column.name, type, shape);
    column.present = archive.add("present." + column.name, {"|b1", 1}, shape);
    columns_.push_back(std::move(column));
  }
}

Status NpzChannels::put_value(Column& column, const ChannelValues& values, std::size_t row, const std::string& of,
                              char* to) const {
  std::uint64_t item = 0;
  if (is_text(column.type.kind)) {
    const bool bytes = column.type.kind == ChannelKind::kBytes;
    const std::string text = bytes ? hex_cell(values.bytes[row]) : values.bytes[row];
    const auto [place, is_new] = column.numbers.try_emplace(text, static_cast<std::uint32_t>(column.numbers.size()));
    column.longest = std::max(column.longest, text.size());
    if (is_new && 4 * column.longest * column.numbers.size() > kTextBytesMax) {
      return bad_input(column.name + " of " + of + ": found more than " + bytes_text(kTextBytesMax) +
                       " of different texts, all as long as the longest; export to .mcap");
    }
    item = place->second;
  } else {
    item = values.bits[row];
  }
  std::array<char, 8> eight{};
  put_little(item, eight.data());
  std::memcpy(to, eight.data(), column.item_bytes);
  return {};
}

Status NpzChannels::add(const ExportStep& step, NpzArchive& archive) {
  for (Column& column : columns_) {
    const ChannelValues& values = step.record.extras.values(column.channel);
    const bool world = column.type.scope == ChannelScope::kWorld;
    const std::size_t count = world ? 1 : plan_->bodies.size();
    bytes_.assign(count * column.item_bytes, '\0');
    flags_.assign(count, '\0');
    std::size_t from = 0;
    for (std::size_t i = 0; i < count; ++i) {
      const std::size_t row = world ? 0 : value_row(values, plan_->bodies[i].box.id, from);
      if (row >= values.size()) continue;
      const std::string of = world ? "step " + std::to_string(step.record.step) : plan_->place(i, step.record.step);
      if (Status ok = put_value(column, values, row, of, bytes_.data() + i * column.item_bytes); !ok.ok()) return ok;
      flags_[i] = 1;
    }
    if (Status ok = archive.append(column.values, bytes_); !ok.ok()) return ok;
    if (Status ok = archive.append(column.present, flags_); !ok.ok()) return ok;
  }
  return {};
}

Status NpzChannels::finish(NpzArchive& archive) {
  for (const Column& column : columns_) {
    if (!is_text(column.type.kind)) continue;
    std::vector<std::string> all(column.numbers.size());
    for (const auto& [text, number] : column.numbers) all[number] = text;
    const Texts texts(all);
    if (Status ok = archive.add_whole("texts." + column.name, texts.type(), {all.size()}, texts.bytes()); !ok.ok()) {
      return ok;
    }
  }
  return {};
}

}  // namespace tumble::replay

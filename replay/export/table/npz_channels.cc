#include "replay/export/table/npz_channels.h"

#include <algorithm>
#include <array>
#include <cstring>
#include <utility>

#include "replay/export/plan/utf8_text.h"
#include "replay/export/table/channel_cells.h"
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

Status NpzChannels::begin(const ExportPlan& plan, NpzArchive& archive) {
  plan_ = &plan;
  for (std::size_t i = 0; i < plan.header.declared.channels.size(); ++i) {
    const Channel& channel = plan.header.declared.channels[i];
    std::vector<std::uint64_t> shape = {plan.steps.size()};
    if (channel.type.scope == ChannelScope::kBody) shape.push_back(plan.bodies.size());
    Column column;
    column.channel = i;
    column.type = channel.type;
    column.name = channel_column(channel);
    const ItemType type = item_type(channel.type.kind);
    column.item_bytes = type.bytes;
    if (!column.of_pairs()) {
      column.values = archive.add(column.name, type, shape);
      column.present = archive.add("present." + column.name, {"|b1", 1}, shape);
    }
    if (!unit_in_column(channel).empty()) {
      const Texts unit({channel.unit});
      if (Status ok = archive.add_whole("unit." + column.name, unit.type(), {}, unit.bytes()); !ok.ok()) return ok;
    }
    columns_.push_back(std::move(column));
  }
  return {};
}

bool NpzChannels::has_pairs() const { return std::ranges::any_of(columns_, &Column::of_pairs); }

bool NpzChannels::is_there(const ExportStep& step, sim::BodyId body) const {
  const auto found = std::ranges::lower_bound(plan_->bodies, body, {}, [](const ExportBody& b) { return b.box.id; });
  if (found == plan_->bodies.end() || found->box.id != body) return false;
  return step.rows[static_cast<std::size_t>(found - plan_->bodies.begin())] != ExportStep::kAbsent;
}

void NpzChannels::look(const ExportStep& step) {
  for (Column& column : columns_) {
    if (!column.of_pairs()) continue;
    for (const ChannelKey& key : step.record.extras.values(column.channel).keys) {
      column.rows += is_there(step, key.a) ? 1U : 0U;
    }
  }
}

void NpzChannels::plan_pairs(NpzArchive& archive) {
  if (std::exchange(pairs_planned_, true)) return;
  for (Column& column : columns_) {
    if (!column.of_pairs()) continue;
    column.values = archive.add(column.name, item_type(column.type.kind), {column.rows});
    constexpr std::array<const char*, 3> kPlaces = {"step.", "a.", "b."};
    for (std::size_t i = 0; i < kPlaces.size(); ++i) {
      column.places[i] = archive.add(kPlaces[i] + column.name, {"<u8", 8}, {column.rows});
    }
  }
}

Status NpzChannels::add_pairs(Column& column, const ExportStep& step, NpzArchive& archive) {
  const ChannelValues& values = step.record.extras.values(column.channel);
  std::string item(column.item_bytes, '\0'), number(8, '\0');
  for (std::size_t row = 0; row < values.size(); ++row) {
    const auto [a, b] = values.keys[row];
    if (!is_there(step, a)) {
      ++lost_values_;
      continue;
    }
    const std::string of =
        "bodies " + std::to_string(a) + " and " + std::to_string(b) + " at step " + std::to_string(step.record.step);
    if (Status ok = put_value(column, values, row, of, item.data()); !ok.ok()) return ok;
    if (Status ok = archive.append(column.values, item); !ok.ok()) return ok;
    const std::uint64_t places[] = {step.record.step, a, b};
    for (std::size_t i = 0; i < column.places.size(); ++i) {
      put_little(places[i], number.data());
      if (Status ok = archive.append(column.places[i], number); !ok.ok()) return ok;
    }
  }
  return {};
}

Status NpzChannels::put_value(Column& column, const ChannelValues& values, std::size_t row, const std::string& of,
                              char* to) const {
  std::uint64_t item = 0;
  if (is_text(column.type.kind)) {
    const bool bytes = column.type.kind == ChannelKind::kBytes;
    const std::string text = bytes ? hex_digits(values.bytes[row]) : values.bytes[row];
    if (text.ends_with('\0')) {
      return bad_input(column.name + " of " + of + ": found a text that ends with a zero byte, which numpy cuts off; " +
                       "export to .csv or .mcap");
    }
    if (!is_utf8(text)) {
      return bad_input(column.name + " of " + of + ": found a text that is no UTF-8, which numpy cannot hold; " +
                       "export to .csv");
    }
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
  plan_pairs(archive);
  for (Column& column : columns_) {
    if (column.of_pairs()) {
      if (Status ok = add_pairs(column, step, archive); !ok.ok()) return ok;
      continue;
    }
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
    lost_values_ += values.size() - static_cast<std::size_t>(std::ranges::count(flags_, '\1'));
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

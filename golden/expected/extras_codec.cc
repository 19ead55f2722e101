#include "golden/expected/extras_codec.h"

#include <algorithm>
#include <cstring>
#include <functional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "replay/codec/blob.h"
#include "replay/codec/channel_codec.h"
#include "replay/codec/header_codec.h"
#include "replay/format/limits.h"

namespace tumble::golden {
namespace {

/// Room for `count` elements of `size` bytes.
unsigned room_for(std::size_t count, std::size_t size) { return static_cast<unsigned>(count * size); }

void encode_channel(const ExpectedChannel& from, schema::Channel::Builder out) {
  out.setName(from.channel.name);
  out.setUnit(from.channel.unit);
  out.setKind(static_cast<std::uint8_t>(from.channel.type.kind));
  out.setScope(static_cast<std::uint8_t>(from.channel.type.scope));
  replay::put_planes(std::span(from.hashes), out.initHash(room_for(from.hashes.size(), 4)));
  std::vector<std::uint64_t> steps;
  std::vector<const replay::ChannelValues*> values;
  for (const KeptValues& kept : from.values) {
    steps.push_back(kept.step);
    values.push_back(&kept.values);
  }
  replay::put_differences(std::span<const std::uint64_t>(steps), out.initValueSteps(room_for(steps.size(), 8)));
  if (!values.empty()) replay::encode(0, from.channel.type, values, out.initValues());
}

Status decode_type(schema::Channel::Reader in, replay::ChannelType& type) {
  if (in.getKind() > static_cast<std::uint8_t>(replay::ChannelKind::kText) ||
      in.getScope() > static_cast<std::uint8_t>(replay::ChannelScope::kPair)) {
    return bad_input("found a channel of a kind or scope that this program does not know; use a newer one");
  }
  type = {static_cast<replay::ChannelKind>(in.getKind()), static_cast<replay::ChannelScope>(in.getScope())};
  return {};
}

Status decode_values(schema::Channel::Reader in, std::uint64_t steps, std::uint64_t& rows_left, ExpectedChannel& out) {
  std::vector<std::uint64_t> kept;
  const auto bytes = in.getValueSteps();
  if (Status ok = replay::get_differences("valueSteps", bytes, bytes.size() / 8, kept); !ok.ok()) return ok;
  const bool ascend = std::ranges::adjacent_find(kept, std::greater_equal<>()) == kept.end();
  if (!ascend || (!kept.empty() && kept.back() > steps)) {
    return damaged("channel " + out.channel.name + ": found steps out of order");
  }
  if (kept.empty()) return {};
  out.values.resize(kept.size());
  std::vector<replay::ChannelValues*> values;
  for (std::size_t i = 0; i < kept.size(); ++i) {
    out.values[i].step = kept[i];
    values.push_back(&out.values[i].values);
  }
  return replay::decode(in.getValues(), out.channel.type, values, rows_left);
}

Status decode_channel(schema::Channel::Reader in, std::uint64_t steps, std::uint64_t& rows_left, ExpectedChannel& out) {
  out.channel.name = std::string(in.getName().cStr(), in.getName().size());
  out.channel.unit = std::string(in.getUnit().cStr(), in.getUnit().size());
  if (Status ok = decode_type(in, out.channel.type); !ok.ok()) return ok;
  if (Status ok = replay::get_planes("hash", in.getHash(), steps + 1, out.hashes); !ok.ok()) return ok;
  return decode_values(in, steps, rows_left, out);
}

}  // namespace

void encode(const ExpectedExtras& extras, schema::Expected::Builder out) {
  out.setKeepsExtras(true);
  auto channels = out.initChannels(static_cast<unsigned>(extras.channels.size()));
  for (unsigned i = 0; i < channels.size(); ++i) encode_channel(extras.channels[i], channels[i]);
  replay::put_planes(std::span(extras.contact_hashes), out.initContactHash(room_for(extras.contact_hashes.size(), 4)));
}

Status decode(schema::Expected::Reader in, std::uint64_t steps, std::optional<ExpectedExtras>& extras) {
  if (!in.getKeepsExtras()) return {};
  ExpectedExtras found;
  std::vector<replay::Channel> channels;
  std::uint64_t rows_left = replay::kExtraRowsMax;
  for (const schema::Channel::Reader channel : in.getChannels()) {
    if (Status ok = decode_channel(channel, steps, rows_left, found.channels.emplace_back()); !ok.ok()) return ok;
    channels.push_back(found.channels.back().channel);
  }
  if (Status ok = replay::check_channels(channels); !ok.ok()) return damaged("channels: " + ok.error().message);
  const auto hashes = in.getContactHash();  // once: a message may be read as often as it is long
  const std::uint64_t contacts = hashes.size() == 0 ? 0 : steps + 1;
  if (Status ok = replay::get_planes("contactHash", hashes, contacts, found.contact_hashes); !ok.ok()) return ok;
  extras = std::move(found);
  return {};
}

void encode(const std::vector<BodyShape>& shapes, schema::Expected::Builder out) {
  out.setKeepsShapes(true);
  auto list = out.initShapes(static_cast<unsigned>(shapes.size()));
  for (unsigned i = 0; i < list.size(); ++i) {
    list[i].setId(shapes[i].id);
    list[i].setLow(shapes[i].shape.low);
    list[i].setHigh(shapes[i].shape.high);
    list[i].setText(shapes[i].text);
  }
}

Status decode(schema::Expected::Reader in, std::optional<std::vector<BodyShape>>& shapes) {
  if (!in.getKeepsShapes()) return {};
  std::vector<BodyShape> found;
  for (const schema::BodyShape::Reader body : in.getShapes()) {
    const capnp::Text::Reader text = body.getText();
    found.push_back({body.getId(), {body.getHigh(), body.getLow()}, std::string(text.cStr(), text.size())});
  }
  const bool ascend = std::ranges::adjacent_find(found, std::greater_equal<>(), &BodyShape::id) == found.end();
  if (!ascend) return damaged("shapes: found ids out of order");
  shapes = std::move(found);
  return {};
}

Status encode(const ExpectedSetup& setup, schema::Expected::Builder out) {
  replay::LogHeader header = setup.header;
  header.scene.steps = setup.steps_until;
  header.scene.inputs.clear();
  for (const StepSetup& step : setup.steps) {
    header.scene.inputs.push_back({step.step, sim::SetDt{step.dt}});
    for (const sim::Command& input : step.inputs) header.scene.inputs.push_back({step.step, input});
  }
  const Result<replay::MessageBytes> message = replay::encode_header(header);
  if (!message.ok()) return message.error();
  const std::span<const std::byte> bytes = message->bytes();
  auto data = out.initSetup(static_cast<unsigned>(bytes.size()));
  std::memcpy(data.begin(), bytes.data(), bytes.size());
  return {};
}

Status decode(schema::Expected::Reader in, std::optional<ExpectedSetup>& setup) {
  const capnp::Data::Reader data = in.getSetup();
  if (data.size() == 0) return {};
  if (data.size() % 8 != 0) return damaged("setup: found " + std::to_string(data.size()) + " bytes");
  replay::MessageBytes message(data.size());
  std::memcpy(message.bytes().data(), data.begin(), data.size());
  Result<replay::LogHeader> header = replay::decode_header(message);
  if (!header.ok()) return Error{header.error().kind, "setup: " + header.error().message};
  ExpectedSetup found{*std::move(header), {}, 0};
  found.steps_until = std::exchange(found.header.scene.steps, 0);
  for (sim::TimedCommand& input : std::exchange(found.header.scene.inputs, {})) {
    if (!found.steps.empty() && input.step < found.steps.back().step) return damaged("setup: found steps out of order");
    if (!found.steps.empty() && input.step == found.steps.back().step) {
      found.steps.back().inputs.push_back(std::move(input.command));
      continue;
    }
    const auto* dt = std::get_if<sim::SetDt>(&input.command);
    if (dt == nullptr) return damaged("setup: found a step without its dt");
    found.steps.push_back({input.step, dt->dt, {}});
  }
  setup = std::move(found);
  return {};
}

}  // namespace tumble::golden

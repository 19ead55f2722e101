#include "replay/codec/extras_codec.h"

#include <algorithm>
#include <array>
#include <string>
#include <utility>

#include "replay/codec/blob.h"
#include "replay/codec/channel_codec.h"
#include "replay/codec/shape_codec.h"
#include "replay/codec/state_keys.h"
#include "replay/format/limits.h"
#include "src/base/check.h"

namespace tumble::replay {
namespace {

using ExtrasOfSteps = std::span<const Extras* const>;
using ChannelIndex = std::pair<std::size_t, ChannelType>;

constexpr std::size_t kContactColumns = kContactNumbers.size();
constexpr unsigned kCameraNumbers = 9;

void encode_channels(ExtrasOfSteps steps, const ChannelTypes& types, schema::Extras::Builder out) {
  std::vector<std::size_t> used;
  for (std::size_t c = 0; c < types.size(); ++c) {
    if (std::ranges::any_of(steps, [c](const Extras* step) { return !step->values(c).empty(); })) used.push_back(c);
  }
  auto channels = out.initChannels(static_cast<unsigned>(used.size()));
  for (unsigned i = 0; i < used.size(); ++i) {
    std::vector<const ChannelValues*> values;
    for (const Extras* step : steps) values.push_back(&step->values(used[i]));
    encode(used[i], types[used[i]], values, channels[i]);
  }
}

void encode_contacts(ExtrasOfSteps steps, schema::Extras::Builder out) {
  const auto touches = [](const Extras* step) { return !step->contacts.empty(); };
  if (std::ranges::none_of(steps, touches)) return;
  StepRows rows;
  std::array<std::vector<std::uint64_t>, kContactColumns> columns;
  for (const Extras* step : steps) {
    std::vector<ChannelKey> keys;
    for (const EngineContact& contact : step->contacts) {
      keys.push_back({contact.a, contact.b});
      const auto numbers = numbers_of(contact);
      for (std::size_t c = 0; c < kContactColumns; ++c) columns[c].push_back(codec1::ordered(bits_of(numbers[c])));
    }
    rows.add_step(keys);
  }
  schema::Contacts::Builder contacts = out.initContacts();
  encode(rows, ChannelScope::kPair, contacts.initRows());
  auto doubles = contacts.initDoubles(kContactColumns);
  for (unsigned c = 0; c < kContactColumns; ++c) {
    const std::vector<std::uint64_t> residuals = residuals_of(rows, std::span<const std::uint64_t>(columns[c]));
    put_planes(std::span<const std::uint64_t>(residuals), doubles.init(c, static_cast<unsigned>(residuals.size() * 8)));
  }
}

/// One list of structs over all steps: init(count) makes it, put(struct, step, item) fills one.
template <class Item, class Init, class Put>
void encode_list(ExtrasOfSteps steps, std::vector<Item> Extras::*items, std::uint64_t first_step, Init init, Put put) {
  std::size_t count = 0;
  for (const Extras* step : steps) count += (step->*items).size();
  if (count == 0) return;
  auto list = init(static_cast<unsigned>(count));
  unsigned next = 0;
  for (std::size_t i = 0; i < steps.size(); ++i) {
    for (const Item& item : steps[i]->*items) put(list[next++], first_step + i, item);
  }
}

void put_view(schema::View::Builder out, std::uint64_t step, const View& view) {
  out.setStep(step);
  out.setPart(view.part);
  out.setWallTime(view.wall_time);
  const sim::Camera& c = view.camera;
  const std::array<double, kCameraNumbers> numbers = {
      c.position.x(), c.position.y(), c.position.z(), c.target.x(), c.target.y(), c.target.z(), c.fov, c.focus, c.blur};
  auto camera = out.initCamera(kCameraNumbers);
  for (unsigned i = 0; i < kCameraNumbers; ++i) camera.set(i, numbers[i]);
  out.setEffects(view.effects);
  out.setFollow(view.follow);
}

Result<View> view_of(schema::View::Reader in) {
  const capnp::Text::Reader effects = in.getEffects();
  const auto n = in.getCamera();
  if (n.size() != kCameraNumbers) return damaged("views: found a camera of " + std::to_string(n.size()) + " numbers");
  View view;
  view.part = in.getPart();
  view.wall_time = in.getWallTime();
  view.camera = {{n[0], n[1], n[2]}, {n[3], n[4], n[5]}, n[6], n[7], n[8]};
  view.effects = {effects.cStr(), effects.size()};
  view.follow = in.getFollow();
  return view;
}

capnp::Data::Reader data_of(const std::string& bytes) {
  return {reinterpret_cast<const capnp::byte*>(bytes.data()), bytes.size()};
}

/// Reads a list whose items name their steps, in ascending order. add(extras of the step, item) returns a Status.
template <class List, class Add>
Status decode_list(const char* name, List list, std::uint64_t most, std::uint64_t first_step,
                   std::span<Extras* const> steps, Add add) {
  if (list.size() > most) return damaged(std::string(name) + ": found " + std::to_string(list.size()));
  std::uint64_t before = first_step;
  for (const auto item : list) {
    const std::uint64_t step = item.getStep();
    if (step < before || step - first_step >= steps.size()) {
      return damaged(std::string(name) + ": found one of step " + std::to_string(step) + ", wanted steps from " +
                     std::to_string(before) + " on, inside the chunk");
    }
    before = step;
    if (Status ok = add(*steps[step - first_step], item); !ok.ok()) return ok;
  }
  return {};
}

Status decode_contacts(schema::Contacts::Reader in, std::span<Extras* const> steps, std::uint64_t& rows_left) {
  const auto doubles = in.getDoubles();
  if (doubles.size() != kContactColumns)
    return damaged("contacts: found " + std::to_string(doubles.size()) + " columns");
  std::array<capnp::Data::Reader, kContactColumns> data;  // each is got once: see read_message()
  for (unsigned c = 0; c < kContactColumns; ++c) data[c] = doubles[c];
  const RowLimits limits = {rows_left, 8, data[0].size(), false};
  const Result<StepRows> rows = decode(in.getRows(), ChannelScope::kPair, steps.size(), limits);
  if (!rows.ok()) return rows.error();
  std::array<std::vector<std::uint64_t>, kContactColumns> columns;
  for (unsigned c = 0; c < kContactColumns; ++c) {
    if (Status ok = get_planes("contacts: doubles", data[c], rows->keys.size(), columns[c]); !ok.ok()) return ok;
    columns[c] = values_of(*rows, std::move(columns[c]));
  }
  std::size_t row = 0;
  const auto number = [&](std::size_t c) { return double_of(codec1::unordered(columns[c][row])); };
  for (std::size_t i = 0; i < steps.size(); ++i) {
    steps[i]->contacts.reserve(rows->counts[i]);
    for (std::uint32_t k = 0; k < rows->counts[i]; ++k, ++row) {
      steps[i]->contacts.push_back({rows->keys[row].a,
                                    rows->keys[row].b,
                                    {number(0), number(1), number(2)},
                                    {number(3), number(4), number(5)},
                                    number(6),
                                    number(7)});
    }
  }
  return {};
}

Result<std::vector<ChannelIndex>> decode_channels(schema::Extras::Reader in, std::span<Extras* const> steps,
                                                  std::uint64_t& rows_left) {
  std::vector<ChannelIndex> found;
  const auto channels = in.getChannels();
  if (channels.size() * steps.size() > kChannelStepsMax || channels.size() > kChannelsMax) {
    return damaged("found " + std::to_string(channels.size()) + " channels in a chunk of " +
                   std::to_string(steps.size()) + " steps");
  }
  std::size_t next = 0;
  for (const schema::ChannelValues::Reader channel : channels) {
    const std::size_t index = channel.getChannel();
    const ChannelType type = {static_cast<ChannelKind>(channel.getKind()),
                              static_cast<ChannelScope>(channel.getScope())};
    if (index < next || (index + 1) * steps.size() > kChannelStepsMax || index >= kChannelsMax) {
      return damaged("found values of channel " + std::to_string(index) + ", wanted one from " + std::to_string(next) +
                     " on");
    }
    if (type.kind > ChannelKind::kText || type.scope > ChannelScope::kPair) {
      return bad_input("channel " + std::to_string(index) +
                       " has values of a kind that this program does not know; "
                       "use a newer one");
    }
    next = index + 1;
    found.emplace_back(index, type);
    std::vector<ChannelValues*> values;
    for (Extras* step : steps) {
      step->channels.resize(index + 1);
      values.push_back(&step->channels[index]);
    }
    if (Status ok = decode(channel, type, values, rows_left); !ok.ok()) return ok.error();
  }
  return found;
}

Status decode_lists(schema::Extras::Reader in, std::uint64_t first_step, std::span<Extras* const> steps) {
  const auto list = [&](const char* name, auto items, auto add) {
    return decode_list(name, items, kExtraListMax, first_step, steps, add);
  };
  Status ok = list("notes", in.getNotes(), [](Extras& step, schema::Note::Reader note) -> Status {
    const capnp::Text::Reader text = note.getText();
    step.notes.emplace_back(text.cStr(), text.size());
    return {};
  });
  if (!ok.ok()) return ok;
  ok = list("snapshots", in.getSnapshots(), [](Extras& step, schema::Snapshot::Reader snapshot) -> Status {
    const capnp::Data::Reader bytes = snapshot.getBytes();
    const capnp::Text::Reader name = snapshot.getName();
    step.snapshots.push_back(
        {{name.cStr(), name.size()}, {reinterpret_cast<const char*>(bytes.begin()), bytes.size()}});
    return {};
  });
  if (!ok.ok()) return ok;
  ok = list("views", in.getViews(), [](Extras& step, schema::View::Reader view) -> Status {
    Result<View> one = view_of(view);
    if (!one.ok()) return one.error();
    step.views.push_back(*std::move(one));
    return {};
  });
  if (!ok.ok()) return ok;
  ok = list("superseded", in.getSuperseded(), [](Extras& step, schema::Superseded::Reader before) -> Status {
    const capnp::Text::Reader text = before.getDifference();
    step.superseded.push_back({before.getSameInputs(), {text.cStr(), text.size()}});
    return {};
  });
  if (!ok.ok()) return ok;
  return list("bodies", in.getBodies(), [](Extras& step, schema::NewBody::Reader body) -> Status {
    Result<BodyInfo> info = decode(body.getBody());
    if (!info.ok()) return info.error();
    step.bodies.push_back(*std::move(info));
    return {};
  });
}

}  // namespace

void encode(ExtrasOfSteps steps, std::uint64_t first_step, const ChannelTypes& types, schema::Extras::Builder out) {
  encode_channels(steps, types, out);
  encode_contacts(steps, out);
  const auto list = [&](auto items, auto init, auto put) { encode_list(steps, items, first_step, init, put); };
  list(
      &Extras::notes, [&](unsigned n) { return out.initNotes(n); },
      [](schema::Note::Builder note, std::uint64_t step, const std::string& text) {
        note.setStep(step);
        note.setText(text);
      });
  list(
      &Extras::snapshots, [&](unsigned n) { return out.initSnapshots(n); },
      [](schema::Snapshot::Builder out_one, std::uint64_t step, const EngineSnapshot& snapshot) {
        out_one.setStep(step);
        out_one.setBytes(data_of(snapshot.bytes));
        if (!snapshot.name.empty()) out_one.setName(snapshot.name);
      });
  list(
      &Extras::views, [&](unsigned n) { return out.initViews(n); }, put_view);
  list(
      &Extras::superseded, [&](unsigned n) { return out.initSuperseded(n); },
      [](schema::Superseded::Builder superseded, std::uint64_t step, const Superseded& before) {
        superseded.setStep(step);
        superseded.setSameInputs(before.same_inputs);
        superseded.setDifference(before.difference);
      });
  list(
      &Extras::bodies, [&](unsigned n) { return out.initBodies(n); },
      [](schema::NewBody::Builder body, std::uint64_t step, const BodyInfo& info) {
        body.setStep(step);
        encode(info, body.initBody());
      });
  list(
      &Extras::shapes, [&](unsigned n) { return out.initShapes(n); },
      [](schema::Shape::Builder shape, std::uint64_t, const Shape& item) { encode(item, shape); });
}

Result<std::vector<ChannelIndex>> decode(schema::Extras::Reader in, std::uint64_t first_step,
                                         std::span<Extras* const> steps) {
  if (steps.empty()) return damaged("found extras of no step");
  std::uint64_t rows_left = kExtraRowsMax;
  Result<std::vector<ChannelIndex>> channels = decode_channels(in, steps, rows_left);
  if (!channels.ok()) return channels;
  if (in.hasContacts()) {
    if (Status ok = decode_contacts(in.getContacts(), steps, rows_left); !ok.ok()) return ok.error();
  }
  if (Status ok = decode_lists(in, first_step, steps); !ok.ok()) return ok.error();
  for (const schema::Shape::Reader shape : in.getShapes()) {  // shapes name no step: the chunk's first one has them
    Result<Shape> one = decode(shape);
    if (!one.ok()) return one.error();
    steps.front()->shapes.push_back(*std::move(one));
  }
  for (const Extras* step : steps) {
    if (Status ok = check_extras(*step); !ok.ok()) return damaged(ok.error().message);
  }
  return channels;
}

}  // namespace tumble::replay

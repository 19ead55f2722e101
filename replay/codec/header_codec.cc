#include "replay/codec/header_codec.h"

#include <array>
#include <utility>

#include "replay/codec/extras_codec.h"
#include "replay/codec/message.h"
#include "replay/codec/scene_codec.h"
#include "replay/codec/shape_codec.h"
#include "replay/format/limits.h"
#include "src/base/check.h"
#include "tumble/sim/limits.h"

namespace tumble::replay {
namespace {

void encode_texts(const std::vector<std::string>& texts, capnp::List<capnp::Text>::Builder out) {
  for (unsigned i = 0; i < out.size(); ++i) out.set(i, texts[i]);
}

std::vector<std::string> decode_texts(capnp::List<capnp::Text>::Reader in) {
  std::vector<std::string> texts;
  for (const capnp::Text::Reader text : in) texts.emplace_back(text.cStr(), text.size());
  return texts;
}

void encode_recovered(const Recovered& recovered, schema::Recovered::Builder out) {
  out.setLog(recovered.log);
  out.setHeaderLost(recovered.header_lost);
  auto missing = out.initGaps(static_cast<unsigned>(recovered.missing.size()));
  for (unsigned i = 0; i < missing.size(); ++i) {
    missing[i].setFirstStep(recovered.missing[i].first_step);
    missing[i].setStepCount(recovered.missing[i].step_count);
  }
}

Result<Recovered> decode_recovered(schema::Recovered::Reader in) {
  Recovered recovered{in.getLog().cStr(), in.getHeaderLost(), {}};
  const auto missing = in.getGaps();
  if (missing.size() > kChunksMax) return damaged("found " + std::to_string(missing.size()) + " runs of missing steps");
  std::uint64_t before = 0;
  for (const schema::Recovered::Gap::Reader run : missing) {
    recovered.missing.push_back({run.getFirstStep(), run.getStepCount()});
    const MissingSteps& last = recovered.missing.back();
    const bool fits = last.first_step > before && last.step_count > 0 && last.first_step <= sim::kStepsMax &&
                      last.step_count <= sim::kStepsMax;
    if (!fits) {
      return damaged("found a run of " + std::to_string(last.step_count) + " steps from step " +
                     std::to_string(last.first_step) + " on, wanted one after step " + std::to_string(before));
    }
    before = last.end_step();
  }
  return recovered;
}

// Engine and Imported begin with the same fields.
template <class Builder>
void encode_engine(const EngineName& engine, Builder out) {
  out.setName(engine.name);
  out.setVersion(engine.version);
  out.setPrecisionBits(static_cast<std::uint8_t>(engine.precision_bits));
}

template <class Reader>
EngineName engine_name(Reader in) {
  return {in.getName().cStr(), in.getVersion().cStr(), in.getPrecisionBits()};
}

void encode_table(const ImportedTable& table, schema::Imported::Builder out) {
  SIM_CHECK(check_table(table).ok(), table.axes.up, table.axes.metres, table.passed_over.size());
  out.setUp(static_cast<std::uint8_t>(table.axes.up));
  out.setLeftHanded(table.axes.left_handed);
  out.setMetres(table.axes.metres);
  encode_texts(table.passed_over, out.initPassedOver(static_cast<unsigned>(table.passed_over.size())));
}

Result<ImportedTable> decode_table(schema::Imported::Reader in) {
  ImportedTable table = {{in.getUp(), in.getLeftHanded(), in.getMetres()}, decode_texts(in.getPassedOver())};
  if (Status ok = check_table(table); !ok.ok()) return damaged(ok.error().message);
  return table;
}

/// first_state: the number of the state that the log begins with.
void encode_declared(const Declared& declared, std::uint64_t first_state, schema::Declared::Builder out) {
  auto channels = out.initChannels(static_cast<unsigned>(declared.channels.size()));
  ChannelTypes types;
  for (unsigned i = 0; i < channels.size(); ++i) {
    const Channel& channel = declared.channels[i];
    channels[i].setName(channel.name);
    channels[i].setKind(static_cast<std::uint8_t>(channel.type.kind));
    channels[i].setScope(static_cast<std::uint8_t>(channel.type.scope));
    channels[i].setUnit(channel.unit);
    types.push_back(channel.type);
  }
  auto shapes = out.initShapes(static_cast<unsigned>(declared.shapes.size()));
  for (unsigned i = 0; i < shapes.size(); ++i) encode(declared.shapes[i], shapes[i]);
  auto bodies = out.initBodies(static_cast<unsigned>(declared.bodies.size()));
  for (unsigned i = 0; i < bodies.size(); ++i) encode(declared.bodies[i], bodies[i]);
  const std::array<const Extras*, 1> start = {&declared.start};
  if (!declared.start.empty()) encode(start, first_state, types, out.initStart());
  out.setVelocityDerived(declared.velocity_derived);
  if (!declared.cut_short.empty()) out.setCutShort(declared.cut_short);
  out.setSpinDerived(declared.spin_derived);
}

Result<Declared> decode_declared(schema::Declared::Reader in, std::uint64_t first_state) {
  Declared declared;
  const auto channels = in.getChannels();
  if (channels.size() > kChannelsMax) return damaged("found " + std::to_string(channels.size()) + " channels");
  for (const schema::Channel::Reader channel : channels) {
    const capnp::Text::Reader name = channel.getName(), unit = channel.getUnit();
    declared.channels.push_back(
        {std::string(name.cStr(), name.size()),
         {static_cast<ChannelKind>(channel.getKind()), static_cast<ChannelScope>(channel.getScope())},
         std::string(unit.cStr(), unit.size())});
  }
  for (const schema::Shape::Reader shape : in.getShapes()) {
    Result<Shape> one = decode(shape);
    if (!one.ok()) return one.error();
    declared.shapes.push_back(*std::move(one));
  }
  for (const schema::BodyInfo::Reader body : in.getBodies()) {
    Result<BodyInfo> info = decode(body);
    if (!info.ok()) return info.error();
    declared.bodies.push_back(*std::move(info));
  }
  if (in.hasStart()) {
    const std::array<Extras*, 1> start = {&declared.start};
    const auto found = decode(in.getStart(), first_state, start);
    if (!found.ok()) return found.error();
    for (const auto& [index, type] : *found) {
      if (index < declared.channels.size() && declared.channels[index].type == type) continue;
      return damaged("found a value of channel " + std::to_string(index) + " that is not declared so");
    }
  }
  declared.velocity_derived = in.getVelocityDerived();
  declared.cut_short = in.getCutShort().cStr();
  declared.spin_derived = in.getSpinDerived();
  if (Status ok = check_declared(declared); !ok.ok()) return damaged(ok.error().message);
  return declared;
}

Result<LogHeader> decode_root(schema::Header::Reader in, std::uint64_t message_bytes) {
  LogHeader header;
  header.tool_version = in.getToolVersion().cStr();
  header.tool_build = in.getToolBuild().cStr();
  header.method = in.getMethod().cStr();
  header.method_version = in.getMethodVersion();
  header.float_format = in.getFloatFormat().cStr();
  const auto phases = in.getPhases();
  if (phases.size() > kPhasesMax) {
    return damaged("found " + std::to_string(phases.size()) + " phases, wanted at most " + std::to_string(kPhasesMax));
  }
  header.phases = decode_texts(phases);
  header.phase_rows_max = in.getPhaseRowsMax();
  header.phase_hash_version = in.getPhaseHashVersion();
  Result<sim::SceneDef> scene = decode(in.getScene(), message_bytes);
  if (!scene.ok()) return scene.error();
  header.scene = *std::move(scene);
  const capnp::Text::Reader text = in.getSceneText();
  header.scene_text.assign(text.cStr(), text.size());
  const auto overrides = in.getOverrides();
  if (overrides.size() > kOverridesMax) return damaged("found " + std::to_string(overrides.size()) + " overrides");
  header.overrides = decode_texts(overrides);
  header.transform = decode(in.getTransform());
  if (in.hasGoesOn()) {
    const schema::GoesOn::Reader before = in.getGoesOn();
    const Hash128 hash = {before.getContinuationHigh(), before.getContinuationLow()};
    header.goes_on = {before.getStep(), before.getLog().cStr(), hash, {}};
  }
  if (in.isEngine() && in.hasEngine()) header.engine = engine_name(in.getEngine());
  if (in.isImported()) {
    header.engine = engine_name(in.getImported());
    Result<ImportedTable> table = decode_table(in.getImported());
    if (!table.ok()) return table.error();
    header.table = *std::move(table);
  }
  if (in.hasDeclared()) {
    Result<Declared> declared = decode_declared(in.getDeclared(), header.goes_on ? header.goes_on->step : 0);
    if (!declared.ok()) return declared.error();
    header.declared = *std::move(declared);
  }
  if (in.hasRecovered()) {
    Result<Recovered> recovered = decode_recovered(in.getRecovered());
    if (!recovered.ok()) return recovered.error();
    header.recovered = *std::move(recovered);
  }
  header.states.every = in.getStatesEvery();
  header.hashes.every = in.getPhaseHashesEvery();
  header.chunk_steps_max = in.getChunkStepsMax();
  header.chunk_bytes_max = in.getChunkBytesMax();
  return header;
}

}  // namespace

Result<MessageBytes> encode_header(const LogHeader& header) {
  const std::size_t guess = header.scene.boxes.size() * 256 + header.scene_text.size();
  return write_message<schema::Header>(guess, [&](schema::Header::Builder out) {
    out.setToolVersion(header.tool_version);
    out.setToolBuild(header.tool_build);
    out.setMethod(header.method);
    out.setMethodVersion(header.method_version);
    out.setFloatFormat(header.float_format);
    encode_texts(header.phases, out.initPhases(static_cast<unsigned>(header.phases.size())));
    out.setPhaseRowsMax(header.phase_rows_max);
    out.setPhaseHashVersion(header.phase_hash_version);
    encode(header.scene, out.initScene());
    out.setSceneText(header.scene_text);
    encode_texts(header.overrides, out.initOverrides(static_cast<unsigned>(header.overrides.size())));
    encode(header.transform, out.initTransform());
    if (header.goes_on) {
      schema::GoesOn::Builder before = out.initGoesOn();
      before.setStep(header.goes_on->step);
      before.setLog(header.goes_on->log);
      before.setContinuationLow(header.goes_on->continuation_hash.low);
      before.setContinuationHigh(header.goes_on->continuation_hash.high);
    }
    SIM_CHECK(header.engine || !header.table);
    if (header.table) {
      schema::Imported::Builder imported = out.initImported();
      encode_engine(*header.engine, imported);
      encode_table(*header.table, imported);
    } else if (header.engine) {
      encode_engine(*header.engine, out.initEngine());
    }
    if (!header.declared.empty()) {
      encode_declared(header.declared, header.goes_on ? header.goes_on->step : 0, out.initDeclared());
    }
    if (header.recovered) encode_recovered(*header.recovered, out.initRecovered());
    out.setStatesEvery(header.states.every);
    out.setPhaseHashesEvery(header.hashes.every);
    out.setChunkStepsMax(header.chunk_steps_max);
    out.setChunkBytesMax(header.chunk_bytes_max);
  });
}

Result<LogHeader> decode_header(const MessageBytes& message) {
  const std::uint64_t bytes = message.bytes().size();
  return read_message<schema::Header>(message, [&](schema::Header::Reader in) { return decode_root(in, bytes); });
}

}  // namespace tumble::replay

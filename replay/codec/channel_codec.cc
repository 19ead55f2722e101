#include "replay/codec/channel_codec.h"

#include <algorithm>
#include <string>

#include "replay/codec/blob.h"
#include "replay/codec/state_keys.h"
#include "replay/format/limits.h"
#include "src/base/check.h"

namespace tumble::replay {
namespace {

constexpr std::uint32_t kSignBit32 = 0x80000000U;

std::uint64_t ordered_word(std::uint64_t bits) { return codec1::ordered(bits); }
std::uint64_t unordered_word(std::uint64_t key) { return codec1::unordered(key); }
std::uint32_t ordered_word(std::uint32_t bits) { return (bits & kSignBit32) != 0 ? ~bits : bits | kSignBit32; }
std::uint32_t unordered_word(std::uint32_t key) { return (key & kSignBit32) != 0 ? key & ~kSignBit32 : ~key; }

template <class Word>
Word zigzag(Word difference) {
  constexpr unsigned kTop = 8 * sizeof(Word) - 1;
  return static_cast<Word>((difference << 1U) ^ (Word{0} - (difference >> kTop)));
}
template <class Word>
Word unzigzag(Word number) {
  return static_cast<Word>((number >> 1U) ^ (Word{0} - (number & 1U)));
}

/// Calls visit(row, predicting row or row itself where nothing predicts), over all rows in order.
template <class Visit>
void for_each_row(const StepRows& rows, Visit visit) {
  std::size_t row = 0;
  for (std::size_t step = 0; step < rows.counts.size(); ++step) {
    for (std::uint32_t i = 0; i < rows.counts[step]; ++i, ++row) {
      const std::size_t back = rows.same[step] != 0 ? rows.counts[step] : (i > 0 ? 1 : 0);
      visit(row, row - back);
    }
  }
}

std::vector<std::uint64_t> bodies_of(const StepRows& rows, sim::BodyId ChannelKey::*body) {
  std::vector<std::uint64_t> bodies;
  std::size_t row = 0;
  for (std::size_t step = 0; step < rows.counts.size(); ++step) {
    for (std::uint32_t i = 0; i < rows.counts[step]; ++i, ++row) {
      if (rows.same[step] == 0) bodies.push_back(rows.keys[row].*body);
    }
  }
  return bodies;
}

void put_bodies(const std::vector<std::uint64_t>& bodies, capnp::Data::Builder out) {
  put_differences(std::span<const std::uint64_t>(bodies), out);
}

Status check_keys(const StepRows& rows, ChannelScope scope, bool each_once) {
  std::size_t row = 0;
  for (const std::uint32_t count : rows.counts) {
    if (scope == ChannelScope::kWorld && count > 1) return damaged("found a step with two values of a world channel");
    for (std::uint32_t i = 1; i < count; ++i) {
      const ChannelKey &before = rows.keys[row + i - 1], &key = rows.keys[row + i];
      if (before < key || (!each_once && before == key)) continue;
      return damaged("found a value of body " + std::to_string(key.a) + " after one of body " +
                     std::to_string(before.a) + ", wanted ascending bodies");
    }
    row += count;
  }
  return {};
}

/// Counts and flags, checked against one another. Returns the number of rows whose keys are stored.
Result<std::uint64_t> decode_counts(schema::Rows::Reader in, std::size_t step_count, const RowLimits& limits,
                                    StepRows& rows) {
  if (Status ok = get_plain("rows: counts", in.getCounts(), step_count, rows.counts); !ok.ok()) return ok.error();
  if (Status ok = get_plain("rows: sameBodies", in.getSameBodies(), step_count, rows.same); !ok.ok()) return ok.error();
  std::uint64_t total = 0, stored = 0;
  for (std::size_t i = 0; i < step_count; ++i) {
    total += rows.counts[i];
    if (rows.same[i] == 0) stored += rows.counts[i];
    const bool same_count = i > 0 && rows.counts[i] == rows.counts[i - 1];
    if (rows.same[i] != 0 && !same_count) return damaged("rows: found a step like the one before, with other rows");
  }
  if (total > limits.left || total * limits.row_bytes > limits.value_bytes) {
    return damaged("rows: found " + std::to_string(total) + " rows in " + std::to_string(limits.value_bytes) +
                   " bytes of values");
  }
  limits.left -= total;
  rows.keys.resize(total);
  return stored;
}

template <class Word>
void encode_numbers(const StepRows& rows, bool floating, std::span<const ChannelValues* const> steps,
                    schema::ChannelValues::Builder out) {
  std::vector<Word> words;
  words.reserve(rows.keys.size());
  for (const ChannelValues* step : steps) {
    SIM_CHECK(step->bits.size() == step->size(), step->bits.size(), step->size());
    for (const std::uint64_t bits : step->bits) {
      const auto word = static_cast<Word>(bits);
      words.push_back(floating ? ordered_word(word) : word);
    }
  }
  const std::vector<Word> residuals = residuals_of(rows, std::span<const Word>(words));
  put_planes(std::span<const Word>(residuals), out.initNumbers(static_cast<unsigned>(residuals.size() * sizeof(Word))));
}

template <class Word>
Status decode_numbers(capnp::Data::Reader in, const StepRows& rows, bool floating,
                      std::span<ChannelValues* const> steps) {
  std::vector<Word> words;
  if (Status ok = get_planes("channel: numbers", in, rows.keys.size(), words); !ok.ok()) return ok;
  words = values_of(rows, std::move(words));
  std::size_t row = 0;
  for (std::size_t i = 0; i < steps.size(); ++i) {
    steps[i]->bits.reserve(rows.counts[i]);
    for (std::uint32_t k = 0; k < rows.counts[i]; ++k, ++row) {
      steps[i]->bits.push_back(floating ? unordered_word(words[row]) : words[row]);
    }
  }
  return {};
}

void encode_bytes(std::span<const ChannelValues* const> steps, schema::ChannelValues::Builder out) {
  std::vector<std::uint32_t> lengths;
  std::string all;
  for (const ChannelValues* step : steps) {
    SIM_CHECK(step->bytes.size() == step->size(), step->bytes.size(), step->size());
    for (const std::string& bytes : step->bytes) {
      lengths.push_back(static_cast<std::uint32_t>(bytes.size()));
      all += bytes;
    }
  }
  put_planes(std::span<const std::uint32_t>(lengths), out.initNumbers(static_cast<unsigned>(lengths.size() * 4)));
  capnp::Data::Builder data = out.initBytes(static_cast<unsigned>(all.size()));
  std::copy(all.begin(), all.end(), reinterpret_cast<char*>(data.begin()));
}

Status decode_bytes(capnp::Data::Reader numbers, capnp::Data::Reader data, const StepRows& rows,
                    std::span<ChannelValues* const> steps) {
  if (rows.keys.size() > kTextRowsMax) return damaged("channel: found too many values of text");
  std::vector<std::uint32_t> lengths;
  if (Status ok = get_planes("channel: lengths", numbers, rows.keys.size(), lengths); !ok.ok()) return ok;
  std::size_t row = 0, begin = 0;
  for (std::size_t i = 0; i < steps.size(); ++i) {
    steps[i]->bytes.reserve(rows.counts[i]);
    for (std::uint32_t k = 0; k < rows.counts[i]; ++k, ++row) {
      if (lengths[row] > data.size() - begin) return damaged("channel: found a value longer than its bytes");
      steps[i]->bytes.emplace_back(reinterpret_cast<const char*>(data.begin()) + begin, lengths[row]);
      begin += lengths[row];
    }
  }
  if (begin == data.size()) return {};
  return damaged("channel: found " + std::to_string(data.size() - begin) + " bytes behind the last value");
}

}  // namespace

void StepRows::add_step(std::span<const ChannelKey> next) {
  const std::size_t before = counts.empty() ? 0 : counts.back();
  const auto last = std::span<const ChannelKey>(keys).last(before);
  same.push_back(!counts.empty() && std::ranges::equal(last, next) ? 1 : 0);
  counts.push_back(static_cast<std::uint32_t>(next.size()));
  keys.insert(keys.end(), next.begin(), next.end());
}

void encode(const StepRows& rows, ChannelScope scope, schema::Rows::Builder out) {
  const auto n = static_cast<unsigned>(rows.counts.size());
  put_plain(std::span<const std::uint32_t>(rows.counts), out.initCounts(n * 4));
  put_plain(std::span<const std::uint8_t>(rows.same), out.initSameBodies(n));
  if (scope == ChannelScope::kWorld) return;
  const std::vector<std::uint64_t> a = bodies_of(rows, &ChannelKey::a);
  put_bodies(a, out.initBodyA(static_cast<unsigned>(a.size() * 8)));
  if (scope == ChannelScope::kBody) return;
  const std::vector<std::uint64_t> b = bodies_of(rows, &ChannelKey::b);
  put_bodies(b, out.initBodyB(static_cast<unsigned>(b.size() * 8)));
}

Result<StepRows> decode(schema::Rows::Reader in, ChannelScope scope, std::size_t step_count, const RowLimits& limits) {
  StepRows rows;
  const Result<std::uint64_t> stored = decode_counts(in, step_count, limits, rows);
  if (!stored.ok()) return stored.error();
  std::vector<std::uint64_t> a, b;
  const std::size_t with_a = scope == ChannelScope::kWorld ? 0 : *stored;
  const std::size_t with_b = scope == ChannelScope::kPair ? *stored : 0;
  if (Status ok = get_differences("rows: bodyA", in.getBodyA(), with_a, a); !ok.ok()) return ok.error();
  if (Status ok = get_differences("rows: bodyB", in.getBodyB(), with_b, b); !ok.ok()) return ok.error();
  std::size_t row = 0, next = 0;
  for (std::size_t step = 0; step < step_count; ++step) {
    for (std::uint32_t i = 0; i < rows.counts[step]; ++i, ++row) {
      if (rows.same[step] != 0) {
        rows.keys[row] = rows.keys[row - rows.counts[step]];
        continue;
      }
      rows.keys[row] = {with_a > 0 ? a[next] : 0, with_b > 0 ? b[next] : 0};
      ++next;
    }
  }
  if (Status ok = check_keys(rows, scope, limits.each_once); !ok.ok()) return ok.error();
  return rows;
}

template <class Word>
std::vector<Word> residuals_of(const StepRows& rows, std::span<const Word> values) {
  std::vector<Word> residuals(values.size());
  for_each_row(rows, [&](std::size_t row, std::size_t from) {
    const Word predicted = from == row ? Word{0} : values[from];
    residuals[row] = zigzag(static_cast<Word>(values[row] - predicted));
  });
  return residuals;
}

template <class Word>
std::vector<Word> values_of(const StepRows& rows, std::vector<Word> residuals) {
  SIM_CHECK(residuals.size() == rows.keys.size(), residuals.size(), rows.keys.size());
  for_each_row(rows, [&](std::size_t row, std::size_t from) {
    const Word predicted = from == row ? Word{0} : residuals[from];
    residuals[row] = static_cast<Word>(unzigzag(residuals[row]) + predicted);
  });
  return residuals;
}

template std::vector<std::uint64_t> residuals_of(const StepRows&, std::span<const std::uint64_t>);
template std::vector<std::uint64_t> values_of(const StepRows&, std::vector<std::uint64_t>);

void encode(std::size_t channel, ChannelType type, std::span<const ChannelValues* const> steps,
            schema::ChannelValues::Builder out) {
  StepRows rows;
  for (const ChannelValues* step : steps) rows.add_step(step->keys);
  out.setChannel(static_cast<std::uint16_t>(channel));
  out.setKind(static_cast<std::uint8_t>(type.kind));
  out.setScope(static_cast<std::uint8_t>(type.scope));
  encode(rows, type.scope, out.initRows());
  if (!is_number(type.kind)) {
    encode_bytes(steps, out);
  } else if (type.kind == ChannelKind::kFloat32) {
    encode_numbers<std::uint32_t>(rows, true, steps, out);
  } else {
    encode_numbers<std::uint64_t>(rows, type.kind == ChannelKind::kFloat64, steps, out);
  }
}

Status decode(schema::ChannelValues::Reader in, ChannelType type, std::span<ChannelValues* const> steps,
              std::uint64_t& rows_left) {
  const capnp::Data::Reader numbers = in.getNumbers();
  const bool narrow = type.kind == ChannelKind::kFloat32 || !is_number(type.kind);
  const RowLimits limits = {rows_left, narrow ? 4U : 8U, numbers.size()};
  const Result<StepRows> rows = decode(in.getRows(), type.scope, steps.size(), limits);
  if (!rows.ok()) return rows.error();
  std::size_t row = 0;
  for (std::size_t i = 0; i < steps.size(); ++i) {
    const auto begin = rows->keys.begin() + static_cast<std::ptrdiff_t>(row);
    steps[i]->keys.assign(begin, begin + rows->counts[i]);
    row += rows->counts[i];
  }
  if (!is_number(type.kind)) return decode_bytes(numbers, in.getBytes(), *rows, steps);
  if (type.kind == ChannelKind::kFloat32) return decode_numbers<std::uint32_t>(numbers, *rows, true, steps);
  return decode_numbers<std::uint64_t>(numbers, *rows, type.kind == ChannelKind::kFloat64, steps);
}

}  // namespace tumble::replay

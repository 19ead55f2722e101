#include "replay/export/table/npz_writer.h"

#include <algorithm>
#include <array>
#include <bit>
#include <string>
#include <utility>

#include "replay/export/table/npz_archive.h"
#include "replay/export/table/npz_channels.h"
#include "replay/export/table/npz_texts.h"
#include "replay/export/table/table_frame.h"
#include "replay/format/not_finite.h"
#include "src/base/text.h"

namespace tumble::replay {
namespace {

void put(double value, char* to) { put_little(std::bit_cast<std::uint64_t>(value), to); }

class NpzWriter : public ExportWriter {
 public:
  explicit NpzWriter(files::OutputFile& file) : archive_(file), frame_(EngineAxes{}) {}

  Status begin(const ExportPlan& plan) override {
    plan_ = &plan;
    frame_ = TableFrame(table_axes(plan.header));
    left_out_ = left_out_of_tables(plan);
    whole_ = plan.all_present();
    const std::uint64_t steps = plan.steps.size(), bodies = plan.bodies.size();
    const ItemType number = {"<f8", 8}, flag = {"|b1", 1};
    vectors_[0] = archive_.add("position", number, {steps, bodies, 3});
    vectors_[1] = archive_.add("orientation", number, {steps, bodies, 4});
    vectors_[2] = archive_.add("velocity", number, {steps, bodies, 3});
    vectors_[3] = archive_.add("spin", number, {steps, bodies, 3});
    frozen_ = archive_.add("frozen", flag, {steps, bodies});
    if (!whole_) present_ = archive_.add("present", flag, {steps, bodies});
    if (Status ok = channels_.begin(plan, archive_); !ok.ok()) return ok;
    if (Status ok = write_clock(); !ok.ok()) return ok;
    if (Status ok = write_bodies(); !ok.ok()) return ok;
    for (const auto& [key, value] : table_settings(plan)) {
      const Texts texts({value});
      if (Status ok = archive_.add_whole(key, texts.type(), {}, texts.bytes()); !ok.ok()) return ok;
    }
    return {};
  }

  [[nodiscard]] bool looks_first() const override { return channels_.has_pairs(); }
  void look(const ExportStep& step) override { channels_.look(step); }

  Status add(const ExportStep& step) override {
    const BodyStates& states = frame_.states(step.record.states);
    const ConstColumns columns = columns_of(states);
    constexpr std::array<std::size_t, 4> kFirst = {kPosition, kOrientation, kVelocity, kSpin};
    for (std::size_t v = 0; v < kFirst.size(); ++v) {
      const std::size_t width = kFirst[v] == kOrientation ? 4 : 3;
      bytes_.resize(step.rows.size() * width * 8);
      for (std::size_t c = 0; c < width; ++c) gather(*columns[kFirst[v] + c], step.rows, c, width);
      if (Status ok = archive_.append(vectors_[v], bytes_); !ok.ok()) return ok;
    }
    bytes_.resize(step.rows.size());
    for (std::size_t i = 0; i < step.rows.size(); ++i) {
      bytes_[i] = step.rows[i] != ExportStep::kAbsent && states.frozen[step.rows[i]] != 0 ? 1 : 0;
    }
    if (Status ok = archive_.append(frozen_, bytes_); !ok.ok()) return ok;
    if (!whole_) {
      std::ranges::transform(step.rows, bytes_.begin(),
                             [](std::uint32_t row) { return static_cast<char>(row != ExportStep::kAbsent); });
      if (Status ok = archive_.append(present_, bytes_); !ok.ok()) return ok;
    }
    return channels_.add(step, archive_);
  }

  Status finish() override {
    if (Status ok = channels_.finish(archive_); !ok.ok()) return ok;
    if (channels_.lost_values() > 0 && !plan_->chosen) left_out_.push_back(left_out_values(channels_.lost_values()));
    return archive_.finish();
  }

 private:
  /// Component `c` of vectors of `width` numbers.
  void gather(const std::vector<double>& column, std::span<const std::uint32_t> rows, std::size_t c,
              std::size_t width) {
    char* to = bytes_.data() + c * 8;
    for (const std::uint32_t row : rows) {
      put(row == ExportStep::kAbsent ? kNotANumber : column[row], to);
      to += width * 8;
    }
  }

  Status write_numbers(const std::string& name, const std::vector<double>& numbers,
                       const std::vector<std::uint64_t>& shape) {
    std::string bytes(numbers.size() * 8, '\0');
    for (std::size_t i = 0; i < numbers.size(); ++i) put(numbers[i], bytes.data() + i * 8);
    return archive_.add_whole(name, {"<f8", 8}, shape, bytes);
  }

  Status write_wholes(const std::string& name, const std::vector<std::uint64_t>& numbers) {
    std::string bytes(numbers.size() * 8, '\0');
    for (std::size_t i = 0; i < numbers.size(); ++i) put_little(numbers[i], bytes.data() + i * 8);
    return archive_.add_whole(name, {"<u8", 8}, {numbers.size()}, bytes);
  }

  Status write_clock() {
    if (Status ok = write_wholes("step", plan_->steps); !ok.ok()) return ok;
    if (Status ok = write_numbers("time", plan_->times, {plan_->times.size()}); !ok.ok() || plan_->dt) return ok;
    return write_numbers("dt", plan_->dts, {plan_->dts.size()});
  }

  template <class Number>
  Status write_number(const std::string& name, Number number_of) {
    std::vector<double> numbers;
    for (const ExportBody& body : plan_->bodies) numbers.push_back(number_of(body.box));
    return write_numbers(name, numbers, {numbers.size()});
  }

  template <class Word>
  Status write_words(const std::string& name, Word word_of) {
    std::vector<std::string> words;
    for (const ExportBody& body : plan_->bodies) words.push_back(word_of(body));
    const Texts texts(words);
    return archive_.add_whole(name, texts.type(), {words.size()}, texts.bytes());
  }

  Status write_bodies() {
    std::vector<std::uint64_t> ids;
    std::vector<double> sizes;
    std::string fixed;
    for (const ExportBody& body : plan_->bodies) {
      ids.push_back(body.box.id);
      const sim::Vec3 size = frame_.extents(body.box.size);
      sizes.insert(sizes.end(), {size.x(), size.y(), size.z()});
      fixed += body.box.is_static ? '\1' : '\0';
    }
    if (Status ok = write_wholes("id", ids); !ok.ok()) return ok;
    if (Status ok = write_numbers("size", sizes, {ids.size(), 3}); !ok.ok()) return ok;
    if (Status ok = archive_.add_whole("static", {"|b1", 1}, {ids.size()}, fixed); !ok.ok()) return ok;
    using Box = const sim::BoxDef&;
    const std::pair<const char*, double (*)(Box)> numbers[] = {
        {"mass", [](Box box) { return box.mass; }},
        {"friction", [](Box box) { return box.material.friction; }},
        {"friction_dynamic", [](Box box) { return box.material.friction_dynamic; }},
        {"restitution", [](Box box) { return box.material.restitution; }}};
    for (const auto& [name, number_of] : numbers) {
      if (Status ok = write_number(name, number_of); !ok.ok()) return ok;
    }
    const auto texture = [](const ExportBody& body) { return std::string(name_of(body.box.material.texture)); };
    if (Status ok = write_words("texture", texture); !ok.ok()) return ok;
    if (plan_->named()) {
      if (Status ok = write_words("name", [](const ExportBody& body) { return body.name; }); !ok.ok()) return ok;
    }
    if (std::ranges::none_of(plan_->bodies, [](const ExportBody& body) { return body.shape != nullptr; })) return {};
    return write_words("shape", [this](const ExportBody& body) { return shape_word(body, frame_.axes()); });
  }

  NpzArchive archive_;
  const ExportPlan* plan_ = nullptr;
  TableFrame frame_;
  NpzChannels channels_;
  bool whole_ = true;
  std::array<std::size_t, 4> vectors_ = {};
  std::size_t frozen_ = 0, present_ = 0;
  std::string bytes_;
};

}  // namespace

std::unique_ptr<ExportWriter> make_npz_writer(files::OutputFile& file) { return std::make_unique<NpzWriter>(file); }

}  // namespace tumble::replay

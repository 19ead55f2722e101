#include "replay/export/table/csv_writer.h"

#include <algorithm>
#include <utility>
#include <vector>

#include "replay/arrays/pair_cell.h"
#include "replay/export/table/channel_cells.h"
#include "replay/export/table/table_frame.h"
#include "src/base/text.h"

namespace tumble::replay {
namespace {

void append_comma(double number, std::string& row) {
  row += ',';
  row += number_cell(number);
}

bool fits_cell(const std::string& text) { return text_cell(text) == text; }

class CsvWriter : public ExportWriter {
 public:
  explicit CsvWriter(files::OutputFile& file) : file_(file), frame_(EngineAxes{}) {}

  Status begin(const ExportPlan& plan) override {
    plan_ = &plan;
    frame_ = TableFrame(table_axes(plan.header));
    left_out_ = left_out_of_tables(plan);
    named_ = plan.named();
    shaped_ = std::ranges::any_of(plan.bodies, [](const ExportBody& body) { return body.shape != nullptr; });
    gridded_ = std::ranges::any_of(
        plan.bodies, [](const ExportBody& body) { return body.box.origin.kind == sim::Origin::Kind::kGrid; });
    for (const Channel& channel : channels()) {
      // Texts of steps to come may need it.
      escaped_ =
          escaped_ || !is_number(channel.type.kind) || !fits_cell(channel_column(channel) + unit_in_column(channel));
    }
    escaped_ = escaped_ || std::ranges::any_of(plan.bodies, [](const ExportBody& body) {
                 return !body.name.empty() && !fits_cell(body.name);
               });
    for (const ExportBody& body : plan.bodies) describe(body);
    return write_head();
  }

  Status add(const ExportStep& step) override {
    write_world(step);
    const BodyStates& states = frame_.states(step.record.states);
    std::string front = std::to_string(step.record.step);
    append_comma(step.time, front);
    if (!plan_->dt) append_comma(plan_->dts[step.index], front);
    std::vector<std::size_t> from(channels().size(), 0);
    for (std::size_t i = 0; i < plan_->bodies.size(); ++i) {
      if (step.rows[i] == ExportStep::kAbsent) continue;
      rows_ += front;
      write_state(states, step.rows[i], plan_->bodies[i]);
      rows_ += about_[i];
      write_values(step, i, from);
      rows_ += '\n';
    }
    empty_steps_ += rows_.empty() ? 1U : 0U;
    for (std::size_t c = 0; c < channels().size(); ++c) {
      if (channels()[c].type.scope != ChannelScope::kWorld) lost_values_ += step.record.extras.values(c).size();
    }
    lost_values_ -= std::exchange(written_values_, 0);
    Status ok = file_.write(rows_);
    rows_.clear();
    return ok;
  }

  Status finish() override {
    if (lost_values_ > 0 && !plan_->chosen) left_out_.push_back(left_out_values(lost_values_));
    if (empty_steps_ > 0) left_out_.push_back(count_text(empty_steps_, "step") + " without a body: a table has no row");
    return {};
  }

 private:
  Status write_head() {
    std::string head = setting_lines(table_settings(*plan_));
    if (escaped_) head += kEscapesLine;
    if (!channels().empty()) {
      head += "# kinds:";
      for (const Channel& channel : channels()) head += std::string(" ") + name_of(table_kind(channel.type.kind));
      head += '\n';
    }
    head += plan_->dt ? "step,time,id" : "step,time,dt,id";
    if (named_) head += ",name";
    for (const std::size_t k : kFieldOrder) head += std::string(",") + kColumnNames[k];
    head += ",frozen,size.x,size.y,size.z,mass,static,friction,friction_dynamic,restitution,texture";
    if (gridded_) head += ",row,column";
    if (shaped_) head += ",shape";
    for (const Channel& channel : channels()) head += ',' + as_cell(channel_column(channel) + unit_in_column(channel));
    return file_.write(head + '\n');
  }

  static ChannelKind table_kind(ChannelKind kind) { return kind == ChannelKind::kBytes ? ChannelKind::kText : kind; }

  /// The cells that all rows of a body share.
  void describe(const ExportBody& body) {
    std::string cells;
    const sim::BoxDef& box = body.box;
    const sim::Vec3 size = frame_.extents(box.size);
    for (const double edge : {size.x(), size.y(), size.z(), box.mass}) append_comma(edge, cells);
    cells += box.is_static ? ",1" : ",0";
    for (const double number : {box.material.friction, box.material.friction_dynamic, box.material.restitution}) {
      append_comma(number, cells);
    }
    cells += ',';
    cells += name_of(box.material.texture);
    if (gridded_) {
      const bool in_grid = box.origin.kind == sim::Origin::Kind::kGrid;
      cells += in_grid ? ',' + std::to_string(box.origin.row) + ',' + std::to_string(box.origin.column) : ",,";
    }
    if (shaped_) cells += ',' + shape_word(body, frame_.axes());
    about_.push_back(std::move(cells));
    const std::string name = body.name.empty() ? "" : as_cell(body.name);
    names_.push_back(',' + std::to_string(box.id) + (named_ ? ',' + name : ""));
  }

  void write_state(const BodyStates& states, std::size_t row, const ExportBody& body) {
    rows_ += names_[static_cast<std::size_t>(&body - plan_->bodies.data())];
    const ConstColumns columns = columns_of(states);
    for (const std::size_t k : kFieldOrder) append_comma((*columns[k])[row], rows_);
    rows_ += states.frozen[row] != 0 ? ",1" : ",0";
  }

  [[nodiscard]] std::string as_cell(const std::string& text) const { return escaped_ ? text_cell(text) : text; }

  void append_value(const ExportStep& step, std::size_t channel, std::size_t row, std::string& out) const {
    const Channel& about = channels()[channel];
    const ChannelValue value = step.record.extras.values(channel).value(row, about.type.kind);
    const auto* text = std::get_if<std::string>(&value);
    if (text == nullptr) {
      out += value_cell(value, about.type.kind);
    } else {
      out += as_cell(about.type.kind == ChannelKind::kBytes ? hex_digits(*text) : *text);
    }
  }

  /// The values of the step as a whole, which every row repeats.
  void write_world(const ExportStep& step) {
    world_.assign(channels().size(), "");
    for (std::size_t c = 0; c < channels().size(); ++c) {
      if (channels()[c].type.scope != ChannelScope::kWorld || step.record.extras.values(c).empty()) continue;
      append_value(step, c, 0, world_[c]);
    }
  }

  void write_values(const ExportStep& step, std::size_t body, std::vector<std::size_t>& from) {
    const sim::BodyId id = plan_->bodies[body].box.id;
    for (std::size_t c = 0; c < channels().size(); ++c) {
      rows_ += ',';
      const ChannelType& type = channels()[c].type;
      if (type.scope == ChannelScope::kWorld) {
        rows_ += world_[c];
        continue;
      }
      const ChannelValues& values = step.record.extras.values(c);
      const std::size_t row = value_row(values, id, from[c]);
      if (row == values.size()) continue;
      if (type.scope == ChannelScope::kPair) {
        rows_ += as_cell(pair_cell(values, type.kind, row));
        while (from[c] < values.size() && values.keys[from[c]].a == id) ++from[c];
        written_values_ += from[c] - row;
        continue;
      }
      ++written_values_;
      append_value(step, c, row, rows_);
    }
  }

  [[nodiscard]] const std::vector<Channel>& channels() const { return plan_->header.declared.channels; }

  files::OutputFile& file_;
  const ExportPlan* plan_ = nullptr;
  TableFrame frame_;
  bool named_ = false, shaped_ = false, gridded_ = false;
  bool escaped_ = false;                    // texts and names are as text_cell() writes them
  std::vector<std::string> about_, names_;  // cells of each body
  std::vector<std::string> world_;          // cells of the step
  std::string rows_;
  std::uint64_t written_values_ = 0;  // of bodies and pairs, in this step
  std::uint64_t empty_steps_ = 0, lost_values_ = 0;
};

}  // namespace

std::unique_ptr<ExportWriter> make_csv_writer(files::OutputFile& file) { return std::make_unique<CsvWriter>(file); }

}  // namespace tumble::replay

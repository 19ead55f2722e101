#include "python/binding/log_file.h"

#include "python/binding/arrays.h"
#include "python/binding/values.h"

namespace tumble::python {
namespace {

std::vector<double> rows_of(const sim::Vec3Column& column) {
  std::vector<double> rows(column.size() * 3);
  for (std::size_t i = 0; i < column.size(); ++i) {
    rows[3 * i] = column.x[i];
    rows[3 * i + 1] = column.y[i];
    rows[3 * i + 2] = column.z[i];
  }
  return rows;
}

std::vector<double> rows_of(const sim::QuatColumn& column) {
  std::vector<double> rows(column.size() * 4);
  for (std::size_t i = 0; i < column.size(); ++i) {
    rows[4 * i] = column.w[i];
    rows[4 * i + 1] = column.x[i];
    rows[4 * i + 2] = column.y[i];
    rows[4 * i + 3] = column.z[i];
  }
  return rows;
}

Result<std::shared_ptr<StateBlock>> states_from(replay::StateSource& source, std::uint64_t k) {
  const Result<const replay::StepRecord*> record = source.read(k);
  if (!record.ok()) return record.error();
  return std::make_shared<StateBlock>(block_of((*record)->states));
}

/// Whether nothing is missing, and in words. A log without damage may hold a session that was cut short.
std::pair<bool, std::string> condition_of(const replay::LogReader& log) {
  const replay::LogCondition& condition = log.condition();
  const std::string& cut_short = log.header().declared.cut_short;
  std::string text = condition.summary(log.last_step());
  if (cut_short.empty()) return {condition.whole(), text};
  const std::string gone_on = "its session may have gone on: " + cut_short;
  return {false, condition.whole() ? gone_on : text + "; " + gone_on};
}

}  // namespace

StateBlock block_of(const replay::BodyStates& states) {
  return {states.id,
          rows_of(states.position),
          rows_of(states.orientation),
          rows_of(states.velocity),
          rows_of(states.spin),
          states.frozen};
}

LogFile::LogFile(const std::string& path) : path_(path) {
  reader_.emplace(take(released([&] { return replay::LogReader::open(path); })));
  if (!reader_->holds(reader_->first_state())) {
    raise(damaged(path + ": " + reader_->condition().summary(reader_->last_step()) + "; it holds no state"));
  }
  source_.emplace(*reader_);
  contacts_.emplace(*reader_);
  header_ = reader_->header();
  first_ = reader_->first_state();
  last_ = reader_->last_step();
}

StepData LogFile::step(std::uint64_t k) {
  return take(read([&](replay::LogReader& reader) -> Result<StepData> {
    const Result<const replay::StepRecord*> record = reader.read_step(k);
    if (!record.ok()) return record.error();
    StepData step;
    if ((*record)->has_states) step.states = std::make_shared<StateBlock>(block_of((*record)->states));
    step.record = **record;
    step.record.states = {};
    return step;
  }));
}

std::shared_ptr<StateBlock> LogFile::states(std::uint64_t k) {
  return take(read([&](replay::LogReader& /*reader*/) { return states_from(*source_, k); }));
}

std::vector<replay::ContactPoint> LogFile::contacts(std::uint64_t k) {
  return take(read([&](replay::LogReader& /*reader*/) { return contacts_->read(k); }));
}

void LogFile::close() {
  released([&] {
    const std::scoped_lock lock(mutex_);
    contacts_.reset();
    source_.reset();
    reader_.reset();
    closed_ = true;
  });
}

void LogFile::raise_closed() const { raise(bad_input(path_ + ": the log is closed; open it again")); }

void add_log(py::module_& module) {
  const auto chain = [](LogFile& log, std::uint64_t k) {
    return to_string(take(log.read([&](replay::LogReader& reader) { return reader.chain_at(k); })));
  };
  const auto condition = [](LogFile& log) { return log.read(condition_of); };
  const auto holds = [](LogFile& log, std::uint64_t k) {
    return log.read([&](replay::LogReader& reader) {
      return k >= reader.first_state() && k <= reader.last_step() && reader.holds(k);
    });
  };
  py::class_<LogFile, std::shared_ptr<LogFile>>(module, "LogFile")
      .def(py::init<const std::string&>())
      .def("close", &LogFile::close)
      .def_property_readonly("closed", &LogFile::is_closed)
      .def_property_readonly("path", [](const LogFile& log) { return py::bytes(log.path()); })
      .def_property_readonly("first", &LogFile::first)
      .def_property_readonly("last", &LogFile::last)
      .def("header", &header_dict)
      .def("bodies", &bodies_dict)
      .def("condition", condition)
      .def("holds", holds)
      .def("chain", chain)
      .def("step", &LogFile::step)
      .def("states", &LogFile::states)
      .def("contacts",
           [](LogFile& log, std::uint64_t k) {
             py::list rows;
             for (const replay::ContactPoint& point : log.contacts(k)) {
               rows.append(py::make_tuple(point.a, point.b ? py::object(py::int_(*point.b)) : py::none(),
                                          tuple_of(point.at), tuple_of(point.normal), point.depth, point.impulse));
             }
             return rows;
           })
      .def("column", &read_column)
      .def("scan", &scan_steps)
      .def("inputs", &read_inputs)
      .def("channel_rows", &channel_rows);
}

}  // namespace tumble::python

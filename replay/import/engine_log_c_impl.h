#pragma once

#include <cstddef>
#include <exception>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "replay/import/declared_bodies.h"
#include "tumble/replay/engine_log.h"
#include "tumble/replay/engine_log_c.h"

/// What the functions of engine_log_c.h share.
namespace tumble::replay {

/// A value of state 0, which C gives before the log is begun.
struct StartValue {
  std::size_t channel;
  ChannelKey key;
  ChannelValue value;
};

}  // namespace tumble::replay

// Collects the arguments of EngineLog::create, which C passes one call at a time.
struct TumbleLog {
  tumble::replay::EngineDef def;
  tumble::sim::SceneDef start;
  std::unique_ptr<tumble::replay::EngineLog> log;  // from tumble_log_begin() on
  std::vector<tumble::replay::Channel> channels;   // in the caller's order
  std::vector<std::size_t> place;                  // of each in EngineDef::declared, which is ordered by name
  std::vector<tumble::replay::StartValue> start_values;
  tumble::replay::DeclaredBodies declared_bodies;
  tumble::Status status;  // of the first call that failed
};

namespace tumble::replay {

/// Orders the channels of a log by name, and the values of the start by channel.
Status declare_channels(TumbleLog& log);

inline TumbleLogStatus kind_of(const Status& status) {
  if (status.ok()) return TUMBLE_OK;
  return status.error().kind == ErrorKind::kBadInput ? TUMBLE_BAD_INPUT : TUMBLE_CANNOT_FINISH;
}

/// Completes a log whose step was refused, since no further call is taken: it has the steps before, and keeps why it
/// ends. Adds to the refusal where that fails.
void end_refused(TumbleLog& log);

/// Runs a call unless an earlier one failed. Catches all exceptions, because none may reach C.
template <class Call>
TumbleLogStatus guarded(TumbleLog* log, Call call) {
  if (log == nullptr) return TUMBLE_BAD_INPUT;
  if (!log->status.ok()) return kind_of(log->status);
  try {
    log->status = call();
    if (log->log && kind_of(log->status) == TUMBLE_BAD_INPUT) end_refused(*log);
  } catch (const std::exception& error) {
    log->status = cannot_finish(std::string("out of memory: ") + error.what());
  }
  return kind_of(log->status);
}

/// As guarded(), for calls after tumble_log_begin().
template <class Call>
TumbleLogStatus while_open(TumbleLog* log, Call call) {
  return guarded(log, [&]() -> Status {
    if (!log->log) return bad_input("found a step or an input, wanted tumble_log_begin() before");
    return call(*log->log);
  });
}

inline Error missing(const char* what) { return bad_input(std::string("found NULL, wanted ") + what); }

inline sim::Vec3 vector_of(const double* v) { return {v[0], v[1], v[2]}; }

}  // namespace tumble::replay

#pragma once

#include <stdexcept>

#include "golden/hunt/judge/relation.h"
#include "golden/hunt/judge/trace.h"
#include "tumble/scenes/scene_file.h"

/// Sessions for the tests of relations and laws.
namespace tumble::test {

/// The session of a scene's text. Throws where that is no scene.
inline hunt::Trace traced(const char* text) {
  const Result<sim::SceneDef> scene = scenes::parse_scene(text, "test.toml");
  if (!scene.ok()) throw std::runtime_error(scene.error().message);
  Result<hunt::Trace> session = hunt::trace(*scene);
  if (!session.ok()) throw std::runtime_error(session.error().message);
  return *std::move(session);
}

inline hunt::Judgement judge(const char* relation, const hunt::Trace& trace) {
  return hunt::find_relation(relation)->judge(trace);
}

}  // namespace tumble::test

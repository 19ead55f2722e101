#include "tumble/render/backend.h"

namespace tumble::render {

Result<Backend> parse_backend(const std::string& word) {
  if (word == "auto") return Backend::kAuto;
  if (word == "osmesa") return Backend::kOsmesa;
  if (word == "egl") return Backend::kEgl;
  return bad_input("--gl: found \"" + word + "\", wanted auto, osmesa or egl");
}

}  // namespace tumble::render

#include "golden/judge/judge_pictures.h"

#include <algorithm>
#include <memory>
#include <system_error>
#include <utility>

#include "golden/suite/text_files.h"
#include "replay/picture/picture_source.h"
#include "src/render/picture/image_difference.h"
#include "tumble/golden/provenance.h"
#include "tumble/render/png.h"
#include "tumble/render/renderer.h"

namespace tumble::golden {
namespace {

namespace fs = std::filesystem;

constexpr int kSamples = 2;

std::string pixels_text(std::uint64_t n) { return std::to_string(n) + (n == 1 ? " pixel" : " pixels"); }

// Draws pictures of one log, with a renderer for each size in turn.
class Artist {
 public:
  explicit Artist(replay::LogReader& log) : log_(log), pictures_(log) {}

  Result<DrawnPicture> draw(const PictureRule& rule) {
    if (!renderer_ || width_ != rule.width || height_ != rule.height) {
      renderer_ = nullptr;  // its context goes before another comes
      auto made = render::Renderer::create({rule.width, rule.height, kSamples, {}});
      if (!made.ok()) return made.error();
      renderer_ = *std::move(made);
      width_ = rule.width;
      height_ = rule.height;
    }
    const Result<replay::Picture> picture = pictures_.read(rule.step, {.freezing = rule.freezing});
    if (!picture.ok()) return picture.error();
    Result<render::Image> image = renderer_->draw(picture->snapshot);
    if (!image.ok()) return image.error();
    const render::PngText text = {{"Software", "tumble " TUMBLE_VERSION},
                                  {"Scene", log_.header().scene.name},
                                  {"Step", std::to_string(rule.step)},
                                  {"State hash", to_string(picture->state_hash)},
                                  {"Effects", "all"},
                                  {"Driver", driver()}};
    Result<std::vector<std::byte>> png = render::encode_png(*image, text);
    if (!png.ok()) return png.error();
    return DrawnPicture{rule.file(), *std::move(png), *std::move(image), {}, driver()};
  }

 private:
  /// "llvmpipe (LLVM 15.0.6, 256 bits), 4.5 (Core Profile) Mesa 22.3.6, x86 with AVX-512".
  [[nodiscard]] std::string driver() const { return renderer_->driver() + ", " + processor_class(); }

  replay::LogReader& log_;
  replay::PictureSource pictures_;
  std::unique_ptr<render::Renderer> renderer_;
  int width_ = 0, height_ = 0;
};

std::string driver_of(const render::PngFile& png) {
  const auto found = std::ranges::find(png.text, std::string("Driver"), &std::pair<std::string, std::string>::first);
  return found == png.text.end() ? "an unknown driver" : found->second;
}

std::string stem_of(const std::string& file) { return file.substr(0, file.rfind('.')); }

bool is_of_size(const render::Image& image, const PictureRule& rule) {
  return image.width == rule.width && image.height == rule.height;
}

std::string size_text(const render::Image& image) {
  return std::to_string(image.width) + " x " + std::to_string(image.height) + " pixels";
}

// The picture as the other machine drew it. A report leaves out a picture that did not move: it is the golden.
Result<DrawnPicture> recorded_picture(const RecordedPictures& recorded, const PictureRule& rule,
                                      const CaseFolder& folder) {
  const auto there = std::ranges::find_if(recorded.results, [&](const PictureResult& result) {
    return result.rule.file() == rule.file() && result.rule.freezing == rule.freezing;
  });
  if (there == recorded.results.end()) return bad_input("was not drawn by the check of the report");
  const bool moved = !there->message.empty();
  const fs::path path = moved ? recorded.folder / (stem_of(rule.file()) + ".actual.png") : folder.path / rule.file();
  std::error_code error;
  if (moved && !fs::exists(path, error)) return bad_input("is not in the report, which says: " + there->message);
  Result<render::PngFile> png = render::read_png(path.string());
  if (!png.ok()) return png.error();
  if (!is_of_size(png->image, rule)) {
    return bad_input(path.string() + ": found " + size_text(png->image) + ", not as large as its [[picture]]");
  }
  Result<std::vector<std::byte>> bytes = read_bytes(path);
  if (!bytes.ok()) return bytes.error();
  return DrawnPicture{rule.file(), *std::move(bytes), std::move(png->image), {}, driver_of(*png)};
}

// Every picture in the folder must belong to a rule: any other would never be judged.
void find_unreferenced(const std::vector<PictureRule>& rules, const CaseFolder& folder,
                       std::vector<std::string>& problems) {
  std::error_code error;
  std::vector<std::string> names;
  for (fs::directory_iterator at(folder.path, error), end; !error && at != end; at.increment(error)) {
    const std::string name = at->path().filename().string();
    const bool is_known = std::ranges::any_of(rules, [&](const PictureRule& rule) { return rule.file() == name; });
    if (is_picture_name(name) && !is_known) names.push_back(name);
  }
  std::ranges::sort(names);
  for (const std::string& name : names) {
    problems.push_back("unreferenced: no [[picture]] of " + std::string(kRulesFile) + " names " + name + "; remove it");
  }
}

void compare(const render::PngFile& golden, DrawnPicture& drawn, PictureResult& result, JudgedPictures& judged) {
  const PictureRule& rule = result.rule;
  if (!is_of_size(golden.image, rule)) {
    judged.problems.push_back("stale: " + drawn.file + " is " + size_text(golden.image) +
                              ", not as large as its [[picture]]; bless it");
    return;
  }
  drawn.expected = golden.image;
  const render::ImageDifference found = render::difference_of(golden.image, drawn.image);
  result.pixels = found.pixels;
  result.far_off = found.far_off;
  result.pass = found.equal() || found.far_off <= rule.far_off_max;
  if (found.equal()) return;
  result.message = pixels_text(found.pixels) + " not as blessed, " + std::to_string(found.far_off) +
                   " of them by more than " + std::to_string(render::kFarOffLevels) +
                   " levels (bound: " + std::to_string(rule.far_off_max) + "), the worst by " +
                   std::to_string(found.largest);
  judged.notes.push_back(drawn.file + ": drawn with " + drawn.driver + "; the golden with " + driver_of(golden));
}

Verdict verdict_of(const std::vector<PictureResult>& results) {
  std::size_t bad = 0, moved = 0;
  std::string words;
  for (const PictureResult& result : results) {
    bad += result.pass ? 0U : 1U;
    moved += result.pass && result.pixels > 0 ? 1U : 0U;
    if (!result.pass && words.empty()) words = result.rule.file() + ": " + result.message;
  }
  const std::string all = std::to_string(results.size()) + (results.size() == 1 ? " picture" : " pictures");
  if (bad > 0) return {Outcome::kFail, std::to_string(bad) + " of " + all + " differ: " + words};
  if (moved > 0) return {Outcome::kPass, std::to_string(moved) + " of " + all + " differ within their bounds"};
  return {Outcome::kPass, all + ", every pixel the same"};
}

}  // namespace

JudgedPictures judge_pictures(replay::LogReader& log, const std::vector<PictureRule>& rules, const CaseFolder& folder,
                              const RecordedPictures* recorded) {
  JudgedPictures judged;
  judged.verdict = {Outcome::kNone, "none: the case names no picture"};
  find_unreferenced(rules, folder, judged.problems);
  Artist artist(log);
  for (const PictureRule& rule : rules) {
    PictureResult result{.rule = rule, .pixels = 0, .far_off = 0, .pass = false, .message = {}};
    Result<DrawnPicture> drawn = recorded != nullptr ? recorded_picture(*recorded, rule, folder) : artist.draw(rule);
    if (!drawn.ok()) {
      result.message = (recorded != nullptr ? "" : "cannot be drawn: ") + drawn.error().message;
      judged.drawn.push_back({rule.file(), {}, {}, {}, {}});
    } else {
      std::error_code error;
      const fs::path path = folder.path / rule.file();
      const Result<render::PngFile> golden = render::read_png(path.string());
      if (golden.ok()) {
        compare(*golden, *drawn, result, judged);
      } else if (fs::exists(path, error)) {
        judged.problems.push_back(golden.error().message);
      } else {
        judged.problems.push_back("no " + rule.file() + ": bless the case");
      }
      judged.drawn.push_back(*std::move(drawn));
    }
    if (!result.pass && result.message.empty()) result.message = "is new: there is no golden to compare it with";
    judged.results.push_back(std::move(result));
  }
  if (!rules.empty()) judged.verdict = verdict_of(judged.results);
  return judged;
}

std::vector<PictureFile> explaining_files(const DrawnPicture& picture) {
  const std::string stem = stem_of(picture.file);
  std::vector<PictureFile> files = {{stem + ".actual.png", picture.png}};
  if (picture.expected.rgb.empty()) return files;
  Result<std::vector<std::byte>> expected = render::encode_png(picture.expected);
  if (expected.ok()) files.push_back({stem + ".expected.png", *std::move(expected)});
  Result<std::vector<std::byte>> map = render::encode_png(render::difference_map(picture.expected, picture.image));
  if (map.ok()) files.push_back({stem + ".difference.png", *std::move(map)});
  return files;
}

}  // namespace tumble::golden

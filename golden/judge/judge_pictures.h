#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

#include "tumble/golden/case_result.h"
#include "tumble/golden/case_rules.h"
#include "tumble/golden/suite.h"
#include "tumble/render/image.h"
#include "tumble/replay/log_reader.h"
#include "tumble/sim/result.h"

/// The third verdict: pictures of a session, drawn as `tumble render` draws them, against the golden ones.
namespace tumble::golden {

/// The picture of a rule.
struct DrawnPicture {
  std::string file;            ///< "frame_0120.png"
  std::vector<std::byte> png;  ///< as a golden
  render::Image image;
  render::Image expected;  ///< empty: there is none, or it cannot be read
  std::string driver;      ///< that drew it
};

/// Pictures that another machine drew of its session, as the report of its check holds them.
struct RecordedPictures {
  const std::filesystem::path& folder;        ///< with STEM.actual.png of each that moved there
  const std::vector<PictureResult>& results;  ///< of that check
};

struct JudgedPictures {
  Verdict verdict;                     ///< kNone if the rules name no picture
  std::vector<PictureResult> results;  ///< one a rule
  std::vector<std::string> problems;   ///< a golden picture that is missing, damaged or that no rule names
  std::vector<std::string> notes;      ///< the driver, where a pixel has changed
  std::vector<DrawnPicture> drawn;     ///< one a rule; without bytes where it could not be drawn
};

/// Draws every picture that the rules name and compares its decoded pixels with the case's file. Equal pixels pass;
/// else those off by more than render::kFarOffLevels are counted against the rule's bound. recorded: judges these
/// pictures instead of drawing any; one that did not move there is the golden.
JudgedPictures judge_pictures(replay::LogReader& log, const std::vector<PictureRule>& rules, const CaseFolder& folder,
                              const RecordedPictures* recorded = nullptr);

/// Files that show a person the fault of a picture, by name: "frame_0120.actual.png", and if there is a golden,
/// "….expected.png" and "….difference.png".
struct PictureFile {
  std::string name;
  std::vector<std::byte> bytes;
};
std::vector<PictureFile> explaining_files(const DrawnPicture& picture);

}  // namespace tumble::golden

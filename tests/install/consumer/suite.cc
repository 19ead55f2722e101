// suite SUITE CASE FOLDER: checks one case of a suite, writes the report and a picture into FOLDER, prints the final
// hash of the session that was judged; exits with 1 where the case failed.
#include <filesystem>
#include <iostream>
#include <string>

#include "tumble/golden/check.h"
#include "tumble/golden/report.h"
#include "tumble/render/png.h"

int main(int argc, char** argv) {
  if (argc != 4) return 2;
  const std::filesystem::path folder = argv[3];
  tumble::golden::CheckOptions options;
  options.suite = argv[1];
  options.selection.names = {argv[2]};
  options.report = folder;
  const auto result = tumble::golden::check_suite(options);
  if (!result.ok()) {
    std::cerr << result.error().message << '\n';
    return 2;
  }
  if (!tumble::golden::write_reports(*result, folder, {}).ok()) return 4;
  if (!tumble::render::write_png((folder / "grey.png").string(), tumble::render::Image::blank(32, 16)).ok()) return 4;
  if (!result->passed()) {
    std::cerr << tumble::golden::headline(*result) << '\n';
    return 1;
  }
  std::cout << result->cases.front().final_hash << '\n';
  return 0;
}

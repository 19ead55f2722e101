#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "tumble/sim/result.h"

namespace tumble::files {

/// How every page of ours begins: the report of `check` and the page of `view`.
inline constexpr std::string_view kPageBegins =
    "<!doctype html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
    "<meta http-equiv=\"Content-Security-Policy\"";

/// An output takes the place of an older output only. Asked of a file that is there: what its first bytes say it is
/// must be what its ending says (.csv, .glb, .html, .json, .mcap, .mp4, .npz, .png, .svg, .webm, .xml; .html: a page of
/// ours). An empty file, a device and any other ending pass.
///
/// option: for messages: "-o". Errors (kBadInput): a file of another kind.
Status replaces_its_kind(const std::string& option, const std::filesystem::path& path);

}  // namespace tumble::files

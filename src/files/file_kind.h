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

/// What an output holds: a table of ours ("step,…"), a page of ours, a report for CI (JUnit), probes of a step.
enum class FileKind { kTable, kGltf, kPage, kJson, kMcap, kMp4, kArrays, kPng, kProbes, kSvg, kWebm, kJunit };

/// For an output whose name chooses its kind (.csv, .glb, .html, .json, .mcap, .mp4, .npz, .png, .svg, .webm, .xml, in
/// any case). Precondition (SIM_CHECK): one of these endings.
FileKind kind_by_name(const std::filesystem::path& path);

/// An output takes the place of an older output of its kind only: the first bytes of a file that is there decide,
/// whatever its name. An empty file and a device pass.
///
/// option: for messages: "-o". Errors (kBadInput): a file of another kind.
Status replaces_its_kind(const std::string& option, const std::filesystem::path& path, FileKind kind);

}  // namespace tumble::files

#pragma once

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include "src/base/result.h"
#include "src/render/picture/image.h"

namespace tumble::render {

/// What a PNG file says of itself: keyword and text, in order. Keywords have 1 … 79 Latin-1 characters; text is UTF-8.
using PngText = std::vector<std::pair<std::string, std::string>>;

struct PngFile {
  Image image;
  PngText text;
};

/// The bytes of an 8-bit RGB file. Errors (kCannotFinish): memory, a keyword that PNG does not allow.
Result<std::vector<std::byte>> encode_png(const Image& image, const PngText& text = {});

/// Writes them through a temporary file beside it, so that a file is whole or not there. Errors: a path that
/// cannot be written to (kBadInput), a full disk (kCannotFinish).
Status write_png(const std::string& path, const Image& image, const PngText& text = {});

/// Reads any PNG as 8-bit RGB (alpha is dropped). Errors: no such file, not a PNG, larger than kSizeMax each way
/// (kBadInput); damaged (kDamaged).
Result<PngFile> read_png(const std::string& path);

}  // namespace tumble::render

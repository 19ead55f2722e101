#pragma once

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include "tumble/render/image.h"
#include "tumble/sim/result.h"

namespace tumble::render {

/// The text entries of a PNG file: keyword and text, in order. Keywords have 1 … 79 Latin-1 characters; text is UTF-8.
using PngText = std::vector<std::pair<std::string, std::string>>;

struct PngFile {
  Image image;
  PngText text;
};

/// The bytes of an 8-bit RGB file. Errors (kCannotFinish): out of memory, a keyword that PNG does not allow.
Result<std::vector<std::byte>> encode_png(const Image& image, const PngText& text = {});

/// Writes a file of encode_png(). Writes a temporary file in the same folder first and renames it, so that no partial
/// file remains. Errors. kBadInput: the path cannot be written. kCannotFinish: the disk is full.
Status write_png(const std::string& path, const Image& image, const PngText& text = {});

/// Reads any PNG as 8-bit RGB, without alpha. Errors. kBadInput: no such file, not a PNG, wider or higher than
/// kSizeMax. kDamaged: the file is damaged.
Result<PngFile> read_png(const std::string& path);

}  // namespace tumble::render

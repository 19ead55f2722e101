#include "tumble/render/png.h"

#include <png.h>

#include <array>
#include <cerrno>
#include <csetjmp>
#include <cstdio>
#include <cstring>
#include <memory>

#include "src/files/output_file.h"

namespace tumble::render {
namespace {

struct CloseFile {
  void operator()(std::FILE* file) const { std::fclose(file); }
};
using File = std::unique_ptr<std::FILE, CloseFile>;

// Where libpng puts its words before it jumps. No object with a destructor may be made between setjmp and the jump,
// so that the functions that call libpng own nothing.
struct Words {
  std::array<char, 200> text{};
};

void on_error(png_structp png, png_const_charp words) {
  auto* kept = static_cast<Words*>(png_get_error_ptr(png));
  std::snprintf(kept->text.data(), kept->text.size(), "%s", words);
  png_longjmp(png, 1);
}
void on_warning(png_structp /*png*/, png_const_charp /*words*/) {}

void append(png_structp png, png_bytep data, std::size_t count) {
  auto* bytes = static_cast<std::vector<std::byte>*>(png_get_io_ptr(png));
  const auto* begin = reinterpret_cast<const std::byte*>(data);
  bytes->insert(bytes->end(), begin, begin + count);
}

bool write_all(png_structp png, png_infop info, std::vector<std::byte>& bytes, const Image& image, png_textp texts,
               int text_count) {
  if (setjmp(png_jmpbuf(png)) != 0) return false;
  png_set_write_fn(png, &bytes, append, nullptr);
  png_set_compression_level(png, 6);
  png_set_filter(png, 0, PNG_FILTER_SUB | PNG_FILTER_UP | PNG_FILTER_PAETH);
  png_set_IHDR(png, info, static_cast<png_uint_32>(image.width), static_cast<png_uint_32>(image.height), 8,
               PNG_COLOR_TYPE_RGB, PNG_INTERLACE_NONE, PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
  png_set_text(png, info, texts, text_count);
  png_write_info(png, info);
  for (int y = 0; y < image.height; ++y) png_write_row(png, image.rgb.data() + image.at(0, y));
  png_write_end(png, nullptr);
  return true;
}

// The size, once the header is read and every transformation to 8-bit RGB asked for.
bool read_header(png_structp png, png_infop info, std::FILE* file, int& width, int& height) {
  if (setjmp(png_jmpbuf(png)) != 0) return false;
  png_init_io(png, file);
  png_set_user_limits(png, kSizeMax, kSizeMax);
  png_read_info(png, info);
  png_set_expand(png);
  png_set_strip_16(png);
  png_set_gray_to_rgb(png);
  png_set_strip_alpha(png);
  png_set_interlace_handling(png);
  png_read_update_info(png, info);
  width = static_cast<int>(png_get_image_width(png, info));
  height = static_cast<int>(png_get_image_height(png, info));
  return true;
}

bool read_rows(png_structp png, png_infop info, png_bytepp rows) {
  if (setjmp(png_jmpbuf(png)) != 0) return false;
  png_read_image(png, rows);
  png_read_end(png, info);
  return true;
}

// libpng's two structures, freed together.
class Reader {
 public:
  explicit Reader(Words& words)
      : png(png_create_read_struct(PNG_LIBPNG_VER_STRING, &words, on_error, on_warning)),
        info(png == nullptr ? nullptr : png_create_info_struct(png)) {}
  ~Reader() { png_destroy_read_struct(&png, &info, nullptr); }
  Reader(const Reader&) = delete;
  Reader& operator=(const Reader&) = delete;
  png_structp png;
  png_infop info;
};

class Writer {
 public:
  explicit Writer(Words& words)
      : png(png_create_write_struct(PNG_LIBPNG_VER_STRING, &words, on_error, on_warning)),
        info(png == nullptr ? nullptr : png_create_info_struct(png)) {}
  ~Writer() { png_destroy_write_struct(&png, &info); }
  Writer(const Writer&) = delete;
  Writer& operator=(const Writer&) = delete;
  png_structp png;
  png_infop info;
};

}  // namespace

Result<std::vector<std::byte>> encode_png(const Image& image, const PngText& text) {
  Words words;
  Writer writer(words);
  if (writer.info == nullptr) return cannot_finish("out of memory for a PNG");
  PngText kept = text;
  std::vector<png_text> texts(kept.size());
  for (std::size_t i = 0; i < kept.size(); ++i) {
    texts[i].compression = PNG_ITXT_COMPRESSION_NONE;
    texts[i].key = kept[i].first.data();
    texts[i].text = kept[i].second.data();
    texts[i].itxt_length = kept[i].second.size();
  }
  std::vector<std::byte> bytes;
  if (write_all(writer.png, writer.info, bytes, image, texts.data(), static_cast<int>(texts.size()))) return bytes;
  return cannot_finish(std::string("a PNG cannot be made: ") + words.text.data());
}

Status write_png(const std::string& path, const Image& image, const PngText& text) {
  const Result<std::vector<std::byte>> bytes = encode_png(image, text);
  if (!bytes.ok()) return bytes.error();
  return files::write_whole_file(path, {reinterpret_cast<const char*>(bytes->data()), bytes->size()});
}

Result<PngFile> read_png(const std::string& path) {
  const File file(std::fopen(path.c_str(), "rb"));
  if (file == nullptr) return bad_input(path + ": cannot be read: " + std::strerror(errno));
  std::array<png_byte, 8> signature{};
  if (std::fread(signature.data(), 1, 8, file.get()) != 8 || png_sig_cmp(signature.data(), 0, 8) != 0) {
    return bad_input(path + ": not a PNG file");
  }
  Words words;
  Reader reader(words);
  if (reader.info == nullptr) return cannot_finish(path + ": out of memory");
  png_set_sig_bytes(reader.png, 8);
  int width = 0, height = 0;
  if (!read_header(reader.png, reader.info, file.get(), width, height)) {
    return damaged(path + ": damaged PNG: " + words.text.data());
  }
  PngFile made;
  made.image = Image::blank(width, height);
  std::vector<png_bytep> rows;
  rows.reserve(static_cast<std::size_t>(height));
  for (int y = 0; y < height; ++y) rows.push_back(made.image.rgb.data() + made.image.at(0, y));
  if (!read_rows(reader.png, reader.info, rows.data())) return damaged(path + ": damaged PNG: " + words.text.data());
  png_textp texts = nullptr;
  const int count = png_get_text(reader.png, reader.info, &texts, nullptr);
  for (int i = 0; i < count; ++i) made.text.emplace_back(texts[i].key, texts[i].text);
  return made;
}

}  // namespace tumble::render

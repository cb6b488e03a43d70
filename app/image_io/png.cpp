// png.cpp: libpng behind three functions.
//
// libpng reports failure by longjmp, so the functions that call setjmp hold no objects with
// destructors.
#include "app/image_io/png.h"

#include <png.h>

#include <algorithm>
#include <csetjmp>
#include <fstream>
#include <iterator>

#include "core/atomic_file.h"
#include "core/error.h"

namespace neph {
namespace {

struct Writer {
    png_structp png = nullptr;
    png_infop info = nullptr;
    std::string bytes;
    std::string fault;
    ~Writer() { png_destroy_write_struct(&png, &info); }
};

struct Reader {
    png_structp png = nullptr;
    png_infop info = nullptr;
    std::string bytes;
    std::size_t at = 0;
    std::string fault;
    ~Reader() { png_destroy_read_struct(&png, &info, nullptr); }
};

template <typename State>
[[noreturn]] void onError(png_structp png, png_const_charp message) {
    static_cast<State*>(png_get_error_ptr(png))->fault = message;
    png_longjmp(png, 1);
}

void onWarning(png_structp, png_const_charp) {}

void append(png_structp png, png_bytep data, std::size_t size) {
    static_cast<Writer*>(png_get_io_ptr(png))->bytes.append(reinterpret_cast<char*>(data), size);
}

void onFlush(png_structp) {}

void fetch(png_structp png, png_bytep data, std::size_t size) {
    auto* reader = static_cast<Reader*>(png_get_io_ptr(png));
    if (size > reader->bytes.size() - reader->at) png_error(png, "the file is truncated");
    std::copy_n(reader->bytes.data() + reader->at, size, reinterpret_cast<char*>(data));
    reader->at += size;
}

bool isAscii(const std::string& text) {
    return std::all_of(text.begin(), text.end(),
                       [](char c) { return static_cast<unsigned char>(c) < 128; });
}

/// The texts point into `metadata`, which libpng copies from without writing to it.
std::vector<png_text> toTexts(const Metadata& metadata) {
    std::vector<png_text> texts;
    for (const auto& [key, text] : metadata) {
        png_text& entry = texts.emplace_back();
        entry = {};
        entry.compression = isAscii(text) ? PNG_TEXT_COMPRESSION_NONE : PNG_ITXT_COMPRESSION_NONE;
        entry.key = const_cast<char*>(key.c_str());
        entry.text = const_cast<char*>(text.c_str());
        entry.text_length = text.size();
        entry.itxt_length = text.size();
    }
    return texts;
}

bool encode(Writer& writer, const Image8& image, const std::vector<png_text>& texts,
            const std::vector<png_const_bytep>& rows) {
    if (setjmp(png_jmpbuf(writer.png)) != 0) return false;
    png_set_write_fn(writer.png, &writer, append, onFlush);
    png_set_IHDR(writer.png, writer.info, static_cast<png_uint_32>(image.size.x),
                 static_cast<png_uint_32>(image.size.y), 8, PNG_COLOR_TYPE_RGBA, PNG_INTERLACE_NONE,
                 PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
    png_set_sRGB_gAMA_and_cHRM(writer.png, writer.info, PNG_sRGB_INTENT_PERCEPTUAL);
    png_set_text(writer.png, writer.info, texts.data(), static_cast<int>(texts.size()));
    png_write_info(writer.png, writer.info);
    for (const png_const_bytep row : rows) png_write_row(writer.png, row);
    png_write_end(writer.png, nullptr);
    return true;
}

bool readHead(Reader& reader) {
    if (setjmp(png_jmpbuf(reader.png)) != 0) return false;
    png_set_read_fn(reader.png, &reader, fetch);
    png_read_info(reader.png, reader.info);
    return true;
}

std::string readBytes(const std::filesystem::path& file) {
    std::ifstream stream(file, std::ios::binary);
    std::string bytes{std::istreambuf_iterator<char>(stream), {}};
    if (!stream && !stream.eof()) bytes.clear();
    if (bytes.empty()) {
        throw Error({file.string(), "cannot be read as PNG", "no bytes", "a PNG file", ""});
    }
    return bytes;
}

[[noreturn]] void refuseRead(const std::filesystem::path& file, const std::string& fault) {
    throw Error({file.string(), "cannot be read as PNG", fault, "", ""});
}

}  // namespace

void writePng(const std::filesystem::path& file, const Image8& image, const Metadata& metadata) {
    const std::size_t rowBytes = static_cast<std::size_t>(image.size.x) * 4;
    std::vector<png_const_bytep> rows;
    for (std::size_t y = 0; y < static_cast<std::size_t>(image.size.y); ++y) {
        rows.push_back(image.rgba.data() + y * rowBytes);
    }
    Writer writer;
    writer.png =
        png_create_write_struct(PNG_LIBPNG_VER_STRING, &writer, onError<Writer>, onWarning);
    writer.info = writer.png == nullptr ? nullptr : png_create_info_struct(writer.png);
    if (writer.info == nullptr || !encode(writer, image, toTexts(metadata), rows)) {
        throw Error({file.string(), "cannot be written as PNG", writer.fault, "", ""});
    }
    replaceFile(file, writer.bytes);
}

Image8 readPng(const std::filesystem::path& file) {
    const std::string bytes = readBytes(file);
    png_image png{};
    png.version = PNG_IMAGE_VERSION;
    if (png_image_begin_read_from_memory(&png, bytes.data(), bytes.size()) == 0) {
        refuseRead(file, png.message);
    }
    png.format = PNG_FORMAT_RGBA;
    Image8 image;
    image.size = {static_cast<int>(png.width), static_cast<int>(png.height)};
    image.rgba.resize(PNG_IMAGE_SIZE(png));
    if (png_image_finish_read(&png, nullptr, image.rgba.data(), 0, nullptr) == 0) {
        refuseRead(file, png.message);
    }
    return image;
}

Metadata readPngMetadata(const std::filesystem::path& file) {
    Reader reader;
    reader.bytes = readBytes(file);
    reader.png = png_create_read_struct(PNG_LIBPNG_VER_STRING, &reader, onError<Reader>, onWarning);
    reader.info = reader.png == nullptr ? nullptr : png_create_info_struct(reader.png);
    if (reader.info == nullptr || !readHead(reader)) refuseRead(file, reader.fault);
    png_textp texts = nullptr;
    const int count = png_get_text(reader.png, reader.info, &texts, nullptr);
    Metadata metadata;
    for (int i = 0; i < count; ++i) metadata.emplace_back(texts[i].key, texts[i].text);
    return metadata;
}

}  // namespace neph

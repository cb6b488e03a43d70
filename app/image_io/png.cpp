// png.cpp: calls of libpng.
//
// libpng reports failures by longjmp, so functions that call setjmp must not have local objects
// with destructors.
#include "app/image_io/png.h"

#include <png.h>

#include <algorithm>
#include <cassert>
#include <cerrno>
#include <csetjmp>
#include <cstdio>
#include <cstring>
#include <fstream>
#include <iterator>

#include "core/base/atomic_file.h"
#include "core/base/error.h"

namespace neph {
namespace {

/// State of libpng while a file is written.
struct Writer {
    png_structp png = nullptr;
    png_infop info = nullptr;
    std::FILE* file = nullptr;
    std::string fault;
    ~Writer() {
        png_destroy_write_struct(&png, &info);
        if (file != nullptr) std::fclose(file);
    }
};

/// State of libpng while a file, held in memory, is read.
struct Reader {
    png_structp png = nullptr;
    png_infop info = nullptr;
    std::string bytes;
    std::size_t at = 0;
    std::string fault;
    ~Reader() { png_destroy_read_struct(&png, &info, nullptr); }
};

/// Keeps the message and returns to the setjmp of the caller.
template <typename State>
[[noreturn]] void onError(png_structp png, png_const_charp message) {
    static_cast<State*>(png_get_error_ptr(png))->fault = message;
    png_longjmp(png, 1);
}

void onWarning(png_structp, png_const_charp) {}

void put(png_structp png, png_bytep data, std::size_t size) {
    auto* writer = static_cast<Writer*>(png_get_io_ptr(png));
    if (std::fwrite(data, 1, size, writer->file) != size) png_error(png, std::strerror(errno));
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

/// The texts point into `metadata`, which libpng only reads, although its pointers are not const.
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

/// The encode functions return false after a failure of libpng.
bool encodeHead(Writer& writer, glm::ivec2 sizePx, const std::vector<png_text>& texts) {
    if (setjmp(png_jmpbuf(writer.png)) != 0) return false;
    png_set_write_fn(writer.png, &writer, put, onFlush);
    png_set_IHDR(writer.png, writer.info, static_cast<png_uint_32>(sizePx.x),
                 static_cast<png_uint_32>(sizePx.y), 8, PNG_COLOR_TYPE_RGBA, PNG_INTERLACE_NONE,
                 PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
    png_set_sRGB_gAMA_and_cHRM(writer.png, writer.info, PNG_sRGB_INTENT_PERCEPTUAL);
    png_set_text(writer.png, writer.info, texts.data(), static_cast<int>(texts.size()));
    png_write_info(writer.png, writer.info);
    return true;
}

bool encodeRows(Writer& writer, const std::vector<png_const_bytep>& rows) {
    if (setjmp(png_jmpbuf(writer.png)) != 0) return false;
    for (const png_const_bytep row : rows) png_write_row(writer.png, row);
    return true;
}

bool encodeEnd(Writer& writer) {
    if (setjmp(png_jmpbuf(writer.png)) != 0) return false;
    png_write_end(writer.png, nullptr);
    return true;
}

std::vector<png_const_bytep> rowsOf(const Image8& band) {
    const std::size_t rowBytes = static_cast<std::size_t>(band.size.x) * 4;
    std::vector<png_const_bytep> rows;
    for (std::size_t y = 0; y < static_cast<std::size_t>(band.size.y); ++y) {
        rows.push_back(band.rgba.data() + y * rowBytes);
    }
    return rows;
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

void writePng(const std::filesystem::path& file, glm::ivec2 sizePx, const Metadata& metadata,
              const std::function<Image8()>& next) {
    replaceFile(file, [&](const std::filesystem::path& temporary) {
        Writer writer;
        writer.file = std::fopen(temporary.c_str(), "wb");
        writer.png =
            png_create_write_struct(PNG_LIBPNG_VER_STRING, &writer, onError<Writer>, onWarning);
        writer.info = writer.png == nullptr ? nullptr : png_create_info_struct(writer.png);
        bool ok = writer.file != nullptr && writer.info != nullptr &&
                  encodeHead(writer, sizePx, toTexts(metadata));
        for (int row = 0; ok && row < sizePx.y;) {
            const Image8 band = next();
            assert(band.size.x == sizePx.x && band.size.y >= 1);
            ok = encodeRows(writer, rowsOf(band));
            row += band.size.y;
        }
        if (ok && encodeEnd(writer) && std::fflush(writer.file) == 0) return;
        throw Error({file.string(), "cannot be written as PNG",
                     writer.fault.empty() ? std::strerror(errno) : writer.fault, "", ""});
    });
}

void writePng(const std::filesystem::path& file, const Image8& image, const Metadata& metadata) {
    writePng(file, image.size, metadata, [&] { return image; });
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

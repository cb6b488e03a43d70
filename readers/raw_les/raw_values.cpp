// raw_values.cpp: reads boxes with pread, in pieces, so that cancelling takes effect soon. Threads
// share nothing: every call opens the file.
#include "readers/raw_les/raw_values.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <cstring>
#include <ctime>
#include <filesystem>
#include <limits>
#include <utility>
#include <vector>

namespace les {
namespace {

constexpr std::size_t kPieceBytes = 1U << 20U;
// GrADS treats a value as missing if it is within this relative tolerance of undef.
constexpr double kMissingTolerance = 1e-5;

/// A file opened for positioned reads.
class InputFile {
  public:
    explicit InputFile(std::string path)
        : path_(std::move(path)), handle_(::open(path_.c_str(), O_RDONLY | O_CLOEXEC)) {
        if (handle_ < 0) {
            throw Error{"cannot be opened", std::generic_category().message(errno), {}, {}, path_};
        }
    }
    ~InputFile() { ::close(handle_); }
    InputFile(const InputFile&) = delete;
    InputFile& operator=(const InputFile&) = delete;

    /// Fills `bytes` from `position` on. Throws Error if the file ends before.
    void readAt(std::uint64_t position, std::span<std::byte> bytes) const {
        std::size_t done = 0;
        while (done < bytes.size()) {
            const ssize_t count = ::pread(handle_, bytes.data() + done, bytes.size() - done,
                                          static_cast<off_t>(position + done));
            if (count < 0 && errno == EINTR) continue;
            if (count <= 0) {
                throw Error{count < 0 ? "cannot be read" : "is truncated",
                            count < 0 ? std::generic_category().message(errno)
                                      : fmt::format("it ends at byte {}", position + done),
                            fmt::format("{} bytes from byte {} on", bytes.size(), position),
                            "it may have changed since it was opened: open it again", path_};
            }
            done += static_cast<std::size_t>(count);
        }
    }

  private:
    std::string path_;
    int handle_;
};

template <std::size_t N>
std::array<std::byte, N> reversed(std::array<std::byte, N> bytes) {
    std::ranges::reverse(bytes);
    return bytes;
}

template <typename Number>
Number numberAt(const std::byte* from, bool swapped) {
    std::array<std::byte, sizeof(Number)> bytes{};
    std::memcpy(bytes.data(), from, sizeof(Number));
    if (swapped) bytes = reversed(bytes);
    Number number{};
    std::memcpy(&number, bytes.data(), sizeof(Number));
    return number;
}

/// Numbers of one type to values of the field: byte order, missing values, scale and offset.
template <typename Number>
void decode(const RawField& field, const std::byte* from, std::span<float> values) {
    const double missing = field.missing.value_or(0.0);
    const double tolerance = field.missing ? std::abs(missing) * kMissingTolerance : -1.0;
    for (std::size_t i = 0; i < values.size(); ++i) {
        const auto number =
            static_cast<double>(numberAt<Number>(from + i * sizeof(Number), field.swapped));
        values[i] = std::abs(number - missing) <= tolerance
                        ? std::numeric_limits<float>::quiet_NaN()
                        : static_cast<float>(number * field.scale + field.offset);
    }
}

void decodeAs(const RawField& field, const std::byte* from, std::span<float> values) {
    switch (field.type) {
        case NumberType::float32:
            return decode<float>(field, from, values);
        case NumberType::float64:
            return decode<double>(field, from, values);
        case NumberType::uint8:
            return decode<std::uint8_t>(field, from, values);
        case NumberType::int16:
            return decode<std::int16_t>(field, from, values);
        case NumberType::uint16:
            return decode<std::uint16_t>(field, from, values);
        case NumberType::int32:
            return decode<std::int32_t>(field, from, values);
    }
}

/// Byte position of the first number of plane `z`, which counts from the bottom.
std::uint64_t planePosition(const RawField& field, std::size_t z) {
    const std::size_t plane = field.flipZ ? field.size[2] - 1 - z : z;
    return field.firstByte + plane * field.planeStride() + (field.records ? 4 : 0);
}

/// Fortran writes the length of a record before and after it. Wrong lengths mean that the file is
/// not sequential, or in the other byte order.
void checkRecord(const RawField& field, const InputFile& file, std::uint64_t firstNumber) {
    const std::uint64_t expected = field.planeBytes();
    for (const std::uint64_t position : {firstNumber - 4, firstNumber + expected}) {
        std::array<std::byte, 4> bytes{};
        file.readAt(position, bytes);
        const auto found = numberAt<std::uint32_t>(bytes.data(), field.swapped);
        if (found == expected) continue;
        const bool other = numberAt<std::uint32_t>(bytes.data(), !field.swapped) == expected;
        throw Error{fmt::format("the record length at byte {} is not that of a plane", position),
                    fmt::format("{}", found), fmt::format("{}", expected),
                    other ? "the other byte order fits: change big_endian, little_endian or "
                            "byteswapped in the .ctl's options"
                          : "if the file has no Fortran records, remove sequential from the "
                            "options in the .ctl",
                    field.path};
    }
}

/// Reads rows [firstRow, firstRow + rows) of the box in plane `z`. `buffer` is reused between
/// calls.
void readRows(const RawField& field, const InputFile& file, const Box& box, std::size_t z,
              std::size_t firstRow, std::size_t rows, std::vector<std::byte>& buffer,
              std::span<float> values) {
    const std::size_t width = box.length(0);
    const std::size_t rowNumbers = field.size[0];
    const std::size_t y =
        field.flipY ? field.size[1] - (box.lower[1] + firstRow + rows) : box.lower[1] + firstRow;
    const std::size_t count = rows * width;  // several rows at once only if they are whole
    buffer.resize(count * bytesOf(field.type));
    file.readAt(planePosition(field, z) + (y * rowNumbers + box.lower[0]) * bytesOf(field.type),
                buffer);
    for (std::size_t row = 0; row < rows; ++row) {
        const std::size_t from = field.flipY ? rows - 1 - row : row;
        decodeAs(field, buffer.data() + from * width * bytesOf(field.type),
                 values.subspan(row * width, width));
    }
}

}  // namespace

std::size_t bytesOf(NumberType type) {
    switch (type) {
        case NumberType::float64:
            return 8;
        case NumberType::float32:
        case NumberType::int32:
            return 4;
        case NumberType::int16:
        case NumberType::uint16:
            return 2;
        case NumberType::uint8:
            return 1;
    }
    return 0;
}

std::optional<NumberType> numberTypeNamed(std::string_view name) {
    if (name == "float32") return NumberType::float32;
    if (name == "float64") return NumberType::float64;
    if (name == "uint8") return NumberType::uint8;
    if (name == "int16") return NumberType::int16;
    if (name == "uint16") return NumberType::uint16;
    if (name == "int32") return NumberType::int32;
    return {};
}

void readBox(const RawField& field, const Box& box, std::span<float> values, const Tick& tick) {
    if (field.path.empty()) {
        std::ranges::fill(values, 0.0f);
        return tick(1.0);
    }
    const InputFile file(field.path);
    const std::size_t width = box.length(0);
    const std::size_t rowBytes = width * bytesOf(field.type);
    const bool wholeRows = width == field.size[0];
    const std::size_t most = wholeRows ? std::max<std::size_t>(1, kPieceBytes / rowBytes) : 1;
    std::vector<std::byte> buffer;
    std::size_t sinceTick = kPieceBytes;
    std::size_t done = 0;
    for (std::size_t z = box.lower[2]; z < box.upper[2]; ++z) {
        if (field.records) checkRecord(field, file, planePosition(field, z));
        for (std::size_t row = 0; row < box.length(1);) {
            if (sinceTick >= kPieceBytes) {
                tick(static_cast<double>(done) / static_cast<double>(box.count()));
                sinceTick = 0;
            }
            const std::size_t rows = std::min(most, box.length(1) - row);
            readRows(field, file, box, z, row, rows, buffer, values.subspan(done, rows * width));
            row += rows;
            done += rows * width;
            sinceTick += rows * rowBytes;
        }
    }
    tick(1.0);
}

Source storedAt(Locate locate) {
    Source source;
    source.stored = [locate = std::move(locate)](std::size_t time, const Box& box,
                                                 std::span<float> values, const Tick& tick) {
        readBox(locate(time), box, values, tick);
    };
    return source;
}

bool changedLately(const std::string& path) {
    constexpr std::time_t kSeconds = 120;
    struct stat status {};
    if (::stat(path.c_str(), &status) != 0) return false;
    const std::time_t age = std::time(nullptr) - status.st_mtime;
    return age < kSeconds && age > -kSeconds;
}

void describeSize(const std::string& path, Error& error) {
    error.where = path;
    if (!changedLately(path)) return;
    error.what = "is being written, or was a moment ago, and " + error.what;
    error.hint = "open it again when the model has finished this time" +
                 (error.hint.empty() ? "" : "; if nothing writes it: " + error.hint);
}

std::string folderOf(const std::string& path) {
    const std::string folder = std::filesystem::path(path).parent_path().string();
    return folder.empty() ? "." : folder;
}

std::vector<double> readNumbers(const std::string& path, NumberType type, bool swapped,
                                std::size_t count) {
    return readReals(path, bytesOf(type), swapped, count);
}

std::optional<RecordLength> firstRecordOf(const std::string& path, std::uint64_t expected) {
    if (fileSize(path).value_or(0) < 4) return {};
    std::array<std::byte, 4> bytes{};
    InputFile(path).readAt(0, bytes);
    for (const bool swapped : {false, true}) {
        const auto found = numberAt<std::uint32_t>(bytes.data(), swapped);
        if (found == expected) return RecordLength{found, swapped};
    }
    return {};
}

void checkFirstRecord(const RawField& field) {
    checkRecord(field, InputFile(field.path), planePosition(field, 0));
}

}  // namespace les

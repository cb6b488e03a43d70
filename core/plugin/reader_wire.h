// reader_wire.h: the messages between host and reader process, as bytes.
//
// Both sides are of the same build on one machine, so numbers are sent as they are in memory.
// Unpacking trusts nothing: bytes that end early or are left over throw Malformed.
#pragma once
#include <cstdint>
#include <cstring>
#include <glm/glm.hpp>
#include <stdexcept>
#include <string>
#include <string_view>
#include <type_traits>

#include "core/base/error.h"
#include "core/grid/boxes.h"
#include "core/plugin/dataset_info.h"

namespace neph::wire {

/// Thrown while unpacking bytes that are not a valid message.
class Malformed : public std::runtime_error {
  public:
    Malformed() : std::runtime_error("a message of the reader process is malformed") {}
};

/// Appends numbers and texts to a message.
class Packer {
  public:
    template <typename T>
    Packer& number(T value) {
        static_assert(std::is_trivially_copyable_v<T> && !std::is_pointer_v<T>);
        bytes_.append(reinterpret_cast<const char*>(&value), sizeof value);
        return *this;
    }
    Packer& text(std::string_view text);
    std::string take() { return std::move(bytes_); }

  private:
    std::string bytes_;
};

/// Takes numbers and texts from a message, in the order in which they were packed.
class Unpacker {
  public:
    explicit Unpacker(std::string_view bytes) : rest_(bytes) {}
    template <typename T>
    T number() {
        static_assert(std::is_trivially_copyable_v<T> && !std::is_pointer_v<T>);
        T value;
        std::memcpy(&value, piece(sizeof value).data(), sizeof value);
        return value;
    }
    std::string text();
    /// A count of entries of at least `bytesEach` bytes; throws Malformed if fewer bytes remain.
    std::size_t count(std::size_t bytesEach);
    /// Throws Malformed if bytes are left.
    void end() const;

  private:
    std::string_view piece(std::size_t length);
    std::string_view rest_;
};

/// The requests of the host, and the first byte of every answer.
enum class Ask : std::uint8_t { score, open, read, close };
enum class Answer : std::uint8_t { ok, failed, cancelled };

/// What a reader states about itself.
struct Identity {
    std::string id, version, title, extensions;
    std::uint32_t abiVersion = 0;
    bool takesMap = false;  ///< whether it opens files with a map
};

/// A box of one variable at one time; indices refer to the description.
struct ReadRequest {
    std::uint32_t handle = 0;
    std::uint64_t variable = 0, time = 0;
    CellBox box;
};

void pack(Packer& to, const Identity& identity);
void pack(Packer& to, const ErrorParts& parts);
/// What a reader states about one file, without its times, which differ from file to file: the
/// header cache keeps times for each file and the rest once.
void packBesidesTimes(Packer& to, const DatasetInfo& info);
void packTimes(Packer& to, const std::vector<TimeInfo>& times);
/// Both.
void pack(Packer& to, const DatasetInfo& info);
Identity unpackIdentity(Unpacker& from);
ErrorParts unpackError(Unpacker& from);
DatasetInfo unpackBesidesTimes(Unpacker& from);
std::vector<TimeInfo> unpackTimes(Unpacker& from);
DatasetInfo unpackInfo(Unpacker& from);

/// Sends one message; false if the other side has closed the connection.
bool send(int socket, std::string_view message);
/// Waits for one message; false if the other side has closed the connection or the message is too
/// long.
bool receive(int socket, std::string& message);

}  // namespace neph::wire

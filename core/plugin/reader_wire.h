// reader_wire.h: what host and reader process say to each other, as bytes.
//
// Both are of one build on one machine: numbers go as they lie in memory. Unpacking trusts nothing:
// bytes that end early or are left over throw Malformed.
#pragma once
#include <cstdint>
#include <cstring>
#include <glm/glm.hpp>
#include <stdexcept>
#include <string>
#include <string_view>
#include <type_traits>

#include "core/base/error.h"
#include "core/plugin/file_description.h"

namespace neph::wire {

class Malformed : public std::runtime_error {
  public:
    Malformed() : std::runtime_error("a message of the reader process is malformed") {}
};

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
    /// A count of entries of at least `bytesEach`, which must still be there.
    std::size_t count(std::size_t bytesEach);
    void end() const;

  private:
    std::string_view piece(std::size_t length);
    std::string_view rest_;
};

enum class Ask : std::uint8_t { score, open, read, close };
enum class Answer : std::uint8_t { ok, failed, cancelled };

/// What a reader says of itself.
struct Identity {
    std::string id, version, title, extensions;
    std::uint32_t abiVersion = 0;
};

struct ReadRequest {
    std::uint32_t handle = 0;
    std::uint64_t variable = 0, time = 0;
    glm::ivec3 lower{0}, upper{0};
};

void pack(Packer& to, const Identity& identity);
void pack(Packer& to, const ErrorParts& parts);
void pack(Packer& to, const FileDescription& description);
Identity unpackIdentity(Unpacker& from);
ErrorParts unpackError(Unpacker& from);
FileDescription unpackDescription(Unpacker& from);

/// Sends one message; false when the other side has gone.
bool send(int socket, std::string_view message);
/// Waits for one message; false when the other side has gone or the message is larger than any.
bool receive(int socket, std::string& message);

}  // namespace neph::wire

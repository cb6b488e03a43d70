// reader_wire.cpp: packing and unpacking, and messages prefixed with their length.
#include "core/plugin/reader_wire.h"

#include <sys/socket.h>

#include <cerrno>

namespace neph::wire {
namespace {

constexpr std::uint64_t kLongestMessage = std::uint64_t{1} << 28U;

bool sendAll(int socket, const char* bytes, std::size_t count) {
    while (count > 0) {
        const ssize_t sent = ::send(socket, bytes, count, MSG_NOSIGNAL);
        if (sent < 0 && errno == EINTR) continue;
        if (sent <= 0) return false;
        bytes += sent;
        count -= static_cast<std::size_t>(sent);
    }
    return true;
}

bool receiveAll(int socket, char* bytes, std::size_t count) {
    while (count > 0) {
        const ssize_t got = ::recv(socket, bytes, count, 0);
        if (got < 0 && errno == EINTR) continue;
        if (got <= 0) return false;
        bytes += got;
        count -= static_cast<std::size_t>(got);
    }
    return true;
}

}  // namespace

Packer& Packer::text(std::string_view text) {
    number(static_cast<std::uint64_t>(text.size()));
    bytes_.append(text);
    return *this;
}

std::string_view Unpacker::piece(std::size_t length) {
    if (length > rest_.size()) throw Malformed{};
    const std::string_view taken = rest_.substr(0, length);
    rest_.remove_prefix(length);
    return taken;
}

std::string Unpacker::text() {
    return std::string(piece(number<std::uint64_t>()));
}

std::size_t Unpacker::count(std::size_t bytesEach) {
    const auto entries = number<std::uint64_t>();
    if (entries > rest_.size() / bytesEach) throw Malformed{};
    return entries;
}

void Unpacker::end() const {
    if (!rest_.empty()) throw Malformed{};
}

void pack(Packer& to, const Identity& identity) {
    to.text(identity.id).text(identity.version).text(identity.title).text(identity.extensions);
    to.number(identity.abiVersion);
}

Identity unpackIdentity(Unpacker& from) {
    Identity identity;
    for (std::string* part :
         {&identity.id, &identity.version, &identity.title, &identity.extensions}) {
        *part = from.text();
    }
    identity.abiVersion = from.number<std::uint32_t>();
    return identity;
}

void pack(Packer& to, const ErrorParts& parts) {
    to.text(parts.where).text(parts.what).text(parts.found).text(parts.expected).text(parts.hint);
}

ErrorParts unpackError(Unpacker& from) {
    ErrorParts parts;
    for (std::string* part :
         {&parts.where, &parts.what, &parts.found, &parts.expected, &parts.hint}) {
        *part = from.text();
    }
    return parts;
}

void pack(Packer& to, const FileDescription& d) {
    to.text(d.model).text(d.scheme).number(d.microphysics).number(d.cloudDropletsPerM3);
    to.number(d.size).number(d.spacingM);
    to.number(static_cast<std::uint64_t>(d.times.size()));
    for (const FileTime& time : d.times) to.text(time.label).number(time.seconds);
    to.number(static_cast<std::uint64_t>(d.variables.size()));
    for (const FileVariable& v : d.variables) {
        to.text(v.name).text(v.standardName).text(v.units).text(v.description);
        to.number(v.role).number(v.species).number(v.size);
    }
    to.number(static_cast<std::uint64_t>(d.notes.size()));
    for (const std::string& note : d.notes) to.text(note);
    to.number(static_cast<std::uint64_t>(d.attributes.size()));
    for (const auto& [name, value] : d.attributes) to.text(name).text(value);
}

FileDescription unpackDescription(Unpacker& from) {
    FileDescription d;
    d.model = from.text();
    d.scheme = from.text();
    d.microphysics = from.number<NephMicrophysics>();
    d.cloudDropletsPerM3 = from.number<double>();
    d.size = from.number<glm::ivec3>();
    d.spacingM = from.number<glm::dvec2>();
    d.times.resize(from.count(sizeof(std::uint64_t)));
    for (FileTime& time : d.times) {
        time.label = from.text();
        time.seconds = from.number<double>();
    }
    d.variables.resize(from.count(sizeof(std::uint64_t)));
    for (FileVariable& v : d.variables) {
        for (std::string* part : {&v.name, &v.standardName, &v.units, &v.description}) {
            *part = from.text();
        }
        v.role = from.number<NephRole>();
        v.species = from.number<NephSpecies>();
        v.size = from.number<glm::ivec3>();
    }
    d.notes.resize(from.count(sizeof(std::uint64_t)));
    for (std::string& note : d.notes) note = from.text();
    const std::size_t attributes = from.count(2 * sizeof(std::uint64_t));
    for (std::size_t i = 0; i < attributes; ++i) {
        std::string name = from.text();
        d.attributes[std::move(name)] = from.text();
    }
    return d;
}

bool send(int socket, std::string_view message) {
    const std::uint64_t length = message.size();
    return sendAll(socket, reinterpret_cast<const char*>(&length), sizeof length) &&
           sendAll(socket, message.data(), message.size());
}

bool receive(int socket, std::string& message) {
    std::uint64_t length = 0;
    if (!receiveAll(socket, reinterpret_cast<char*>(&length), sizeof length)) return false;
    if (length > kLongestMessage) return false;
    message.resize(length);
    return receiveAll(socket, message.data(), message.size());
}

}  // namespace neph::wire

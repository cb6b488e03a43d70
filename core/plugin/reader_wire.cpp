// reader_wire.cpp: packing and unpacking, and messages prefixed with their length.
#include "core/plugin/reader_wire.h"

#include <sys/socket.h>

#include <cerrno>
#include <cmath>
#include <limits>

namespace neph::wire {
namespace {

constexpr std::uint64_t kLongestMessage = std::uint64_t{1} << 28U;

constexpr std::int32_t kNoSpecies = -1;
constexpr double kNoDate = std::numeric_limits<double>::quiet_NaN();

/// A number from `first` to below `end`: of an enumeration.
int unpackChoice(Unpacker& from, std::int32_t first, std::int32_t end) {
    const auto choice = from.number<std::int32_t>();
    if (choice < first || choice >= end) throw Malformed{};
    return choice;
}

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

/// None, or one more than there are `cells`.
void unpackEdges(Unpacker& from, int cells, std::vector<double>& edges) {
    edges.resize(from.count(sizeof(double)));
    for (double& edge : edges) edge = from.number<double>();
    if (!edges.empty() && edges.size() != static_cast<std::size_t>(cells) + 1) throw Malformed();
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
    to.number(identity.abiVersion).number(std::uint32_t{identity.takesMap ? 1U : 0U});
}

Identity unpackIdentity(Unpacker& from) {
    Identity identity;
    for (std::string* part :
         {&identity.id, &identity.version, &identity.title, &identity.extensions}) {
        *part = from.text();
    }
    identity.abiVersion = from.number<std::uint32_t>();
    identity.takesMap = from.number<std::uint32_t>() != 0;
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

void packTimes(Packer& to, const std::vector<TimeInfo>& times) {
    to.number(static_cast<std::uint64_t>(times.size()));
    for (const TimeInfo& time : times) {
        to.text(time.label).number(time.seconds);
        to.number(time.utc ? time.utc->time_since_epoch().count() : kNoDate);
        to.number(time.gridOffsetM);
    }
}

std::vector<TimeInfo> unpackTimes(Unpacker& from) {
    std::vector<TimeInfo> times(from.count(5 * sizeof(std::uint64_t)));
    for (std::size_t i = 0; i < times.size(); ++i) {
        times[i].label = from.text();
        times[i].seconds = from.number<double>();
        times[i].indexInFile = static_cast<int>(i);
        const auto utc = from.number<double>();
        if (!std::isnan(utc)) times[i].utc = UtcTime(UtcTime::duration(utc));
        times[i].gridOffsetM = from.number<glm::dvec2>();
    }
    return times;
}

void packBesidesTimes(Packer& to, const DatasetInfo& info) {
    to.text(info.model).text(info.scheme);
    to.number(static_cast<std::int32_t>(info.microphysics)).number(info.cloudDropletsPerM3);
    to.number(info.size).number(info.spacingM).text(info.domain);
    to.text(info.map.projection).number(info.map.originM).number(info.map.mapPerGrid);
    to.text(info.noPlace).number(info.rowsTogether);
    to.number(info.nest.number).number(info.nest.parent);
    to.number(info.nest.cornerCells).number(info.nest.ratio);
    for (const std::vector<double>& edges : info.edgesM) {
        to.number(static_cast<std::uint64_t>(edges.size()));
        for (const double edge : edges) to.number(edge);
    }
    to.number(static_cast<std::uint64_t>(info.parts.size()));
    for (const std::filesystem::path& part : info.parts) to.text(part.string());
    to.number(static_cast<std::uint64_t>(info.variables.size()));
    for (const VariableInfo& v : info.variables) {
        to.text(v.name).text(v.standardName).text(v.units).text(v.description);
        to.number(static_cast<std::int32_t>(v.role));
        to.number(v.species ? static_cast<std::int32_t>(*v.species) : kNoSpecies).number(v.size);
        to.text(v.reason);
    }
    to.number(static_cast<std::uint64_t>(info.notes.size()));
    for (const std::string& note : info.notes) to.text(note);
    to.number(static_cast<std::uint64_t>(info.attributes.size()));
    for (const auto& [name, value] : info.attributes) to.text(name).text(value);
}

DatasetInfo unpackBesidesTimes(Unpacker& from) {
    DatasetInfo info;
    info.model = from.text();
    info.scheme = from.text();
    info.microphysics = static_cast<Microphysics>(unpackChoice(from, 0, kMicrophysics));
    info.cloudDropletsPerM3 = from.number<double>();
    info.size = from.number<glm::ivec3>();
    info.spacingM = from.number<glm::dvec2>();
    info.domain = from.text();
    info.map.projection = from.text();
    info.map.originM = from.number<glm::dvec2>();
    info.map.mapPerGrid = from.number<glm::dvec2>();
    info.noPlace = from.text();
    info.rowsTogether = from.number<std::uint32_t>();
    info.nest.number = from.number<int>();
    info.nest.parent = from.number<int>();
    info.nest.cornerCells = from.number<glm::ivec2>();
    info.nest.ratio = from.number<int>();
    for (std::size_t axis = 0; axis < info.edgesM.size(); ++axis) {
        unpackEdges(from, info.size[static_cast<int>(axis)], info.edgesM[axis]);
    }
    info.parts.resize(from.count(sizeof(std::uint64_t)));
    for (std::filesystem::path& part : info.parts) part = from.text();
    info.variables.resize(from.count(4 * sizeof(std::uint64_t)));
    for (VariableInfo& v : info.variables) {
        for (std::string* part : {&v.name, &v.standardName, &v.units, &v.description}) {
            *part = from.text();
        }
        v.role = static_cast<VariableRole>(unpackChoice(from, 0, kVariableRoles));
        const int species = unpackChoice(from, kNoSpecies, static_cast<int>(kSpeciesCount));
        if (species != kNoSpecies) v.species = static_cast<Species>(species);
        v.size = from.number<glm::ivec3>();
        v.reason = from.text();
    }
    info.notes.resize(from.count(sizeof(std::uint64_t)));
    for (std::string& note : info.notes) note = from.text();
    const std::size_t attributes = from.count(2 * sizeof(std::uint64_t));
    for (std::size_t i = 0; i < attributes; ++i) {
        std::string name = from.text();
        info.attributes[std::move(name)] = from.text();
    }
    return info;
}

void pack(Packer& to, const DatasetInfo& info) {
    packTimes(to, info.times);
    packBesidesTimes(to, info);
}

DatasetInfo unpackInfo(Unpacker& from) {
    std::vector<TimeInfo> times = unpackTimes(from);
    DatasetInfo info = unpackBesidesTimes(from);
    info.times = std::move(times);
    return info;
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

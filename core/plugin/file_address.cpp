// file_address.cpp: the commands that fetch what stands at an address, by its scheme.
#include "core/plugin/file_address.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>

#include "core/plugin/file_signs.h"

namespace neph {
namespace {

constexpr std::string_view kMark = "://";

struct Scheme {
    std::string_view name, command;
};
/// ADDRESS stands for the whole address.
constexpr std::array kSchemes{
    Scheme{"http", "curl -fLO ADDRESS"},      Scheme{"https", "curl -fLO ADDRESS"},
    Scheme{"ftp", "curl -fLO ADDRESS"},       Scheme{"ftps", "curl -fLO ADDRESS"},
    Scheme{"s3", "aws s3 cp ADDRESS ."},      Scheme{"gs", "gcloud storage cp ADDRESS ."},
    Scheme{"az", "azcopy copy ADDRESS ."},    Scheme{"dap", "nccopy ADDRESS data.nc"},
    Scheme{"dods", "nccopy ADDRESS data.nc"}, Scheme{"dap2", "nccopy ADDRESS data.nc"},
    Scheme{"dap4", "nccopy ADDRESS data.nc"}, Scheme{"sftp", "curl -O ADDRESS"},
    Scheme{"scp", "curl -O ADDRESS"},
};

bool isSchemeLetter(char c) {
    return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '+' || c == '-' || c == '.';
}

/// Servers of OPeNDAP answer ordinary requests with a page; these paths are theirs.
bool isOpendap(std::string_view address) {
    return address.find("/dodsC/") != address.npos || address.find("/opendap/") != address.npos ||
           address.find("#dap") != address.npos;
}

std::string lowered(std::string_view text) {
    std::string low(text);
    std::ranges::transform(low, low.begin(), [](unsigned char c) { return std::tolower(c); });
    return low;
}

std::string commandFor(std::string_view scheme, std::string_view address) {
    const auto known = std::ranges::find(kSchemes, scheme, &Scheme::name);
    if (known == kSchemes.end()) return {};
    std::string command(isOpendap(address) ? "nccopy ADDRESS data.nc" : known->command);
    constexpr std::string_view kWord = "ADDRESS";
    return command.replace(command.find(kWord), kWord.size(), shellWord(std::string(address)));
}

}  // namespace

std::optional<std::size_t> addressIn(std::string_view text) {
    const std::size_t mark = text.find(kMark);
    if (mark == text.npos) return {};
    std::size_t begin = mark;
    while (begin > 0 && isSchemeLetter(text[begin - 1])) --begin;
    const bool scheme = begin < mark && std::isalpha(static_cast<unsigned char>(text[begin])) != 0;
    return scheme ? std::optional(begin) : std::nullopt;
}

std::string addressAdvice(std::string_view name) {
    if (addressIn(name) != std::size_t{0}) return {};
    const std::size_t mark = name.find(kMark);
    const std::string scheme = lowered(name.substr(0, mark));
    if (scheme == "file") {
        return fmt::format("name the file by its path: {}", name.substr(mark + kMark.size()));
    }
    const std::string command = commandFor(scheme, name);
    return command.empty()
               ? "copy it to this machine first, then open the copy"
               : fmt::format(
                     "download it first, then open the copy: `{}`, on a cluster on a node "
                     "that reaches the network",
                     command);
}

}  // namespace neph

// file_address.h: addresses in the network that are named where files are opened.
#pragma once
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace neph {

/// Where in `text` an address such as https://... begins: at its scheme. Empty where there is none.
std::optional<std::size_t> addressIn(std::string_view text);

/// What to do about a name that is an address, which cannot be opened; empty where it is none.
std::string addressAdvice(std::string_view name);

}  // namespace neph

// metadata.h: text stored in an image file: where the image comes from and how to make it again.
#pragma once
#include <string>
#include <utility>
#include <vector>

namespace neph {

/// Pairs of key and UTF-8 text, in file order. Keys are 1 to 31 printable ASCII characters, which
/// both EXR attribute names and PNG keywords allow.
using Metadata = std::vector<std::pair<std::string, std::string>>;

}  // namespace neph

// metadata.h: the text that goes with a picture: where it comes from and how to make it again.
#pragma once
#include <string>
#include <utility>
#include <vector>

namespace neph {

/// Pairs of key and UTF-8 text, in the order in which they are written. Keys are 1 to 31 printable
/// ASCII characters, which both EXR attribute names and PNG keywords allow.
using Metadata = std::vector<std::pair<std::string, std::string>>;

}  // namespace neph

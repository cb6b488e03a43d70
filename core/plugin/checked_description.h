// checked_description.h: what a reader says of a file, as this program trusts it.
#pragma once
#include <string>

#include "core/plugin/dataset_info.h"
#include "core/plugin/reader_abi.h"

namespace neph {

/// One faulty claim of a reader; PluginFile makes it an Error that names reader and file.
struct ReaderFault {
    std::string text;
};

/// Copies a description of any served version while checking it. Throws ReaderFault. A place or a
/// date that cannot be used is left out with a note.
DatasetInfo checkedDescription(const NephDescription* pointer);

}  // namespace neph

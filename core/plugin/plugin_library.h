// plugin_library.h: one reader library, loaded into this process and checked.
//
// Only `nephoscope-reader` and the fuzz targets load libraries; everything else asks a
// ReaderProcess. A loaded library is never unloaded, because libraries such as HDF5 do not bear it.
#pragma once
#include <filesystem>

#include "core/plugin/reader_abi.h"
#include "core/plugin/reader_wire.h"

namespace neph {

struct PluginLibrary {
    wire::Identity identity;
    const NephReader* calls = nullptr;
};

/// Loads a library. Throws Error, whose `what` is the reason, when it is no reader.
PluginLibrary loadPlugin(const std::filesystem::path& library);

/// What a table of calls says of itself. Throws Error when it cannot be used.
PluginLibrary checkPlugin(const NephReader* calls);

}  // namespace neph

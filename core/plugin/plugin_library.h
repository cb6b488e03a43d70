// plugin_library.h: one reader library, loaded into this process and checked.
//
// Only `nephoscope-reader` and the fuzz targets load libraries; everything else asks a
// ReaderProcess. A loaded library is never unloaded, because libraries such as HDF5 do not tolerate
// it.
#pragma once
#include <filesystem>

#include "core/plugin/reader_abi.h"
#include "core/plugin/reader_wire.h"

namespace neph {

/// A loaded reader: what it is, and its table of calls.
struct PluginLibrary {
    wire::Identity identity;
    const NephReader* calls = nullptr;
};

/// Loads a library. Throws Error, whose `what` is the reason, if it is not a reader.
PluginLibrary loadPlugin(const std::filesystem::path& library);

/// Checks a table of calls and takes its identity. Throws Error if it cannot be used.
PluginLibrary checkPlugin(const NephReader* calls);

}  // namespace neph

// reader.cpp: entry point of the reader of NetCDF from LES models and by the conventions of CF.
#include "core/plugin/reader_plugin.h"
#include "readers/cf_les/cf_file.h"

namespace {

namespace plugin = neph::plugin;

int score(const char* path) {
    return cf::scoreOf(path);
}

std::unique_ptr<plugin::File> open(const char* path) {
    return cf::openFile(path, "");
}

std::unique_ptr<plugin::File> openWithMap(const char* path, const char* map) {
    return cf::openFile(path, map);
}

constexpr plugin::Reader kReader{
    "cf_les",
    "1.0",
    "NetCDF of LES models (CM1, SAM, DALES, PALM, MONC, UCLALES, MicroHH, Meso-NH) and CF",
    "nc",
    &score,
    &open,
    &openWithMap};

}  // namespace

NEPHOSCOPE_READER(kReader)

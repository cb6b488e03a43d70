// reader.cpp: entry point of the WRF reader: adapts WrfFile to core/plugin/reader_plugin.h.
#include "core/plugin/reader_plugin.h"
#include "readers/wrf_netcdf/wrf_file.h"

namespace {

namespace plugin = neph::plugin;

class File : public plugin::File {
  public:
    explicit File(const char* path) : file_(path) {}

    const plugin::Description& description() const override { return file_.description(); }

    void read(const plugin::Request& request) override {
        file_.read(request.variable, request.time, {request.lower, request.upper},
                   {request.values, request.count()}, request.tick);
    }

  private:
    wrf::WrfFile file_;
};

/// A NetCDF file that is not WRF output, or is damaged, still scores a little: opening it then
/// reports what is wrong, which "unknown format" would not.
int score(const char* path) {
    constexpr int kContainerOnly = 5;
    constexpr int kWrf = 90;
    try {
        if (wrf::containerOf(path) == wrf::Container::unknown) return 0;
        return wrf::looksLikeWrf(wrf::NcFile(path)) ? kWrf : kContainerOnly;
    } catch (...) {
        return kContainerOnly;
    }
}

constexpr plugin::Reader kReader{
    "wrf_netcdf", "1.2",  "WRF output (NetCDF-3, 64-bit offset, NetCDF-4)",
    "nc",         &score, &plugin::openAs<File>};

}  // namespace

NEPHOSCOPE_READER(kReader)

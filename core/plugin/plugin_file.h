// plugin_file.h: one file, opened through the calls of a reader in this process, with all results
// of the reader checked.
//
// Nothing that comes through the ABI is trusted: sizes, counts, numbers and strings are checked
// before they are used, so that a faulty reader causes an Error and never a wrong image.
#pragma once
#include <filesystem>
#include <functional>
#include <glm/glm.hpp>
#include <memory>
#include <span>
#include <string>

#include "core/base/error.h"
#include "core/base/progress.h"
#include "core/grid/boxes.h"
#include "core/plugin/dataset_info.h"
#include "core/plugin/reader_abi.h"

namespace neph {

class PluginFile {
  public:
    /// Opens the file, with a map where one is named, and gets its description. `reader` names the
    /// reader in messages. Throws Error.
    PluginFile(const NephReader& calls, std::string reader, std::filesystem::path path,
               const std::filesystem::path& map = {});

    const DatasetInfo& description() const { return description_; }

    /// Extra values that `read` needs behind those requested, to detect a reader that writes too
    /// much.
    static constexpr std::size_t kGuardValues = 1024;

    /// Fills `room` with the cells of `box`, x fastest, NaN where the reader wrote nothing; behind
    /// them `room` holds exactly kGuardValues more. Throws Error or Cancelled.
    void read(std::size_t variable, std::size_t time, const CellBox& box, std::span<float> room,
              const Progress& progress);

  private:
    struct Closer {
        const NephReader* calls;
        void operator()(NephFile* file) const;
    };
    /// Runs one call of the reader; an exception, which the ABI forbids, becomes an Error.
    void guarded(const std::function<void()>& call) const;
    Error faulty(const std::string& text) const;

    const NephReader* calls_;
    std::string reader_;
    std::filesystem::path path_;
    std::unique_ptr<NephFile, Closer> file_;
    DatasetInfo description_;
};

}  // namespace neph

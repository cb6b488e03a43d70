// reader_file.h: one file, opened by a reader in a separate process.
//
// Whatever the file or the reader does, the result is at worst an Error. One ReaderFile is used by
// one thread at a time; several may be used concurrently.
#pragma once
#include <filesystem>
#include <glm/glm.hpp>
#include <memory>
#include <string>
#include <vector>

#include "core/base/progress.h"
#include "core/grid/boxes.h"
#include "core/plugin/dataset_info.h"
#include "core/plugin/plugin_host.h"
#include "core/plugin/reader_process.h"

namespace neph {

class ReaderFile {
  public:
    /// Opens the file and gets its description. Throws Error or Cancelled.
    ReaderFile(std::shared_ptr<const ReaderPlugin> reader, std::filesystem::path path,
               const Progress& progress = {});
    ~ReaderFile();
    ReaderFile(const ReaderFile&) = delete;
    ReaderFile& operator=(const ReaderFile&) = delete;

    const DatasetInfo& description() const { return description_; }

    /// The cells of `box`, x fastest; NaN where the reader wrote nothing. Throws Error or
    /// Cancelled. After a crash of the reader the next read opens the file again.
    std::vector<float> read(std::size_t variable, std::size_t time, const CellBox& box,
                            const Progress& progress);

  private:
    void open(const Progress& progress);

    std::shared_ptr<const ReaderPlugin> reader_;
    std::filesystem::path path_;
    std::unique_ptr<ReaderProcess> process_;
    std::uint32_t handle_ = 0;
    DatasetInfo description_;
};

}  // namespace neph

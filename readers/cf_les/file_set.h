// file_set.h: the files of one data set at one time or several: one file, its tiles, and files
// beside it that hold one variable each.
#pragma once
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "readers/cf_les/tiled_file.h"

namespace cf {

/// A variable in one of the files.
struct Stored {
    std::size_t file = 0;  ///< index into FileSet::files()
    const nc::NcVariable* variable = nullptr;
    const Name* name = nullptr;  ///< null if it has no known meaning
    Layout layout;
};

class FileSet {
  public:
    /// Opens the files beside `file` whose names differ in nothing but the variable: ql.nc, qr.nc.
    /// Throws Failure.
    FileSet(std::unique_ptr<nc::NcFile> file, const Model& model);

    const nc::NcFile& main() const { return files_.front()->first(); }
    const TiledFile& file(std::size_t index) const { return *files_[index]; }
    const TiledFile& tiles() const { return *files_.front(); }
    /// All files but the one that was opened.
    std::vector<std::string> parts() const;
    /// The variables with a layout, of all files; of one name the first.
    const std::vector<Stored>& variables() const { return variables_; }
    /// The first with a meaning.
    const Stored* find(Meaning meaning) const;

    /// Leaves out the files that `unfit` refuses, which is asked for each file but the first.
    template <typename Unfit>
    void dropFiles(Unfit unfit) {
        for (std::size_t i = files_.size(); i-- > 1;) {
            if (unfit(files_[i]->first())) drop(i);
        }
    }

  private:
    void addVariables(std::size_t file, const Model& model);
    void drop(std::size_t file);

    std::string path_;
    std::vector<std::unique_ptr<TiledFile>> files_;
    std::vector<Stored> variables_;
};

}  // namespace cf

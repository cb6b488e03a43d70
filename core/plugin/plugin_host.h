// plugin_host.h: finds reader plugins, checks them and picks the one for a file.
//
// Registration is explicit: a host knows the places it was given and no others. A library is
// accepted if a separate process can load it, it exports the entry of core/plugin/reader_abi.h, and
// its table is complete; otherwise it is listed with the reason.
#pragma once
#include <filesystem>
#include <memory>
#include <mutex>
#include <span>
#include <string>
#include <vector>

#include "core/plugin/reader_process.h"

namespace neph {

/// What a reader states about itself, and where its library is.
struct ReaderName : wire::Identity {
    std::filesystem::path library;
};

/// One accepted reader, and the processes that run it.
struct ReaderPlugin : ReaderName {
    /// Starts a first process. Throws Error, with the reason in `what`, if the library is not a
    /// reader.
    explicit ReaderPlugin(const std::filesystem::path& file, const ReaderLimits& limits = {},
                          std::filesystem::path mapFile = {});

    const std::filesystem::path map;  ///< what files are opened with; empty: without

    /// An idle process of this reader, or a new one. May be called from any thread. Throws Error.
    std::unique_ptr<ReaderProcess> borrow() const;
    /// Returns a borrowed process for reuse; one that has ended is dropped.
    void giveBack(std::unique_ptr<ReaderProcess> process) const;

  private:
    ReaderLimits limits_;
    mutable std::mutex mutex_;
    mutable std::vector<std::unique_ptr<ReaderProcess>> idle_;
};

/// A library that was found but not accepted; `nephoscope readers` lists it.
struct RejectedPlugin {
    std::filesystem::path library;
    std::string reason;
};

/// Throws Error if a path cannot be opened for reading at all, or is neither a file nor a folder: a
/// reader would wait for what writes to a pipe.
void requireReadable(const std::filesystem::path& file);

/// The readers that are available. Immutable after construction, so any thread may use it.
class PluginHost {
  public:
    /// Loads every plugin of `places`, in order; a place is a folder of libraries or one library. A
    /// place that does not exist is skipped. Of two readers with the same id the first is kept.
    explicit PluginHost(std::span<const std::filesystem::path> places,
                        const ReaderLimits& limits = {}, std::filesystem::path map = {});

    /// The readers available to a user: the libraries or folders in `named`, then those of
    /// standardPlaces(). Throws Error if one of `named` does not exist or is not a reader.
    /// `map` is a file that says what the variables of unknown files are: every file is then opened
    /// with it, by the first reader that takes one.
    static PluginHost standard(std::span<const std::string> named = {},
                               const std::string& map = {});

    /// NEPHOSCOPE_READER_PATH (separated by colons), the user's data folder (XDG), and the folder
    /// of this installation.
    static std::vector<std::filesystem::path> standardPlaces();

    const std::vector<std::shared_ptr<const ReaderPlugin>>& readers() const { return readers_; }
    const std::vector<RejectedPlugin>& rejected() const { return rejected_; }
    const std::filesystem::path& map() const { return map_; }

    /// Of the files that readers take, as they say, without dots.
    std::vector<std::string> extensions() const;

    /// Whether a reader knows the format of a file, if only to say what is wrong with it.
    bool isKnown(const std::filesystem::path& file) const;

    /// The reader with the best score for the content of `file`. Throws Error if the file cannot be
    /// opened or no reader knows its format, or Cancelled.
    std::shared_ptr<const ReaderPlugin> pick(const std::filesystem::path& file,
                                             const Progress& progress = {}) const;

  private:
    std::shared_ptr<const ReaderPlugin> pickForMap(const std::filesystem::path& file) const;
    void load(const std::filesystem::path& library, const ReaderLimits& limits);

    std::vector<std::shared_ptr<const ReaderPlugin>> readers_;
    std::vector<RejectedPlugin> rejected_;
    std::filesystem::path map_;
};

}  // namespace neph

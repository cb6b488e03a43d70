// plugin_host.h: finds reader plugins, checks them at the door and picks the one for a file.
//
// Registration is explicit: a host knows the places it was given and no others. A library is
// accepted when a process of its own can load it, it exports the entry of core/plugin/reader_abi.h
// and its table is complete; otherwise it is kept in a list with the reason.
#pragma once
#include <filesystem>
#include <memory>
#include <mutex>
#include <span>
#include <string>
#include <vector>

#include "core/plugin/reader_process.h"

namespace neph {

/// What a reader says of itself, and where it lies.
struct ReaderName : wire::Identity {
    std::filesystem::path library;
};

/// One accepted reader, and the processes that run it.
struct ReaderPlugin : ReaderName {
    /// Starts a first process. Throws Error, with the reason in `what`, when it is no reader.
    explicit ReaderPlugin(const std::filesystem::path& file, const ReaderLimits& limits = {});

    /// An idle process of this reader, or a new one. Any thread. Throws Error.
    std::unique_ptr<ReaderProcess> borrow() const;
    void giveBack(std::unique_ptr<ReaderProcess> process) const;

  private:
    ReaderLimits limits_;
    mutable std::mutex mutex_;
    mutable std::vector<std::unique_ptr<ReaderProcess>> idle_;
};

struct RejectedPlugin {
    std::filesystem::path library;
    std::string reason;
};

class PluginHost {
  public:
    /// Loads every plugin of `places`, in order; a place is a folder of libraries or one library. A
    /// place that does not exist is passed over. Of two readers with the same id the first is kept.
    explicit PluginHost(std::span<const std::filesystem::path> places,
                        const ReaderLimits& limits = {});

    /// The readers a user has: the libraries or folders in `named`, then those of
    /// standardPlaces(). Throws Error where one of `named` is not there or is no reader.
    static PluginHost standard(std::span<const std::string> named = {});

    /// NEPHOSCOPE_READER_PATH (separated by colons), the user's data folder (XDG), and beside the
    /// executable.
    static std::vector<std::filesystem::path> standardPlaces();

    const std::vector<std::shared_ptr<const ReaderPlugin>>& readers() const { return readers_; }
    const std::vector<RejectedPlugin>& rejected() const { return rejected_; }

    /// The reader with the best score for the content of `file`. Throws Error when the file cannot
    /// be opened or no reader knows its format, or Cancelled.
    std::shared_ptr<const ReaderPlugin> pick(const std::filesystem::path& file,
                                             const Progress& progress = {}) const;

  private:
    void load(const std::filesystem::path& library, const ReaderLimits& limits);

    std::vector<std::shared_ptr<const ReaderPlugin>> readers_;
    std::vector<RejectedPlugin> rejected_;
};

}  // namespace neph

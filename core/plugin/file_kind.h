// file_kind.h: what a file or folder is that no reader takes, and what its owner can do about it.
//
// One table: each row recognises one kind by content, never by name. A name only decides how the
// command in the advice is spelled. docs/readers.md has the table for users.
#pragma once
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "core/plugin/file_signs.h"

namespace neph {

/// One kind of file that is recognised but not read.
struct FileKindRow {
    std::string_view id;
    std::string_view what;      ///< "a file compressed with gzip"
    std::string_view sign;      ///< how it is recognised, for the reference page
    std::string_view step;      ///< what to do; FILE is the path, STEM the path without its ending
    std::string_view suffix{};  ///< that the command in `step` needs, ".gz"; empty: none
    std::string_view otherwise{};  ///< instead of `step` where the name has another ending
    bool (*is)(const FileSigns&) = nullptr;
    /// What runs leave beside their output, or empty; nobody misses it where it is left out.
    bool aside = false;
    std::string (*detail)(const FileSigns&) = nullptr;  ///< what else is known of it; null: nothing
};

/// In the order in which they are tried.
std::span<const FileKindRow> fileKinds();

/// A file that was recognised.
struct RecognisedFile {
    const FileKindRow* row = nullptr;
    std::string what;  ///< with what is known of this one: "a NumPy array of float32, 64 x 32 x 16"
    std::string step;  ///< with the name of this one, ready to be typed
};

/// What a file or folder is; empty where it is none of the kinds, or cannot be looked at.
std::optional<RecognisedFile> recogniseFile(const std::filesystem::path& path);

}  // namespace neph

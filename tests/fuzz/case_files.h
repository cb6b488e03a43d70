// case_files.h: several files in one input, for the target whose reader opens a folder.
//
// Each file is a line "=== NAME" and the bytes up to the next such line. "=== NAME BYTES" sets its
// length, by truncation or zeros at the end, so that sizes can be made to fit.
#pragma once
#include <algorithm>
#include <charconv>
#include <string>
#include <string_view>
#include <vector>

namespace fuzz {

struct CaseFile {
    std::string name;
    std::string bytes;
};

inline constexpr std::string_view kFileMark = "\n=== ";
inline constexpr std::size_t kMaxFiles = 12, kMaxFileBytes = 1U << 16U;

/// One piece of the input as a file; its name cannot leave the folder.
inline CaseFile caseFileOf(std::string_view piece) {
    const std::size_t lineEnd = std::min(piece.find('\n'), piece.size());
    const std::string_view line = piece.substr(0, lineEnd);
    const std::size_t nameEnd = std::min(line.find(' '), line.size());
    CaseFile file{std::string(line.substr(0, std::min<std::size_t>(nameEnd, 60))),
                  std::string(piece.substr(std::min(lineEnd + 1, piece.size())))};
    std::ranges::replace_if(
        file.name, [](char c) { return c == '/' || c == '\0'; }, '_');
    if (file.name.empty() || file.name == "." || file.name == "..") file.name = "unnamed";
    std::size_t bytes = file.bytes.size();
    if (nameEnd < line.size()) {
        std::from_chars(line.data() + nameEnd + 1, line.data() + line.size(), bytes);
    }
    file.bytes.resize(std::min(bytes, kMaxFileBytes));
    return file;
}

inline std::vector<CaseFile> caseFiles(std::string_view input) {
    std::vector<CaseFile> files;
    std::size_t at = input.find(kFileMark);
    while (at != std::string_view::npos && files.size() < kMaxFiles) {
        const std::size_t from = at + kFileMark.size();
        at = input.find(kFileMark, from);
        files.push_back(
            caseFileOf(input.substr(from, at == std::string_view::npos ? at : at - from)));
    }
    return files;
}

}  // namespace fuzz

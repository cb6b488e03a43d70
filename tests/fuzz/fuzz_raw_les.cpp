// fuzz_raw_les.cpp: any folder, and each of its files, is read as raw model output or gives an
// Error.
#include "core/base/error.h"
#include "tests/fuzz/case_files.h"
#include "tests/fuzz/read_everything.h"
#include "tests/fuzz/scratch.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t count) {
    static const fuzz::Scratch scratch;
    const std::vector<fuzz::CaseFile> files = fuzz::caseFiles(fuzz::asText({bytes, count}));
    std::filesystem::create_directory(scratch.folder() / "case");
    std::vector<std::filesystem::path> paths{scratch.folder() / "case"};
    for (const fuzz::CaseFile& file : files) {
        paths.push_back(scratch.write("case/" + file.name, file.bytes));
    }
    for (const auto& path : paths) {
        try {
            fuzz::readEverything(path);
        } catch (const neph::Error&) {  // expected for invalid input
        }
    }
    std::filesystem::remove_all(paths.front());
    return 0;
}

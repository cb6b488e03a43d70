// reader_file.cpp: borrows a process of the reader for as long as the file is open.
#include "core/plugin/reader_file.h"

#include "core/base/error.h"

namespace neph {

ReaderFile::ReaderFile(std::shared_ptr<const ReaderPlugin> reader, std::filesystem::path path,
                       const Progress& progress)
    : reader_(std::move(reader)), path_(std::move(path)) {
    open(progress);
}

ReaderFile::~ReaderFile() {
    if (!process_->alive()) return;
    try {
        process_->close(handle_);
        reader_->giveBack(std::move(process_));
    } catch (const Error&) {  // its process failed while closing; nobody is left to report it to
    }
}

void ReaderFile::open(const Progress& progress) {
    process_ = reader_->borrow();
    ReaderProcess::Opened opened = process_->open(path_, progress, reader_->map);
    handle_ = opened.handle;
    description_ = std::move(opened.description);
}

std::vector<float> ReaderFile::read(std::size_t variable, std::size_t time, const CellBox& box,
                                    const Progress& progress) {
    if (!process_->alive()) open(progress);
    const std::string name = description_.variables.at(variable).name;
    return process_->read({handle_, variable, time, box}, path_, name, progress);
}

}  // namespace neph

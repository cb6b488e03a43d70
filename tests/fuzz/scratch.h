// scratch.h: a folder in memory for the files that a fuzz target writes from its input.
#pragma once
#include <unistd.h>

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <span>
#include <string>
#include <string_view>

namespace fuzz {

inline std::string_view asText(std::span<const std::uint8_t> bytes) {
    return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

class Scratch {
  public:
    Scratch() : folder_("/dev/shm/nephoscope-fuzz-" + std::to_string(getpid())) {
        std::filesystem::create_directories(folder_);
    }
    ~Scratch() {
        std::error_code none;
        std::filesystem::remove_all(folder_, none);
    }
    Scratch(const Scratch&) = delete;
    Scratch& operator=(const Scratch&) = delete;

    const std::filesystem::path& folder() const { return folder_; }
    std::filesystem::path write(const std::string& name, std::string_view bytes) const {
        std::filesystem::path file = folder_ / name;
        std::ofstream(file, std::ios::binary)
            .write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
        return file;
    }

  private:
    std::filesystem::path folder_;
};

}  // namespace fuzz

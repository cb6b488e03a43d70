// reader_process.h: a process that runs one reader library, and the requests to it.
//
// Whatever a library does to its process (crash, abort, hang, exhaust memory), the host gets an
// Error that names the reader and the file, and nothing that the library started stays behind. One
// ReaderProcess is used by one thread at a time.
#pragma once
#include <sys/types.h>

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <limits>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

#include "core/base/progress.h"
#include "core/plugin/dataset_info.h"
#include "core/plugin/reader_wire.h"

namespace neph {

/// Numbers of the descriptors that the process inherits.
inline constexpr int kReaderSocket = 3;
inline constexpr int kReaderMemory = 4;

/// Start of the shared memory. Values begin at kReaderValuesAt.
struct ReaderControl {
    std::uint32_t cancel = 0;  ///< set by the host; both sides use atomic_ref
    std::uint32_t beats = 0;   ///< counts the reader's progress reports
    double fraction = 0.0;     ///< fraction of the last report
};
inline constexpr std::size_t kReaderValuesAt = 4096;

/// Limits after which a reader process is ended.
struct ReaderLimits {
    /// Processor time while it opens or reads without reporting progress: readers report every few
    /// megabytes. Waiting for a slow disk does not count.
    double silentCpuSeconds = 5.0;
    /// Wall time for everything that reads no data: loading, scoring, closing.
    double answerSeconds = 30.0;
    /// Address space. Far above what reading a band or a chunk of any model output needs; a damaged
    /// header that asks for more gets "not enough memory".
    std::uint64_t memoryBytes = std::uint64_t{8} << 30U;
};

class ReaderProcess {
  public:
    /// Starts the process and makes it load `library`. Throws Error, with the reason in `what`, if
    /// that is not a reader.
    explicit ReaderProcess(const std::filesystem::path& library, const ReaderLimits& limits = {});
    ~ReaderProcess();
    ReaderProcess(const ReaderProcess&) = delete;
    ReaderProcess& operator=(const ReaderProcess&) = delete;

    const wire::Identity& identity() const { return identity_; }
    bool alive() const { return pid_ > 0 && !hasEnded(); }

    /// Score of a file, 0 to 100. Throws Error if the reader fails, or Cancelled.
    int score(const std::filesystem::path& file, const Progress& progress = {});

    struct Opened {
        std::uint32_t handle = 0;
        DatasetInfo description;
    };
    /// `map`: the file that says what the variables are, for a reader that takes one; or empty.
    /// Throws Error or Cancelled.
    Opened open(const std::filesystem::path& file, const Progress& progress,
                const std::filesystem::path& map = {});
    void close(std::uint32_t handle);

    /// The values of a box, x fastest; `file` and `variable` are named in messages. Throws Error or
    /// Cancelled.
    std::vector<float> read(const wire::ReadRequest& request, const std::filesystem::path& file,
                            std::string_view variable, const Progress& progress);

  private:
    struct Task {
        const std::filesystem::path& file;
        std::string doing;  ///< "opening it", "reading QCLOUD"
        double mostSeconds = std::numeric_limits<double>::infinity();
    };
    void start();
    int spawn(const std::string& program, int theirs);
    void growMemory(std::size_t bytes);
    void map(std::size_t bytes);
    /// Sends a request and waits for the answer, returned without its first byte if it is ok.
    std::string ask(std::string_view message, const Task& task, const Progress& progress);
    void endIfStuck(const Task& task, double silentCpuSeconds,
                    std::chrono::duration<double> waited);
    bool await(const Task& task, const Progress& progress);
    template <typename Unpack>
    std::invoke_result_t<Unpack, wire::Unpacker&> unpacked(std::string_view answer,
                                                           const Task& task, Unpack&& unpack);
    bool hasEnded() const;
    [[noreturn]] void endAndThrow(const Task& task, std::string reason);
    std::string end();

    std::filesystem::path library_;
    ReaderLimits limits_;
    wire::Identity identity_;
    pid_t pid_ = -1;
    int socket_ = -1;
    int memory_ = -1;
    std::byte* mapped_ = nullptr;
    std::size_t mappedBytes_ = 0;
};

}  // namespace neph

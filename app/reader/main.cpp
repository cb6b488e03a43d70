// main.cpp of nephoscope-reader: loads one reader library and serves the requests of the host.
//
// Started by core/plugin/reader_process with a socket and shared memory as descriptors 3 and 4. The
// arguments are the library and the memory, in bytes, that it may use. Ends with the host, even
// while the library hangs.
#include <fcntl.h>
#include <fmt/format.h>
#include <poll.h>
#include <sys/mman.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <unistd.h>

#include <atomic>
#include <csignal>
#include <cstdlib>
#include <map>
#include <optional>
#include <span>
#include <thread>

#include "core/base/error.h"
#include "core/plugin/plugin_file.h"
#include "core/plugin/plugin_library.h"
#include "core/plugin/reader_process.h"
#include "core/plugin/reader_wire.h"

namespace {

using namespace neph;

/// The memory shared with the host, mapped again when the host has enlarged it.
class SharedMemory {
  public:
    SharedMemory() { grow(kReaderValuesAt); }
    ReaderControl& control() { return *reinterpret_cast<ReaderControl*>(at_); }

    /// Space for `values` values and the guard values that detect writes beyond them.
    std::span<float> buffer(std::size_t values) {
        const std::size_t count = values + PluginFile::kGuardValues;
        grow(kReaderValuesAt + count * sizeof(float));
        return {reinterpret_cast<float*>(at_ + kReaderValuesAt), count};
    }

  private:
    /// Maps at least `bytes`. Throws Error if the host has not provided so much.
    void grow(std::size_t bytes) {
        if (bytes <= bytes_) return;
        struct stat now {};
        if (fstat(kReaderMemory, &now) != 0 || static_cast<std::size_t>(now.st_size) < bytes) {
            throw Error({.what = "the shared memory is smaller than requested"});
        }
        if (at_ != nullptr) munmap(at_, bytes_);
        at_ = nullptr;
        bytes_ = 0;
        void* mapped = mmap(nullptr, bytes, PROT_READ | PROT_WRITE, MAP_SHARED, kReaderMemory, 0);
        if (mapped == MAP_FAILED) throw Error({.what = "there is not enough memory to read it"});
        at_ = static_cast<std::byte*>(mapped);
        bytes_ = bytes;
    }
    std::byte* at_ = nullptr;
    std::size_t bytes_ = 0;
};

/// Executes requests with the library; see core/plugin/reader_wire.h for the messages.
class Server {
  public:
    explicit Server(PluginLibrary library) : library_(std::move(library)) {}

    /// Executes one request; failures become part of the answer.
    std::string respond(std::string_view request) {
        wire::Unpacker from(request);
        wire::Packer to;
        try {
            to.number(wire::Answer::ok);
            switch (from.number<wire::Ask>()) {
                case wire::Ask::score:
                    score(from, to);
                    break;
                case wire::Ask::open:
                    open(from, to);
                    break;
                case wire::Ask::read:
                    read(from);
                    break;
                case wire::Ask::close:
                    files_.erase(from.number<std::uint32_t>());
                    break;
            }
        } catch (const Error& error) {
            to = {};
            wire::pack(to.number(wire::Answer::failed), error.parts());
        } catch (const Cancelled&) {
            to = {};
            to.number(wire::Answer::cancelled);
        }
        return to.take();
    }

  private:
    void score(wire::Unpacker& from, wire::Packer& to) {
        std::int32_t score = 0;
        try {
            score = library_.calls->score(from.text().c_str());
        } catch (...) {  // the ABI forbids exceptions: treat the file as unknown to this reader
        }
        to.number(score);
    }

    void open(wire::Unpacker& from, wire::Packer& to) {
        const std::uint32_t handle = ++lastHandle_;
        const std::string path = from.text(), map = from.text();
        if (!map.empty() && !library_.identity.takesMap) {
            throw Error({.where = path, .what = "its reader takes no map"});
        }
        const auto& file =
            files_.try_emplace(handle, *library_.calls, library_.identity.id, path, map)
                .first->second;
        to.number(handle);
        wire::pack(to, file.description());
    }

    void read(wire::Unpacker& from) {
        const auto request = from.number<wire::ReadRequest>();
        const std::span<float> buffer = shared_.buffer(from.number<std::uint64_t>());
        ReaderControl& control = shared_.control();
        // Every call proves that the library is alive, and returns whether to go on.
        const auto tick = [&control](double fraction) {
            std::atomic_ref(control.fraction).store(fraction);
            std::atomic_ref(control.beats).fetch_add(1);
            return std::atomic_ref(control.cancel).load() == 0;
        };
        files_.at(request.handle).read(request.variable, request.time, request.box, buffer, tick);
    }

    PluginLibrary library_;
    SharedMemory shared_;
    std::map<std::uint32_t, PluginFile> files_;
    std::uint32_t lastHandle_ = 0;
};

/// HDF5 locks each file that it opens, so that the model which writes it could not open it again.
/// The library looks at this when it is loaded.
void lockNoFiles() {
    setenv("HDF5_USE_FILE_LOCKING", "FALSE", 1);
}

/// Applies the memory limit, disables core dumps, and allows as many open files as the system does:
/// a domain may be stored in one file for each MPI rank.
void limitResources([[maybe_unused]] rlim_t memoryBytes) {
    rlimit files{};
    if (getrlimit(RLIMIT_NOFILE, &files) == 0) {
        files.rlim_cur = files.rlim_max;
        setrlimit(RLIMIT_NOFILE, &files);
    }
    const rlimit none{0, 0};
    setrlimit(RLIMIT_CORE, &none);  // damaged files must not fill the disk with core dumps
#ifndef NEPH_SANITIZED
    const rlimit memory{memoryBytes, memoryBytes};
    setrlimit(RLIMIT_AS, &memory);  // sanitizers map terabytes that they never touch
#endif
}

/// Starts a thread that ends this process and its children when the host has ended, whatever the
/// library is doing.
void watchHost() {
    std::thread([] {
        pollfd host{kReaderSocket, POLLRDHUP, 0};
        while (poll(&host, 1, -1) <= 0) {
        }
        if (getpgrp() == getpid()) kill(0, SIGKILL);
        _exit(0);
    }).detach();
}

/// Loads the library and reports to the host what it is, or why it cannot be used.
std::optional<Server> sendIdentity(const char* library) {
    wire::Packer hello;
    std::optional<Server> server;
    try {
        PluginLibrary loaded = loadPlugin(library);
        wire::pack(hello.number(wire::Answer::ok), loaded.identity);
        server.emplace(std::move(loaded));
    } catch (const Error& error) {
        wire::pack(hello.number(wire::Answer::failed), error.parts());
    }
    wire::send(kReaderSocket, hello.take());
    return server;
}

}  // namespace

int main(int count, char** arguments) {
    if (count != 3 || fcntl(kReaderSocket, F_GETFD) < 0 || fcntl(kReaderMemory, F_GETFD) < 0) {
        fmt::print(stderr,
                   "nephoscope-reader is started by nephoscope and cannot be used on its own\n");
        return 2;
    }
    lockNoFiles();
    limitResources(std::strtoull(arguments[2], nullptr, 10));
    watchHost();
    std::optional<Server> server = sendIdentity(arguments[1]);
    std::string request;
    while (server && wire::receive(kReaderSocket, request)) {
        if (!wire::send(kReaderSocket, server->respond(request))) break;
    }
    return 0;
}

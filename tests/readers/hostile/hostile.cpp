// hostile.cpp: a reader that violates the ABI as its file asks: "HOSTILE <call> <action>".
//
// A call is one of the ABI, or loading the library (`constructor`, `entry`), for which the two
// words are in NEPH_HOSTILE_LOAD. The calls `describe` and `read` also accept the lies of
// hostile_lies.cpp. "HOSTILE good -" reads correctly: 4 x 4 x 4 cells, where q of cell i is i.
#include "tests/readers/hostile/hostile.h"

#include <fcntl.h>
#include <unistd.h>

#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <functional>
#include <map>
#include <stdexcept>
#include <vector>

namespace hostile {
namespace {

[[noreturn]] void spin() {
    for (volatile unsigned turns = 0;;) turns = turns + 1;
}

/// Allocates memory, and writes to it, until there is none left.
void exhaustMemory() {
    std::vector<std::vector<char>> blocks;
    for (;;) blocks.emplace_back(std::size_t{16} << 20U, 'x');
}

/// Starts a process that keeps every descriptor open, and crashes.
void leaveChild() {
    if (fork() == 0) {
        for (;;) pause();
    }
    std::abort();
}

/// Writes to the socket of the reader process.
void sendUnrequestedMessage() {
    const char noise[] = "\5\0\0\0\0\0\0\0noise";
    if (write(3, noise, sizeof noise - 1) < 0) std::abort();
}

const std::map<std::string, std::function<void()>> kActions{
    {"throw", [] { throw std::runtime_error("boo"); }},
    {"throwInt", [] { throw 1; }},
    {"abort", [] { std::abort(); }},
    {"segfault", [] { *static_cast<volatile int*>(nullptr) = 1; }},
    {"exit", [] { std::exit(0); }},
    {"spin", [] { spin(); }},
    {"sleep",
     [] {
         for (;;) pause();
     }},
    {"eat", [] { exhaustMemory(); }},
    {"fork", [] { leaveChild(); }},
    {"close",
     [] {
         close(3);
         close(4);
     }},
    {"truncate", [] { static_cast<void>(ftruncate(4, 0)); }},
    {"noise", [] { sendUnrequestedMessage(); }},
    {"print",
     [] {
         std::puts("hostile was here");
         std::fflush(stdout);
     }},
};

}  // namespace

std::string Instruction::actionIn(const char* where) const {
    return call == where ? action : "";
}

void Instruction::runIn(const char* where) const {
    if (call != where) return;
    const auto found = kActions.find(action);
    if (found != kActions.end()) found->second();
}

Instruction readInstruction(const char* path) {
    std::ifstream in(path);
    std::string magic;
    Instruction instruction;
    in >> magic >> instruction.call >> instruction.action;
    return magic == "HOSTILE" ? instruction : Instruction{};
}

Instruction loadInstruction() {
    Instruction instruction;
    const char* text = std::getenv("NEPH_HOSTILE_LOAD");
    const std::string both = text != nullptr ? text : "good -";
    instruction.call = both.substr(0, both.find(' '));
    instruction.action = both.substr(both.find(' ') + 1);
    return instruction;
}

}  // namespace hostile

struct NephFile {
    hostile::Instruction instruction;
    hostile::FalseDescription description;
    int described = 0;  ///< how often it was asked for its description
};

namespace {

using namespace hostile;

struct Constructor {
    Constructor() { loadInstruction().runIn("constructor"); }
} const constructor;

std::int32_t score(const char* path) {
    const Instruction instruction = readInstruction(path);
    instruction.runIn("score");
    if (instruction.actionIn("score") == "huge") return 2'000'000'000;
    return instruction.call.empty() ? 0 : 100;
}

NephStatus open(const char* path, NephFile** file, NephError* error) {
    const Instruction instruction = readInstruction(path);
    instruction.runIn("open");
    const std::string lie = instruction.actionIn("open");
    if (lie == "noHandle") return NEPH_OK;
    if (lie == "endless") {
        std::memset(error->what, 'x', sizeof *error - offsetof(NephError, what));
        return NEPH_FAILED;
    }
    *file = new NephFile{instruction, {}, 0};
    return lie == "badStatus" ? 77 : NEPH_OK;
}

const NephDescription* describe(NephFile* file) {
    file->instruction.runIn("describe");
    if (file->instruction.actionIn("describe") == "null") return nullptr;
    return file->description.describe(file->instruction.actionIn("describe"), ++file->described);
}

NephStatus read(NephFile* file, NephReadRequest* request, NephError*) {
    file->instruction.runIn("read");
    return hostile::read(file->instruction.actionIn("read"), *request);
}

void close(NephFile* file) {
    file->instruction.runIn("close");
    delete file;
}

}  // namespace

extern "C" NEPH_READER_EXPORT const NephReader* nephReader(std::uint32_t) {
    static NephReader reader{{NEPH_READER_ABI_VERSION, sizeof(NephReader)},
                             "hostile",
                             "1",
                             "files that ask for trouble",
                             "",
                             &score,
                             &open,
                             &describe,
                             &read,
                             &close,
                             nullptr};
    const Instruction instruction = loadInstruction();
    instruction.runIn("entry");
    const std::string lie = instruction.actionIn("entry");
    if (lie == "null") return nullptr;
    if (lie == "abi") reader.header.abi_version = 99;
    if (lie == "small") reader.header.struct_size = 16;
    if (lie == "noId") reader.id = nullptr;
    if (lie == "endlessId") reader.id = unterminatedText();
    if (lie == "noRead") reader.read = nullptr;
    if (lie == "nowhere") return reinterpret_cast<const NephReader*>(std::uintptr_t{8});
    return &reader;
}

// hostile.cpp: a reader that breaks its promises as its file asks: "HOSTILE <stage> <deed>".
//
// Stages are the calls of the ABI, and being loaded, where NEPH_HOSTILE_LOAD holds the two words.
// The stages `describe` and `read` know lies too, see hostile_lies.h. "HOSTILE good -" is read
// well: a grid of 4 x 4 x 4 cells, where q in cell i is i.
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

/// Takes memory, and touches it, until there is no more.
void eat() {
    std::vector<std::vector<char>> eaten;
    for (;;) eaten.emplace_back(std::size_t{16} << 20U, 'x');
}

/// Leaves a process behind that holds every descriptor open, and crashes.
void leaveChild() {
    if (fork() == 0) {
        for (;;) pause();
    }
    std::abort();
}

void talkOutOfTurn() {
    const char noise[] = "\5\0\0\0\0\0\0\0noise";
    if (write(3, noise, sizeof noise - 1) < 0) std::abort();
}

const std::map<std::string, std::function<void()>> kDeeds{
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
    {"eat", [] { eat(); }},
    {"fork", [] { leaveChild(); }},
    {"close",
     [] {
         close(3);
         close(4);
     }},
    {"truncate", [] { static_cast<void>(ftruncate(4, 0)); }},
    {"noise", [] { talkOutOfTurn(); }},
    {"print",
     [] {
         std::puts("hostile was here");
         std::fflush(stdout);
     }},
};

}  // namespace

std::string Words::lieAt(const char* where) const {
    return stage == where ? deed : "";
}

void Words::actAt(const char* where) const {
    if (stage != where) return;
    const auto found = kDeeds.find(deed);
    if (found != kDeeds.end()) found->second();
}

Words wordsOf(const char* path) {
    std::ifstream in(path);
    std::string magic;
    Words words;
    in >> magic >> words.stage >> words.deed;
    return magic == "HOSTILE" ? words : Words{};
}

Words loadWords() {
    Words words;
    const char* text = std::getenv("NEPH_HOSTILE_LOAD");
    const std::string both = text != nullptr ? text : "good -";
    words.stage = both.substr(0, both.find(' '));
    words.deed = both.substr(both.find(' ') + 1);
    return words;
}

}  // namespace hostile

struct NephFile {
    hostile::Words words;
    hostile::Lies lies;
    int described = 0;
};

namespace {

using namespace hostile;

struct Constructor {
    Constructor() { loadWords().actAt("constructor"); }
} const constructor;

std::int32_t score(const char* path) {
    const Words words = wordsOf(path);
    words.actAt("score");
    if (words.lieAt("score") == "huge") return 2'000'000'000;
    return words.stage.empty() ? 0 : 100;
}

NephStatus open(const char* path, NephFile** file, NephError* error) {
    const Words words = wordsOf(path);
    words.actAt("open");
    const std::string lie = words.lieAt("open");
    if (lie == "noHandle") return NEPH_OK;
    if (lie == "endless") {
        std::memset(error->what, 'x', sizeof *error - offsetof(NephError, what));
        return NEPH_FAILED;
    }
    *file = new NephFile{words, {}, 0};
    return lie == "badStatus" ? 77 : NEPH_OK;
}

const NephDescription* describe(NephFile* file) {
    file->words.actAt("describe");
    if (file->words.lieAt("describe") == "null") return nullptr;
    return file->lies.describe(file->words.lieAt("describe"), ++file->described);
}

NephStatus read(NephFile* file, NephReadRequest* request, NephError*) {
    file->words.actAt("read");
    return hostile::read(file->words.lieAt("read"), *request);
}

void close(NephFile* file) {
    file->words.actAt("close");
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
                             &close};
    const Words words = loadWords();
    words.actAt("entry");
    const std::string lie = words.lieAt("entry");
    if (lie == "null") return nullptr;
    if (lie == "abi") reader.header.abi_version = 99;
    if (lie == "small") reader.header.struct_size = 16;
    if (lie == "noId") reader.id = nullptr;
    if (lie == "endlessId") reader.id = endlessText();
    if (lie == "noRead") reader.read = nullptr;
    if (lie == "nowhere") return reinterpret_cast<const NephReader*>(std::uintptr_t{8});
    return &reader;
}

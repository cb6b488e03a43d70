// child_process_test.cpp: programs of the shell, run beside the test.
#include <doctest/doctest.h>
#include <signal.h>
#include <sys/stat.h>
#include <unistd.h>

#include <chrono>
#include <filesystem>
#include <fstream>
#include <memory>
#include <string>
#include <thread>

#include "core/base/child_process.h"
#include "core/base/error.h"
#include "tests/environment.h"
#include "tests/temporary_folder.h"
#include "tests/text.h"

using namespace neph;

namespace {

ChildProcess::Options givenInput() {
    return {.niceness = 0, .takesInput = true};
}

std::vector<std::string> script(const std::string& text) {
    return {"-c", text};
}

std::span<const std::byte> bytesOf(const std::string& text) {
    return std::as_bytes(std::span(text));
}

}  // namespace

TEST_CASE("A program's lines come whole and in order, its last words and status are kept") {
    ChildProcess child("/bin/sh", script("echo one; echo two; echo why >&2; printf half; exit 3"),
                       {});
    CHECK(child.wait() == 3);
    CHECK(child.takeLines() == std::vector<std::string>{"one", "two"});
    CHECK(child.lastWords() == "why");
    CHECK(child.takeLines().empty());
    CHECK(child.status() == 3);
}

TEST_CASE("Arguments reach a program as they are, whatever is in them") {
    ChildProcess child("/bin/echo", {"a b", "$HOME", "*", "'"}, {});
    CHECK(child.wait() == 0);
    CHECK(child.takeLines() == std::vector<std::string>{"a b $HOME * '"});
}

TEST_CASE("More than a pipe holds is taken on both outputs, and of the errors the end is kept") {
    ChildProcess child("/bin/sh",
                       script("i=0; while [ $i -lt 20000 ]; do echo out$i; echo err$i >&2; "
                              "i=$((i+1)); done"),
                       {});
    CHECK(child.wait() == 0);
    const auto lines = child.takeLines();
    REQUIRE(lines.size() == 20000);
    CHECK(lines.back() == "out19999");
    CHECK(child.lastWords().size() <= 4096);
    CHECK(child.lastWords().ends_with("err19999"));
}

TEST_CASE("A cancelled program may tidy up; one that does not heed it is ended") {
    SUBCASE("heeding") {
        ChildProcess child(
            "/bin/sh",
            script("trap 'echo tidied; exit 143' TERM; echo up; while :; do sleep 0.01; done"), {});
        while (child.takeLines().empty()) child.poll();
        child.cancel();
        CHECK(child.wait() == 143);
        CHECK(child.takeLines() == std::vector<std::string>{"tidied"});
    }
    SUBCASE("not asked") {
        ChildProcess child("/bin/sh", script("trap '' TERM; echo up; exec sleep 600"), {});
        while (child.takeLines().empty()) child.poll();
        child.end();
        CHECK(child.status() == 128 + SIGKILL);
    }
    SUBCASE("not heeding") {
        ChildProcess child("/bin/sh", script("trap '' TERM; echo up; while :; do sleep 0.01; done"),
                           {});
        while (child.takeLines().empty()) child.poll();
        child.cancel();
        CHECK(child.wait() == 128 + SIGKILL);
    }
}

TEST_CASE("A program ends with what started it, and leaves nothing over") {
    pid_t pid = 0;
    {
        ChildProcess child("/bin/sh", script("echo $$; sleep 600"), {});
        std::vector<std::string> lines;
        while (lines.empty()) {
            child.poll();
            lines = child.takeLines();
        }
        pid = static_cast<pid_t>(std::stol(lines.front()));
        CHECK(kill(pid, 0) == 0);
    }
    CHECK(kill(pid, 0) == -1);
}

TEST_CASE("A program ends with the thread that started it") {
    const TemporaryFolder folder;
    std::unique_ptr<ChildProcess> child;
    std::thread starter([&] {
        child = std::make_unique<ChildProcess>("/bin/sleep", std::vector<std::string>{"600"},
                                               ChildProcess::Options{});
    });
    starter.join();
    CHECK(child->wait() == 128 + SIGTERM);
}

TEST_CASE(
    "A program that was let go ends by itself, whatever it has to say, and its file goes then") {
    const TemporaryFolder folder;
    const auto held = folder / "held by \"it\" $HOME", done = folder / "done";
    std::ofstream(held) << "x";
    const auto waitFor = [](const auto& condition) {
        for (int i = 0; i < 5000 && !condition(); ++i) {
            std::this_thread::sleep_for(std::chrono::milliseconds(2));
        }
        return condition();
    };
    REQUIRE(mkfifo((folder / "go").c_str(), 0600) == 0);
    std::thread starter([&] {
        // More than pipes hold, on both; without a reader the first of them would stop it.
        const std::string talk = "dd if=/dev/zero bs=1024 count=200 2>/dev/null";
        ChildProcess child("/bin/sh",
                           script("trap '' PIPE; set -e; read x < " + (folder / "go").string() +
                                  "; " + talk + "; " + talk + " >&2; touch " + done.string()),
                           {.mayOutlive = true});
        child.poll();
        child.letGo(held);
        CHECK_FALSE(child.poll());
    });
    starter.join();  // neither the object nor its thread are there any more
    std::this_thread::sleep_for(std::chrono::milliseconds(50));
    CHECK(std::filesystem::exists(held));
    std::ofstream(folder / "go") << "now\n";
    CHECK(waitFor([&] { return std::filesystem::exists(done); }));
    CHECK(waitFor([&] { return !std::filesystem::exists(held); }));
}

TEST_CASE("Input is given whole, and one who no longer reads is no crash") {
    SUBCASE("counted") {
        ChildProcess child("/bin/sh", script("wc -c"), givenInput());
        const std::string much(300000, 'x');
        for (int i = 0; i < 4; ++i) CHECK(child.write(bytesOf(much)));
        child.closeInput();
        CHECK(child.wait() == 0);
        const auto lines = child.takeLines();
        REQUIRE(lines.size() == 1);
        CHECK(std::stol(lines.front()) == 1200000);
    }
    SUBCASE("gone") {
        ChildProcess child("/bin/sh", script("exit 5"), givenInput());
        const std::string much(1 << 20, 'x');
        CHECK_FALSE(child.write(bytesOf(much)));
        CHECK(child.wait() == 5);
    }
    SUBCASE("none") {
        ChildProcess child("/bin/cat", {}, {});
        CHECK(child.wait() == 0);
    }
}

TEST_CASE("Niceness is added to our own") {
    ChildProcess child("/bin/sh", script("cut -d' ' -f19 /proc/self/stat"),
                       {.niceness = 5, .takesInput = false});
    ChildProcess plain("/bin/sh", script("cut -d' ' -f19 /proc/self/stat"), {});
    CHECK(child.wait() == 0);
    CHECK(plain.wait() == 0);
    const int own = std::stoi(plain.takeLines().at(0));
    CHECK(std::stoi(child.takeLines().at(0)) == std::min(own + 5, 19));
}

TEST_CASE("What cannot be started says so at once") {
    const TemporaryFolder folder;
    try {
        ChildProcess child(folder / "missing", {}, {});
        FAIL("started");
    } catch (const Error& error) {
        CHECK(contains(error.message(), "missing"));
        CHECK(contains(error.message(), "No such file"));
    }
}

TEST_CASE("A program is found on the path, in its order, when it may be run") {
    const TemporaryFolder folder;
    const Environment path("PATH", folder.path().string() + ":/bin");
    CHECK(findProgram("sh") == std::filesystem::path("/bin/sh"));
    CHECK_FALSE(findProgram("no-such-program"));
    std::filesystem::copy_file("/bin/sh", folder / "sh");
    CHECK(findProgram("sh") == folder / "sh");
    std::filesystem::permissions(folder / "sh", std::filesystem::perms::owner_read);
    if (geteuid() != 0) CHECK(findProgram("sh") == std::filesystem::path("/bin/sh"));
}

// file_browser_test.cpp: lines, lists and choices without a window, and keys that come early.
#include "app/ui/widgets/file_browser.h"

#include <doctest/doctest.h>
#include <imgui.h>

#include <fstream>

#include "app/ui/shell/frame.h"
#include "core/session/session_file.h"
#include "tests/temporary_folder.h"
#include "tests/text.h"
#include "tests/ui/headless.h"

using namespace neph;
using ui::BrowseFor;

namespace {

namespace fs = std::filesystem;

/// A folder "run" with three files of a series, a note and a folder.
struct Tree {
    Tree() {
        fs::create_directories(folder / "run/deeper");
        for (const char* name : {"wrfout_b", "wrfout_a", "wrfout_c"}) {
            std::ofstream(folder / "run" / name) << "CDF\1 and more";
        }
        std::ofstream(folder / "run/Notes.txt") << "text";
        std::ofstream(folder / "run/.hidden") << "text";
        begin(browser, BrowseFor::data, folder / "run");
    }
    std::vector<std::string> shown() const {
        std::vector<std::string> names;
        for (const int i : shownEntries(browser)) {
            names.push_back(browser.entries[static_cast<std::size_t>(i)].name);
        }
        return names;
    }
    void type(const std::string& line) {
        browser.line = line;
        browser.narrows = true;
        browser.chosen.clear();
        refresh(browser);
    }
    std::string at(const std::string& name) const { return folder / "run" / name; }

    struct Place : TemporaryFolder {
        fs::path operator/(const std::string& name) const { return path() / name; }
    } folder;
    ui::FileBrowser browser;
};

using Names = std::vector<std::string>;

}  // namespace

TEST_CASE("A folder is listed with its folders first, and narrowed by what is typed") {
    Tree tree;
    CHECK(tree.shown() == Names{"deeper", "Notes.txt", "wrfout_a", "wrfout_b", "wrfout_c"});
    tree.type(tree.at("OUT_"));
    CHECK(tree.shown() == Names{"wrfout_a", "wrfout_b", "wrfout_c"});
    tree.type(tree.at("nothing"));
    CHECK(tree.shown().empty());
    tree.type(tree.at("deeper/"));
    CHECK(tree.browser.folder == tree.folder / "run/deeper/");
    tree.type(tree.at("no such folder/x"));
    CHECK(tree.browser.folder == tree.folder / "run/deeper/");
    goUp(tree.browser);
    goUp(tree.browser);
    CHECK(tree.shown() == Names{"run"});
}

TEST_CASE("A line is completed as far as the names agree") {
    Tree tree;
    tree.type(tree.at("wr"));
    CHECK(completed(tree.browser) == tree.at("wrfout_"));
    tree.type(tree.at("dee"));
    CHECK(completed(tree.browser) == tree.at("deeper/"));
    tree.type(tree.at("x"));
    CHECK(completed(tree.browser) == tree.at("x"));
}

TEST_CASE("A path typed behind another takes its place") {
    CHECK(ui::laterPath("/data/run/wrfout") == 0);
    CHECK(ui::laterPath("/data/run//home/me") == 10);
    CHECK(ui::laterPath("/data/run/~/x") == 10);
}

TEST_CASE("Only what a reader could take is held out, by content or by the reader's word") {
    Tree tree;
    tree.browser.extensions = {"txt"};
    const auto good = [&](const std::string& name) {
        for (ui::FileEntry& entry : tree.browser.entries) {
            if (entry.name == name) return ui::fits(tree.browser, entry);
        }
        return false;
    };
    CHECK(good("wrfout_a"));
    CHECK(good("Notes.txt"));
    CHECK(good("deeper"));
    tree.browser.extensions.clear();
    begin(tree.browser, BrowseFor::data, {});
    CHECK_FALSE(good("Notes.txt"));
    begin(tree.browser, BrowseFor::session, {});
    CHECK_FALSE(good("wrfout_a"));
}

TEST_CASE("Files are chosen one by one, in ranges, and opened together") {
    Tree tree;
    choose(tree.browser, 2, false, false);
    CHECK(accept(tree.browser) == Names{tree.at("wrfout_a")});
    choose(tree.browser, 4, true, false);
    CHECK(accept(tree.browser) == Names{tree.at("wrfout_a"), tree.at("wrfout_c")});
    choose(tree.browser, 2, true, false);
    choose(tree.browser, 3, false, false);
    choose(tree.browser, 4, false, true);
    CHECK(tree.browser.chosen == std::set<std::string>{"wrfout_b", "wrfout_c"});
}

TEST_CASE("A folder is gone into first and opened as a series when asked again") {
    Tree tree;
    tree.type(tree.folder.path().string() + "/run");
    CHECK_FALSE(accept(tree.browser).has_value());
    CHECK(tree.browser.line == tree.at(""));
    CHECK(accept(tree.browser) == Names{tree.at("")});
    begin(tree.browser, BrowseFor::session, {});
    CHECK_FALSE(accept(tree.browser).has_value());
}

TEST_CASE("What is not there is told with the nearest name, and a sample needs no path") {
    Tree tree;
    tree.type(tree.at("wrfout_d"));
    CHECK_FALSE(accept(tree.browser).has_value());
    CHECK(contains(tree.browser.fault, "wrfout_"));
    tree.type("cumulus");
    CHECK(accept(tree.browser) == Names{"cumulus"});
}

TEST_CASE("An address that is typed or pasted behind a path is told from a path") {
    Tree tree;
    tree.type("https://a.org/wrfout_d01");
    CHECK(ui::laterPath(tree.browser.line) == 0);
    CHECK_FALSE(accept(tree.browser).has_value());
    CHECK(contains(tree.browser.fault, "curl -fLO https://a.org/wrfout_d01"));
    CHECK(ui::laterPath("/home/me/https://a.org/x") == 9);
    CHECK(ui::laterPath("/home/me//data/x") == 9);
}

TEST_CASE("A file that is there is replaced when asked twice, and gets the ending of sessions") {
    Tree tree;
    begin(tree.browser, BrowseFor::saveSession, {});
    tree.type(tree.at("mine"));
    CHECK(accept(tree.browser) == Names{tree.at("mine.nephoscope.json")});
    tree.type(tree.at("Notes.txt"));
    CHECK_FALSE(accept(tree.browser).has_value());
    CHECK(tree.browser.replaces);
    CHECK(accept(tree.browser) == Names{tree.at("Notes.txt")});
    tree.type(tree.at("missing/mine"));
    CHECK_FALSE(accept(tree.browser).has_value());
    CHECK(contains(tree.browser.fault, "no folder"));
}

TEST_CASE("No key that is typed after Ctrl+O is lost, however slow the frames are") {
    const std::string wanted = "/dev/null";
    for (const std::size_t perFrame : {1U, 2U, 3U, 9U}) {
        CAPTURE(perFrame);
        Headless gui;
        Session session(noReaders());
        ui::Ui state(session);
        ui::browse(state.settings, state.sessionDialogs, BrowseFor::data);
        for (std::size_t i = 0; i < wanted.size() + 4 * perFrame; i += perFrame) {
            if (i < wanted.size()) {
                ImGui::GetIO().AddInputCharactersUTF8(wanted.substr(i, perFrame).c_str());
            }
            gui.frame([&] { ui::draw(state); });
        }
        CHECK(state.sessionDialogs.browser.line == wanted);
    }
}

TEST_CASE("The name of a session that is saved is replaced by typing; its folder and ending stay") {
    const TemporaryFolder folder;
    const std::string wanted = "anvil";
    for (const std::size_t perFrame : {1U, 2U, 9U}) {
        CAPTURE(perFrame);
        Headless gui;
        Session session(noReaders());
        ui::Ui state(session);
        ui::FileBrowser& browser = state.sessionDialogs.browser;
        browser.folder = folder.path();
        ui::browse(state.settings, state.sessionDialogs, BrowseFor::saveSession);
        const std::string before = folder.path().string() + "/";
        CHECK(browser.line == before + "session.nephoscope.json");
        for (std::size_t i = 0; i < wanted.size() + 4 * perFrame; i += perFrame) {
            if (i < wanted.size()) {
                ImGui::GetIO().AddInputCharactersUTF8(wanted.substr(i, perFrame).c_str());
            }
            gui.frame([&] { ui::draw(state); });
        }
        CHECK(browser.line == before + "anvil.nephoscope.json");
    }
    SUBCASE("also when the keyboard is there first") {
        Headless gui;
        Session session(noReaders());
        ui::Ui state(session);
        ui::FileBrowser& browser = state.sessionDialogs.browser;
        browser.folder = folder.path();
        ui::browse(state.settings, state.sessionDialogs, BrowseFor::saveSession);
        for (int i = 0; i < 6; ++i) gui.frame([&] { ui::draw(state); });
        for (const char letter : wanted) {
            ImGui::GetIO().AddInputCharacter(static_cast<unsigned>(letter));
            gui.frame([&] { ui::draw(state); });
        }
        CHECK(browser.line == folder.path().string() + "/anvil.nephoscope.json");
    }
}

TEST_CASE("What names the file ends before a session's ending, and behind all else") {
    ui::FileBrowser browser;
    const auto partOf = [&](BrowseFor purpose, const std::string& line) {
        browser.purpose = purpose;
        browser.line = line;
        const ui::NamePart part = ui::namePart(browser);
        return line.substr(part.from, part.to - part.from);
    };
    CHECK(partOf(BrowseFor::saveSession, "/a/storm.nephoscope.json") == "storm");
    CHECK(partOf(BrowseFor::saveSession, "/a/storm.json") == "storm.json");
    CHECK(partOf(BrowseFor::saveSession, "/a/").empty());
    CHECK(partOf(BrowseFor::session, "/a/storm.nephoscope.json") == "storm.nephoscope.json");
}

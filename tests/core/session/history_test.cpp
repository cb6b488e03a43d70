// history_test.cpp: steps of undo and redo, and their labels.
#include "core/session/history.h"

#include <doctest/doctest.h>

using namespace neph;

TEST_CASE("A drag of many changes and one commit is one step") {
    Document document;
    History history(document);
    for (const float scale : {0.9f, 0.7f, 0.5f})
        document.look.of(Species::cloud).mixingScale = scale;
    history.commit(document);
    CHECK(history.undoLabel() == "Cloud: Mixing scale 1 -> 0.5");
    CHECK(history.undo(document));
    CHECK(document == Document{});
    CHECK_FALSE(history.canUndo());
}

TEST_CASE("Redo goes where undo came from, and a new change forgets it") {
    Document document;
    History history(document);
    document.time = 2;
    history.commit(document);
    document.look.exposureEv = 1.0f;
    history.commit(document);
    const Document last = document;
    CHECK(history.undo(document));
    CHECK(document.look.exposureEv == Look{}.exposureEv);
    CHECK(document.time == 2);
    CHECK(history.redo(document));
    CHECK(document == last);
    CHECK_FALSE(history.redo(document));
    CHECK(history.undo(document));
    document.look.exposureEv = -1.0f;
    history.commit(document);
    CHECK_FALSE(history.canRedo());
}

TEST_CASE("A commit without a change makes no step") {
    Document document;
    History history(document);
    history.commit(document);
    CHECK_FALSE(history.canUndo());
}

TEST_CASE("Undo takes back what has not been committed yet") {
    Document document;
    History history(document);
    document.camera.distance = 0.4f;
    CHECK(history.undo(document));
    CHECK(document == Document{});
    CHECK(history.redoLabel() == "Camera");
}

TEST_CASE("Undoing every step of a long walk leads back to its start") {
    Document document;
    History history(document);
    for (int i = 1; i <= 300; ++i) {
        document.look.sunAzimuthDeg = static_cast<float>(i);
        history.commit(document);
    }
    while (history.undo(document)) {
    }
    CHECK(document == Document{});
    while (history.redo(document)) {
    }
    CHECK(document.look.sunAzimuthDeg == 300.0f);
}

TEST_CASE("Labels speak as the panels do: units on screen, words for choices") {
    const Document before;
    Document after;
    after.look.of(Species::rain).effectiveRadiusM = 5e-4f;
    CHECK(describeChange(before, after) == "Rain: Effective radius 1000 µm -> 500 µm");
    after = {};
    after.look.transport = Transport::lowAlbedo;
    CHECK(describeChange(before, after) == "Light: Transport Full -> Low albedo");
    after = {};
    after.sampling.targetError = 0.01f;
    CHECK(describeChange(before, after) == "Sampling: Target error 2 % -> 1 %");
    after = {};
    after.look.groundVisible = false;
    CHECK(describeChange(before, after) == "Sun and sky: Ground on -> off");
    after.time = 1;
    after.camera.fovDeg = 50.0f;
    CHECK(describeChange(before, after) == "Sun and sky: Ground on -> off, time 1 -> 2, camera");
    CHECK(describeChange(before, before).empty());
}

TEST_CASE("A change of several parameters names what they share") {
    const Document before;
    Document after;
    after.look.of(Species::cloud).mixingScale = after.look.of(Species::rain).mixingScale = 0.5f;
    CHECK(describeChange(before, after) == "Cloud, Rain: Mixing scale 1 -> 0.5");
    after.look.of(Species::rain).mixingScale = 0.25f;
    CHECK(describeChange(before, after) == "Cloud, Rain: Mixing scale");
    after = {};
    after.look.of(Species::snow).albedo = 0.5f;
    after.look.of(Species::snow).noiseAmount = 0.1f;
    CHECK(describeChange(before, after) == "Snow: 2 parameters");
    after.look.exposureEv = 3.0f;
    CHECK(describeChange(before, after) == "3 parameters");
}

TEST_CASE("Steps of time, bookmarks and keys of the path are told as what they are") {
    Document before, after;
    after.time = 4;
    CHECK(describeChange(before, after) == "Time 1 -> 5");
    after.camera.fovDeg = 50.0f;
    CHECK(describeChange(before, after) == "Time 1 -> 5, camera");
    after = before;
    after.bookmarks.push_back({"Anvil", {}});
    CHECK(describeChange(before, after) == "Bookmark \"Anvil\"");
    CHECK(describeChange(after, before) == "Bookmark \"Anvil\" removed");
    after = before;
    after.path.keys.resize(1);
    CHECK(describeChange(before, after) == "Camera path: key 1 added");
    CHECK(describeChange(after, before) == "Camera path removed");
}

TEST_CASE("A drag that rests with the button held is one step, two quick drags are two") {
    Document document;
    History history(document);
    const auto frame = [&](float scale, bool down, double restS) {
        document.look.of(Species::cloud).mixingScale = scale;
        history.settle(document, down, restS);
    };
    frame(1.0f, true, 0.0);
    frame(0.9f, true, 0.0);
    frame(0.9f, true, 5.0);
    frame(0.5f, true, 0.0);
    CHECK(history.steps().empty());
    frame(0.5f, false, 0.0);
    CHECK(history.steps() == std::vector<std::string>{"Cloud: Mixing scale 1 -> 0.5"});
    frame(0.4f, true, 0.0);
    frame(0.4f, false, 0.0);
    CHECK(history.steps().size() == 2);
}

TEST_CASE("Turns of the wheel are one step when they have come to rest") {
    Document document;
    History history(document);
    for (const double restS : {0.0, 0.2, 0.0, 0.3}) {
        document.camera.distance *= 0.9f;
        history.settle(document, false, restS);
    }
    CHECK(history.steps().empty());
    history.settle(document, false, 0.5);
    CHECK(history.steps() == std::vector<std::string>{"Camera"});
}

TEST_CASE("Any step of the list can be gone to, there and back") {
    Document document;
    History history(document);
    std::vector<Document> states{document};
    for (const float ev : {1.0f, 2.0f, 3.0f}) {
        document.look.exposureEv = ev;
        history.commit(document);
        states.push_back(document);
    }
    const std::vector<std::string> labels = history.steps();
    REQUIRE(labels.size() == 3);
    CHECK(labels[1] == "View: Exposure 1 EV -> 2 EV");
    for (const std::size_t to : {0u, 2u, 1u, 3u}) {
        CAPTURE(to);
        CHECK(history.jumpTo(document, to));
        CHECK((document == states[to]));
        CHECK(history.position() == to);
        CHECK(history.steps() == labels);
    }
    CHECK_FALSE(history.jumpTo(document, 3));
    CHECK_FALSE(history.jumpTo(document, 4));
    history.jumpTo(document, 1);
    document.look.exposureEv = -1.0f;  // not committed: a step of its own, and those after it go
    CHECK(history.jumpTo(document, 0));
    CHECK(history.steps().size() == 2);
    CHECK((document == states[0]));
}

TEST_CASE("Starting again forgets all steps") {
    Document document;
    History history(document);
    document.time = 1;
    history.commit(document);
    history.restart(document);
    CHECK_FALSE(history.undo(document));
    CHECK(document.time == 1);
}

TEST_CASE("Adapting changes every state that steps lead to and makes no step") {
    Document document;
    History history(document);
    document.time = 1;
    history.commit(document);
    document.time = 2;
    history.commit(document);
    const auto later = [](Document& state) { state.time += 10; };
    later(document);
    history.adapt(later);
    history.commit(document);
    CHECK(history.undo(document));
    CHECK(document.time == 11);
    CHECK(history.undo(document));
    CHECK(document.time == 10);
    CHECK_FALSE(history.undo(document));
}

// history_test.cpp: steps of undo and redo, and their labels.
#include "core/history.h"

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
    CHECK(describeChange(before, after) == "Modes: Light Translucent -> Low albedo");
    after = {};
    after.look.groundVisible = false;
    CHECK(describeChange(before, after) == "Sun and sky: Ground on -> off");
    after.time = 1;
    after.camera.fovDeg = 50.0f;
    CHECK(describeChange(before, after) == "3 changes");
    CHECK(describeChange(before, before).empty());
}

TEST_CASE("Starting anew forgets all steps") {
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

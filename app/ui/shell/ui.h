// ui.h: all that the panels edit and keep: the session, what the last frame was, what is asked of
// the window, and a struct of each room.
//
// Panels see core and ImGui, and leave room for the image, which the window draws itself. The
// shell alone knows this struct; a panel is given a PanelContext and the state of its room.
#pragma once
#include <cstddef>
#include <cstdint>

#include "app/ui/ask/ask_state.h"
#include "app/ui/camera/camera_tools.h"
#include "app/ui/compare/compare_errors.h"
#include "app/ui/compare/compare_state.h"
#include "app/ui/compare/error_map.h"
#include "app/ui/compare/preview_label.h"
#include "app/ui/data/data_panel.h"
#include "app/ui/data/ensemble_panel.h"
#include "app/ui/data/session_files.h"
#include "app/ui/fields/fields_state.h"
#include "app/ui/output/output_state.h"
#include "app/ui/panel/frame_report.h"
#include "app/ui/panel/panel_context.h"
#include "app/ui/presets/preset_state.h"
#include "app/ui/shell/palette_state.h"
#include "app/ui/time/playback.h"
#include "app/ui/widgets/profile.h"

namespace neph::ui {

struct Ui {
    Ui() = default;
    explicit Ui(Session& edited) : active(&edited) {}

    Session* active = nullptr;  ///< of the slot that panels edit; set before the first frame
    Session& session() const { return *active; }
    Layout layout() const { return layoutOf(session(), settings, columns); }

    Settings settings;  ///< remembered when they change
    Services services;
    FrameReport report;
    Profile profile;  ///< kept up to date while it is shown
    Requests requests;
    NextFrame next;
    Columns columns;

    PresetBrowser presets;
    CameraTools cameraTools;
    AskState ask;
    CompareState compare;
    CompareErrors errors;
    ErrorMeter errorMeter;
    PreviewMarks previews;
    DataEdits data;
    FieldsState fields;
    OutputState output;
    Playback playback;
    SessionDialogs sessionDialogs;
    EnsemblePanel ensemble;

    Palette palette;
    bool showHelp = false;
    bool showHistory = false;
    bool showMessages = false;
    bool showProfile = false;
    bool showEnsemble = false;
    bool hintsAtKeys = false;           ///< of a first run: until it is closed or one was used
    std::size_t historySeen = 0;        ///< position that the list was last scrolled to
    std::uint64_t dismissedSerial = 0;  ///< errors up to here were closed
};

}  // namespace neph::ui

// panel_rows.cpp: the rows of the table of panels.
#include <array>

#include "app/ui/ask/ask_panels.h"
#include "app/ui/ask/pointing.h"
#include "app/ui/camera/camera_overlays.h"
#include "app/ui/camera/camera_panel.h"
#include "app/ui/compare/compare.h"
#include "app/ui/compare/error_map.h"
#include "app/ui/compare/preview_label.h"
#include "app/ui/data/data_panel.h"
#include "app/ui/data/ensemble_panel.h"
#include "app/ui/data/path_popup.h"
#include "app/ui/data/session_dialogs.h"
#include "app/ui/fields/fields_panel.h"
#include "app/ui/fields/groups_panel.h"
#include "app/ui/output/output_panel.h"
#include "app/ui/presets/preset_browser.h"
#include "app/ui/presets/preset_dialogs.h"
#include "app/ui/shell/context.h"
#include "app/ui/shell/help_sheet.h"
#include "app/ui/shell/history_panel.h"
#include "app/ui/shell/menu_bar.h"
#include "app/ui/shell/notices.h"
#include "app/ui/shell/palette.h"
#include "app/ui/shell/panel_table.h"
#include "app/ui/shell/profile_overlay.h"
#include "app/ui/shell/status_line.h"
#include "app/ui/time/time_bar.h"

namespace neph::ui {
namespace {

const std::array kPanels{
    Panel{.id = "camera_overlays",
          .place = PanelPlace::image,
          .draw = [](Ui& ui) { drawCameraOverlays(contextOf(ui), ui.cameraTools); }},
    Panel{.id = "pointing",
          .place = PanelPlace::image,
          .draw = [](Ui& ui) { drawPointing(contextOf(ui), ui.ask); }},
    Panel{.id = "menu_bar", .place = PanelPlace::top, .draw = drawMenuBar},
    Panel{.id = "data",
          .place = PanelPlace::left,
          .draw = [](Ui& ui) { drawData(contextOf(ui), ui.data); }},
    Panel{.id = "fields",
          .place = PanelPlace::left,
          .draw = [](Ui& ui) { drawFields(contextOf(ui), ui.fields); }},
    Panel{.id = "find",
          .place = PanelPlace::right,
          .draw = [](Ui& ui) { drawFind(contextOf(ui), ui.fields); }},
    Panel{.id = "presets",
          .place = PanelPlace::right,
          .draw = [](Ui& ui) { drawPresets(contextOf(ui), ui.presets); }},
    Panel{.id = "camera",
          .place = PanelPlace::right,
          .draw = [](Ui& ui) { drawCamera(contextOf(ui), ui.cameraTools, ui.playback); }},
    Panel{.id = "groups",
          .place = PanelPlace::right,
          .draw = [](Ui& ui) { drawGroups(contextOf(ui)); }},
    Panel{.id = "time_bar",
          .place = PanelPlace::bottom,
          .draw = [](Ui& ui) { drawTimeBar(contextOf(ui), ui.playback); }},
    Panel{.id = "status_line",
          .place = PanelPlace::bottom,
          .draw = [](Ui& ui) { drawStatus(contextOf(ui), ui.report, ui.showMessages); }},
    Panel{.id = "error_map",
          .draw =
              [](Ui& ui) {
                  if (ui.compare.mode != CompareMode::single) return;
                  drawErrorMap(contextOf(ui), ui.errorMeter, ui.report);
              }},
    Panel{.id = "preview_labels",
          .draw =
              [](Ui& ui) {
                  // The colours of the error are in the place of both images.
                  if (ui.compare.mode == CompareMode::error && ui.errors.texture != 0) return;
                  drawPreviewLabels(contextOf(ui), ui.compare, ui.previews);
              }},
    Panel{.id = "compare",
          .draw = [](Ui& ui) { drawCompare(contextOf(ui), ui.compare, ui.errors); }},
    Panel{.id = "ask",
          .draw =
              [](Ui& ui) {
                  const PanelContext context = contextOf(ui);
                  AskState& ask = ui.ask;
                  if (ask.showColumn) drawColumnPanel(context, ask, ask.showColumn);
                  if (ask.showSection) drawSectionPanel(context, ask, ask.showSection);
                  if (ask.showPins) drawPinsPanel(context, ask, ask.showPins);
                  if (ask.showSeries) drawSeriesPanel(context, ask, ask.showSeries);
              }},
    Panel{.id = "profile",
          .draw = [](Ui& ui) { drawProfile(ui.layout().image, ui.profile); },
          .shown = &Ui::showProfile,
          .toggle = {.id = "view.profile",
                     .label = "Performance",
                     .menu = Menu::view,
                     .chord = {Key::f3},
                     .help = "Shows what the image cost, pass by pass"},
          .before = "view.full_screen",
          .toggled = [](Ui& ui) { ui.requests.redraw = ui.showProfile; }},
    Panel{.id = "notices",
          .draw =
              [](Ui& ui) {
                  drawNotices(contextOf(ui), ui.sessionDialogs, ui.dismissedSerial);
                  ui.hintsAtKeys &= !ui.showHelp && !ui.palette.open;
                  if (ui.hintsAtKeys)
                      drawKeyHint(contextOf(ui), ui.dismissedSerial, ui.hintsAtKeys);
              }},
    Panel{.id = "messages",
          .draw = [](Ui& ui) { drawMessages(contextOf(ui), ui.showMessages); },
          .shown = &Ui::showMessages,
          .toggle = {.id = "view.messages",
                     .label = "Messages",
                     .menu = Menu::view,
                     .chord = {Key::m},
                     .help = "Lists all messages so far",
                     .separated = true},
          .before = "view.profile"},
    Panel{.id = "ensemble",
          .draw = [](Ui& ui) { drawEnsemble(contextOf(ui), ui.ensemble, ui.showEnsemble); },
          .shown = &Ui::showEnsemble,
          .toggle = {.id = "view.ensemble_map",
                     .label = "Ensemble map",
                     .menu = Menu::view,

                     .help = "Probability that the optical depth exceeds a threshold, its mean and "
                             "spread over the members"},
          .before = "view.messages"},
    Panel{.id = "files", .draw = [](Ui& ui) { drawPathPopup(contextOf(ui), ui.sessionDialogs); }},
    Panel{.id = "sessions",
          .draw = [](Ui& ui) { drawSessionDialogs(contextOf(ui), ui.sessionDialogs); }},
    Panel{.id = "output",
          .draw = [](Ui& ui) { drawOutput(contextOf(ui), ui.output, exportSceneOf(ui)); }},
    Panel{.id = "preset_dialogs",
          .draw = [](Ui& ui) { drawPresetDialogs(contextOf(ui), ui.presets); }},
    Panel{.id = "history",
          .draw = [](Ui& ui) { drawHistory(ui.session(), ui.showHistory, ui.historySeen); },
          .shown = &Ui::showHistory,
          .toggle = {.id = "edit.history",
                     .label = "History",
                     .menu = Menu::edit,
                     .chord = {Key::h, true},
                     .help = "Lists all steps; click one to go there"},
          .before = "edit.show_all"},
    Panel{.id = "help_sheet",
          .draw = [](Ui& ui) { drawHelp(ui.showHelp); },
          .shown = &Ui::showHelp,
          .toggle = {.id = "help.sheet",
                     .label = "Mouse and keys",
                     .menu = Menu::help,
                     .chord = {Key::h},
                     .other = {Key::question},
                     .help = "Lists what the mouse and the keys do"},
          .before = "help.close"},
    Panel{.id = "palette", .draw = drawPalette},
};

}  // namespace

std::span<const Panel> panels() {
    return kPanels;
}

}  // namespace neph::ui

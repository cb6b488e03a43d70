// settings.h: settings that are kept between runs, in $XDG_CONFIG_HOME/nephoscope/settings.json.
#pragma once
#include <optional>
#include <string>
#include <vector>

namespace neph {

/// Colours of the panels.
enum class Theme : int { dark, light };

/// Contents of the window on the screen, in its coordinates: x to the right, y down.
struct WindowPlace {
    int x = 0, y = 0, width = 1, height = 1;
    bool operator==(const WindowPlace&) const = default;
};

/// Widths that a column of panels may have, letters.
inline constexpr float kLeastColumnEms = 15.0f, kMostColumnEms = 40.0f;

/// Preferences of the user; not part of any document.
struct Settings {
    std::string memory;  ///< as for parseMemory in memory_setting.h; empty: the program chooses
    Theme theme = Theme::dark;
    float textScale = 1.0f;  ///< scale of text and panels, in addition to that of the monitor
    double framesPerSecond = 30.0;  ///< target while something moves
    bool leftColumn = true, rightColumn = true;
    float leftColumnEms = 20.0f, rightColumnEms = 20.0f;  ///< their widths, in letters
    bool dataDetails = false;                             ///< more of the data than one line
    std::optional<WindowPlace> window;                    ///< as it was left; none: as it opens
    bool scaleBar = true, compass = true, heightRuler = false;  ///< overlays on the image
    /// The error of the image is measured whenever it rests; none: as suits the device.
    std::optional<bool> measureAtRest;
    bool denoisedPreview = false;     ///< of images of paths, on the screen in their place
    std::vector<std::string> recent;  ///< data and sessions opened, newest first, absolute paths
    bool operator==(const Settings&) const = default;
};

/// The saved settings, or those of a first run. Invalid ones are left out and reported in
/// `warnings`.
Settings loadSettings(std::vector<std::string>& warnings);

/// Whether settings have been saved before; also where they cannot be.
bool settingsWereSaved();

/// Saves the settings; keys unknown to this version are kept. Throws Error.
void saveSettings(const Settings& settings);

}  // namespace neph

// kept_settings.h: the settings of the window between what it changes and their file.
#pragma once
#include <string>
#include <vector>

#include "core/session/session.h"
#include "core/session/settings.h"

namespace neph {

class KeptSettings {
  public:
    KeptSettings() : first_(!settingsWereSaved()), kept_(loadSettings(warnings_)) {}

    const Settings& get() const { return kept_; }
    /// Whether there were none.
    bool firstRun() const { return first_; }
    /// What was wrong with their file.
    const std::vector<std::string>& warnings() const { return warnings_; }
    /// Saves them where they are others; a place that cannot be written to is told once.
    void keep(const Settings& settings, Session& told);

  private:
    bool first_ = false;
    std::vector<std::string> warnings_;
    Settings kept_;
};

}  // namespace neph

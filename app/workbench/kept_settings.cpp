// kept_settings.cpp: writes what has changed.
#include "app/workbench/kept_settings.h"

#include "core/base/error.h"

namespace neph {

void KeptSettings::keep(const Settings& settings, Session& told) {
    if (settings == kept_) return;
    kept_ = settings;
    try {
        saveSettings(kept_);
    } catch (const Error& error) {
        told.say(Message::Kind::error, error.message());
    }
}

}  // namespace neph

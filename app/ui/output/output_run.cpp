// output_run.cpp: what the window shows goes into a session file, which the program beside it
// reads.
#include "app/ui/output/output_run.h"

#include <fmt/format.h>
#include <unistd.h>

#include <utility>

#include "core/base/error.h"
#include "core/base/resources.h"
#include "core/session/session_file.h"

namespace neph::ui {
namespace {

std::filesystem::path sessionFile() {
    const auto cache = userCacheDir();
    const std::filesystem::path folder =
        (cache ? *cache : std::filesystem::temp_directory_path() / "nephoscope") / "exports";
    std::filesystem::create_directories(folder);
    return folder / fmt::format("{}{}", getpid(), kSessionEnding);
}

void removeSession(OutputState& output) {
    std::error_code ignored;
    std::filesystem::remove(std::exchange(output.session, {}), ignored);
}

}  // namespace

std::string stoppedText(const ExportJob& job) {
    if (job.done() == 0 || job.file().extension() == ".mp4") {
        return "The export was stopped; nothing was written";
    }
    return fmt::format("The export was stopped; {} image{} kept", job.done(),
                       job.done() == 1 ? " is" : "s are");
}

bool exports(const OutputState& output) {
    return output.job && output.job->state() == ExportJob::State::running;
}

void startExport(const PanelContext& context, OutputState& output, const ExportSettings& settings,
                 const ExportScene& scene) {
    if (exports(output) || !context.services.state) return;
    try {
        const bool series =
            settings.what != ExportWhat::image && settings.format != ExportFormat::mp4;
        const auto out = freeFile(withEnding(settings.file, settings.format), series);
        output.session = sessionFile();
        saveSession(output.session, context.services.state());
        output.job.emplace(output.program.empty() ? programDir() / "nephoscope" : output.program,
                           exportArguments(settings, scene, output.session, out));
    } catch (const Error& error) {
        removeSession(output);
        context.session().say(Message::Kind::error, error.message());
    } catch (const std::filesystem::filesystem_error& error) {
        context.session().say(Message::Kind::error, error.what());
    }
}

bool mayQuit(OutputState& output) {
    if (!exports(output) || output.mayQuit) return true;
    output.asksToQuit = true;
    return false;
}

void quitAfterExport(const PanelContext& context, OutputState& output) {
    output.asksToQuit = false;
    output.quitsAfter = true;
    context.session().say(Message::Kind::note, "Nephoscope will quit when the export is done");
}

void quitAndStopExport(const PanelContext& context, OutputState& output) {
    output.asksToQuit = false;
    if (output.job) output.job->cancel();
    removeSession(output);
    output.mayQuit = context.requests.quit = true;
}

void quitAndLeaveExport(const PanelContext& context, OutputState& output) {
    output.asksToQuit = false;
    try {
        if (exports(output)) output.job->letGo(output.session);
        output.session.clear();  // removed by what reads its end
        output.mayQuit = context.requests.quit = true;
    } catch (const Error& error) {
        context.session().say(Message::Kind::error, error.message());
    }
}

void exportImage(const PanelContext& context, OutputState& output, const ExportScene& scene) {
    ExportSettings settings = output.settings;
    settings.what = ExportWhat::image;
    settings.size = ExportSize::window;
    if (settings.format == ExportFormat::mp4) settings.format = ExportFormat::png;
    if (settings.file.empty()) settings.file = defaultExportFile().string();
    startExport(context, output, settings, scene);
}

void updateExport(const PanelContext& context, OutputState& output) {
    if (!exports(output)) return;
    context.next.again(kLookS);
    const ExportJob::State state = output.job->poll();
    if (state == ExportJob::State::running) return;
    removeSession(output);
    output.asksToQuit = false;
    const bool quits = std::exchange(output.quitsAfter, false);
    if (quits && state == ExportJob::State::done) context.requests.quit = true;
    if (state == ExportJob::State::done) {
        context.session().say(Message::Kind::note, "Wrote " + output.job->file().string());
    } else if (state == ExportJob::State::cancelled) {
        context.session().say(Message::Kind::note, stoppedText(*output.job));
    }
}

}  // namespace neph::ui

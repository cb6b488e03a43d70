// plugin_file.cpp: calls through the ABI.
#include "core/plugin/plugin_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <exception>
#include <limits>
#include <utility>

#include "core/base/error.h"
#include "core/plugin/checked_description.h"

namespace neph {
namespace {

NephError emptyError(std::uint32_t abiVersion) {
    NephError error{};
    error.header = {abiVersion, sizeof(NephError)};
    return error;
}

template <std::size_t N>
std::string partOf(const char (&text)[N]) {
    return {text, strnlen(text, N)};
}

/// The error of a reader, completed with the path and a reason if they are missing.
Error errorFrom(const NephError& raw, const std::filesystem::path& path,
                const std::string& reader) {
    ErrorParts parts{partOf(raw.where), partOf(raw.what), partOf(raw.found), partOf(raw.expected),
                     partOf(raw.hint)};
    if (parts.where.empty()) parts.where = path.string();
    if (parts.what.empty()) parts.what = fmt::format("reader {} failed and gave no reason", reader);
    return Error(std::move(parts));
}

/// Carries progress through the C callback.
struct ProgressBridge {
    const Progress& progress;
    bool stopped = false;
    std::exception_ptr thrown{};  ///< rethrown later: nothing may be thrown through the plugin
};

std::int32_t reportProgress(void* context, double fraction) {
    auto& bridge = *static_cast<ProgressBridge*>(context);
    try {
        fraction = std::isfinite(fraction) ? std::clamp(fraction, 0.0, 1.0) : 0.0;
        bridge.stopped = bridge.stopped || !goOn(bridge.progress, fraction);
    } catch (...) {
        bridge.thrown = std::current_exception();
        bridge.stopped = true;
    }
    return bridge.stopped ? 0 : 1;
}

constexpr float kUntouched = -6.02e23f;  // a value that no field contains

}  // namespace

void PluginFile::Closer::operator()(NephFile* file) const {
    try {
        calls->close(file);
    } catch (...) {  // breaks the ABI, but there is nobody left to report it to
    }
}

Error PluginFile::faulty(const std::string& text) const {
    return Error({.where = path_.string(),
                  .what = fmt::format("reader {} is faulty: {}", reader_, text),
                  .hint = "report this to the author of the reader"});
}

void PluginFile::guarded(const std::function<void()>& call) const {
    try {
        call();
    } catch (const Error&) {
        throw;
    } catch (const ReaderFault& fault) {
        throw faulty(fault.text);
    } catch (const std::bad_alloc&) {
        throw Error({.where = path_.string(), .what = "there is not enough memory to read it"});
    } catch (const std::exception& problem) {
        throw faulty(fmt::format("it threw {}", problem.what()));
    } catch (...) {
        throw faulty("it threw what is no std::exception");
    }
}

PluginFile::PluginFile(const NephReader& calls, std::string reader, std::filesystem::path path,
                       const std::filesystem::path& map)
    : calls_(&calls),
      reader_(std::move(reader)),
      path_(std::move(path)),
      file_(nullptr, Closer{&calls}) {
    guarded([&] {
        NephError error = emptyError(calls_->header.abi_version);
        NephFile* raw = nullptr;
        const NephStatus status =
            map.empty() ? calls_->open(path_.c_str(), &raw, &error)
                        : calls_->open_with_map(path_.c_str(), map.c_str(), &raw, &error);
        if (status != NEPH_OK) throw errorFrom(error, path_, reader_);
        if (raw == nullptr) throw ReaderFault{"open gave no handle"};
        file_.reset(raw);
        description_ = checkedDescription(calls_->describe(file_.get()));
    });
}

void PluginFile::read(std::size_t variable, std::size_t time, const CellBox& box,
                      std::span<float> room, const Progress& progress) {
    const std::span<float> values = room.first(room.size() - kGuardValues);
    const std::span<float> guard = room.last(kGuardValues);
    // What the reader does not write stays missing, and what it writes too much shows in the guard.
    std::ranges::fill(values, std::numeric_limits<float>::quiet_NaN());
    std::ranges::fill(guard, kUntouched);
    NephReadRequest request{};
    request.header = {calls_->header.abi_version, sizeof(NephReadRequest)};
    request.variable = static_cast<std::uint32_t>(variable);
    request.time = static_cast<std::uint32_t>(time);
    for (int axis = 0; axis < 3; ++axis) {
        request.lower[axis] = box.lower[axis];
        request.upper[axis] = box.upper[axis];
    }
    request.values = values.data();
    request.value_count = values.size();
    ProgressBridge bridge{progress};
    request.progress = &reportProgress;
    request.progress_context = &bridge;
    const std::string& name = description_.variables.at(variable).name;
    guarded([&] {
        NephError error = emptyError(calls_->header.abi_version);
        const NephStatus status = calls_->read(file_.get(), &request, &error);
        if (bridge.stopped) return;
        if (status == NEPH_CANCELLED)
            throw ReaderFault{"read was cancelled, and nobody had asked to"};
        if (status != NEPH_OK) throw errorFrom(error, path_, reader_);
        if (std::ranges::any_of(guard, [](float value) { return value != kUntouched; })) {
            throw ReaderFault{
                fmt::format("read wrote beyond the {} values asked of {}", values.size(), name)};
        }
        if (request.values_written != values.size()) {
            throw ReaderFault{fmt::format("read gave {} values of {}, {} were asked for",
                                          request.values_written, name, values.size())};
        }
    });
    if (bridge.thrown) std::rethrow_exception(bridge.thrown);
    if (bridge.stopped) throw Cancelled{};
}

}  // namespace neph

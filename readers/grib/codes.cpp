// codes.cpp: one handle for one message.
#include "readers/grib/codes.h"

#include <eccodes.h>
#include <fmt/format.h>

#include <cmath>
#include <limits>
#include <memory>
#include <mutex>

#include "readers/grib/packing.h"

namespace grib {
namespace {

std::mutex codesMutex;
std::string lastWords;  ///< of ecCodes, while the mutex is held

void listen(const codes_context*, int level, const char* words) {
    if (level == GRIB_LOG_ERROR || level == GRIB_LOG_FATAL) lastWords = words;
}

struct DeleteHandle {
    void operator()(codes_handle* handle) const { codes_handle_delete(handle); }
};
using Handle = std::unique_ptr<codes_handle, DeleteHandle>;

/// Null if ecCodes does not take the message.
Handle handleOf(const Bytes& message) {
    lastWords.clear();
    codes_context* context = codes_context_get_default();
    codes_context_set_logging_proc(context, &listen);
    return Handle(codes_handle_new_from_message(context, message.data(), message.size()));
}

Failure refusal(int code, unsigned form) {
    const bool lacking = code == CODES_FUNCTIONALITY_NOT_ENABLED || code == CODES_NOT_IMPLEMENTED;
    return Failure{
        lacking ? "ecCodes on this machine was built without the packing " + packingName(form)
                : "ecCodes cannot unpack it, packed as " + packingName(form),
        lastWords.empty() ? codes_get_error_message(code) : lastWords,
        {},
        lacking
            ? "install a build with it, or repack: grib_set -r -s packingType=grid_simple IN OUT"
            : "the message is damaged: download the file again"};
}

std::string textOf(codes_handle* handle, const char* key) {
    std::array<char, 256> text{};
    std::size_t length = text.size();
    if (codes_get_string(handle, key, text.data(), &length) != 0) return {};
    const std::string value = text.data();
    return value == "unknown" || value == "~" ? std::string() : value;
}

}  // namespace

std::vector<float> unpackWithCodes(const Bytes& message, unsigned form) {
    const std::scoped_lock lock(codesMutex);
    const Handle handle = handleOf(message);
    if (!handle) throw refusal(CODES_INVALID_MESSAGE, form);
    constexpr double kMark = -1.7e308;  // no packing reaches it
    codes_set_double(handle.get(), "missingValue", kMark);
    std::size_t count = 0;
    int code = codes_get_size(handle.get(), "values", &count);
    std::vector<double> numbers(code == 0 ? count : 0);
    if (code == 0) code = codes_get_double_array(handle.get(), "values", numbers.data(), &count);
    if (code != 0) throw refusal(code, form);
    std::vector<float> values(count);
    for (std::size_t i = 0; i < count; ++i) {
        values[i] = numbers[i] == kMark ? std::numeric_limits<float>::quiet_NaN()
                                        : static_cast<float>(numbers[i]);
    }
    return values;
}

ParameterText textWithCodes(const Bytes& message) {
    const std::scoped_lock lock(codesMutex);
    const Handle handle = handleOf(message);
    if (!handle) return {};
    std::string units = textOf(handle.get(), "units");
    std::erase(units, '*');  // "m s**-1"
    return {textOf(handle.get(), "shortName"), textOf(handle.get(), "name"), units,
            textOf(handle.get(), "cfName")};
}

}  // namespace grib

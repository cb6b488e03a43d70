// nc_attributes.cpp: attributes by the calls of NetCDF-C.
#include "readers/netcdf/nc_attributes.h"

#include <algorithm>
#include <string_view>

namespace nc {
namespace {

constexpr std::size_t kMaxText = 65536;
constexpr std::size_t kMaxNumbers = 64;

struct Attribute {
    nc_type type = NC_NAT;
    std::size_t length = 0;
};

Attribute inquire(int file, int variable, const char* name) {
    Attribute found;
    if (nc_inq_att(file, variable, name, &found.type, &found.length) != NC_NOERR) return {};
    return found;
}

std::string trimmed(std::string_view text) {
    constexpr std::string_view kBlank(" \t\n\0", 4);
    const std::size_t first = text.find_first_not_of(kBlank);
    if (first == std::string_view::npos) return {};
    return std::string(text.substr(first, text.find_last_not_of(kBlank) - first + 1));
}

}  // namespace

std::optional<std::string> textAttribute(int file, int variable, const char* name) {
    const Attribute found = inquire(file, variable, name);
    if (found.type == NC_STRING && found.length == 1) {
        char* text = nullptr;
        if (nc_get_att_string(file, variable, name, &text) != NC_NOERR) return {};
        std::string copy = text == nullptr ? std::string() : trimmed(text);
        nc_free_string(1, &text);
        return copy;
    }
    if (found.type != NC_CHAR || found.length > kMaxText) return {};
    std::string text(found.length, '\0');
    if (nc_get_att_text(file, variable, name, text.data()) != NC_NOERR) return {};
    return trimmed(text);
}

std::vector<double> numbersAttribute(int file, int variable, const char* name) {
    const Attribute found = inquire(file, variable, name);
    const bool number = found.type >= NC_BYTE && found.type <= NC_UINT64 && found.type != NC_CHAR;
    if (!number || found.length == 0 || found.length > kMaxNumbers) return {};
    std::vector<double> values(found.length);
    if (nc_get_att_double(file, variable, name, values.data()) != NC_NOERR) return {};
    return values;
}

std::optional<double> numberAttribute(int file, int variable, const char* name) {
    const std::vector<double> values = numbersAttribute(file, variable, name);
    if (values.size() != 1) return {};
    return values.front();
}

bool isRealAttribute(int file, int variable, const char* name) {
    const nc_type type = inquire(file, variable, name).type;
    return type == NC_FLOAT || type == NC_DOUBLE;
}

}  // namespace nc

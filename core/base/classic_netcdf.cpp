// classic_netcdf.cpp: the header first, then each variable at its offset; numbers are big-endian.
#include "core/base/classic_netcdf.h"

#include <bit>
#include <cassert>
#include <cstddef>
#include <cstdint>
#include <string_view>

namespace neph {
namespace {

// Tags and types of the format.
constexpr std::uint32_t kDimensionTag = 10, kVariableTag = 11, kAttributeTag = 12;
constexpr std::uint32_t kCharType = 2, kFloatType = 5, kDoubleType = 6;
constexpr std::size_t kAlignment = 4;

template <typename Number>
void addNumber(std::string& bytes, Number number) {
    for (int shift = static_cast<int>(8 * sizeof(Number)) - 8; shift >= 0; shift -= 8) {
        bytes += static_cast<char>((number >> static_cast<unsigned>(shift)) & 0xFFU);
    }
}

void addCount(std::string& bytes, std::size_t count) {
    addNumber(bytes, static_cast<std::uint32_t>(count));
}

void align(std::string& bytes) {
    while (bytes.size() % kAlignment != 0) bytes += '\0';
}

void addText(std::string& bytes, std::string_view text) {
    addCount(bytes, text.size());
    bytes += text;
    align(bytes);
}

void addValues(std::string& bytes, const std::vector<float>& values) {
    for (const float value : values) addNumber(bytes, std::bit_cast<std::uint32_t>(value));
}

void addValues(std::string& bytes, const std::vector<double>& values) {
    for (const double value : values) addNumber(bytes, std::bit_cast<std::uint64_t>(value));
}

/// The head of a list: its tag and length, or twice 0 where it is empty.
void addList(std::string& bytes, std::uint32_t tag, std::size_t count) {
    addNumber(bytes, count == 0 ? 0U : tag);
    addCount(bytes, count);
}

void addAttributes(std::string& bytes, const std::vector<NetcdfAttribute>& attributes) {
    addList(bytes, kAttributeTag, attributes.size());
    for (const NetcdfAttribute& attribute : attributes) {
        addText(bytes, attribute.name);
        if (const auto* text = std::get_if<std::string>(&attribute.value)) {
            addNumber(bytes, kCharType);
            addText(bytes, *text);
        } else {
            const auto& numbers = std::get<std::vector<double>>(attribute.value);
            addNumber(bytes, kDoubleType);
            addCount(bytes, numbers.size());
            addValues(bytes, numbers);
        }
    }
}

std::size_t bytesOf(const NetcdfVariable& variable) {
    return std::visit(
        [](const auto& values) {
            const std::size_t bytes = values.size() * sizeof(values.front());
            return (bytes + kAlignment - 1) / kAlignment * kAlignment;
        },
        variable.values);
}

/// `offset`: of the first variable's values from the start of the file.
std::string headerOf(const NetcdfContents& contents, std::size_t offset) {
    std::string bytes = "CDF\x02";
    addCount(bytes, 0);  // records
    addList(bytes, kDimensionTag, contents.dimensions.size());
    for (const NetcdfDimension& dimension : contents.dimensions) {
        addText(bytes, dimension.name);
        addNumber(bytes, static_cast<std::uint32_t>(dimension.length));
    }
    addAttributes(bytes, contents.attributes);
    addList(bytes, kVariableTag, contents.variables.size());
    for (const NetcdfVariable& variable : contents.variables) {
        addText(bytes, variable.name);
        addCount(bytes, variable.dimensions.size());
        for (const int dimension : variable.dimensions) {
            addNumber(bytes, static_cast<std::uint32_t>(dimension));
        }
        addAttributes(bytes, variable.attributes);
        const bool floats = std::holds_alternative<std::vector<float>>(variable.values);
        addNumber(bytes, floats ? kFloatType : kDoubleType);
        addCount(bytes, bytesOf(variable));
        addNumber(bytes, static_cast<std::uint64_t>(offset));
        offset += bytesOf(variable);
    }
    return bytes;
}

}  // namespace

std::string formatNetcdf(const NetcdfContents& contents) {
    std::string bytes = headerOf(contents, headerOf(contents, 0).size());
    for (const NetcdfVariable& variable : contents.variables) {
        std::size_t expected = 1;
        for (const int dimension : variable.dimensions) {
            expected *= static_cast<std::size_t>(
                contents.dimensions.at(static_cast<std::size_t>(dimension)).length);
        }
        std::visit(
            [&](const auto& values) {
                assert(values.size() == expected);
                addValues(bytes, values);
            },
            variable.values);
        align(bytes);
    }
    return bytes;
}

}  // namespace neph

// rows.h: textures have their rows from the bottom, images from the top.
#pragma once
#include <cstddef>
#include <vector>

namespace neph::render {

/// The values of an image whose rows of `width` values come from the bottom, from the top.
template <typename T>
std::vector<T> fromTop(const std::vector<T>& values, std::size_t width) {
    std::vector<T> out;
    out.reserve(values.size());
    const auto step = static_cast<std::ptrdiff_t>(width);
    for (auto row = values.end(); row != values.begin(); row -= step) {
        out.insert(out.end(), row - step, row);
    }
    return out;
}

}  // namespace neph::render

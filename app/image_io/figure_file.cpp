// figure_file.cpp: draws plots by cairo.
#include "app/image_io/figure_file.h"

#include <cairo/cairo-svg.h>
#include <cairo/cairo.h>

#include <array>
#include <cstring>
#include <memory>
#include <numbers>

#include "app/image_io/png.h"
#include "core/base/atomic_file.h"
#include "core/base/error.h"
#include "core/plot/draw.h"

#if defined(__has_feature)
#if __has_feature(address_sanitizer)
// fontconfig loses a few patterns that cairo asks it for, half a kilobyte in a process.
extern "C" const char* __lsan_default_suppressions();
extern "C" const char* __lsan_default_suppressions() {
    return "leak:libfontconfig";
}
extern "C" const char* __lsan_default_options();
extern "C" const char* __lsan_default_options() {
    return "print_suppressions=0";
}
#endif
#endif

namespace neph {
namespace {

constexpr double kPixelsPerPt = 2.0;
// It has the superscripts and signs that units need.
constexpr const char* kFont = "DejaVu Sans";

class CairoCanvas final : public plot::Canvas {
  public:
    explicit CairoCanvas(cairo_surface_t* surface) : cairo_(cairo_create(surface), cairo_destroy) {
        cairo_select_font_face(context(), kFont, CAIRO_FONT_SLANT_NORMAL, CAIRO_FONT_WEIGHT_NORMAL);
        cairo_set_line_join(context(), CAIRO_LINE_JOIN_ROUND);
    }

    void scale(double factor) { cairo_scale(context(), factor, factor); }

    void line(std::span<const glm::dvec2> points, const plot::Pen& pen) override {
        trace(points);
        setColour(pen.colour);
        cairo_set_line_width(context(), pen.widthPt);
        constexpr std::array kDashPt{5.0, 3.0};
        cairo_set_dash(context(), kDashPt.data(), pen.dashed ? 2 : 0, 0.0);
        cairo_stroke(context());
    }

    void fill(std::span<const glm::dvec2> points, const glm::vec4& colour) override {
        trace(points);
        cairo_close_path(context());
        setColour(colour);
        cairo_fill(context());
    }

    void fillRect(const plot::RectPt& rect, const glm::vec4& colour) override {
        // Neighbours meet without a line of the ground between them.
        cairo_set_antialias(context(), CAIRO_ANTIALIAS_NONE);
        cairo_rectangle(context(), rect.lower.x, rect.lower.y, rect.size().x, rect.size().y);
        setColour(colour);
        cairo_fill(context());
        cairo_set_antialias(context(), CAIRO_ANTIALIAS_DEFAULT);
    }

    void text(glm::dvec2 at, plot::Anchor anchor, const std::string& text, const glm::vec4& colour,
              double sizePt, bool upwards) override {
        const glm::dvec2 size = textSize(text, sizePt);
        cairo_font_extents_t font;
        cairo_font_extents(context(), &font);
        cairo_save(context());
        cairo_translate(context(), at.x, at.y);
        setColour(colour);
        if (upwards) {
            // The anchor is that of the turned text.
            cairo_translate(context(), (1.0 - anchor.x) * size.y, (1.0 - anchor.y) * size.x);
            cairo_rotate(context(), -0.5 * std::numbers::pi);
            cairo_move_to(context(), 0.0, -font.descent);
        } else {
            cairo_move_to(context(), -anchor.x * size.x, font.ascent - anchor.y * size.y);
        }
        cairo_show_text(context(), text.c_str());
        cairo_restore(context());
    }

    glm::dvec2 textSize(const std::string& text, double sizePt) override {
        cairo_set_font_size(context(), sizePt);
        cairo_text_extents_t extents;
        cairo_text_extents(context(), text.c_str(), &extents);
        cairo_font_extents_t font;
        cairo_font_extents(context(), &font);
        return {extents.x_advance, font.ascent + font.descent};
    }

    void clip(const plot::RectPt& rect) override {
        cairo_save(context());
        cairo_rectangle(context(), rect.lower.x, rect.lower.y, rect.size().x, rect.size().y);
        cairo_clip(context());
    }
    void endClip() override { cairo_restore(context()); }

  private:
    cairo_t* context() const { return cairo_.get(); }
    void setColour(const glm::vec4& colour) {
        const glm::dvec4 c(colour);
        cairo_set_source_rgba(context(), c.r, c.g, c.b, c.a);
    }
    void trace(std::span<const glm::dvec2> points) {
        cairo_new_path(context());
        for (const glm::dvec2& point : points) cairo_line_to(context(), point.x, point.y);
    }

    std::unique_ptr<cairo_t, decltype(&cairo_destroy)> cairo_;
};

using Surface = std::unique_ptr<cairo_surface_t, decltype(&cairo_surface_destroy)>;

void drawSheet(const Sheet& sheet, CairoCanvas& canvas) {
    canvas.fillRect({glm::dvec2(0.0), sheet.sizePt}, glm::vec4(1.0f));
    for (const PlacedFigure& placed : sheet.figures) {
        plot::draw(placed.figure, placed.area, canvas, {});
    }
}

void requireDrawn(cairo_surface_t* surface, const std::filesystem::path& file) {
    const cairo_status_t status = cairo_surface_status(surface);
    if (status == CAIRO_STATUS_SUCCESS) return;
    throw Error({.where = file.string(),
                 .what = "the plot cannot be drawn",
                 .found = cairo_status_to_string(status)});
}

std::string escaped(const std::string& text) {
    std::string out;
    for (const char c : text) {
        out += c == '<' ? "&lt;" : c == '>' ? "&gt;" : c == '&' ? "&amp;" : std::string(1, c);
    }
    return out;
}

void writeSvg(const std::filesystem::path& file, const Sheet& sheet) {
    std::string svg;
    const auto append = [](void* to, const unsigned char* data, unsigned size) {
        static_cast<std::string*>(to)->append(reinterpret_cast<const char*>(data), size);
        return CAIRO_STATUS_SUCCESS;
    };
    {
        const Surface surface(
            cairo_svg_surface_create_for_stream(append, &svg, sheet.sizePt.x, sheet.sizePt.y),
            cairo_surface_destroy);
        CairoCanvas canvas(surface.get());
        drawSheet(sheet, canvas);
        cairo_surface_finish(surface.get());
        requireDrawn(surface.get(), file);
    }
    std::string desc;
    for (const auto& [key, value] : sheet.metadata) desc += escaped(key + ": " + value + '\n');
    const std::size_t root = svg.find('>', svg.find("<svg"));
    if (root != std::string::npos && !desc.empty()) {
        svg.insert(root + 1, "\n<desc>" + desc + "</desc>");
    }
    replaceFile(file, svg);
}

void writePngSheet(const std::filesystem::path& file, const Sheet& sheet) {
    const glm::ivec2 size(glm::ceil(kPixelsPerPt * sheet.sizePt));
    const Surface surface(cairo_image_surface_create(CAIRO_FORMAT_RGB24, size.x, size.y),
                          cairo_surface_destroy);
    requireDrawn(surface.get(), file);
    CairoCanvas canvas(surface.get());
    canvas.scale(kPixelsPerPt);
    drawSheet(sheet, canvas);
    cairo_surface_flush(surface.get());
    requireDrawn(surface.get(), file);
    Image8 image;
    image.size = size;
    const unsigned char* data = cairo_image_surface_get_data(surface.get());
    const int stride = cairo_image_surface_get_stride(surface.get());
    for (int y = 0; y < size.y; ++y) {
        for (int x = 0; x < size.x; ++x) {
            std::uint32_t pixel = 0;
            std::memcpy(&pixel, data + y * stride + 4 * x, sizeof(pixel));
            for (const unsigned shift : {16U, 8U, 0U}) {
                image.rgba.push_back(static_cast<std::uint8_t>(pixel >> shift));
            }
            image.rgba.push_back(255);
        }
    }
    writePng(file, image, sheet.metadata);
}

}  // namespace

void writeSheet(const std::filesystem::path& file, const Sheet& sheet) {
    const std::string kind = file.extension().string();
    if (kind == ".svg") return writeSvg(file, sheet);
    if (kind == ".png") return writePngSheet(file, sheet);
    throw Error({.where = file.string(),
                 .what = "plots are not written as such a file",
                 .found = kind.empty() ? "no extension" : kind,
                 .expected = ".svg or .png"});
}

}  // namespace neph

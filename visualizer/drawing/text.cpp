#include "visualizer/drawing/text.hpp"

#include <vtkStdString.h>
#include <vtkTextRenderer.h>

#include <cmath>
#include <cstdio>
#include <filesystem>
#include <map>
#include <numbers>
#include <stdexcept>

namespace rayscope::drawing {
namespace {

constexpr int dots_per_inch = 72;  // then a point is a pixel
constexpr double measured_at = 32; // font sizes are whole numbers: measure large, scale down

std::string font_file(Font font) {
    const std::filesystem::path folder = "/usr/share/fonts/truetype/dejavu";
    constexpr std::array<const char*, 3> files{"DejaVuSans.ttf", "DejaVuSans-Bold.ttf", "DejaVuSansMono.ttf"};
    const auto file = folder / files.at(std::size_t(font));
    if (!std::filesystem::exists(file))
        throw std::runtime_error("the font " + file.string() + " is missing (package fonts-dejavu-core)");
    return file.string();
}

bool continues_character(char c) { return (static_cast<unsigned char>(c) & 0xC0U) == 0x80U; }

/// The text's characters, each with its bytes.
std::vector<std::string> characters(const std::string& text) {
    std::vector<std::string> result;
    for (const char c : text)
        if (continues_character(c) && !result.empty())
            result.back() += c;
        else
            result.emplace_back(1, static_cast<unsigned char>(c) < ' ' ? ' ' : c);
    return result;
}

} // namespace

vtkSmartPointer<vtkTextProperty> text_property(Font font, double size, Rgb colour) {
    static const std::array files{font_file(Font::sans), font_file(Font::bold), font_file(Font::mono)};
    auto property = vtkSmartPointer<vtkTextProperty>::New();
    property->SetFontFamily(VTK_FONT_FILE);
    property->SetFontFile(files.at(std::size_t(font)).c_str());
    property->SetFontSize(int(std::lround(size)));
    property->SetColor(colour.red / 255.0, colour.green / 255.0, colour.blue / 255.0);
    property->SetJustificationToLeft();
    property->SetVerticalJustificationToBottom();
    return property;
}

double text_width(const std::string& text, Font font, double size) {
    if (text.empty()) return 0;
    static std::map<std::pair<Font, std::string>, double> known;
    const auto [at, fresh] = known.try_emplace({font, text}, 0);
    if (fresh) {
        std::array<int, 4> box{};
        const auto property = text_property(font, measured_at, ink);
        vtkTextRenderer::GetInstance()->GetBoundingBox(property, text, box.data(), dots_per_inch,
                                                       vtkTextRenderer::FreeType);
        at->second = (box[1] - box[0] + 1) / measured_at;
    }
    return at->second * size;
}

Area text_area(const Text& text) {
    const double width = text_width(text.text, text.font, text.size);
    const double share = text.align == Align::left ? 0 : (text.align == Align::centre ? 0.5 : 1);
    return {text.at.x - share * width, text.at.y - text.size * 0.6, width, text.size * 1.2};
}

std::string elided(const std::string& text, Font font, double size, double width) {
    const std::vector<std::string> all = characters(text);
    const auto joined = [&](std::size_t kept) {
        std::string result;
        const std::size_t head = (kept + 1) / 2, tail = kept / 2;
        for (std::size_t i = 0; i < head; ++i) result += all[i];
        if (kept < all.size()) result += "…";
        for (std::size_t i = all.size() - tail; i < all.size(); ++i) result += all[i];
        return result;
    };
    // No letter is narrower than a quarter of the size: what is far too long need not be measured.
    std::size_t most = std::min(all.size(), std::size_t(std::max(width, 0.0) / (size / 4)) + 1);
    std::size_t least = 0;
    if (text_width(joined(most), font, size) <= width) return joined(most);
    while (least + 1 < most) {
        const std::size_t middle = (least + most) / 2;
        (text_width(joined(middle), font, size) <= width ? least : most) = middle;
    }
    return joined(least);
}

std::string number(double value, int digits) {
    if (std::isnan(value)) return "undefined";
    if (std::isinf(value)) return value > 0 ? "∞" : "−∞";
    std::array<char, 40> text{};
    std::snprintf(text.data(), text.size(), "%.*g", digits, value == 0 ? 0.0 : value);
    std::string result = text.data();
    return result;
}

std::string degrees(double radians) { return number(radians * 180 / std::numbers::pi) + "°"; }

} // namespace rayscope::drawing

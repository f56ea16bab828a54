#include "visualizer/drawing/effects_chart.hpp"

#include "visualizer/drawing/flat_picture.hpp"
#include "visualizer/drawing/text.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

namespace rayscope::drawing {
namespace {

constexpr Rgb called_for_blue{0x00, 0x72, 0xB2}, added_orange{0xD5, 0x5E, 0x00};

std::string with_format(const char* format, double value) {
    std::array<char, 32> text{};
    std::snprintf(text.data(), text.size(), format, value);
    return text.data();
}

class EffectsChart {
public:
    EffectsChart(const EffectsFile& file, const PictureSize& size)
        : file_(file), size_(size), font_(std::max(12.0, size.height / 45.0)), picture_(size) {
        for (const MeasuredEffect& e : file.effects) {
            least_ = std::min(least_, e.least_time);
            most_ = std::max(most_, e.greatest_time);
            largest_ = std::max(largest_, e.difference);
        }
        const double width = size_.width - 2 * font_, names = width * 0.24, numbers = 5 * font_;
        name_ = font_;
        time_ = {font_ + names, font_ + names + width * 0.38 - numbers};
        difference_ = {time_.to + numbers + font_, size_.width - font_ - numbers};
    }

    [[nodiscard]] Raster draw() {
        canvas_.add(Text{{font_, 1.4 * font_},
                         elided("What each effect costs and changes: " + file_.scene, Font::bold, 1.4 * font_,
                                size_.width - 2 * font_),
                         1.4 * font_,
                         ink,
                         Font::bold});
        draw_heads();
        const double room = (size_.height - top() - 2.6 * font_) / double(file_.effects.size());
        const double row = std::min(room, 2.6 * font_);
        draw_ones(top(), top() + row * double(file_.effects.size()));
        for (std::size_t i = 0; i < file_.effects.size(); ++i)
            draw_row(file_.effects[i], top() + (double(i) + 0.5) * row, row);
        canvas_.add(
            Text{{font_, size_.height - 1.2 * font_},
                 "thin line: from the least to the greatest ratio of the rounds;  a difference of 1 is "
                 "just visible",
                 font_,
                 quiet_ink});
        return picture_.finish(std::move(canvas_));
    }

private:
    struct Band {
        double from = 0, to = 0;
    };

    [[nodiscard]] double top() const { return 5.6 * font_; }
    [[nodiscard]] double x_of_time(double ratio) const {
        const double from = std::log(least_), to = std::log(std::max(most_, least_ * 1.1));
        return time_.from + (std::log(ratio) - from) / (to - from) * (time_.to - time_.from);
    }

    void draw_heads() {
        const double y = 3.8 * font_;
        canvas_.add(Text{{name_, y}, "effect", font_, quiet_ink});
        canvas_.add(Text{{time_.from, y}, "time with it / without it (log scale)", font_, quiet_ink});
        canvas_.add(Text{{difference_.from, y}, "difference of the image (mean ΔE2000)", font_, quiet_ink});
        canvas_.add(Stroke{{{font_, y + font_}, {size_.width - font_, y + font_}}, hair});
    }

    // Where an effect costs nothing, and where it changes nothing.
    void draw_ones(double from, double to) {
        for (const double x : {x_of_time(1), difference_.from})
            canvas_.add(Stroke{{{x, from}, {x, to}}, quiet_ink});
    }

    void draw_row(const MeasuredEffect& effect, double y, double row) {
        const Rgb colour = effect.called_for ? called_for_blue : added_orange;
        const double half = 0.3 * row;
        canvas_.add(Text{{name_, y}, effect.name, font_, ink, Font::bold});
        canvas_.add(Text{{time_.from - font_, y},
                         effect.called_for ? "called for" : "added",
                         0.9 * font_,
                         colour,
                         Font::sans,
                         Align::right});
        const double one = x_of_time(1), at = x_of_time(effect.time);
        add_bar(std::min(one, at), std::max(one, at), y, half, effect);
        const double most = x_of_time(effect.greatest_time);
        canvas_.add(Stroke{{{x_of_time(effect.least_time), y}, {most, y}}, ink});
        canvas_.add(
            Text{{std::max(most, one) + 0.5 * font_, y}, with_format("%.2f ×", effect.time), font_, ink});
        const double width = largest_ > 0 ? effect.difference / largest_ : 0;
        const double end = difference_.from + width * (difference_.to - difference_.from);
        add_bar(difference_.from, end, y, half, effect);
        canvas_.add(Text{{end + 0.5 * font_, y}, with_format("%.2f", effect.difference), font_, ink});
    }

    // Filled, or an outline: nobody has to see colours.
    void add_bar(double from, double to, double y, double half, const MeasuredEffect& effect) {
        const Rgb colour = effect.called_for ? called_for_blue : added_orange;
        if (effect.called_for)
            canvas_.add(FilledArea{{from, y - half, to - from, 2 * half}, colour});
        else
            canvas_.add(
                Stroke{{{from, y - half}, {to, y - half}, {to, y + half}, {from, y + half}, {from, y - half}},
                       colour,
                       2});
    }

    const EffectsFile& file_;
    PictureSize size_;
    double font_;
    FlatPicture picture_;
    Canvas canvas_;
    double least_ = 1, most_ = 1, largest_ = 0;
    double name_ = 0;
    Band time_, difference_;
};

} // namespace

Raster draw_effects_chart(const EffectsFile& file, const PictureSize& size) {
    return EffectsChart(file, size).draw();
}

} // namespace rayscope::drawing

#include "visualizer/drawing/canvas_item.hpp"

#include "visualizer/drawing/text.hpp"

#include <vtkBrush.h>
#include <vtkContext2D.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkObjectFactory.h>
#include <vtkPen.h>
#include <vtkRect.h>

namespace rayscope::drawing {
namespace {

// From the middle of a line of text down to the lower edge of its image, in sizes: half of a capital's height and
// what DejaVu keeps below the base line.
constexpr double below_middle = 0.36 + 0.236;

class Painter {
public:
    Painter(vtkContext2D* context, int height, int scale)
        : context_(context), height_(height), scale_(scale) {}

    void operator()(const FilledArea& shape) const {
        fill(shape.colour, shape.opacity);
        const Area& a = shape.area;
        context_->DrawRect(x(a.x), y(a.bottom()), float(a.width * scale_), float(a.height * scale_));
    }
    void operator()(const FilledPolygon& shape) const {
        fill(shape.colour, 1);
        std::vector<float> points = flat(shape.points);
        context_->DrawPolygon(points.data(), int(shape.points.size()));
    }
    void operator()(const Disc& shape) const {
        fill(shape.colour, 1);
        const auto r = float(shape.radius * scale_);
        context_->DrawEllipse(x(shape.centre.x), y(shape.centre.y), r, r);
    }
    void operator()(const Stroke& shape) const {
        vtkPen* pen = context_->GetPen();
        pen->SetColor(shape.colour.red, shape.colour.green, shape.colour.blue, 255);
        pen->SetWidth(float(shape.width * scale_));
        pen->SetLineType(vtkPen::SOLID_LINE);
        for (std::size_t i = 0; i + 1 < shape.points.size(); ++i) {
            if (shape.dashed)
                dashes(shape.points[i], shape.points[i + 1]);
            else
                line(shape.points[i], shape.points[i + 1]);
        }
    }
    void operator()(const Text& shape) const {
        if (shape.text.empty()) return;
        const Area area = text_area(shape);
        context_->ApplyTextProp(text_property(shape.font, shape.size * scale_, shape.colour));
        context_->DrawString(x(area.x), y(shape.at.y + below_middle * shape.size), shape.text.c_str());
    }

    void operator()(const Bitmap& shape) const {
        vtkNew<vtkImageData> image;
        image->SetDimensions(shape.width, shape.height, 1);
        image->AllocateScalars(VTK_UNSIGNED_CHAR, 3);
        for (int row = 0; row < shape.height; ++row) // VTK's rows come from the bottom
            for (int column = 0; column < shape.width; ++column) {
                auto* bytes =
                    static_cast<unsigned char*>(image->GetScalarPointer(column, shape.height - 1 - row, 0));
                const Rgb& pixel =
                    shape.pixels[std::size_t(row) * std::size_t(shape.width) + std::size_t(column)];
                bytes[0] = pixel.red;
                bytes[1] = pixel.green;
                bytes[2] = pixel.blue;
            }
        const Area& a = shape.area;
        context_->DrawImage(
            vtkRectf(x(a.x), y(a.bottom()), float(a.width * scale_), float(a.height * scale_)), image);
    }

private:
    [[nodiscard]] float x(double canvas) const { return float(canvas * scale_); }
    [[nodiscard]] float y(double canvas) const { return float((height_ - canvas) * scale_); }
    [[nodiscard]] std::vector<float> flat(const std::vector<Pixel>& points) const {
        std::vector<float> result;
        for (const Pixel& p : points) {
            result.push_back(x(p.x));
            result.push_back(y(p.y));
        }
        return result;
    }
    void fill(Rgb colour, double opacity) const {
        context_->GetPen()->SetLineType(vtkPen::NO_PEN);
        context_->GetBrush()->SetColor(colour.red, colour.green, colour.blue,
                                       static_cast<unsigned char>(std::lround(opacity * 255)));
    }
    void line(const Pixel& from, const Pixel& to) const {
        context_->DrawLine(x(from.x), y(from.y), x(to.x), y(to.y));
    }
    void dashes(const Pixel& from, const Pixel& to) const {
        constexpr double dash = 5, period = 9;
        const double size = std::hypot(to.x - from.x, to.y - from.y);
        const auto at = [&](double s) {
            return Pixel{from.x + (to.x - from.x) * s / size, from.y + (to.y - from.y) * s / size};
        };
        for (double s = 0; s < size; s += period) line(at(s), at(std::min(s + dash, size)));
    }

    vtkContext2D* context_;
    int height_, scale_;
};

} // namespace

vtkStandardNewMacro(CanvasItem);

void CanvasItem::show(Canvas canvas, int height, int scale) {
    canvas_ = std::move(canvas);
    height_ = height;
    scale_ = scale;
    this->Modified();
}

bool CanvasItem::Paint(vtkContext2D* painter) {
    const Painter paint(painter, height_, scale_);
    for (const Shape& shape : canvas_.shapes) std::visit(paint, shape);
    return true;
}

} // namespace rayscope::drawing

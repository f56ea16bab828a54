#include "visualizer/window/material_panel.hpp"

#include "visualizer/drawing/text.hpp"

#include <QGridLayout>

#include <algorithm>

namespace rayscope::window {
namespace {

constexpr int steps = 1000;

// Of the parts, in their order.
constexpr std::array<const char*, 7> meanings{"light that comes from everywhere",
                                              "matt: light of the lamps, scattered",
                                              "highlight: the lamps, mirrored",
                                              "how much a mirror",
                                              "how much goes through",
                                              "how small the highlight is",
                                              "of refraction: 1 air, 1.33 water, 1.5 glass, 2.4 diamond"};

} // namespace

MaterialPanel::MaterialPanel() {
    setObjectName("materials");
    names_.setObjectName("material");
    names_.setAccessibleName("Material");
    auto* grid = new QGridLayout(this);
    grid->addWidget(new QLabel("Material"), 0, 0);
    grid->addWidget(&names_, 0, 1, 1, 2);
    for (std::size_t i = 0; i < part_names.size(); ++i) {
        const QString name = QString::fromUtf8(part_names.at(i).data());
        auto* slider = new QSlider(Qt::Horizontal);
        slider->setObjectName("slider_" + name);
        slider->setAccessibleName(name);
        slider->setRange(0, steps);
        slider->setToolTip(meanings.at(i));
        auto* value = new QLabel;
        value->setMinimumWidth(90);
        rows_.push_back({new QLabel(name), slider, value});
        grid->addWidget(rows_.back().name, int(i) + 1, 0);
        grid->addWidget(slider, int(i) + 1, 1);
        grid->addWidget(value, int(i) + 1, 2);
        QObject::connect(slider, &QSlider::valueChanged, this, [this, i] { slid(i); });
        QObject::connect(slider, &QSlider::sliderPressed, this, [this] { sliding_ = false; });
    }
    note_.setWordWrap(true);
    note_.setText(
        "The rays and the image follow. A colour keeps its hue. reflection + transmission is at most 1.\n"
        "Ctrl+Z takes a change back; Ctrl+S writes the numbers into the scene's file, and nothing else.");
    grid->addWidget(&note_, int(rows_.size()) + 1, 0, 1, 3);
    grid->setRowStretch(int(rows_.size()) + 2, 1);
    grid->setColumnStretch(1, 1);
    QObject::connect(&names_, QOverload<int>::of(&QComboBox::currentIndexChanged), this,
                     [this] { show_numbers(); });
}

void MaterialPanel::show_scene(const Scene& scene) {
    const bool same =
        scene.materials.size() == materials_.size() &&
        std::ranges::equal(scene.materials, materials_, {}, &SceneMaterial::name, &SceneMaterial::name);
    materials_ = scene.materials;
    if (!same) {
        showing_ = true;
        names_.clear();
        for (const SceneMaterial& material : materials_)
            names_.addItem(QString::fromStdString(material.name));
        showing_ = false;
    }
    show_numbers();
}

void MaterialPanel::choose(std::size_t material) {
    if (material < materials_.size()) names_.setCurrentIndex(int(material));
}

void MaterialPanel::show_numbers() {
    if (showing_) return;
    showing_ = true;
    const bool any = chosen() < materials_.size();
    for (std::size_t i = 0; i < rows_.size(); ++i) {
        const auto part = MaterialPart(i);
        Row& row = rows_[i];
        const bool patterned = any && is_patterned(materials_[chosen()], part);
        row.slider->setEnabled(any && !patterned);
        if (!any) {
            row.value->clear();
            continue;
        }
        const double value = part_of(materials_[chosen()], part);
        row.most = std::max(range_of(part), value);
        if (!row.slider->isSliderDown()) row.slider->setValue(int(std::lround(value / row.most * steps)));
        row.value->setText(patterned ? "a pattern" : QString::fromStdString(drawing::number(value, 4)));
    }
    showing_ = false;
}

void MaterialPanel::slid(std::size_t index) {
    if (showing_ || chosen() >= materials_.size() || !on_change) return;
    const auto part = MaterialPart(index);
    const Row& row = rows_[index];
    double value = row.most * row.slider->value() / steps;
    if (part == MaterialPart::index) value = std::max(value, 0.1);
    value = std::min(value, std::max(most_of(materials_[chosen()], part), 0.0));
    const bool continues = row.slider->isSliderDown() && sliding_;
    sliding_ = row.slider->isSliderDown();
    // To four digits: what the file will say is what one reads here.
    const double rounded =
        part == MaterialPart::shininess ? std::round(value) : std::round(value * 1000) / 1000;
    on_change(chosen(), part, rounded, continues);
}

bool MaterialPanel::slide(const std::string& part, double value) {
    for (std::size_t i = 0; i < rows_.size(); ++i)
        if (part_names.at(i) == part && rows_[i].slider->isEnabled()) {
            rows_[i].slider->setValue(int(std::lround(value / rows_[i].most * steps)));
            return true;
        }
    return false;
}

QStringList MaterialPanel::values() const {
    QStringList texts;
    for (const Row& row : rows_) texts << row.name->text() + " " + row.value->text();
    return texts;
}

} // namespace rayscope::window

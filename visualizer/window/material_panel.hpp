#pragma once
// A material's numbers as sliders: the image and the rays follow while one drags.

#include "visualizer/window/scene_edit.hpp"

#include <QComboBox>
#include <QLabel>
#include <QSlider>
#include <QWidget>

#include <functional>

namespace rayscope::window {

class MaterialPanel : public QWidget {
public:
    MaterialPanel();

    /// @param continues the same drag goes on
    std::function<void(std::size_t material, MaterialPart part, double value, bool continues)> on_change;

    /// Another scene, or the same one with other numbers.
    void show_scene(const Scene& scene);
    void choose(std::size_t material);
    [[nodiscard]] std::size_t chosen() const { return std::size_t(std::max(names_.currentIndex(), 0)); }
    /// As a person's drag would; false: there is no such part, or it can't be changed.
    [[nodiscard]] bool slide(const std::string& part, double value);
    [[nodiscard]] QStringList values() const;

private:
    void show_numbers();
    void slid(std::size_t part);

    struct Row {
        QLabel* name;
        QSlider* slider;
        QLabel* value;
        double most = 1;
    };
    std::vector<SceneMaterial> materials_;
    QComboBox names_;
    std::vector<Row> rows_;
    QLabel note_;
    bool showing_ = false, sliding_ = false;
};

} // namespace rayscope::window

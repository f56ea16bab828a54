#pragma once
// Scenes made in code.

#include "core/csg/expression.hpp"
#include "core/rayscope.hpp"
#include "tests/support/matrices.hpp"

#include <stdexcept>

namespace rayscope::test {

/// Adds one thing after the other; ids are indices in the order of adding.
class SceneBuilder {
public:
    SceneBuilder() { scene_.file = "test"; }

    [[nodiscard]] Scene& scene() { return scene_; }

    std::size_t material(SceneMaterial material) {
        scene_.materials.push_back(std::move(material));
        return scene_.materials.size() - 1;
    }
    /// Ambient light alone: the colour that a ray brings back is the material's.
    std::size_t glowing(const Colour& colour) {
        SceneMaterial m = dark();
        m.ambient = colour;
        return material(m);
    }
    /// No light of its own.
    std::size_t clear(double reflection, double transmission, double index) {
        SceneMaterial m = dark();
        m.reflection = Colour{reflection};
        m.transmission = Colour{transmission};
        m.speed = 1 / index;
        return material(m);
    }
    [[nodiscard]] static SceneMaterial dark() {
        SceneMaterial m;
        m.name = "dark";
        m.ambient = m.diffuse = m.specular = Colour{0};
        return m;
    }

    /// A drawn generic; returns its index among the generics.
    std::size_t generic(const Generic<double>& shape, const Mat4d& matrix, std::size_t material,
                        std::string name = {}, int priority = 0) {
        const std::size_t index = operand(std::move(name), shape, matrix);
        scene_.generics.back().material = material;
        scene_.generics.back().visible = true;
        scene_.generics.back().priority = priority;
        scene_.drawn.push_back({false, index});
        return index;
    }
    /// A generic for compounds, not drawn.
    std::size_t operand(std::string name, const Generic<double>& shape, const Mat4d& matrix = Mat4d{1}) {
        SceneGeneric g;
        g.name = std::move(name);
        g.shape = shape;
        g.matrix = matrix;
        g.visible = false;
        scene_.generics.push_back(std::move(g));
        return scene_.generics.size() - 1;
    }
    /// A compound of operands and compounds that are there; drawn if it has a material.
    std::size_t compound(std::string name, const std::string& expression,
                         std::optional<std::size_t> material = std::nullopt, const Mat4d& matrix = Mat4d{1},
                         int priority = 0) {
        SceneCompound c;
        c.name = std::move(name);
        c.expression = expression;
        for (const ExpressionNode& node : parse_expression(expression)) {
            SceneNode n;
            n.operation = node.operation;
            n.left = node.left;
            n.right = node.right;
            if (node.operation == Operation::leaf) find(node.name, n);
            c.nodes.push_back(n);
        }
        c.matrix = matrix;
        c.material = material;
        c.priority = priority;
        c.visible = material.has_value();
        scene_.compounds.push_back(std::move(c));
        if (material) scene_.drawn.push_back({true, scene_.compounds.size() - 1});
        return scene_.compounds.size() - 1;
    }

    SceneLight& light(const Vec3d& position, const Colour& colour = Colour{1}) {
        SceneLight l;
        l.name = "lamp";
        l.position = position;
        l.colour = colour;
        scene_.lights.push_back(l);
        return scene_.lights.back();
    }
    SceneLight& sun(const Vec3d& towards, const Colour& colour = Colour{1}) {
        SceneLight& l = light(normalized(towards), colour);
        l.directional = true;
        return l;
    }

    [[nodiscard]] Workbench open() const { return make_workbench(scene_); }

private:
    void find(std::string_view name, SceneNode& node) const {
        for (std::size_t i = 0; i < scene_.generics.size(); ++i)
            if (scene_.generics[i].name == name) {
                node.operand = i;
                return;
            }
        for (std::size_t i = 0; i < scene_.compounds.size(); ++i)
            if (scene_.compounds[i].name == name) {
                node.is_compound = true;
                node.operand = i;
                return;
            }
        throw std::invalid_argument("no operand is called " + std::string(name));
    }

    Scene scene_;
};

} // namespace rayscope::test

#pragma once
// A scene as its author wrote it: names, places in the file, angles in degrees.

#include "core/generics/generic.hpp"
#include "core/scene/input_error.hpp"
#include "core/trace/operation.hpp"
#include "core/world/camera.hpp"
#include "core/world/effect_set.hpp"
#include "core/world/light_area.hpp"
#include "core/world/world.hpp"

#include <optional>
#include <string>
#include <vector>

namespace rayscope {

struct SceneLight {
    std::string name;
    bool directional = false;
    Vec3d position{0}; ///< of a point light; for a directional one the unit direction *towards* the light
    Colour colour{1};
    bool shadows = true; ///< objects cast them
    LightArea area;      ///< of a light that is no point
    Place place;

    /// What brings no light needs no shadow ray, and one point of it tells.
    [[nodiscard]] bool shines() const { return largest_component(colour) > 0; }
};

struct SceneMaterial {
    std::string name;
    Colour ambient{0.1}, diffuse{0.7}, specular{0};
    double shininess = 32;
    Colour reflection{0}, transmission{0};
    double speed = 1; ///< of light inside, air 1; the index of refraction is its inverse
    Mirror mirror = Mirror::constant;
    Colour absorption{0};  ///< of light inside, for each unit of length
    Dispersion dispersion; ///< how the index depends on the wavelength
    Patterns patterns;     ///< in place of coefficients

    /// Whether light goes through.
    [[nodiscard]] bool transmits() const;
    Place place;
};

/// A generic shape with its matrix and its material.
struct SceneGeneric {
    std::string name; ///< may be empty in files that do not name (NFF)
    Generic<double> shape;
    Mat4d matrix{1};                     ///< object → world (or → the compound's space)
    std::optional<std::size_t> material; ///< index into materials; needed where it is drawn by itself
    int priority = 0;
    bool visible = true; ///< drawn by itself
    Place place;
};

/// One node of a compound's expression.
struct SceneNode {
    Operation operation = Operation::leaf;
    std::size_t left = 0, right = 0; ///< operands: nodes of the same compound; complement uses left only
    bool is_compound = false;        ///< a leaf names a compound …
    std::size_t operand = 0;         ///< … index into compounds, else into generics
    Place place;
};

struct SceneCompound {
    std::string name;
    std::string expression;
    std::vector<SceneNode> nodes; ///< children before parents; the last one is the root
    Mat4d matrix{1};
    std::optional<std::size_t> material; ///< needed where it is drawn
    int priority = 0;
    bool visible = true;
    Place place;
};

/// Objects in the order of the file: ties between equal t go to the first.
struct SceneObject {
    bool is_compound = false;
    std::size_t index = 0;
};

struct Limits {
    int max_depth = 8;
    double min_weight = 0.001;
    int wavelengths = 8;   ///< behind a boundary that spreads colours
    int max_rays = 100000; ///< per sample; a guard for scenes whose recursion neither limit would end in time
};

struct Scene {
    std::string file;
    Camera camera;
    Place samples_place; ///< of the camera's, where they are asked for
    Colour background{0};
    Colour ambient{1};
    bool shadows = true;      ///< of lights that say nothing else
    bool notes_media = false; ///< the notes' rule: always air outside
    double medium_speed = 1;  ///< of what fills the space between the solids
    Limits limits;
    std::optional<EffectSet>
        effects;          ///< those that the author wants, and no other; none: those that the scene calls for
    EffectSet taken_away; ///< of those that the scene calls for: a person wanted none of them
    EffectSet went_along; ///< of those that the scene calls for: what called for them was taken away
    EffectSet added;      ///< that the scene does not call for: a person wanted them
    std::optional<std::pair<int, int>> step_pixel;
    std::vector<SceneLight> lights;
    std::vector<SceneMaterial> materials;
    std::vector<SceneGeneric> generics;
    std::vector<SceneCompound> compounds;
    std::vector<SceneObject> drawn;    ///< what the rays can hit
    std::vector<std::string> warnings; ///< "file:line:column: message", for a person to read
};

} // namespace rayscope

#include "core/scene/read_nff.hpp"

#include "core/math/decimals.hpp"
#include "core/scene/mesh_builder.hpp"
#include "core/scene/nff_tokens.hpp"
#include "core/scene/nff_tube.hpp"
#include "core/scene/polygon_check.hpp"
#include "core/scene/source_text.hpp"
#include "core/scene/view_check.hpp"
#include "core/scene/wording.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace rayscope {
namespace {

constexpr std::size_t most_nff_bytes = std::size_t(1) << 30U;
constexpr std::size_t most_warnings = 20;
constexpr int most_vertices = 1000000;
// Within these a sphere's matrix can be inverted.
constexpr double smallest_radius = 1e-100, largest_radius = 1e100;

constexpr std::array<std::string_view, 6> view_lines{"from", "at", "up", "angle", "hither", "resolution"};

// Lines that begin like an object. A guess, but nearly always the exact number.
std::size_t count_objects(std::string_view text) {
    std::size_t count = 0;
    for (std::size_t i = 0; i < text.size(); i = std::min(text.find_first_of("\r\n", i), text.size() - 1) + 1)
        if (text[i] == 's' || text[i] == 'p' || text[i] == 'c') ++count;
    return count;
}

class NffReader {
public:
    NffReader(std::string_view text, std::string file) : tokens_(std::move(file), text) {
        scene_.file = tokens_.file();
        scene_.limits.max_depth = 4; // the format's customary 5 counts the eye ray
        scene_.limits.min_weight = 0;
        // Growing step by step would take longer than all the reading.
        scene_.generics.reserve(count_objects(text));
        scene_.drawn.reserve(scene_.generics.capacity());
    }

    Scene read() {
        if (tokens_.at_end()) fail_at_end("the file is empty, expected a scene");
        while (!tokens_.at_end()) read_command(tokens_.take());
        if (!has_view_) fail_at_end("the file has no viewpoint: expected 'v' with from, at, up and angle");
        finish_lights();
        if (scene_.generics.empty()) warn(tokens_.peek(), "nothing is drawn: the scene has no objects");
        if (warnings_ > most_warnings)
            scene_.warnings.push_back(
                fmt::format("{}: {} more warnings of this kind", tokens_.file(), warnings_ - most_warnings));
        return std::move(scene_);
    }

private:
    void read_command(const NffToken& command) {
        const std::string_view word = command.text;
        if (word == "s") return read_sphere(command);
        if (word == "f") return read_material(command);
        if (word == "c") return read_tube(command);
        if (word == "p") return read_polygon(command, false);
        if (word == "pp") return read_polygon(command, true);
        if (word == "l") return read_light(command);
        if (word == "v") return read_view(command);
        if (word != "b")
            tokens_.fail(command, fmt::format("expected a command (b, v, l, f, c, s, p or pp), found {}",
                                              in_quotes(word)));
        scene_.background = colour("the background");
    }

    void read_view(const NffToken& command) {
        std::vector<std::string_view> found;
        // Its lines may come in any order; a word that is none of them ends it.
        while (std::find(view_lines.begin(), view_lines.end(), tokens_.peek().text) != view_lines.end()) {
            found.push_back(tokens_.take().text);
            read_view_line(found.back());
        }
        for (const std::string_view line : {"from", "at", "up", "angle"})
            if (std::find(found.begin(), found.end(), line) == found.end())
                tokens_.fail(command, fmt::format("the viewpoint has no '{}'", line));
        if (const auto problem = view_problem(scene_.camera, "from", "at")) tokens_.fail(command, *problem);
        has_view_ = true;
    }

    void read_view_line(std::string_view line) {
        Camera& camera = scene_.camera;
        if (line == "from") {
            camera.eye = tokens_.vector("the eye's coordinates");
        } else if (line == "at") {
            camera.look_at = tokens_.vector("coordinates of the point looked at");
        } else if (line == "up") {
            camera.up = tokens_.vector("the direction up");
        } else if (line == "angle") {
            const NffToken token = tokens_.peek();
            camera.field_of_view = tokens_.number("the angle of view");
            if (!(camera.field_of_view > 0 && camera.field_of_view < 180))
                tokens_.fail(
                    token, fmt::format("expected an angle between 0 and 180 degrees, found {}", token.text));
        } else if (line == "resolution") {
            const NffToken token = tokens_.peek();
            camera.width = tokens_.integer("the width", 1, largest_side);
            camera.height = tokens_.integer("the height", 1, largest_side);
            if (double(camera.width) * camera.height > most_pixels)
                tokens_.fail(token, "the resolution is more than 10^8 pixels");
        } else {
            (void)tokens_.number("the distance of the near plane"); // nothing is clipped
        }
    }

    void read_light(const NffToken& command) {
        SceneLight light;
        light.name = fmt::format("l{}", scene_.lights.size() + 1);
        light.place = command.place;
        light.position = tokens_.vector("a light's coordinates");
        if (tokens_.number_follows())
            light.colour = colour("a light's colour");
        else
            white_lights_.push_back(scene_.lights.size());
        scene_.lights.push_back(std::move(light));
    }

    // Together, lights without a colour are as bright however many they are.
    void finish_lights() {
        for (const std::size_t light : white_lights_)
            scene_.lights[light].colour = Colour{1 / std::sqrt(double(scene_.lights.size()))};
    }

    void read_material(const NffToken& command) {
        SceneMaterial material;
        material.name = fmt::format("f{}", scene_.materials.size() + 1);
        material.place = command.place;
        const Colour fill = colour("a material's colour");
        const double diffuse = not_negative("a material's diffuse share");
        const double specular = not_negative("a material's specular share");
        material.ambient = Colour{0};
        material.diffuse = diffuse * fill;
        material.specular = material.reflection = Colour{specular};
        material.shininess = not_negative("a material's shine");
        const double transmission = not_negative("a material's transmission");
        material.transmission = Colour{transmission};
        const NffToken token = tokens_.peek();
        const double index = tokens_.number("a material's index of refraction");
        if (index > 0 && !(index >= 1 / 1e6 && index <= 1e6))
            tokens_.fail(token, fmt::format("expected an index of refraction from 1e-06 to 1e+06, found {}",
                                            token.text));
        material.speed = index > 0 ? 1 / index : 1;
        if (specular + transmission > 1 + 4 * epsilon<double>)
            warn(command, fmt::format("reflection + transmission is {:.6g}, more light than arrives",
                                      specular + transmission));
        scene_.materials.push_back(std::move(material));
    }

    void read_sphere(const NffToken& command) {
        const Vec3d centre = tokens_.vector("a sphere's coordinates");
        // A negative radius means seen from inside: the surface is the same.
        const double radius = magnitude(tokens_.number("a sphere's radius"));
        if (!(radius >= smallest_radius && radius <= largest_radius))
            return warn(command, fmt::format("a sphere of radius {} is left out", radius));
        Mat4d matrix{radius};
        matrix[3] = {centre.x, centre.y, centre.z, 1};
        draw(command, Sphere<double>{}, matrix);
    }

    void read_tube(const NffToken& command) {
        TubeEnd base, apex;
        for (TubeEnd* end : {&base, &apex}) {
            end->centre = tokens_.vector("a cone's coordinates");
            end->radius = tokens_.number("a cone's radius");
        }
        if (const auto tube = place_tube(base, apex))
            draw(command, tube->shape, tube->matrix);
        else
            warn(command, "a cone without length or radius is left out");
    }

    void read_polygon(const NffToken& command, bool with_normals) {
        const int count = tokens_.integer("the number of vertices", 0, most_vertices);
        std::vector<Vec3d> vertices, normals;
        for (int i = 0; i < count; ++i) {
            vertices.push_back(tokens_.vector("a vertex's coordinates"));
            if (with_normals) normals.push_back(tokens_.vector("a vertex's normal"));
        }
        if (std::any_of(normals.begin(), normals.end(), [](const Vec3d& n) { return length(n) == 0; })) {
            warn(command, "a normal has length zero: the polygon is shaded as a flat one");
            normals.clear();
        }
        add_polygon(command, std::move(vertices), std::move(normals));
    }

    void add_polygon(const NffToken& command, std::vector<Vec3d> vertices, std::vector<Vec3d> normals) {
        const bool can_cut = vertices.size() <= mesh_limits::most_corners;
        if (const auto problem = polygon_problem(vertices, flatness_of(vertices))) {
            const bool only_bent = !polygon_problem(vertices, infinity<double>);
            if (!only_bent) return warn(command, *problem + "; it is left out");
            if (vertices.size() > 3) {
                if (can_cut) return add_triangles(command, vertices, normals);
                return warn(command, fmt::format("{}, and of more than {} it is not cut; it is left out",
                                                 *problem, mesh_limits::most_corners));
            }
        }
        if (!normals.empty() && !is_fan(vertices)) {
            if (can_cut) return add_triangles(command, vertices, normals);
            warn(command, fmt::format("a smooth polygon of more than {} vertices that is no fan around its "
                                      "first is shaded as a flat one",
                                      mesh_limits::most_corners));
            normals.clear();
        }
        draw(command, Polygon<double>(std::move(vertices), std::move(normals)), Mat4d{1});
    }

    // In the polygon's size. Where it lies farther off its plane than rounding explains, that plane would stand out of its
    // neighbours' along their common edges, and throw shadows on them.
    [[nodiscard]] static double flatness_of(const std::vector<Vec3d>& vertices) {
        double largest = 0, size = 0;
        for (const Vec3d& vertex : vertices) {
            largest = maximum(largest, largest_component(absolute(vertex)));
            size = maximum(size, length(vertex - vertices[0]));
        }
        return minimum(maximum(decimals::six_digits * largest / size, decimals::flatness),
                       decimals::largest_flatness);
    }

    // What is not flat, or has normals that no fan of triangles interpolates. Triangles without area are not drawn.
    void add_triangles(const NffToken& command, const std::vector<Vec3d>& vertices,
                       const std::vector<Vec3d>& normals) {
        Triangulation triangulation;
        for (const MeshData::Corners& t : triangulation.of(vertices)) {
            const auto three = [&](const std::vector<Vec3d>& of) {
                return of.empty() ? of : std::vector<Vec3d>{of[t[0]], of[t[1]], of[t[2]]};
            };
            std::vector<Vec3d> corners = three(vertices);
            if (!polygon_problem(corners, infinity<double>))
                draw(command, Polygon<double>(std::move(corners), three(normals)), Mat4d{1});
        }
    }

    void draw(const NffToken& command, Generic<double> shape, const Mat4d& matrix) {
        if (scene_.materials.empty())
            tokens_.fail(command, "expected a material (f) before the first object");
        scene_.drawn.push_back({false, scene_.generics.size()});
        scene_.generics.push_back(
            {{}, std::move(shape), matrix, scene_.materials.size() - 1, 0, true, command.place});
    }

    double not_negative(std::string_view what) {
        const NffToken token = tokens_.peek();
        const double x = tokens_.number(what);
        if (x < 0) tokens_.fail(token, fmt::format("expected {}, not negative, found {}", what, token.text));
        return x;
    }

    Colour colour(std::string_view what) {
        const double red = not_negative(what), green = not_negative(what), blue = not_negative(what);
        return {red, green, blue};
    }

    void warn(const NffToken& token, const std::string& message) {
        if (++warnings_ <= most_warnings)
            scene_.warnings.emplace_back(InputError(tokens_.file(), token.place, message).what());
    }

    [[noreturn]] void fail_at_end(const std::string& message) const { tokens_.fail(tokens_.peek(), message); }

    NffTokens tokens_;
    Scene scene_;
    bool has_view_ = false;
    std::vector<std::size_t> white_lights_;
    std::size_t warnings_ = 0;
};

} // namespace

Scene parse_nff(std::string_view text, std::string file) { return NffReader(text, std::move(file)).read(); }

Scene read_nff(const std::filesystem::path& path) {
    return parse_nff(read_file(path, most_nff_bytes), path.string());
}

} // namespace rayscope

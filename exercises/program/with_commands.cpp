// render and step with a student's function in place of ours: the picture that it makes, and where a ray goes another way.

#include "core/scene/input_error.hpp"
#include "exercises/grader/divergence_text.hpp"
#include "exercises/grader/served_formulas.hpp"
#include "exercises/grader/units.hpp"
#include "exercises/program/commands.hpp"
#include "exercises/program/failure.hpp"
#include "exercises/program/screen.hpp"
#include "exercises/program/workspace.hpp"

#include <fmt/format.h>

#include <cmath>
#include <cstdio>
#include <cstdlib>

namespace rayscope::exercises {
namespace fs = std::filesystem;
namespace {

constexpr int usual_width = 240; // each formula is a call of another process
constexpr int gap = 8;           // between the panels
constexpr std::chrono::hours most_served{1};

fs::path find_scene(const std::string& text) {
    if (fs::is_regular_file(text)) return text;
    const fs::path chapters = fs::path(RAYSCOPE_EXERCISES).parent_path() / "chapters";
    for (const auto& entry : fs::recursive_directory_iterator(chapters))
        if (entry.path().extension() == ".toml" && entry.path().stem() == text) return entry.path();
    throw UsageError(fmt::format("no scene file '{}', and no shipped scene of that name", text));
}

/// The student's program of an exercise, compiled.
struct Substitute {
    const Exercise* exercise;
    fs::path program;
};
Substitute substitute(const Context& context, const Toolchain& toolchain, const std::string& name) {
    const bool is_file = fs::is_regular_file(name);
    const Exercise& exercise =
        find_exercise(context.catalogue, is_file ? fs::path(name).stem().string() : name);
    if (exercise.formula.empty()) {
        std::string known;
        for (const Exercise* one : with_formulas(context.catalogue))
            known += (known.empty() ? "" : ", ") + one->id;
        throw UsageError(fmt::format(
            "--with {}: that function is no formula of the tracer; expected one of: {}", name, known));
    }
    const fs::path file = is_file ? fs::path(name) : find_workspace(context.options.workspace).file(exercise);
    const Compiled built = toolchain.kept(answer_unit(exercise, read_code(file)));
    if (!built.program.empty()) return {&exercise, built.program};
    for (const Diagnostic& diagnostic : built.diagnostics)
        if (diagnostic.error)
            throw InputError(file.string(), {diagnostic.line, diagnostic.column}, diagnostic.message);
    throw InputError(file.string(), {}, built.problem);
}

/// "WxH", or `fallback`.
std::pair<int, int> size_of(const std::optional<std::string>& text, std::pair<int, int> fallback) {
    if (!text) return fallback;
    int width = 0, height = 0, end = 0;
    if (std::sscanf(text->c_str(), "%5dx%5d%n", &width, &height, &end) != 2 ||
        std::size_t(end) != text->size() || width < 1 || height < 1 || width > 2048 || height > 2048)
        throw UsageError(fmt::format("--size: expected WxH, 1 to 2048 each, found '{}'", *text));
    return {width, height};
}

Colour pixel(const Image& image, int x, int y) {
    const float* at = &image.rgb[3 * (std::size_t(y) * std::size_t(image.width) + std::size_t(x))];
    return {double(at[0]), double(at[1]), double(at[2])};
}

/// How far two colours are apart, as they are shown: 0 to 1.
double shown_difference(const Colour& a, const Colour& b) {
    const auto one = srgb_bytes(a), other = srgb_bytes(b);
    int most = 0;
    for (std::size_t i = 0; i < 3; ++i) most = std::max(most, std::abs(int(one[i]) - int(other[i])));
    return most / 255.0;
}

struct Panels {
    Image image;
    int different = 0; ///< pixels
    int worst_x = 0, worst_y = 0;
};

/// The student's, ours, and where they differ.
Panels panels_of(const Image& theirs, const Image& ours) {
    Panels panels{Image(3 * ours.width + 2 * gap, ours.height), 0, 0, 0};
    double worst = 0;
    for (int y = 0; y < ours.height; ++y) {
        for (int x = 0; x < panels.image.width; ++x) panels.image.set(x, y, Colour{1});
        for (int x = 0; x < ours.width; ++x) {
            const Colour a = pixel(theirs, x, y), b = pixel(ours, x, y);
            const double difference = shown_difference(a, b);
            panels.image.set(x, y, a);
            panels.image.set(ours.width + gap + x, y, b);
            // One byte apart may be rounding; it is shown, but in the dark.
            panels.image.set(2 * (ours.width + gap) + x, y, Colour{difference, 0.3 * difference, 0});
            if (difference * 255 <= 1.5) continue;
            ++panels.different;
            if (difference > worst) worst = difference, panels.worst_x = x, panels.worst_y = y;
        }
    }
    return panels;
}

} // namespace

int run(const Context& context, const RenderWith& command) {
    if (!is_image_path(command.output))
        throw UsageError(fmt::format("-o: expected a file that ends in .png, .pfm or .exr, found '{}'",
                                     command.output.string()));
    check_writable(command.output);
    const fs::path scene = find_scene(command.scene);
    const Workbench bench = open(scene);
    const auto toolchain = make_toolchain(context);
    const Substitute mine = substitute(context, *toolchain, command.with);
    const Camera& camera = bench.scene.camera;
    const int width = std::min(usual_width, camera.width);
    RenderOptions options;
    std::tie(options.width, options.height) =
        size_of(command.size, {width, std::max(1, width * camera.height / camera.width)});
    const Image ours = render(bench, options).image;
    const Image theirs =
        render(bench, served_formulas(*toolchain, *mine.exercise, mine.program, most_served), options).image;
    const Panels panels = panels_of(theirs, ours);
    write_image(panels.image, command.output);
    std::printf("%s: with your function, with ours, and the difference\n", command.output.c_str());
    if (panels.different == 0) {
        std::puts("The images are the same.");
        return done;
    }
    std::printf("%d of %d pixels differ. The ray that differs most, in both runs:\n  %s step %s --with %s "
                "--pixel %d,%d --size %dx%d\n",
                panels.different, ours.width * ours.height, launcher().c_str(), scene.c_str(),
                command.with.c_str(), panels.worst_x, panels.worst_y, ours.width, ours.height);
    return failed;
}

int run(const Context& context, const StepWith& command) {
    const Workbench bench = open(find_scene(command.scene));
    const Camera& camera = bench.scene.camera;
    const auto toolchain = make_toolchain(context);
    const Substitute mine = substitute(context, *toolchain, command.with);
    const Formulas formulas = served_formulas(*toolchain, *mine.exercise, mine.program, most_served);
    const auto [width, height] = size_of(command.size, {camera.width, camera.height});
    Trace ours, theirs;
    if (command.ray) {
        Ray<double> ray;
        int end = 0;
        if (std::sscanf(command.ray->c_str(), "%lf,%lf,%lf,%lf,%lf,%lf%n", &ray.origin.x, &ray.origin.y,
                        &ray.origin.z, &ray.direction.x, &ray.direction.y, &ray.direction.z, &end) != 6 ||
            std::size_t(end) != command.ray->size() || !(dot(ray.direction, ray.direction) > 0) ||
            !std::isfinite(dot(ray.origin, ray.origin) + dot(ray.direction, ray.direction)))
            throw UsageError("--ray: expected ox,oy,oz,dx,dy,dz, with a direction that is not 0");
        ours = trace_ray(bench, ray);
        theirs = trace_ray(bench, formulas, ray);
    } else {
        int x = width / 2, y = height / 2, end = 0;
        if (command.pixel && (std::sscanf(command.pixel->c_str(), "%6d,%6d%n", &x, &y, &end) != 2 ||
                              std::size_t(end) != command.pixel->size()))
            throw UsageError(fmt::format("--pixel: expected X,Y, found '{}'", *command.pixel));
        if (x < 0 || y < 0 || x >= width || y >= height)
            throw UsageError(
                fmt::format("--pixel: {},{} lies outside the image of {}x{}", x, y, width, height));
        ours = trace_pixel(bench, x, y, width, height);
        theirs = trace_pixel(bench, formulas, x, y, width, height);
    }
    const DivergenceText text = divergence_text(ours, theirs);
    std::fputs(text.text.c_str(), stdout);
    return text.parted ? failed : done;
}

} // namespace rayscope::exercises

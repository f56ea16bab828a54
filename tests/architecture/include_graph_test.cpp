// The include graph keeps the floors: math, trace, generics …, csg, world, stages, tracer, and the programs on top.

#include "tests/architecture/include_rules.hpp"
#include "tests/architecture/source_text.hpp"

#include <gmock/gmock.h>

#include <regex>

namespace rayscope::test {
namespace {

struct Include {
    std::string file; ///< from the top level
    std::size_t line = 0;
    std::string target;
    bool quoted = false;
};

std::vector<Include> includes_under(const char* folder) {
    static const std::regex pattern(R"re(^\s*#\s*include\s*([<"])([^>"]+)[>"])re");
    std::vector<Include> found;
    for (const auto& file : sources_under(source_tree / folder)) {
        const auto lines = without_comments(lines_of(file));
        for (std::size_t i = 0; i < lines.size(); ++i) {
            std::smatch match;
            if (std::regex_search(lines[i], match, pattern))
                found.push_back({file.lexically_relative(source_tree).generic_string(), i + 1, match[2],
                                 match[1] == "\""});
        }
    }
    return found;
}

TEST(IncludeGraph, keeps_the_floors) {
    EXPECT_GT(includes_under("core").size(), 20U) << "nothing was read under " << source_tree;
    for (const char* folder : {"core", "chapters", "exercises", "visualizer", "bench"})
        for (const Include& include : includes_under(folder))
            if (const auto rule = broken_rule(include.file, include.target))
                ADD_FAILURE() << include.file << ":" << include.line << ": includes " << include.target
                              << ", but " << *rule;
}

TEST(IncludeGraph, include_path_is_folder_path) {
    for (const char* folder : {"core", "chapters", "visualizer", "bench", "tests"})
        for (const Include& include : includes_under(folder))
            if (include.quoted && !std::filesystem::exists(source_tree / include.target))
                ADD_FAILURE() << include.file << ":" << include.line << ": \"" << include.target
                              << "\" is no path from the top level";
}

struct Edge {
    const char *from, *to;
};

TEST(IncludeRules, refuse_what_lies_higher_or_beside) {
    for (const Edge edge : {
             Edge{"core/math/vec.hpp", "core/trace/trace.hpp"},
             {"core/image/image.hpp", "core/trace/trace.hpp"},
             {"core/trace/events.hpp", "core/generics/spans.hpp"},
             {"core/generics/sphere.hpp", "core/csg/sweep.hpp"},
             {"core/generics/sphere.hpp", "core/shading/phong.hpp"},
             {"core/csg/sweep.cpp", "core/world/world.hpp"},
             {"core/world/world.hpp", "core/scene/scene.hpp"},
             {"core/world/world.hpp", "core/extents/scan.hpp"},
             {"core/octree/octree.hpp", "core/bvh/bvh.hpp"},
             {"core/extents/scan.hpp", "core/tracer/tracer.hpp"},
             {"core/tracer/tracer.hpp", "core/scene/scene.hpp"},
             {"core/tracer/batch/queue.hpp", "core/accuracy/reference.hpp"},
             {"core/tracer/tracer.hpp", "core/rayscope.hpp"},
             {"core/scene/build.cpp", "core/tracer/tracer.hpp"},
             {"core/scene/build.cpp", "core/effects/effects.hpp"},
             {"core/nowhere/a.hpp", "core/math/vec.hpp"},
             {"core/rayscope.cpp", "visualizer/cli/step.hpp"},
             {"core/math/vec.hpp", "tests/support/hex.hpp"},
             {"core/math/vec.hpp", "vtkMath.h"},
             {"core/math/vec.hpp", "QVector3D"},
             {"core/math/vec.hpp", "QtGui/QVector3D"},
             {"visualizer/cli/main.cpp", "vtkActor.h"},
             {"visualizer/page/page.cpp", "vtkActor.h"},
             {"visualizer/cli/main.cpp", "core/tracer/tracer.hpp"},
             {"visualizer/cli/main.cpp", "visualizer/drawing/drawing.hpp"},
             {"visualizer/drawing/drawing.cpp", "visualizer/cli/text.hpp"},
             {"visualizer/cli/main.cpp", "chapters/01_rays/lesson.hpp"},
             {"chapters/01_rays/lesson.cpp", "exercises/grader/grader.hpp"},
             {"chapters/01_rays/lesson.cpp", "visualizer/cli/text.hpp"},
             {"bench/spheres.cpp", "visualizer/drawing/drawing.hpp"},
             {"bench/spheres.cpp", "tests/support/hex.hpp"},
         })
        EXPECT_TRUE(broken_rule(edge.from, edge.to)) << edge.from << " → " << edge.to;
}

TEST(IncludeRules, allow_what_lies_lower) {
    for (const Edge edge : {
             Edge{"core/math/vec.hpp", "core/math/scalar.hpp"},
             {"core/math/vec.hpp", "glm/vec3.hpp"},
             {"core/math/vec.hpp", "vector"},
             {"core/image/image.cpp", "core/math/vec.hpp"},
             {"core/generics/sphere.hpp", "core/math/roots.hpp"},
             {"core/csg/sweep.cpp", "core/generics/spans.hpp"},
             {"core/world/world.hpp", "core/csg/compound.hpp"},
             {"core/octree/octree.hpp", "core/world/world.hpp"},
             {"core/tracer/tracer.hpp", "core/octree/octree.hpp"},
             {"core/tracer/render.cpp", "core/image/image.hpp"},
             {"core/tracer/batch/queue.hpp", "core/tracer/tracer.hpp"},
             {"core/accuracy/reference.cpp", "core/tracer/tracer.hpp"},
             {"core/scene/build.cpp", "core/world/world.hpp"},
             {"core/effects/effects.cpp", "core/scene/scene.hpp"},
             {"core/rayscope.cpp", "core/tracer/tracer.hpp"},
             {"visualizer/cli/main.cpp", "core/rayscope.hpp"},
             {"visualizer/cli/main.cpp", "visualizer/cli/text.hpp"},
             {"visualizer/drawing/drawing.cpp", "vtkActor.h"},
             {"visualizer/window/window.cpp", "visualizer/drawing/drawing.hpp"},
             {"chapters/01_rays/lesson.cpp", "core/generics/sphere.hpp"},
             {"chapters/01_rays/lesson.cpp", "visualizer/page/page.hpp"},
             {"exercises/1-01-hit/solution.cpp", "visualizer/drawing/drawing.hpp"},
             {"bench/spheres.cpp", "core/tracer/tracer.hpp"},
             {"tests/csg/sweep_test.cpp", "core/csg/sweep.hpp"},
         })
        EXPECT_EQ(broken_rule(edge.from, edge.to), std::nullopt) << edge.from << " → " << edge.to;
}

} // namespace
} // namespace rayscope::test

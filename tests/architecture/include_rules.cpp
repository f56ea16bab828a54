#include "tests/architecture/include_rules.hpp"

#include <algorithm>
#include <cctype>
#include <iterator>
#include <map>
#include <set>
#include <vector>

namespace rayscope::test {
namespace {

using Folders = std::set<std::string, std::less<>>;

// What each folder of core stands on; what those stand on is allowed with them.
const std::map<std::string, Folders, std::less<>> stands_on = {
    {"math", {}},
    {"files", {}},
    {"image", {"math", "files"}},
    {"trace", {"math"}},
    {"boxes", {"math"}},
    {"mesh", {"boxes"}},
    {"generics", {"trace", "mesh"}},
    {"shading", {"trace"}},
    {"reflection", {"trace"}},
    {"refraction", {"trace"}},
    {"csg", {"generics", "shading", "reflection", "refraction", "files"}},
    {"world", {"csg"}},
    {"stage", {"world"}},
    {"extents", {"stage"}},
    {"octree", {"stage"}},
    {"bvh", {"stage"}},
    {"tracer", {"extents", "octree", "bvh", "image"}},
    {"accuracy", {"tracer", "scene"}},
    {"substitute", {"tracer", "scene"}},
    {"scene", {"world", "files"}},
    {"cases", {"tracer", "scene"}},
    {"effects", {"accuracy"}},
    {"povray", {"scene"}},
    {"walk", {"tracer", "scene"}},
};

bool reaches(std::string_view from, std::string_view to) {
    if (from == to) return true;
    const auto& below = stands_on.find(from)->second;
    return std::any_of(below.begin(), below.end(), [&](const auto& folder) { return reaches(folder, to); });
}

std::vector<std::string> split(std::string_view path) {
    std::vector<std::string> parts(1);
    for (const char c : path)
        if (c == '/')
            parts.emplace_back();
        else
            parts.back() += c;
    return parts;
}

/// "csg" of "core/csg/sweep.hpp"; empty for a file that lies in the top-level folder itself.
std::string second_folder(const std::vector<std::string>& parts) { return parts.size() > 2 ? parts[1] : ""; }

bool is_gui_header(std::string_view included) {
    const auto qt = [](std::string_view name) {
        return name.size() > 1 && name[0] == 'Q' && std::isupper(static_cast<unsigned char>(name[1])) != 0;
    };
    return included.starts_with("vtk") || included.starts_with("Qt") || qt(included);
}

std::optional<std::string> broken_in_core(const std::string& folder, const std::string& target_top,
                                          const std::string& target_folder) {
    if (target_top != "core") return "core includes nothing of " + target_top;
    if (folder.empty()) return std::nullopt; // the public face
    for (const auto& known : {folder, target_folder})
        if (!known.empty() && !stands_on.contains(known))
            return "core/" + known + " is on no floor yet: add it to the table";
    if (target_folder.empty()) return "nothing in core includes core's public face";
    if (!reaches(folder, target_folder)) return "core/" + folder + " does not stand on core/" + target_folder;
    return std::nullopt;
}

std::optional<std::string> broken_in_visualizer(const std::string& folder, const std::string& target) {
    static const std::map<std::string, Folders, std::less<>> may_use = {{"cli", {"page"}},
                                                                        {"window", {"cli", "drawing"}},
                                                                        {"figures", {"drawing", "page"}},
                                                                        {"drawing", {}},
                                                                        {"page", {}}};
    const auto known = may_use.find(folder);
    if (folder == target || folder.empty()) return std::nullopt;
    if (known == may_use.end()) return "visualizer/" + folder + " is on no floor yet: add it to the table";
    if (!known->second.contains(target))
        return "visualizer/" + folder + " does not stand on visualizer/" + target;
    return std::nullopt;
}

} // namespace

std::optional<std::string> broken_rule(std::string_view includer, std::string_view included) {
    static const Folders tops = {"core", "chapters", "exercises", "visualizer", "bench", "tests"};
    const auto from = split(includer), to = split(included);
    const std::string &top = from.front(), &target_top = to.front();
    const std::string folder = second_folder(from), target_folder = second_folder(to);

    const bool terminal = top == "visualizer" && (folder == "cli" || folder == "page");
    if (is_gui_header(included) && (top == "core" || terminal))
        return top + " and the terminal build without VTK and Qt";
    if (to.size() < 2 || !tops.contains(target_top)) return std::nullopt; // another library's
    if (target_top == "tests" && top != "tests") return "only tests include tests";
    if (top == "tests") return std::nullopt;
    if (top == "core") return broken_in_core(folder, target_top, target_folder);
    if (target_top == "core") {
        if (top == "visualizer" && included != "core/rayscope.hpp")
            return "the programs use of core only core/rayscope.hpp";
        return std::nullopt;
    }
    if (top == target_top)
        return top == "visualizer" ? broken_in_visualizer(folder, target_folder) : std::nullopt;
    const bool shared = target_top == "visualizer" && (target_folder == "page" || target_folder == "drawing");
    if (shared && (top == "chapters" || top == "exercises")) return std::nullopt;
    return top + " and " + target_top + " do not include each other";
}

} // namespace rayscope::test

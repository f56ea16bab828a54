// rayscope-figures: draws the lessons' figures.

#include "visualizer/figures/catalogue.hpp"

#include "core/rayscope.hpp"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <iostream>

namespace {

namespace fs = std::filesystem;
using namespace rayscope;
using namespace rayscope::figures;

std::vector<Entry> chosen(const std::vector<Entry>& all, const std::vector<std::string>& names) {
    if (names.empty()) return all;
    std::vector<Entry> list;
    for (const std::string& name : names) {
        const auto found =
            std::find_if(all.begin(), all.end(), [&](const Entry& e) { return e.name == name; });
        if (found == all.end())
            throw InputError("--only", {}, "there is no figure '" + name + "'; --list shows them all");
        list.push_back(*found);
    }
    return list;
}

} // namespace

int main(int argc, char** argv) {
    CLI::App app{"Draws the figures of the lessons, as SVG, from their scenes", "rayscope figures"};
    std::vector<std::string> names;
    std::string folder;
    bool list = false;
    app.add_option("--only", names, "Names of figures; without it all are drawn");
    app.add_option("-o,--output", folder, "A folder for the files; without it each goes to its chapter");
    app.add_flag("--list", list, "Only tell which figures there are, with their captions");
    app.footer("Example: ./rayscope figures --only two_spheres_hits -o .");
    try {
        app.parse(argc, argv);
    } catch (const CLI::ParseError& error) {
        return app.exit(error) == 0 ? 0 : 2;
    }
    try {
        const fs::path chapters = fs::path(RAYSCOPE_SOURCE_DIR) / "chapters";
        for (const Entry& entry : chosen(read_catalogue(), names)) {
            if (list) {
                std::cout << entry.name << "\n    " << entry.caption << "\n    " << entry.command << '\n';
                continue;
            }
            const fs::path file =
                folder.empty() ? chapters / entry.file() : fs::path(folder) / entry.file().filename();
            fs::create_directories(file.parent_path());
            check_writable(file);
            write_text_file(file, drawn(entry, chapters));
            std::cout << file.string() << '\n';
        }
    } catch (const InputError& error) {
        std::cerr << error.what() << '\n';
        return 2;
    } catch (const std::exception& error) {
        std::cerr << "rayscope figures: " << error.what() << '\n';
        return 1;
    }
    return 0;
}

#pragma once
// figures.toml: which figures there are, and the words that belong to each.

#include <filesystem>
#include <string>
#include <vector>

namespace rayscope::figures {

struct Entry {
    std::string name;
    std::string chapter; ///< folder in chapters/
    std::string scene;   ///< path below chapters/, without .toml: what a reader can open
    std::string title;
    std::string alt; ///< what the figure shows, for who can't see it
    std::string caption;
    std::string command; ///< that shows the same ray or scene

    /// Below chapters/.
    [[nodiscard]] std::filesystem::path file() const {
        return std::filesystem::path(chapter) / "figures" / (name + ".svg");
    }
};

/// Of this checkout, in the order of the file. Throws InputError with the line of what is wrong.
[[nodiscard]] std::vector<Entry> read_catalogue();

/// The figure as a file's text. Throws InputError where its scene lacks what it shows.
[[nodiscard]] std::string drawn(const Entry& entry, const std::filesystem::path& chapters);

} // namespace rayscope::figures

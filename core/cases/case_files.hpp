#pragma once
// A folder of case files: which families it holds.

#include <filesystem>
#include <string>
#include <vector>

namespace rayscope {

/// One family: cases of one kind, about one precision.
struct CaseFile {
    std::filesystem::path path; ///< FOLDER/FAMILY.jsonl
    std::string family;
    std::string kind;   ///< as its first line says; empty if that can't be read
    double epsilon = 0; ///< the same; a double's where it says nothing
};

/// The case files of a folder, by name; empty if there is no such folder.
[[nodiscard]] std::vector<CaseFile> case_files(const std::filesystem::path& folder);

} // namespace rayscope

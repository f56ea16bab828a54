#include "core/cases/case_files.hpp"

#include "core/math/scalar.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <fstream>

namespace rayscope {
namespace {

CaseFile case_file(const std::filesystem::path& path) {
    CaseFile result{path, path.stem().string(), {}, epsilon<double>};
    std::ifstream file(path);
    std::string line;
    std::getline(file, line);
    const auto json = nlohmann::json::parse(line, nullptr, false);
    if (!json.is_object() || !json.contains("kind") || !json["kind"].is_string()) return result;
    result.kind = json["kind"].get<std::string>();
    if (const auto found = json.find("epsilon"); found != json.end() && found->is_number())
        result.epsilon = found->get<double>();
    return result;
}

} // namespace

std::vector<CaseFile> case_files(const std::filesystem::path& folder) {
    std::vector<CaseFile> files;
    std::error_code missing;
    for (const auto& entry : std::filesystem::directory_iterator(folder, missing))
        if (entry.path().extension() == ".jsonl" && entry.is_regular_file())
            files.push_back(case_file(entry.path()));
    std::ranges::sort(files, {}, &CaseFile::family);
    return files;
}

} // namespace rayscope

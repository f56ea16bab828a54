#pragma once
// References on disk, finished or not.

#include "core/accuracy/reference.hpp"

namespace rayscope {

/// The file of one reference. A file that is not what it should be is as good as none.
class ReferenceCache {
public:
    /// The name follows from the scene's identity and all that the samples depend on.
    explicit ReferenceCache(const ReferenceOptions& options);

    /// The first rows, as far as they were computed; empty if there are none.
    [[nodiscard]] std::vector<ReferenceSample> load() const;
    /// Throws std::runtime_error where the file can't be written.
    void save(const std::vector<ReferenceSample>& samples) const;

private:
    std::filesystem::path path_;
    int width_, height_;
};

} // namespace rayscope

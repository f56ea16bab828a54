#pragma once
// A walk through a trace as pictures: one for each ray, in the order in which they were traced, with that ray in front.

#include "visualizer/drawing/picture.hpp"

namespace rayscope::drawing {

inline constexpr int most_frames = 500; ///< rays of a trace that is drawn so

/// walk.png becomes walk-0.png, walk-1.png …, with as many digits as the last number has.
/// @return the files. Throws InputError if the trace has more rays than most_frames.
std::vector<std::filesystem::path> write_all_pictures(const Workbench& bench, const Trace& trace,
                                                      const std::filesystem::path& path,
                                                      const PictureSize& size);

/// One file, an animated WebP without loss, complete or not at all. Throws as above.
void write_animation(const Workbench& bench, const Trace& trace, const std::filesystem::path& path,
                     const PictureSize& size);

} // namespace rayscope::drawing

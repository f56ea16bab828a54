#pragma once
// The numbers of a PLY file's body, one after the other.

#include "core/scene/ply_header.hpp"

namespace rayscope {

/// Decimals, parted by blanks.
class PlyDecimals {
public:
    PlyDecimals(std::string_view text, const PlyHeader& header, const std::string& file)
        : rest_(text.substr(header.body)), file_(file), line_(header.body_line) {}

    [[nodiscard]] double next(PlyType type);
    /// Fails where anything but blanks is left.
    void end();
    /// "file:line: message"
    [[noreturn]] void fail(const std::string& message) const;

private:
    void skip_blanks();

    std::string_view rest_;
    const std::string& file_;
    int line_;
};

/// Numbers as a machine stores them, packed.
class PlyBytes {
public:
    PlyBytes(std::string_view text, const PlyHeader& header, const std::string& file)
        : size_(text.size()),
          rest_(text.substr(header.body)),
          file_(file),
          big_endian_(header.format == PlyFormat::big_endian) {}

    [[nodiscard]] double next(PlyType type);
    /// Fails where anything but blanks is left.
    void end() const;
    /// "file: at byte 123 (from 0): message"
    [[noreturn]] void fail(const std::string& message) const;

private:
    template <typename Number> [[nodiscard]] double number();

    std::size_t size_; // of the file
    std::string_view rest_;
    const std::string& file_;
    bool big_endian_;
};

} // namespace rayscope

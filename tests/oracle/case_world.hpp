#pragma once
// A case as a scene, through the core's public face, and the core's answers in the oracle's words.

#include "core/rayscope.hpp"
#include "tests/oracle/comparison.hpp"

namespace rayscope::test {

class CaseWorld {
public:
    explicit CaseWorld(const LineCase& exact);

    /// The inside list of the solid or compound on the whole line.
    [[nodiscard]] FoundSpans spans() const;
    /// The boundary that the traced ray meets first, if any.
    [[nodiscard]] std::optional<FoundEnd> first_hit() const;

private:
    [[nodiscard]] FoundEnd end_from(const Crossing<double>& crossing) const;

    const LineCase& exact_;
    Workbench bench_;
};

} // namespace rayscope::test

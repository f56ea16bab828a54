#pragma once
// A case as a scene, through the core's public face, and the core's answers in the oracle's words.

#include "core/rayscope.hpp"
#include "core/tracer/object_spans.hpp"
#include "tests/oracle/comparison.hpp"

namespace rayscope::test {

class CaseWorld {
public:
    explicit CaseWorld(const LineCase& exact, NumbersChoice numbers = {});

    /// The inside list of the solid or compound on the whole line.
    [[nodiscard]] FoundSpans spans() const;
    /// The boundary that the traced ray meets first, if any. Rays are traced in double.
    [[nodiscard]] std::optional<FoundEnd> first_hit() const;

private:
    [[nodiscard]] FoundEnd found(const SpanEnd& end) const;

    const LineCase& exact_;
    NumbersChoice numbers_;
    Workbench bench_;
};

} // namespace rayscope::test

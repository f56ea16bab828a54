// Triangles, alone and edge to edge: kind `tri`.

#include "tests/oracle/case_files.hpp"
#include "tests/oracle/triangle_checks.hpp"

namespace rayscope::test {
namespace {

class Tri : public FamilyTest {};

TEST_P(Tri, HitsAndWeightsAreExact) { expect_triangles(read_triangle_cases(path())); }

INSTANTIATE_TEST_SUITE_P(, Tri, testing::ValuesIn(families("tri")), family_name);

} // namespace
} // namespace rayscope::test

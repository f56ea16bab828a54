// Rays through the cells of an octree: kind `oct`.

#include "tests/oracle/case_files.hpp"
#include "tests/oracle/grid_checks.hpp"

namespace rayscope::test {
namespace {

class Oct : public FamilyTest {};

TEST_P(Oct, CellsAreVisitedInOrder) { expect_cells(read_grid_cases(path())); }

INSTANTIATE_TEST_SUITE_P(, Oct, testing::ValuesIn(families("oct")), family_name);

} // namespace
} // namespace rayscope::test

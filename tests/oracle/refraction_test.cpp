// Snell's law where it is hard: kind `refr`.

#include "tests/oracle/case_files.hpp"
#include "tests/oracle/refraction_checks.hpp"

namespace rayscope::test {
namespace {

class Refr : public FamilyTest {};

TEST_P(Refr, DirectionsAreExact) { expect_refraction(read_refraction_cases(path())); }

INSTANTIATE_TEST_SUITE_P(, Refr, testing::ValuesIn(families("refr")), family_name);

} // namespace
} // namespace rayscope::test

// A ray between mirrors, up to ten thousand times: kind `cavity`.

#include "tests/oracle/case_files.hpp"
#include "tests/oracle/cavity_checks.hpp"

namespace rayscope::test {
namespace {

class Cavity : public FamilyTest {};

TEST_P(Cavity, PathsAreExact) { expect_cavity(read_cavity_cases(path())); }

INSTANTIATE_TEST_SUITE_P(, Cavity, testing::ValuesIn(families("cavity")), family_name);

} // namespace
} // namespace rayscope::test

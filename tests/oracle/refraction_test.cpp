// Snell's law and Fresnel's shares where they are hard: kind `refr`.

#include "tests/oracle/case_files.hpp"
#include "tests/oracle/refraction_checks.hpp"

namespace rayscope::test {
namespace {

class Refr : public FamilyTest {};
TEST_P(Refr, DirectionsAndSharesAreExact) { expect_refraction(read_refraction_cases(path())); }
INSTANTIATE_TEST_SUITE_P(, Refr, testing::ValuesIn(families("refr")), family_name);

class RefrInFloat : public FamilyTest {};
TEST_P(RefrInFloat, DirectionsAndSharesAreExact) {
    expect_refraction(read_refraction_cases(path()), {ScalarType::float32, Method::stable});
}
INSTANTIATE_TEST_SUITE_P(, RefrInFloat, testing::ValuesIn(families("refr", double(epsilon<float>))),
                         family_name);

} // namespace
} // namespace rayscope::test

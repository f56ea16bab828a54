// The same lines in the other scalar types: float on inputs in binary32, long double and __float128 on a double's, each
// with tolerances at its own ε.

#include "tests/oracle/line_checks.hpp"

namespace rayscope::test {
namespace {

void expect_all(const std::vector<LineCase>& cases, ScalarType scalar) {
    expect_spans(cases, {scalar, Method::stable});
    expect_surfaces_and_normals(cases, {scalar, Method::stable});
    expect_bounds_of_ends(cases, {scalar, Method::stable});
}

// Wider numbers decide what double can't; what a case says holds for them where double can decide.
std::vector<LineCase> decidable(std::vector<LineCase> cases) {
    std::erase_if(cases, [](const LineCase& exact) { return !exact.decidable || exact.in_surface; });
    return cases;
}

std::vector<std::string> line_families(double epsilon) {
    std::vector<std::string> names = families("hit", epsilon);
    const std::vector<std::string> compounds = families("csg", epsilon);
    names.insert(names.end(), compounds.begin(), compounds.end());
    return names;
}

class InFloat : public FamilyTest {};
TEST_P(InFloat, LinesAreExact) { expect_all(read_line_cases(path()), ScalarType::float32); }
INSTANTIATE_TEST_SUITE_P(, InFloat, testing::ValuesIn(line_families(double(epsilon<float>))), family_name);

class InLongDouble : public FamilyTest {};
TEST_P(InLongDouble, LinesAreExact) { expect_all(decidable(read_line_cases(path())), ScalarType::float80); }
INSTANTIATE_TEST_SUITE_P(, InLongDouble, testing::ValuesIn(line_families(epsilon<double>)), family_name);

} // namespace
} // namespace rayscope::test

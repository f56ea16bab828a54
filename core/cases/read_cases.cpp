#include "core/cases/read_cases.hpp"

#include "core/scene/input_error.hpp"
#include "core/scene/source_text.hpp"

#include <nlohmann/json.hpp>

#include <cstdlib>
#include <sstream>
#include <stdexcept>

namespace rayscope {
namespace {

using Json = nlohmann::json;

constexpr std::size_t largest_file = std::size_t(1) << 28U; // bytes

double from_hex(const Json& json) {
    const auto& text = json.get_ref<const std::string&>();
    char* end = nullptr;
    const double value = std::strtod(text.c_str(), &end);
    if (text.empty() || *end != '\0') throw std::runtime_error("not a hex float: \"" + text + '"');
    return value;
}

// A JSON number, or "inf" for what JSON lacks.
double number(const Json& json) { return json.is_string() ? from_hex(json) : json.get<double>(); }

Vec3d vector_from_hex(const Json& json) {
    return {from_hex(json.at(0)), from_hex(json.at(1)), from_hex(json.at(2))};
}

Vec3d vector_from_numbers(const Json& json) {
    return {number(json.at(0)), number(json.at(1)), number(json.at(2))};
}

Mat4d matrix_from_hex(const Json& json) {
    Mat4d matrix;
    for (int row = 0; row < 4; ++row)
        for (int column = 0; column < 4; ++column)
            matrix[column][row] = from_hex(json.at(static_cast<std::size_t>(4 * row + column)));
    return matrix;
}

Ray<double> ray_from(const Json& json) {
    return {vector_from_hex(json.at("o_hex")), vector_from_hex(json.at("d_hex"))};
}

Generic<double> shape_from(const Json& json) {
    const auto& type = json.at("type").get_ref<const std::string&>();
    if (type == "sphere") return Sphere<double>{};
    if (type == "plane") return Plane<double>{};
    if (type == "cylinder") return Cylinder<double>{};
    if (type == "cone") return Cone<double>{};
    if (type == "cube") return Cube<double>{};
    if (type == "torus") return Torus<double>{from_hex(json.at("r_hex"))};
    throw std::runtime_error("unknown shape \"" + type + '"');
}

CaseLeaf leaf_from(const Json& json) {
    return {shape_from(json.at("shape")), matrix_from_hex(json.at("M_hex"))};
}

CaseToken token_from(const Json& json) {
    if (json.is_number()) return {Operation::leaf, json.get<std::size_t>()};
    const auto& symbol = json.get_ref<const std::string&>();
    if (symbol == "|") return {Operation::set_union};
    if (symbol == "&") return {Operation::intersection};
    if (symbol == "-") return {Operation::difference};
    if (symbol == "~") return {Operation::complement};
    throw std::runtime_error("unknown operation \"" + symbol + '"');
}

ExactTime time_from(const Json& json) {
    ExactTime t{from_hex(json.at("t_hex")), from_hex(json.at("t_lo_hex"))};
    t.tail = float128_from(json.at("t_str").get<std::string>()) - t.value();
    return t;
}

// What hits and bounds of compounds share.
ExactBound bound_from(const Json& json) {
    ExactBound bound;
    bound.t = time_from(json);
    bound.touch = json.at("event") == "touch";
    bound.tolerance = number(json.at("tol64"));
    bound.tight_tolerance = number(json.at("tol64_tight"));
    bound.tight_condition = number(json.at("cond_tight"));
    return bound;
}

ExactBound hit_from(const Json& json) {
    ExactBound bound = bound_from(json);
    bound.normal_tolerance = number(json.at("ntol64"));
    const Json& normals = json.at("normals");
    for (std::size_t i = 0; i < normals.size(); ++i) {
        ExactSurface surface;
        surface.face = json.at("face").at(i).get<std::string>();
        if (!normals[i].is_null()) surface.normal = vector_from_hex(normals[i].at("n_hex"));
        bound.surfaces.push_back(surface);
    }
    return bound;
}

ExactBound compound_bound_from(const Json& json) {
    ExactBound bound = bound_from(json);
    for (const Json& item : json.at("surfaces")) {
        ExactSurface surface{item.at("leaf").get<std::size_t>(),
                             item.at("face").get<std::string>(),
                             item.at("flip").get<bool>(),
                             {}};
        if (!item.at("n").is_null()) surface.normal = vector_from_numbers(item.at("n"));
        bound.surfaces.push_back(surface);
    }
    return bound;
}

std::vector<ExactSpan> spans_from(const Json& json, std::size_t bounds) {
    const auto end = [&](const Json& index) -> std::optional<std::size_t> {
        if (index.is_null()) return std::nullopt;
        const auto i = index.get<std::size_t>();
        if (i >= bounds) throw std::runtime_error("an interval names bound " + std::to_string(i));
        return i;
    };
    std::vector<ExactSpan> spans;
    for (const Json& pair : json) {
        const ExactSpan span{end(pair.at(0)), end(pair.at(1))};
        const bool point = span.enter && span.enter == span.exit;
        if (!point) spans.push_back(span);
    }
    return spans;
}

std::vector<CaseToken> program_from(const Json& json, std::size_t leaves) {
    std::vector<CaseToken> program;
    std::size_t operands = 0;
    for (const Json& item : json) {
        const CaseToken token = token_from(item);
        const bool is_leaf = token.operation == Operation::leaf;
        const std::size_t needed = is_leaf ? 0 : token.operation == Operation::complement ? 1 : 2;
        if (is_leaf && token.leaf >= leaves)
            throw std::runtime_error("rpn names leaf " + std::to_string(token.leaf) + " of " +
                                     std::to_string(leaves));
        if (operands < needed) throw std::runtime_error("rpn: an operation lacks an operand");
        operands = operands - needed + 1;
        program.push_back(token);
    }
    if (operands != 1)
        throw std::runtime_error("rpn leaves " + std::to_string(operands) + " results, expected 1");
    return program;
}

double epsilon_from(const Json& json) { return json.value("epsilon", epsilon<double>); }

LineCase line_case_from(const Json& json) {
    LineCase result;
    result.id = json.at("id").get<std::string>();
    result.epsilon = epsilon_from(json);
    result.is_compound = json.at("kind") == "csg";
    result.ray = ray_from(json);
    result.decidable = json.at("decidable").get<bool>();
    result.in_surface = json.at("in_surface").get<bool>();
    if (result.is_compound) {
        for (const Json& leaf : json.at("leaves")) result.leaves.push_back(leaf_from(leaf));
        result.program = program_from(json.at("rpn"), result.leaves.size());
        for (const Json& bound : json.at("bounds")) result.bounds.push_back(compound_bound_from(bound));
        result.clean_decidable = json.at("clean_decidable").get<bool>();
        result.clean_spans = spans_from(json.at("intervals_clean"), result.bounds.size());
        result.tolerance_sum = number(json.at("sum_tol64"));
    } else {
        result.leaves.push_back(leaf_from(json));
        result.program.emplace_back();
        for (const Json& hit : json.at("hits")) result.bounds.push_back(hit_from(hit));
        for (const ExactBound& bound : result.bounds) result.tolerance_sum += bound.tolerance;
    }
    result.spans = spans_from(json.at("intervals"), result.bounds.size());
    return result;
}

RefractionCase refraction_case_from(const Json& json) {
    RefractionCase result;
    result.id = json.at("id").get<std::string>();
    result.epsilon = epsilon_from(json);
    result.direction = vector_from_hex(json.at("d_hex"));
    result.normal = vector_from_hex(json.at("n_hex"));
    result.speed_from = from_hex(json.at("c1_hex"));
    result.speed_to = from_hex(json.at("c2_hex"));
    result.total = json.at("tir").get<bool>();
    result.decidable = json.at("decidable").get<bool>();
    result.reflectance_s = number(json.at("Rs"));
    result.reflectance_p = number(json.at("Rp"));
    result.reflectance_tolerance = number(json.at("R_tol64"));
    result.reflected = vector_from_hex(json.at("reflect_hex"));
    if (!json.at("refract").is_null()) {
        result.refracted = vector_from_hex(json.at("refract_hex"));
        result.tolerance = number(json.at("refract_tol64"));
    }
    return result;
}

ExactTriangle triangle_from(const Json& json) {
    ExactTriangle result;
    for (const Json& corner : json.at("v_hex")) result.corners.push_back(vector_from_hex(corner));
    result.status = json.at("status").get<std::string>();
    if (result.status == "parallel" || result.status == "coplanar") return result;
    result.t = time_from(json);
    result.weights = vector_from_numbers(json.at("w"));
    result.tolerance = number(json.at("tol64"));
    result.weight_tolerance = number(json.at("w_tol64"));
    result.decidable = json.at("decidable").get<bool>();
    return result;
}

TriangleCase triangle_case_from(const Json& json) {
    TriangleCase result;
    result.id = json.at("id").get<std::string>();
    result.epsilon = epsilon_from(json);
    for (const Json& triangle : json.at("tris")) result.triangles.push_back(triangle_from(triangle));
    result.matrix = matrix_from_hex(json.at("M_hex"));
    result.ray = ray_from(json);
    result.must_hit = json.at("must_hit").get<bool>();
    return result;
}

CavityCase cavity_case_from(const Json& json) {
    CavityCase result;
    result.id = json.at("id").get<std::string>();
    result.bounces = json.at("N").get<int>();
    result.ray = ray_from(json);
    result.wall_counts = json.at("wall_counts").get<std::array<int, 3>>();
    result.length = from_hex(json.at("t_total_hex"));
    result.end = vector_from_hex(json.at("p_end_hex"));
    result.end_direction = vector_from_hex(json.at("d_end_hex"));
    result.tolerance = number(json.at("p_tol64"));
    return result;
}

GridCase grid_case_from(const Json& json) {
    GridCase result;
    result.id = json.at("id").get<std::string>();
    result.depth = json.at("depth").get<int>();
    result.ray = ray_from(json);
    for (const Json& segment : json.at("segments"))
        result.segments.push_back({from_hex(segment.at("t0_hex")), from_hex(segment.at("t1_hex")),
                                   segment.at("alt").get<std::vector<std::array<int, 3>>>()});
    return result;
}

template <typename Case>
std::vector<Case> read_lines(const std::filesystem::path& path, Case (*convert)(const Json&)) {
    std::istringstream file(read_file(path, largest_file));
    std::vector<Case> cases;
    std::string line;
    for (int i = 1; std::getline(file, line); ++i) {
        try {
            cases.push_back(convert(Json::parse(line)));
        } catch (const std::exception& error) {
            throw InputError(path.string(), {i, 0},
                             std::string("expected a case of the oracle: ") + error.what());
        }
    }
    if (cases.empty()) throw InputError(path.string(), {}, "expected a case on each line, found none");
    return cases;
}

} // namespace

std::vector<LineCase> read_line_cases(const std::filesystem::path& path) {
    return read_lines(path, line_case_from);
}

std::vector<RefractionCase> read_refraction_cases(const std::filesystem::path& path) {
    return read_lines(path, refraction_case_from);
}

std::vector<TriangleCase> read_triangle_cases(const std::filesystem::path& path) {
    return read_lines(path, triangle_case_from);
}

std::vector<CavityCase> read_cavity_cases(const std::filesystem::path& path) {
    return read_lines(path, cavity_case_from);
}

std::vector<GridCase> read_grid_cases(const std::filesystem::path& path) {
    return read_lines(path, grid_case_from);
}

} // namespace rayscope

#include "core/trace/given.hpp"

namespace rayscope {
namespace {

struct Gift {
    std::string_view what;
    Id light;
    Vec3d value;
};

std::vector<Gift> gifts_of(const TracedRay& ray, bool with_shares) {
    std::vector<Gift> gifts;
    double lights = 0;
    for (const Event& event : ray.events) {
        if (const auto* missed = std::get_if<Missed>(&event))
            gifts.push_back({"the background", none, missed->background});
        if (const auto* ambient = std::get_if<AmbientLit>(&event)) {
            gifts.push_back({"the scene's ambient light", none, ambient->scene});
            gifts.push_back({"the material's ambient coefficient", none, ambient->material});
        }
        if (const auto* lit = std::get_if<LightLit>(&event)) {
            ++lights;
            gifts.push_back({"the intensity", lit->light, lit->intensity});
            gifts.push_back({"the diffuse coefficient", none, lit->diffuse_coefficient});
            gifts.push_back({"the specular coefficient", none, lit->specular_coefficient});
            gifts.push_back({"the shininess", none, Vec3d{lit->shininess}});
        }
        if (!with_shares) continue;
        if (const auto* mirrored = std::get_if<Reflected>(&event))
            gifts.push_back({"the coefficient of the reflected ray", none, mirrored->coefficient});
        if (const auto* bent = std::get_if<Refracted>(&event))
            gifts.push_back({"the coefficient of the refracted ray", none, bent->coefficient});
    }
    if (lights > 0) gifts.insert(gifts.begin(), {"the number of lights", none, Vec3d{lights}});
    return gifts;
}

} // namespace

bool has_calculated_shares(const TracedRay& a, const TracedRay& b) {
    return a.find<FresnelShared>() != nullptr && b.find<FresnelShared>() != nullptr;
}

std::optional<GivenDifference> first_given_difference(const TracedRay& a, const TracedRay& b) {
    const bool with_shares = !has_calculated_shares(a, b);
    const auto in_a = gifts_of(a, with_shares), in_b = gifts_of(b, with_shares);
    for (std::size_t i = 0; i < std::min(in_a.size(), in_b.size()); ++i) {
        if (in_a[i].what != in_b[i].what) break; // another decision, which is told as one
        if (in_a[i].value != in_b[i].value)
            return GivenDifference{in_a[i].what, in_a[i].light, in_a[i].value, in_b[i].value};
    }
    return std::nullopt;
}

} // namespace rayscope

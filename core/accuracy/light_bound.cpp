#include "core/accuracy/light_bound.hpp"

namespace rayscope {

Colour light_bound(const WorldBase& world, int bounces) {
    Colour sent_on{0}, local{0}, lights{0};
    for (const Light& light : world.lights) lights += light.colour;
    for (const Material& m : world.materials) {
        const Colour brightest = world.ambient * m.ambient + lights * (m.diffuse + m.specular);
        for (int i = 0; i < 3; ++i) {
            sent_on[i] = maximum(sent_on[i], m.reflection[i] + m.transmission[i]);
            local[i] = maximum(local[i], brightest[i]);
        }
    }
    Colour bound = world.background;
    for (int i = 0; i < 3; ++i) {
        if (sent_on[i] < 1)
            bound[i] = maximum(bound[i], local[i] / (1 - sent_on[i]));
        else
            for (int n = 0; n < bounces; ++n) bound[i] = maximum(bound[i], local[i] + sent_on[i] * bound[i]);
    }
    return bound;
}

} // namespace rayscope

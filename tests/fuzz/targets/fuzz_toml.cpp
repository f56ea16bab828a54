// libFuzzer: whatever the bytes, parse_toml returns a scene or throws InputError.

#include "core/scene/read_toml.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    try {
        (void)rayscope::parse_toml({reinterpret_cast<const char*>(data), size}, "fuzz.toml");
    } catch (const rayscope::InputError&) { // the one right way to refuse
    }
    return 0;
}

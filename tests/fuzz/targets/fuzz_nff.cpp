// libFuzzer: whatever the bytes, parse_nff returns a scene or throws InputError.

#include "core/scene/read_nff.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    try {
        (void)rayscope::parse_nff({reinterpret_cast<const char*>(data), size}, "fuzz.nff");
    } catch (const rayscope::InputError&) { // the one right way to refuse
    }
    return 0;
}

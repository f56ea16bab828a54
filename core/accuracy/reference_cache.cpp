#include "core/accuracy/reference_cache.hpp"

#include "core/files/atomic_file.hpp"
#include "core/math/hash.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <array>
#include <cstring>
#include <fstream>

namespace rayscope {
namespace {

constexpr int version = 1; // of the format, and of what the samples mean

std::array<double, 10> numbers_of(const ReferenceSample& s) {
    return {s.colour.x, s.colour.y,     s.colour.z,   s.lost.x, s.lost.y, s.lost.z, double(s.first.object),
            s.first.t,  s.first.t_rest, s.first.bound};
}

ReferenceSample sample_of(const std::array<double, 10>& n) {
    return {{n[0], n[1], n[2]}, {n[3], n[4], n[5]}, {Id(n[6]), n[7], n[8], n[9]}};
}

std::uint64_t hash_of(const std::vector<std::uint8_t>& bytes) {
    return Fnv1a().add(bytes.data(), bytes.size()).value();
}

} // namespace

ReferenceCache::ReferenceCache(const ReferenceOptions& options)
    : width_(options.width), height_(options.height) {
    if (options.cache.empty()) return;
    const ReferenceLimits& limits = options.limits;
    const std::string key = fmt::format("{} {} {}x{} {} {:a} {}", version, options.identity, options.width,
                                        options.height, limits.max_depth, limits.min_weight, limits.max_rays);
    path_ =
        options.cache / fmt::format("reference-{:016x}.cbor", Fnv1a().add(key.data(), key.size()).value());
}

std::vector<ReferenceSample> ReferenceCache::load() const {
    if (path_.empty()) return {};
    std::ifstream file(path_, std::ios::binary);
    const auto json = nlohmann::json::from_cbor(file, true, false);
    const auto member = json.is_object() ? json.find("samples") : json.end();
    if (!json.is_object() || member == json.end() || !member->is_binary()) return {};
    const auto& bytes = member->get_binary();
    if (json.value("hash", nlohmann::json()) != hash_of(bytes)) return {};
    constexpr std::size_t size = sizeof(std::array<double, 10>);
    const std::size_t row = size * std::size_t(width_);
    if (bytes.size() % row != 0 || bytes.size() / row > std::size_t(height_)) return {};
    std::vector<ReferenceSample> samples(bytes.size() / size);
    for (std::size_t i = 0; i < samples.size(); ++i) {
        std::array<double, 10> numbers{};
        std::memcpy(numbers.data(), bytes.data() + i * size, size);
        samples[i] = sample_of(numbers);
    }
    return samples;
}

void ReferenceCache::save(const std::vector<ReferenceSample>& samples) const {
    if (path_.empty()) return;
    std::filesystem::create_directories(path_.parent_path());
    std::vector<std::uint8_t> bytes(samples.size() * sizeof(std::array<double, 10>));
    for (std::size_t i = 0; i < samples.size(); ++i) {
        const auto numbers = numbers_of(samples[i]);
        std::memcpy(bytes.data() + i * sizeof numbers, numbers.data(), sizeof numbers);
    }
    const nlohmann::json json = {{"format", "rayscope-reference"},
                                 {"hash", hash_of(bytes)},
                                 {"samples", nlohmann::json::binary(std::move(bytes))}};
    const auto text = nlohmann::json::to_cbor(json);
    write_text_file(path_, {reinterpret_cast<const char*>(text.data()), text.size()});
}

} // namespace rayscope

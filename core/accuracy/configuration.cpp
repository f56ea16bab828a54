#include "core/accuracy/configuration.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <stdexcept>

namespace rayscope {
namespace {

constexpr int deepest_asked = 256; // as deep as a scene may ask for: the recursion has to fit on the stack

template <typename T> std::optional<T> number(std::string_view text) {
    T value{};
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc() || end != text.data() + text.size()) return std::nullopt;
    return value;
}

bool set_scalar(Configuration& configuration, std::string_view text) {
    const auto scalar = scalar_named(text);
    if (scalar) configuration.numbers.scalar = *scalar;
    return scalar.has_value();
}

bool set_method(Configuration& configuration, std::string_view text) {
    const auto method = method_named(text);
    if (method) configuration.numbers.method = *method;
    return method.has_value();
}

bool set_depth(Configuration& configuration, std::string_view text) {
    const auto depth = number<int>(text);
    if (!depth || *depth < 0 || *depth > deepest_asked) return false;
    configuration.max_depth = *depth;
    return true;
}

bool set_weight(Configuration& configuration, std::string_view text) {
    const auto weight = number<double>(text);
    if (!weight || !(*weight >= 0 && *weight <= 1)) return false;
    configuration.min_weight = *weight;
    return true;
}

std::vector<std::string_view> split(std::string_view text, char separator) {
    std::vector<std::string_view> parts;
    while (true) {
        const auto end = text.find(separator);
        parts.push_back(text.substr(0, end));
        if (end == std::string_view::npos) return parts;
        text.remove_prefix(end + 1);
    }
}

const Axis* axis_named(std::string_view name) {
    const auto found =
        std::find_if(axes().begin(), axes().end(), [&](const Axis& a) { return a.name == name; });
    return found == axes().end() ? nullptr : &*found;
}

std::string expected_words() {
    std::string words;
    for (const Axis& axis : axes()) {
        if (!words.empty()) words += "; ";
        words += std::string(axis.name) + "=" + std::string(axis.expected);
    }
    return words;
}

// "float" or "scalar=float"; the value alone where its axis is plain from it.
void set_word(Configuration& configuration, std::string_view word) {
    const auto equals = word.find('=');
    if (equals == std::string_view::npos) {
        if (set_scalar(configuration, word) || set_method(configuration, word)) return;
    } else if (const Axis* axis = axis_named(word.substr(0, equals))) {
        if (axis->set(configuration, word.substr(equals + 1))) return;
        throw std::invalid_argument(fmt::format("expected {} after '{}=', found '{}'", axis->expected,
                                                axis->name, word.substr(equals + 1)));
    }
    throw std::invalid_argument(
        fmt::format("'{}' is no value of an axis; expected {}", word, expected_words()));
}

class Collector {
public:
    explicit Collector(const Configuration& base) : base_(base) { add(base); }

    void add(const Configuration& configuration) {
        if (std::find(list_.begin(), list_.end(), configuration) == list_.end())
            list_.push_back(configuration);
    }
    void add_axis(const Axis& axis) {
        for (const std::string& value : axis.values) {
            Configuration configuration = base_;
            axis.set(configuration, value);
            add(configuration);
        }
    }
    void add_default() {
        for (const NumbersChoice& numbers : all_numbers) {
            Configuration configuration = base_;
            configuration.numbers = numbers;
            add(configuration);
        }
        for (const Axis& axis : axes()) add_axis(axis);
    }
    void add_product() {
        std::vector<Configuration> product{base_};
        for (const Axis& axis : axes()) {
            std::vector<Configuration> next;
            for (const Configuration& configuration : product) {
                next.push_back(configuration);
                for (const std::string& value : axis.values)
                    axis.set(next.emplace_back(configuration), value);
            }
            product = std::move(next);
        }
        for (const Configuration& configuration : product) add(configuration);
    }
    [[nodiscard]] std::vector<Configuration> take() { return std::move(list_); }

private:
    Configuration base_;
    std::vector<Configuration> list_;
};

} // namespace

std::string name_of(const Configuration& configuration) {
    return fmt::format("{} {}, depth {}, weight {:g}", scalar_name(configuration.numbers.scalar),
                       method_name(configuration.numbers.method), configuration.max_depth,
                       configuration.min_weight);
}

const std::vector<Axis>& axes() {
    static const std::vector<Axis> table{
        {"scalar",
         "float, double, 'long double' or float128",
         {"float", "double", "long double", "float128"},
         set_scalar},
        {"method", "stable or textbook", {"stable", "textbook"}, set_method},
        {"depth", "a whole number from 0 to 256", {"1", "2", "3", "5", "8", "12"}, set_depth},
        {"weight", "a number from 0 to 1", {"0.1", "0.01", "0.001", "0.0001"}, set_weight},
    };
    return table;
}

Configuration configuration(std::string_view text, const Configuration& base) {
    Configuration result = base;
    for (const std::string_view word : split(text, ',')) set_word(result, word);
    return result;
}

std::vector<Configuration> configurations(std::string_view text, const Configuration& base) {
    Collector collector(base);
    for (const std::string_view part : split(text, '/')) {
        if (part == "default")
            collector.add_default();
        else if (part == "full")
            collector.add_product();
        else if (const Axis* axis = axis_named(part))
            collector.add_axis(*axis);
        else
            collector.add(configuration(part, base));
    }
    return collector.take();
}

} // namespace rayscope

#include "core/walk/quiz.hpp"

#include <algorithm>
#include <map>

namespace rayscope {
namespace {

constexpr std::size_t most_choices = 5;
constexpr const char* nothing = "nothing";

class Examiner {
public:
    Examiner(const Trace& trace, const std::vector<std::string>& names) : trace_(trace), names_(names) {}

    void look(Spot spot) {
        const TracedRay& ray = trace_.rays[std::size_t(spot.ray)];
        const Event& event = ray.events[std::size_t(spot.event)];
        const bool shadow = ray.start().kind == RayKind::shadow;
        if (const auto* node = std::get_if<NodeEvaluated>(&event); node != nullptr && !shadow)
            ask_inside(spot, ray, *node);
        if (const auto* hit = std::get_if<BoundaryChosen>(&event))
            ask_object(spot, trace_.objects[std::size_t(hit->object)].name);
        if (std::holds_alternative<Missed>(event)) ask_object(spot, nothing);
        if (std::holds_alternative<TotallyReflected>(event)) ask_total(spot, true);
        if (const auto* bent = std::get_if<Refracted>(&event)) {
            if (!std::isnan(bent->critical)) ask_total(spot, false);
            ask_bend(spot, *bent);
        }
        if (const auto* end = std::get_if<RayFinished>(&event); end != nullptr && shadow)
            ask_light(spot, end->colour);
    }

    std::vector<Question> questions;

private:
    void ask(Quiz kind, Spot spot, std::vector<std::string> choices, std::size_t right) {
        questions.push_back({kind, spot, std::move(choices), right, none, 0});
    }

    // A few names, the right one among them, in the order of the scene.
    void ask_object(Spot spot, const std::string& right) {
        std::vector<std::string> choices;
        const auto add = [&](const std::string& name) {
            if (std::ranges::find(choices, name) == choices.end()) choices.push_back(name);
        };
        for (const std::string& name : names_)
            if (choices.size() + 2 < most_choices || name == right) add(name);
        if (right != nothing) add(right);
        add(nothing);
        const auto at = std::ranges::find(choices, right);
        ask(Quiz::object, spot, choices, std::size_t(at - choices.begin()));
    }

    // In turn a t within an interval and one beyond it; asked once for each compound, of its root.
    void ask_inside(Spot spot, const TracedRay& ray, const NodeEvaluated& node) {
        const std::size_t nodes = trace_.objects[std::size_t(node.object)].nodes.size();
        if (nodes == 1 || std::size_t(node.node) + 1 != nodes || asked_inside_[node.object]++ > 0) return;
        const auto spans = spans_after(ray, std::size_t(spot.event));
        const auto ahead = std::ranges::find_if(spans, [](const SpanFound& span) { return span.exit.t > 0; });
        if (ahead == spans.end() || !std::isfinite(ahead->exit.t)) return;
        const double from = std::max(ahead->enter.t, 0.0), to = ahead->exit.t;
        const bool last = ahead + 1 == spans.end();
        const double gap = last ? to - from : (ahead + 1)->enter.t - to;
        const bool within = questions.size() % 2 == 0;
        const double t = within ? from + (to - from) / 2 : to + (std::isfinite(gap) ? gap : to - from) / 2;
        ask(Quiz::inside, spot, {"yes", "no"}, within ? 0 : 1);
        questions.back().object = node.object;
        questions.back().t = t;
    }

    void ask_total(Spot spot, bool total) { ask(Quiz::total, spot, {"yes", "no"}, total ? 0 : 1); }

    void ask_bend(Spot spot, const Refracted& bent) {
        ask(Quiz::bend, spot, {"towards the normal", "away from the normal", "not at all"},
            bent.eta == 1 || bent.theta_from == 0 ? 2
            : bent.eta < 1                        ? 0
                                                  : 1);
    }

    void ask_light(Spot spot, const Colour& seen) {
        ask(Quiz::light, spot, {"yes", "no", "dimmed, through something"},
            seen == Colour{1}   ? 0
            : seen == Colour{0} ? 1
                                : 2);
    }

    const Trace& trace_;
    const std::vector<std::string>& names_;
    std::map<Id, int> asked_inside_;
};

} // namespace

std::vector<Question> questions_of(const Trace& trace, const Timeline& timeline,
                                   const std::vector<std::string>& names) {
    Examiner examiner(trace, names);
    for (std::size_t moment = 0; moment < timeline.size(); ++moment) examiner.look(timeline.at(moment));
    return std::move(examiner.questions);
}

} // namespace rayscope

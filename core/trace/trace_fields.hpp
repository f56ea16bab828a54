#pragma once
// The members of everything in a Trace, listed once: writing and reading a trace both follow these lists.
// To add a member or an event: add it here, and to chapters/reference/trace-format.md.

#include "core/trace/trace_words.hpp"

#include <string_view>
#include <tuple>

namespace rayscope {

/// What an id points into; `or_none`: it may also be −1.
enum class Target : std::uint8_t {
    nothing,
    object,
    object_or_none,
    light,
    light_or_none,
    medium_or_none,
    generic_or_none
};

template <typename S, typename M> struct Field {
    const char* name;
    M S::* member;
    Target target = Target::nothing;
};
template <typename S, typename M> Field(const char*, M S::*, Target = Target::nothing) -> Field<S, M>;

/// Fields<S>::list is the tuple of S's Field; events have a `name` too, the "event" of their JSON.
template <typename S> struct Fields;

template <> struct Fields<Boundary> {
    static constexpr auto list =
        std::tuple{Field{"t", &Boundary::t}, Field{"leaf", &Boundary::leaf, Target::generic_or_none},
                   Field{"face", &Boundary::face}, Field{"flipped", &Boundary::flipped}};
};

template <> struct Fields<RaySpawned> {
    static constexpr auto name = "ray_spawned";
    static constexpr auto list = std::tuple{
        Field{"kind", &RaySpawned::kind},
        Field{"depth", &RaySpawned::depth},
        Field{"weight", &RaySpawned::weight},
        Field{"origin", &RaySpawned::origin},
        Field{"direction", &RaySpawned::direction},
        Field{"reach", &RaySpawned::reach},
        Field{"medium", &RaySpawned::medium, Target::medium_or_none},
        Field{"light", &RaySpawned::light, Target::light_or_none},
        Field{"left_object", &RaySpawned::left_object, Target::object_or_none},
        Field{"left_bound", &RaySpawned::left_bound},
        Field{"wavelength", &RaySpawned::wavelength},
    };
};

template <> struct Fields<SearchBegan> {
    static constexpr auto name = "search_began";
    static constexpr auto list =
        std::tuple{Field{"stage", &SearchBegan::stage}, Field{"objects", &SearchBegan::objects}};
};

template <> struct Fields<PlaceEntered> {
    static constexpr auto name = "place_entered";
    static constexpr auto list = std::tuple{
        Field{"kind", &PlaceEntered::kind},   Field{"place", &PlaceEntered::place},
        Field{"level", &PlaceEntered::level}, Field{"object", &PlaceEntered::object, Target::object_or_none},
        Field{"held", &PlaceEntered::held},   Field{"low", &PlaceEntered::low},
        Field{"high", &PlaceEntered::high},   Field{"t_in", &PlaceEntered::t_in},
        Field{"t_out", &PlaceEntered::t_out},
    };
};

template <> struct Fields<PlaceLeft> {
    static constexpr auto name = "place_left";
    static constexpr auto list =
        std::tuple{Field{"tested", &PlaceLeft::tested}, Field{"spared", &PlaceLeft::spared}};
};

template <> struct Fields<SearchEnded> {
    static constexpr auto name = "search_ended";
    static constexpr auto list =
        std::tuple{Field{"reason", &SearchEnded::reason}, Field{"t", &SearchEnded::t},
                   Field{"places", &SearchEnded::places}, Field{"missed", &SearchEnded::missed},
                   Field{"tested", &SearchEnded::tested}, Field{"spared", &SearchEnded::spared}};
};

template <> struct Fields<ObjectAccepted> {
    static constexpr auto name = "object_accepted";
    static constexpr auto list =
        std::tuple{Field{"object", &ObjectAccepted::object, Target::object}, Field{"t", &ObjectAccepted::t}};
};

template <> struct Fields<NodeEvaluated> {
    static constexpr auto name = "node_evaluated";
    static constexpr auto list =
        std::tuple{Field{"object", &NodeEvaluated::object, Target::object},
                   Field{"node", &NodeEvaluated::node}, Field{"count", &NodeEvaluated::count}};
};

template <> struct Fields<SpanFound> {
    static constexpr auto name = "span_found";
    static constexpr auto list =
        std::tuple{Field{"enter", &SpanFound::enter}, Field{"exit", &SpanFound::exit}};
};

template <> struct Fields<ClusterMerged> {
    static constexpr auto name = "cluster_merged";
    static constexpr auto list =
        std::tuple{Field{"object", &ClusterMerged::object, Target::object},
                   Field{"count", &ClusterMerged::count}, Field{"t_first", &ClusterMerged::t_first},
                   Field{"t_last", &ClusterMerged::t_last}, Field{"kept", &ClusterMerged::kept}};
};

template <> struct Fields<BoundaryChosen> {
    static constexpr auto name = "boundary_chosen";
    static constexpr auto list = std::tuple{
        Field{"object", &BoundaryChosen::object, Target::object},
        Field{"boundary", &BoundaryChosen::boundary},
        Field{"entering", &BoundaryChosen::entering},
        Field{"error_bound", &BoundaryChosen::error_bound},
        Field{"point", &BoundaryChosen::point},
        Field{"normal", &BoundaryChosen::normal},
        Field{"facing", &BoundaryChosen::facing},
        Field{"medium_from", &BoundaryChosen::medium_from, Target::medium_or_none},
        Field{"medium_to", &BoundaryChosen::medium_to, Target::medium_or_none},
        Field{"speed_from", &BoundaryChosen::speed_from},
        Field{"speed_to", &BoundaryChosen::speed_to},
    };
};

template <> struct Fields<TriangleHit> {
    static constexpr auto name = "triangle_hit";
    static constexpr auto list =
        std::tuple{Field{"triangle", &TriangleHit::triangle}, Field{"corner_a", &TriangleHit::corner_a},
                   Field{"corner_b", &TriangleHit::corner_b}, Field{"corner_c", &TriangleHit::corner_c},
                   Field{"shares", &TriangleHit::shares}};
};

template <> struct Fields<Missed> {
    static constexpr auto name = "missed";
    static constexpr auto list = std::tuple{Field{"background", &Missed::background}};
};

template <> struct Fields<Absorbed> {
    static constexpr auto name = "absorbed";
    static constexpr auto list =
        std::tuple{Field{"medium", &Absorbed::medium, Target::medium_or_none},
                   Field{"length", &Absorbed::length}, Field{"passed", &Absorbed::passed}};
};

template <> struct Fields<AmbientLit> {
    static constexpr auto name = "ambient_lit";
    static constexpr auto list =
        std::tuple{Field{"scene", &AmbientLit::scene}, Field{"material", &AmbientLit::material}};
};

template <> struct Fields<LightLit> {
    static constexpr auto name = "light_lit";
    static constexpr auto list = std::tuple{
        Field{"light", &LightLit::light, Target::light},
        Field{"to_light", &LightLit::to_light},
        Field{"cosine", &LightLit::cosine},
        Field{"mirror_cosine", &LightLit::mirror_cosine},
        Field{"shininess", &LightLit::shininess},
        Field{"sample", &LightLit::sample},
        Field{"samples", &LightLit::samples},
        Field{"intensity", &LightLit::intensity},
        Field{"visibility", &LightLit::visibility},
        Field{"diffuse_coefficient", &LightLit::diffuse_coefficient},
        Field{"specular_coefficient", &LightLit::specular_coefficient},
        Field{"diffuse", &LightLit::diffuse},
        Field{"specular", &LightLit::specular},
    };
};

template <> struct Fields<LocalLightSkipped> {
    static constexpr auto name = "local_light_skipped";
    static constexpr auto list = std::tuple{Field{"reason", &LocalLightSkipped::reason}};
};

template <> struct Fields<BlockerPassed> {
    static constexpr auto name = "blocker_passed";
    static constexpr auto list =
        std::tuple{Field{"object", &BlockerPassed::object, Target::object}, Field{"t", &BlockerPassed::t},
                   Field{"transmission", &BlockerPassed::transmission}};
};

template <> struct Fields<FresnelShared> {
    static constexpr auto name = "fresnel_shared";
    static constexpr auto list = std::tuple{
        Field{"perpendicular", &FresnelShared::perpendicular}, Field{"parallel", &FresnelShared::parallel},
        Field{"schlick", &FresnelShared::schlick}, Field{"reflected", &FresnelShared::reflected},
        Field{"wavelength", &FresnelShared::wavelength}};
};

template <> struct Fields<Reflected> {
    static constexpr auto name = "reflected";
    static constexpr auto list =
        std::tuple{Field{"coefficient", &Reflected::coefficient}, Field{"theta", &Reflected::theta},
                   Field{"direction", &Reflected::direction}};
};

template <> struct Fields<Refracted> {
    static constexpr auto name = "refracted";
    static constexpr auto list = std::tuple{Field{"coefficient", &Refracted::coefficient},
                                            Field{"theta_from", &Refracted::theta_from},
                                            Field{"theta_to", &Refracted::theta_to},
                                            Field{"critical", &Refracted::critical},
                                            Field{"eta", &Refracted::eta},
                                            Field{"direction", &Refracted::direction},
                                            Field{"wavelength", &Refracted::wavelength}};
};

template <> struct Fields<TotallyReflected> {
    static constexpr auto name = "totally_reflected";
    static constexpr auto list = std::tuple{
        Field{"coefficient", &TotallyReflected::coefficient},
        Field{"theta_from", &TotallyReflected::theta_from}, Field{"critical", &TotallyReflected::critical},
        Field{"eta", &TotallyReflected::eta}, Field{"wavelength", &TotallyReflected::wavelength}};
};

template <> struct Fields<NotSpawned> {
    static constexpr auto name = "not_spawned";
    static constexpr auto list =
        std::tuple{Field{"kind", &NotSpawned::kind}, Field{"reason", &NotSpawned::reason},
                   Field{"coefficient", &NotSpawned::coefficient}, Field{"weight", &NotSpawned::weight}};
};

template <> struct Fields<RayFinished> {
    static constexpr auto name = "ray_finished";
    static constexpr auto list =
        std::tuple{Field{"local", &RayFinished::local}, Field{"colour", &RayFinished::colour},
                   Field{"tested", &RayFinished::tested}, Field{"rejected", &RayFinished::rejected}};
};

template <> struct Fields<Truncated> {
    static constexpr auto name = "truncated";
    static constexpr auto list = std::tuple{Field{"kept", &Truncated::kept}};
};

template <> struct Fields<TraceSource> {
    static constexpr auto list =
        std::tuple{Field{"scene", &TraceSource::scene},   Field{"by_hand", &TraceSource::by_hand},
                   Field{"x", &TraceSource::x},           Field{"y", &TraceSource::y},
                   Field{"sample", &TraceSource::sample}, Field{"given_length", &TraceSource::given_length}};
};

template <> struct Fields<TraceNode> {
    static constexpr auto list = std::tuple{
        Field{"operation", &TraceNode::operation}, Field{"left", &TraceNode::left},
        Field{"right", &TraceNode::right}, Field{"generic", &TraceNode::generic, Target::generic_or_none},
        Field{"name", &TraceNode::name}};
};

template <> struct Fields<TraceObject> {
    static constexpr auto list =
        std::tuple{Field{"name", &TraceObject::name}, Field{"material", &TraceObject::material},
                   Field{"nodes", &TraceObject::nodes}};
};

template <> struct Fields<TraceMedium> {
    static constexpr auto list =
        std::tuple{Field{"name", &TraceMedium::name}, Field{"speed", &TraceMedium::speed}};
};

template <> struct Fields<TraceLight> {
    static constexpr auto list =
        std::tuple{Field{"name", &TraceLight::name}, Field{"directional", &TraceLight::directional},
                   Field{"position", &TraceLight::position}};
};

template <> struct Fields<TracedRay> {
    static constexpr auto list =
        std::tuple{Field{"parent", &TracedRay::parent}, Field{"children", &TracedRay::children},
                   Field{"events", &TracedRay::events}};
};

// The tables come before the rays: ids in the rays are checked against them.
template <> struct Fields<Trace> {
    static constexpr auto list = std::tuple{Field{"source", &Trace::source},
                                            Field{"max_depth", &Trace::max_depth},
                                            Field{"min_weight", &Trace::min_weight},
                                            Field{"eye", &Trace::eye},
                                            Field{"generics", &Trace::generics},
                                            Field{"objects", &Trace::objects},
                                            Field{"media", &Trace::media},
                                            Field{"lights", &Trace::lights},
                                            Field{"rays", &Trace::rays},
                                            Field{"colour", &Trace::colour},
                                            Field{"events_dropped", &Trace::events_dropped}};
};

} // namespace rayscope

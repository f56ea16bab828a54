#include "visualizer/window/desk.hpp"

#include "visualizer/cli/failure.hpp"
#include "visualizer/cli/scene_choice.hpp"

#include <algorithm>
#include <fstream>
#include <iterator>
#include <utility>

namespace rayscope::window {
namespace {

/// As many states as keep their scenes within some hundred megabytes.
std::size_t most_undo(const Scene& scene) {
    return std::clamp<std::size_t>(400'000 / (scene.generics.size() + 1), 4, 200);
}

std::string text_of(const std::filesystem::path& path) {
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
}

} // namespace

Desk::Desk(cli::RayChoice choice) : choice_(std::move(choice)), style_{cli::Numbers(6), cli::Paint(false)} {
    file_ = cli::find_scene(choice_.scene);
    bench_ = std::make_shared<Workbench>(make_workbench(cli::load_with_effects(file_, choice_.effects)));
    begin(file_);
    converse(cli::trace_choice(*bench_, choice_));
}

/// Nothing is changed yet.
void Desk::begin(std::filesystem::path file) {
    file_ = std::move(file);
    original_.reset();
    hash_ = content_hash(file_);
    edits_ = saved_ = {};
    before_.clear();
    after_.clear();
    last_key_.clear();
    opened_places_.clear();
    for (const SceneGeneric& generic : scene().generics) opened_places_.emplace_back(generic.matrix[3]);
}

void Desk::open(const std::string& scene) {
    cli::RayChoice choice;
    choice.scene = scene;
    choice.by_stage = choice_.by_stage;
    choice.stage = choice_.stage;
    const std::filesystem::path file = cli::find_scene(scene);
    auto bench = std::make_shared<Workbench>(make_workbench(cli::load_with_effects(file, {})));
    Trace trace = cli::trace_choice(*bench, choice);
    choice_ = std::move(choice);
    session_.reset();
    bench_ = std::move(bench);
    begin(file);
    converse(std::move(trace));
    if (on_scene) on_scene();
}

/// A conversation about another trace; what was to stop the old one stops the new one too.
void Desk::converse(Trace trace) {
    std::vector<std::string> stops;
    if (session_)
        for (const StopPoint& point : walk().stops().all())
            stops.push_back((point.watches ? "watch " : "break ") + point.expression.text());
    session_.emplace(*bench_, std::move(trace), style_, choice_);
    for (const std::string& stop : stops) (void)session_->reply(stop);
}

cli::Reply Desk::command(const std::string& line) {
    const TraceSource before = trace().source;
    const bool asked = session_->quizzing();
    cli::Reply reply = session_->reply(line);
    const TraceSource& now = trace().source;
    if (reply.command == "pixel" || reply.command == "source" || before.x != now.x || before.y != now.y ||
        before.by_hand != now.by_hand) {
        if (!now.by_hand) {
            choice_.ray.reset();
            choice_.pixel = std::pair(now.x, now.y);
        }
        if (on_trace) on_trace();
    } else if ((asked || session_->quizzing()) && on_trace) {
        on_trace(); // more of it may be shown now, or less
    } else if (on_move) {
        on_move();
    }
    return reply;
}

void Desk::pick(int x, int y) {
    const Camera& camera = scene().camera;
    (void)command("pixel " + std::to_string(std::clamp(x, 0, camera.width - 1)) + "," +
                  std::to_string(std::clamp(y, 0, camera.height - 1)));
}

void Desk::choose_stage(const std::optional<StageChoice>& stage, bool by_stage) {
    choice_.by_stage = by_stage;
    choice_.stage = stage;
    trace_again();
    if (on_trace) on_trace();
}

/// At the same place of the new trace, where it has one.
void Desk::trace_again() {
    const Spot spot = walk().cursor().spot();
    converse(cli::trace_choice(*bench_, choice_));
    const auto& rays = trace().rays;
    if (std::size_t(spot.ray) >= rays.size()) return;
    const int events = int(rays[std::size_t(spot.ray)].events.size());
    (void)session_->reply("goto " + std::to_string(spot.ray) + "." +
                          std::to_string(std::min(spot.event, events - 1)));
}

void Desk::show(std::shared_ptr<const Workbench> bench) {
    // The old conversation points at the old workbench, which must live until the new one has begun.
    const auto old = std::exchange(bench_, std::move(bench));
    trace_again();
    if (old == bench_ && on_trace) on_trace();
    if (old != bench_ && on_scene) on_scene();
}

void Desk::remember(const std::string& key, bool of_ray, bool continues) {
    if (!continues || last_key_ != key || before_.empty()) before_.push_back(state(of_ray));
    if (before_.size() > most_undo(scene())) before_.erase(before_.begin());
    after_.clear();
    last_key_ = key;
}

void Desk::change(Scene scene, const std::string& key, const std::string& value, bool continues) {
    auto bench = std::make_shared<Workbench>(make_workbench(std::move(scene)));
    remember(key, false, continues);
    if (value.empty())
        edits_.erase(key);
    else
        edits_[key] = value;
    show(std::move(bench));
}

void Desk::set_material(std::size_t material, MaterialPart part, double value, bool continues) {
    Scene changed = scene();
    SceneMaterial& entry = changed.materials.at(material);
    const std::string text = set_part(entry, part, std::min(value, most_of(entry, part)));
    const std::string key = "materials." + entry.name + "." + std::string(part_names.at(std::size_t(part)));
    change(std::move(changed), key, text, continues);
}

void Desk::move_light(std::size_t light, const Vec3d& position, double pixel, bool continues) {
    Scene changed = scene();
    SceneLight& entry = changed.lights.at(light);
    if (entry.directional) return;
    entry.position = rounded(position, pixel);
    const std::string key = "lights." + entry.name + ".position", text = toml_vector(entry.position);
    change(std::move(changed), key, text, continues);
}

void Desk::move_generic(const Grip& grip, const Vec3d& middle, double pixel, bool continues) {
    Scene changed = scene();
    SceneGeneric& entry = changed.generics.at(grip.generic);
    const Vec3d opened = opened_places_.at(grip.generic);
    double scale = 0; // of the space that it stands in
    for (int i = 0; i < 3; ++i) scale = std::max(scale, length(Vec3d(grip.outer[i])));
    // From where the file has it: its author's digits stay.
    const Vec3d offset =
        rounded(Vec3d(entry.matrix[3]) + offset_to(scene(), grip, middle) - opened, pixel / scale);
    for (int i = 0; i < 3; ++i) entry.matrix[3][i] = tidy(opened[i] + offset[i]);
    const std::string key = "generics." + generic_title(scene(), grip.generic) + ".transform";
    const std::string text = offset == Vec3d{0} ? "" : "{translate = " + toml_vector(offset) + "}";
    change(std::move(changed), key, text, continues);
}

void Desk::move_ray(const Vec3d& start, const Vec3d& target, double pixel, bool continues) {
    const Vec3d from = rounded(start, pixel), way = rounded(target, pixel) - from;
    if (!(length(way) > 0)) return;
    remember("ray", true, continues);
    // Of the same length as before, so that t keeps its unit.
    choice_.ray = Ray<double>{from, normalized(way) * trace().source.given_length};
    choice_.pixel.reset();
    trace_again();
    if (on_trace) on_trace();
}

bool Desk::undo() { return go_back(before_, after_); }
bool Desk::redo() { return go_back(after_, before_); }

bool Desk::go_back(std::vector<State>& from, std::vector<State>& here) {
    if (from.empty()) return false;
    State wanted = std::move(from.back());
    from.pop_back();
    here.push_back(state(wanted.choice.has_value()));
    edits_ = std::move(wanted.edits);
    last_key_.clear();
    if (wanted.choice) {
        choice_.ray = wanted.choice->ray;
        choice_.pixel = wanted.choice->pixel;
    }
    show(std::move(wanted.bench));
    return true;
}

void Desk::save() {
    if (file_.extension() != ".toml")
        throw std::runtime_error(file_.string() + " is no TOML scene: changes can't be saved into it");
    if (content_hash(file_) != hash_)
        throw std::runtime_error(file_.string() +
                                 " was changed by another program since it was opened: not saved");
    // From the text as it was opened, with all values that differ from it; undone ones are not among them.
    if (!original_) original_ = text_of(file_);
    write_text_file(file_, with_edits(file_.string(), *original_, edits_));
    hash_ = content_hash(file_);
    saved_ = edits_;
}

} // namespace rayscope::window

#include "visualizer/window/desk.hpp"

#include "visualizer/cli/failure.hpp"
#include "visualizer/cli/scene_choice.hpp"

#include <algorithm>
#include <fstream>
#include <iterator>
#include <utility>

namespace rayscope::window {
namespace {

constexpr std::size_t most_undo = 200;

std::string text_of(const std::filesystem::path& path) {
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
}

} // namespace

Desk::Desk(cli::RayChoice choice) : choice_(std::move(choice)), style_{cli::Numbers(6), cli::Paint(false)} {
    file_ = cli::find_scene(choice_.scene);
    bench_ = std::make_shared<Workbench>(make_workbench(cli::load_with_effects(file_, choice_.effects)));
    original_ = text_ = text_of(file_);
    converse(cli::trace_choice(*bench_, choice_));
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
    file_ = file;
    original_ = text_ = text_of(file);
    edits_ = saved_ = {};
    before_.clear();
    after_.clear();
    last_key_.clear();
    session_.reset();
    bench_ = std::move(bench);
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
    cli::Reply reply = session_->reply(line);
    const TraceSource& now = trace().source;
    if (reply.command == "pixel" || reply.command == "source" || before.x != now.x || before.y != now.y ||
        before.by_hand != now.by_hand) {
        if (!now.by_hand) {
            choice_.ray.reset();
            choice_.pixel = std::pair(now.x, now.y);
        }
        if (on_trace) on_trace();
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

void Desk::pick(const Ray<double>& ray) {
    choice_.ray = ray;
    choice_.pixel.reset();
    trace_again();
    if (on_trace) on_trace();
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

void Desk::show(Scene scene) {
    // The old conversation points at the old workbench, which must live until the new one has begun.
    const auto fresh = std::make_shared<Workbench>(make_workbench(std::move(scene)));
    const auto old = std::exchange(bench_, fresh);
    trace_again();
    if (on_scene) on_scene();
}

void Desk::change(Scene scene, const std::string& key, const std::string& value, bool continues) {
    if (!continues || last_key_ != key || before_.empty()) before_.push_back({this->scene(), edits_});
    if (before_.size() > most_undo) before_.erase(before_.begin());
    after_.clear();
    last_key_ = key;
    edits_[key] = value;
    show(std::move(scene));
}

void Desk::set_material(std::size_t material, MaterialPart part, double value, bool continues) {
    Scene changed = scene();
    SceneMaterial& entry = changed.materials.at(material);
    const std::string text = set_part(entry, part, std::min(value, most_of(entry, part)));
    change(std::move(changed),
           "materials." + entry.name + "." + std::string(part_names.at(std::size_t(part))), text, continues);
}

void Desk::move_light(std::size_t light, const Vec3d& position, bool continues) {
    Scene changed = scene();
    SceneLight& entry = changed.lights.at(light);
    if (entry.directional) return;
    for (int i = 0; i < 3; ++i) entry.position[i] = std::round(position[i] * 1e4) / 1e4;
    const std::string text = toml_vector(entry.position);
    const std::string key = "lights." + entry.name + ".position";
    change(std::move(changed), key, text, continues);
}

bool Desk::undo() { return go_back(before_, after_); }
bool Desk::redo() { return go_back(after_, before_); }

bool Desk::go_back(std::vector<State>& from, std::vector<State>& here) {
    if (from.empty()) return false;
    here.push_back({scene(), edits_});
    State state = std::move(from.back());
    from.pop_back();
    edits_ = std::move(state.edits);
    last_key_.clear();
    show(std::move(state.scene));
    return true;
}

void Desk::save() {
    if (file_.extension() != ".toml")
        throw std::runtime_error(file_.string() + " is no TOML scene: changes can't be saved into it");
    if (text_of(file_) != text_)
        throw std::runtime_error(file_.string() +
                                 " was changed by another program since it was opened: not saved");
    // From the text as it was first read, with all values that differ from it; undone ones are not among them.
    std::string text = with_edits(file_.string(), original_, edits_);
    write_text_file(file_, text);
    text_ = std::move(text);
    saved_ = edits_;
}

} // namespace rayscope::window

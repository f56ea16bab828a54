#pragma once
// What lies on the desk: a scene, and the conversation about one of its rays. The terminal has the same conversation,
// so that both say the same. No window in here.

#include "visualizer/cli/session.hpp"
#include "visualizer/window/grip.hpp"
#include "visualizer/window/scene_edit.hpp"

#include <filesystem>
#include <memory>

namespace rayscope::window {

class Desk {
public:
    /// Throws InputError or cli::UsageError.
    explicit Desk(cli::RayChoice choice);

    // What views wait for. Each also means the ones after it.
    std::function<void()> on_scene; ///< another scene, or the same one with other numbers
    std::function<void()> on_trace; ///< another ray was traced
    std::function<void()> on_move;  ///< the cursor stands elsewhere

    [[nodiscard]] const std::shared_ptr<const Workbench>& bench() const { return bench_; }
    [[nodiscard]] const Scene& scene() const { return bench_->scene; }
    [[nodiscard]] const Walk& walk() const { return session_->walk(); }
    [[nodiscard]] const Trace& trace() const { return walk().trace(); }
    [[nodiscard]] int ray() const { return session_->current(); }
    [[nodiscard]] SeenEvent here() const { return walk().here(); }
    [[nodiscard]] const cli::Session& session() const { return *session_; }
    [[nodiscard]] const cli::StepStyle& style() const { return style_; }
    [[nodiscard]] const std::filesystem::path& file() const { return file_; }

    /// Another scene. Throws InputError or cli::UsageError, and then leaves the old one.
    void open(const std::string& scene);
    /// A line of the conversation; views hear of what it moved.
    cli::Reply command(const std::string& line);
    void pick(int x, int y);
    /// Find hits by a stage, which then tells where it looks; nothing: every object is tested.
    void choose_stage(const std::optional<StageChoice>& stage, bool by_stage);
    [[nodiscard]] bool by_stage() const { return choice_.by_stage; }

    // Changes. `continues`: the one before and this one are undone together.

    void set_material(std::size_t material, MaterialPart part, double value, bool continues);
    /// @param pixel the least length that counts
    void move_light(std::size_t light, const Vec3d& position, double pixel, bool continues);
    void move_generic(const Grip& grip, const Vec3d& middle, double pixel, bool continues);
    /// A ray given by hand, in place of the one that is traced.
    void move_ray(const Vec3d& start, const Vec3d& target, double pixel, bool continues);
    [[nodiscard]] bool undo(); ///< false: nothing was changed before
    [[nodiscard]] bool redo();
    [[nodiscard]] bool changed() const { return edits_ != saved_; }
    [[nodiscard]] bool can_undo() const { return !before_.empty(); }
    [[nodiscard]] bool can_redo() const { return !after_.empty(); }
    /// The file with the new values. Throws InputError or std::runtime_error, and then leaves it as it was.
    void save();

private:
    struct State {
        std::shared_ptr<const Workbench> bench;
        Edits edits;
        std::optional<cli::RayChoice> choice; ///< where it was the ray that changed after it
    };
    [[nodiscard]] State state(bool of_ray) const {
        return {bench_, edits_, of_ray ? std::optional(choice_) : std::nullopt};
    }
    void remember(const std::string& key, bool of_ray, bool continues);
    void begin(std::filesystem::path file);
    /// @param value empty: as in the file
    void change(Scene scene, const std::string& key, const std::string& value, bool continues);
    /// To the last state in one list; where it stands now goes into the other.
    bool go_back(std::vector<State>& from, std::vector<State>& here);
    void show(std::shared_ptr<const Workbench> bench);
    void converse(Trace trace);
    void trace_again();

    cli::RayChoice choice_;
    cli::StepStyle style_;
    std::filesystem::path file_;
    std::optional<std::string> original_; // text of the file, as it was opened; from the first saving on
    std::string hash_;                    // … as it was last read or saved
    std::shared_ptr<const Workbench> bench_;
    std::optional<cli::Session> session_;
    Edits edits_, saved_;
    std::vector<Vec3d> opened_places_; // of the generics, as the file has them
    std::vector<State> before_, after_;
    std::string last_key_;
};

} // namespace rayscope::window

#include "core/csg/expression.hpp"
#include "core/scene/mesh_file.hpp"
#include "core/scene/toml_sections.hpp"
#include "core/scene/wording.hpp"

#include <fmt/format.h>

namespace rayscope {
namespace {

/// `material` directly in [compounds] is no compound, but the material of those that are written as one equation.
constexpr std::string_view shared_material = "material";

class CompoundReader {
public:
    CompoundReader(SourceText& source, const NameIndex& materials, const NameIndex& generics, Scene& scene,
                   Visibility& visibility)
        : source_(source),
          materials_(materials),
          generics_(generics),
          scene_(scene),
          visibility_(visibility) {}

    void read(const TomlTable& section) {
        const auto entries = section.named_entries("a compound");
        name_all(entries);
        for (const TomlEntry& entry : entries)
            if (entry.key != shared_material)
                scene_.compounds.push_back(entry.value.is_string() ? read_equation(entry)
                                                                   : read_table(entry));
        if (const auto material = section.find(shared_material))
            share_material(named(*material, "material", materials_));
    }

private:
    // All names first: an equation may use one that is written below it.
    void name_all(const std::vector<TomlEntry>& entries) {
        for (const TomlEntry& entry : entries) {
            if (entry.key == shared_material) continue;
            if (const auto generic = generics_.find(entry.key); generic != generics_.end())
                source_.fail(entry.place,
                             fmt::format("'{}' is the name of a generic already, in line {}", entry.key,
                                         scene_.generics[generic->second].place.line));
            names_.emplace(entry.key, names_.size());
        }
        visibility_.compounds.resize(names_.size());
        visibility_.compound_operands.resize(names_.size());
        is_equation_.resize(names_.size());
    }

    SceneCompound read_equation(const TomlEntry& entry) {
        is_equation_[scene_.compounds.size()] = true;
        return begin(entry, entry.value);
    }

    SceneCompound read_table(const TomlEntry& entry) {
        const TomlTable table = entry.value.table();
        table.allow_only("a compound", {"is", "material", "transform", "priority", "visible"});
        SceneCompound compound = begin(entry, table.require("is", entry.place, "is = \"outer - inner\""));
        if (const auto material = table.find("material"))
            compound.material = named(*material, "material", materials_);
        if (const auto transform = table.find("transform")) compound.matrix = read_transform(*transform);
        if (const auto priority = table.find("priority"))
            compound.priority = priority->integer(-largest_priority, largest_priority);
        if (const auto visible = table.find("visible"))
            visibility_.compounds[scene_.compounds.size()] = visible->boolean();
        return compound;
    }

    SceneCompound begin(const TomlEntry& entry, const TomlValue& expression) {
        SceneCompound compound;
        compound.name = entry.key;
        compound.place = entry.place;
        compound.expression = expression.string();
        const std::vector<Place> places = source_.places_in_string(expression.place(), compound.expression);
        try {
            for (const ExpressionNode& node : parse_expression(compound.expression))
                compound.nodes.push_back(resolved(node, places[node.offset]));
        } catch (const ExpressionError& error) {
            source_.fail(places[error.offset], error.what());
        }
        return compound;
    }

    SceneNode resolved(const ExpressionNode& node, Place place) {
        SceneNode result{node.operation, node.left, node.right, false, 0, place};
        if (node.operation != Operation::leaf) return result;
        if (const auto generic = generics_.find(node.name); generic != generics_.end()) {
            const auto& shape = scene_.generics[generic->second].shape;
            if (const auto* mesh = std::get_if<Mesh<double>>(&shape); mesh != nullptr && !mesh->solid)
                source_.fail(place, fmt::format("'{}' {}; only a closed mesh can be an operand", node.name,
                                                hole_text(mesh->triangles())));
            if (!is_solid(shape))
                source_.fail(place, fmt::format("'{}' is a {}: a surface without volume can't be an operand",
                                                node.name, generic_name(shape)));
            result.operand = generic->second;
            visibility_.generic_operands[result.operand] = true;
        } else if (const auto compound = names_.find(node.name); compound != names_.end()) {
            result.is_compound = true;
            result.operand = compound->second;
            visibility_.compound_operands[result.operand] = true;
        } else {
            fail_unknown(node.name, place);
        }
        return result;
    }

    [[noreturn]] void fail_unknown(std::string_view name, Place place) const {
        std::vector<std::string_view> known;
        known.reserve(generics_.size() + names_.size());
        for (const NameIndex* index : {&generics_, &names_})
            for (const auto& entry : *index) known.push_back(entry.first);
        source_.fail(place, fmt::format("unknown solid {}{}", in_quotes(name), did_you_mean(name, known)));
    }

    // What is only an operand keeps none: it would give its walls the light of another material.
    void share_material(std::size_t material) {
        for (std::size_t i = 0; i < scene_.compounds.size(); ++i)
            if (is_equation_[i] && !visibility_.compound_operands[i]) scene_.compounds[i].material = material;
    }

    SourceText& source_;
    const NameIndex& materials_;
    const NameIndex& generics_;
    Scene& scene_;
    Visibility& visibility_;
    NameIndex names_;
    std::vector<bool> is_equation_;
};

} // namespace

void read_compounds(SourceText& source, const TomlTable& root, const NameIndex& materials,
                    const NameIndex& generics, Scene& scene, Visibility& visibility) {
    if (const auto section = root.find("compounds"))
        CompoundReader(source, materials, generics, scene, visibility).read(section->table());
}

} // namespace rayscope

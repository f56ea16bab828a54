#pragma once
// What `rayscope explain` says.

#include "visualizer/cli/numbers.hpp"
#include "visualizer/cli/page.hpp"

namespace rayscope::cli {

/// Which effects are simulated and why, which are not and why not, and the limits.
void add_effects(Page& page, const Workbench& bench);

/// What an image of the scene took: rays of each kind, and the stage that found the hits.
void add_rays(Page& page, const RenderResult& result);

/// What each effect costs and changes.
void add_costs(Page& page, const EffectCosts& costs);

/// Where light comes from, and what was dropped.
/// @param name of an object in the ledger
/// @param weighed what the dropped weights are shares of
void add_ledger(Page& page, const Ledger& ledger, const std::string& weighed,
                const std::function<std::string(Id)>& name, const Numbers& number);

/// What effects that are off would bring of light, or take from it, each by itself. Nothing where none is.
void add_light_off(Page& page, const std::vector<std::pair<Effect, Colour>>& off, const Numbers& number);

} // namespace rayscope::cli

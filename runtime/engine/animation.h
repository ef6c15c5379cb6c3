// How keyframes show: what drawing and the setters of the component need. The time goes on in Engine::step.
#pragma once

#include <string>
#include <vector>

#include "engine/engine.h"

namespace tumble {

// Where a node's clip is read from: the animation's own file, or the mesh's; the node has an animation.
const std::string& animation_file(const SceneNode& node);
// Where the nodes of the model that `node` shows are to be drawn; empty where its animation has no clip.
std::vector<ModelPlace> animated_places(const Engine& engine, NodeId node, const Model& model, double alpha);
// After a write to the component that was `before`: another clip begins at its start, a backward one at its end, unless
// the write set the time too.
void restart_clip(const Engine& engine, SceneNode& node, const Animation& before);

}  // namespace tumble

// Clips of keyframes: their time goes on before each step, and child nodes that bear the name of a node in the file go
// along, as if a script had moved them. The parts of the node's own mesh are moved only where they are drawn.

#include <algorithm>
#include <cmath>

#include "base/text.h"
#include "engine/animation.h"
#include "engine/engine_private.h"

namespace tumble {

namespace {

constexpr double kSmallestScale = 1e-6;  // a node's scale is above 0, whatever a file says

// Does the clip end where it begins, for this track? Then a body need not jump there.
bool is_closed(const ModelTrack& track, double seconds) {
  ModelPose first, last;
  sample(track, 0, first);
  sample(track, seconds, last);
  return distance(first.position, last.position) < 1e-3 && distance(first.scale, last.scale) < 1e-3 &&
         std::abs(dot(first.rotation, last.rotation)) > 1 - 1e-6;
}

double into_clip(double time, double seconds) {
  if (seconds <= 0) return 0;
  const double rest = std::fmod(time, seconds);
  return rest < 0 ? rest + seconds : rest;
}

std::vector<std::string> clip_names(const Model& model) {
  std::vector<std::string> names;
  for (const ModelClip& clip : model.clips) names.push_back(clip.name);
  return names;
}

}  // namespace

const std::string& animation_file(const SceneNode& node) {
  static const std::string none;
  if (!node.animation->file.empty()) return node.animation->file;
  return node.mesh ? node.mesh->file : none;
}

void Engine::list_animation(NodeId node) {
  if (scene[node].animation) private_->animations.try_emplace(node);
}

void Engine::animate(double seconds) {
  auto& animations = private_->animations;
  std::erase_if(animations, [this](const auto& entry) { return !alive(entry.first) || !scene[entry.first].animation; });
  for (const auto& [node, playing] : animations)
    if (scene.enabled_in_tree(node)) advance_animation(node, seconds);
}

void Engine::advance_animation(NodeId id, double seconds) {
  Animation& animation = *scene[id].animation;
  const std::string& file = animation_file(scene[id]);
  const Model* model = assets && !file.empty() ? assets->model(file) : nullptr;
  if (!model) return;
  const ModelClip* clip = find_clip(*model, animation.clip);
  const auto say = [&](const std::string& text) {
    if (private_->said.insert(text).second) warn(text);
  };
  if (!clip)
    return say("node '" + scene.path(id) + "': animation.clip: no clip '" + animation.clip + "' in '" + file + "'" +
               did_you_mean(animation.clip, clip_names(*model)) + (model->clips.empty() ? "; it has none" : "; it has " + join(clip_names(*model))));

  Private::Playing& playing = private_->animations[id];
  if (playing.clip != clip->name) playing = {clip->name};
  if (!animation.playing && playing.applied == animation.time) return;
  playing.from = animation.time;
  playing.to = animation.time + (animation.playing ? animation.speed * seconds : 0);
  playing.tick = tick;
  bool around = false;
  if (animation.loop) {
    animation.time = into_clip(playing.to, clip->seconds);
    around = animation.playing && std::abs(animation.time - playing.to) > 1e-9;
  } else {
    animation.time = playing.to = std::clamp(playing.to, 0.0, clip->seconds);
    const bool over = animation.speed < 0 ? animation.time <= 0 : animation.time >= clip->seconds;
    if (animation.playing && animation.speed != 0 && over) {
      animation.playing = false;
      private_->animation_ends.push_back({id, clip->name});
    }
  }
  const bool first = !(playing.applied == playing.from);
  playing.applied = animation.time;
  move_animated(id, *model, *clip, animation.time, first || around);
}

// A jump shows nothing in between and carries nothing; where the clip ends as it begins, going around is none.
void Engine::move_animated(NodeId id, const Model& model, const ModelClip& clip, double time, bool jump) {
  scene.each(id, [&](NodeId below, SceneNode& node) {
    if (below == id || node.name.empty()) return;
    ModelPose pose{node.local.position, node.local.rotation, node.local.scale};
    bool found = false, jumps = false;
    for (const ModelTrack& track : clip.tracks) {
      if (model.nodes[static_cast<std::size_t>(track.node)].name != node.name) continue;
      sample(track, time, pose);
      jumps |= jump && !is_closed(track, clip.seconds);
      found = true;
    }
    if (!found) return;
    const BodyComponent* component = body(below);
    if (component && component->def.type == BodyType::dynamic) {
      const std::string text = "node '" + scene.path(below) + "': its dynamic body is not moved by the animation of '" + scene.path(id) +
                               "'; with body = \"kinematic\" it is";
      if (private_->said.insert(text).second) warn(text);
      return;
    }
    const auto above = [](double scale) { return std::max(scale, kSmallestScale); };
    const Transform local{pose.position, normalized(pose.rotation), {above(pose.scale.x), above(pose.scale.y), above(pose.scale.z)}};
    if (jumps) scene.jump(below, local);
    else scene.set_local(below, local);
  });
}

double Engine::animation_time(NodeId node, double alpha) const {
  const Animation& animation = *scene[node].animation;
  const auto found = private_->animations.find(node);
  if (found == private_->animations.end() || found->second.tick != tick || found->second.applied != animation.time || alpha >= 1) return animation.time;
  return found->second.from + (found->second.to - found->second.from) * alpha;
}

std::vector<ModelPlace> animated_places(const Engine& engine, NodeId id, const Model& model, double alpha) {
  const SceneNode& node = engine.scene[id];
  const Model* source = engine.assets->model(animation_file(node));
  const ModelClip* clip = source ? find_clip(*source, node.animation->clip) : nullptr;
  if (!clip) return {};
  const double time = engine.animation_time(id, alpha);
  return places(model, *source, *clip, node.animation->loop && time != clip->seconds ? into_clip(time, clip->seconds) : time);
}

void restart_clip(const Engine& engine, SceneNode& node, const Animation& before) {
  Animation& animation = *node.animation;
  if ((animation.clip == before.clip && animation.file == before.file) || animation.time != before.time) return;
  const std::string& file = animation_file(node);
  const Model* model = engine.assets && !file.empty() ? engine.assets->model(file) : nullptr;
  const ModelClip* clip = model ? find_clip(*model, animation.clip) : nullptr;
  animation.time = animation.speed < 0 && clip ? clip->seconds : 0;
}

std::vector<AnimationEnd> Engine::take_animation_ends() { return std::exchange(private_->animation_ends, {}); }

}  // namespace tumble

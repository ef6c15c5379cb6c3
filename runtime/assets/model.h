// A model from a glTF file, as plain data: parts to draw, the nodes they hang on, clips of keyframes.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "assets/image.h"
#include "assets/mesh.h"
#include "base/color.h"
#include "base/math.h"

namespace tumble {

struct ModelMaterial {
  Color color{1, 1, 1, 1};      // sRGB
  double roughness = 0.7, metalness = 0;
  Color glow{0, 0, 0, 1};       // light of its own, sRGB; above 1 where the file says so
  int image = -1;               // of Model::images, tinted by the color; its alpha is 255 where the file wants it opaque
  bool two_sided = false;
};

// Where a node is against its parent, or a part of it in a clip.
struct ModelPose {
  Vec3 position;
  Quat rotation;
  Vec3 scale{1, 1, 1};          // of any sign in a file
};

// The same as axes and origin, which can also hold what scales above a turned node make of it.
struct ModelPlace {
  Vec3 x{1, 0, 0}, y{0, 1, 0}, z{0, 0, 1}, position;
  Vec3 direction(Vec3 v) const { return x * v.x + y * v.y + z * v.z; }
  Vec3 point(Vec3 p) const { return position + direction(p); }
};
ModelPlace operator*(const ModelPlace& parent, const ModelPlace& child);
ModelPlace to_place(const ModelPose& pose);

struct ModelNode {
  std::string name;
  int parent = -1;              // parents come before their children
  ModelPose rest;
  ModelPlace place;             // at rest, in the model's space
};

// One material's triangles, in the space of their node.
struct ModelPart {
  Mesh mesh;
  int node = 0, material = 0;
};

// What one node's position, rotation or scale does in a clip. `values` holds 3 or 4 numbers a key; of cubic tracks the
// in-tangent, value and out-tangent in turn.
struct ModelTrack {
  enum class Target { position, rotation, scale } target = Target::position;
  enum class Ease { linear, step, cubic } ease = Ease::linear;
  int node = 0;
  std::vector<double> times, values;  // s, rising
};
struct ModelClip {
  std::string name;
  double seconds = 0;
  std::vector<ModelTrack> tracks;
};

struct Model {
  std::vector<ModelNode> nodes;
  std::vector<ModelPart> parts;
  std::vector<ModelMaterial> materials;   // never empty
  std::vector<Image> images;
  std::vector<ModelClip> clips;
  Vec3 low, high;                         // the box around all parts at rest
  std::vector<std::string> notes;         // what the file holds and we do not draw, a sentence each
};

// ---- clips

// The clip of that name, the first for "", or nullptr.
const ModelClip* find_clip(const Model& model, std::string_view name);
// Writes what the track says at that time (s into the clip; held before the first key and after the last).
void sample(const ModelTrack& track, double time, ModelPose& pose);
// Where each node of `model` is at that time of a clip of `source`, whose nodes are found by their names; both may be
// the same model.
std::vector<ModelPlace> places(const Model& model, const Model& source, const ModelClip& clip, double time);

// ---- as points, for colliders

// The corners of all triangles at rest, three each.
std::vector<Vec3> triangles_of(const Model& model);
// Rolling ground 1 m wide, deep and high, centred, as high as the picture is bright.
constexpr int kLargestHeightField = 513;  // pixels a side: half a million triangles
Model height_field_of(const Image& picture, const std::string& name);

}  // namespace tumble

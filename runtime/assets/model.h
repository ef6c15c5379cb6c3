// A model from a glTF file, as plain data: parts to draw, the nodes they hang on, clips of keyframes.
#pragma once

#include <array>
#include <memory>
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
  Color glow{0, 0, 0, 1};       // light of its own, sRGB
  int image = -1;               // of Model::images, tinted by the color
  bool two_sided = false;
};

struct ModelNode {
  std::string name;
  int parent = -1;              // parents come before their children
  Vec3 position;
  Quat rotation;
  Vec3 scale{1, 1, 1};
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
};

}  // namespace tumble

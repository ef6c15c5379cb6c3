// Materials and pictures of a glTF file.
#pragma once

#include "assets/gltf_file.h"
#include "assets/model.h"

namespace tumble {

// One for each of the file's and a plain one behind them, with the pictures that they draw. A picture that is missing or
// broken is a note and pink.
void add_materials(GltfFile& file, Model& model);
// Which set of texture coordinates a material's picture goes by.
int uv_set(const tinygltf::Model& records, int material);

}  // namespace tumble

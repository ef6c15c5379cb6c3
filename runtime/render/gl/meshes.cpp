#include "render/gl/meshes.h"

#include <cstddef>

#include "assets/mesh.h"

namespace tumble {
namespace {

// Shapes that change their size every tick would otherwise pile up.
constexpr std::uint64_t kKeptPictures = 600;

const void* at(std::size_t offset) { return reinterpret_cast<const void*>(offset); }

}  // namespace

GpuMeshes::GpuMeshes(const Gl& gl) : gl_(gl) { gl_.GenBuffers(1, &instances_); }

GpuMeshes::~GpuMeshes() {
  for (const auto& [key, mesh] : meshes_) remove(mesh);
  gl_.DeleteBuffers(1, &instances_);
}

void GpuMeshes::remove(const GpuMesh& mesh) {
  const GLuint buffers[] = {mesh.vertices, mesh.triangles};
  gl_.DeleteBuffers(2, buffers);
  gl_.DeleteVertexArrays(1, &mesh.array);
}

void GpuMeshes::begin_picture() {
  ++picture_;
  std::erase_if(meshes_, [&](const auto& entry) {
    const bool old = entry.second.last_drawn + kKeptPictures < picture_;
    if (old) remove(entry.second);
    return old;
  });
}

void GpuMeshes::upload(const Batches& batches) {
  gl_.BindBuffer(GL_ARRAY_BUFFER, instances_);
  gl_.BufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(batches.instances.size() * sizeof(Instance)),
                 batches.instances.data(), GL_STREAM_DRAW);
}

void GpuMeshes::draw(const DrawList& list, const Batch& batch) {
  const GpuMesh& mesh = find(list, list.shapes[batch.shape], batch.coarseness);
  gl_.BindVertexArray(mesh.array);
  point_at_instances(batch.first);
  gl_.DrawElementsInstanced(GL_TRIANGLES, mesh.indices, GL_UNSIGNED_INT, nullptr, static_cast<GLsizei>(batch.count));
  gl_.BindVertexArray(0);
}

const GpuMeshes::GpuMesh& GpuMeshes::find(const DrawList& list, const DrawShape& shape, int coarseness) {
  const auto [place, is_new] = meshes_.try_emplace(geometry_key(list, shape, coarseness));
  GpuMesh& gpu = place->second;
  gpu.last_drawn = picture_;
  if (!is_new) return gpu;

  const Mesh mesh = mesh_of(list, shape, coarseness);
  gpu.indices = static_cast<GLsizei>(mesh.triangles.size());
  gl_.GenVertexArrays(1, &gpu.array);
  gl_.GenBuffers(1, &gpu.vertices);
  gl_.GenBuffers(1, &gpu.triangles);
  gl_.BindVertexArray(gpu.array);
  gl_.BindBuffer(GL_ARRAY_BUFFER, gpu.vertices);
  gl_.BufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(mesh.vertices.size() * sizeof(Vertex)), mesh.vertices.data(),
                 GL_STATIC_DRAW);
  gl_.BindBuffer(GL_ELEMENT_ARRAY_BUFFER, gpu.triangles);
  gl_.BufferData(GL_ELEMENT_ARRAY_BUFFER, static_cast<GLsizeiptr>(mesh.triangles.size() * sizeof(std::uint32_t)),
                 mesh.triangles.data(), GL_STATIC_DRAW);
  const auto read = [&](GLuint location, GLint count, std::size_t offset) {
    gl_.EnableVertexAttribArray(location);
    gl_.VertexAttribPointer(location, count, GL_FLOAT, GL_FALSE, sizeof(Vertex), at(offset));
  };
  read(0, 3, offsetof(Vertex, position));
  read(1, 3, offsetof(Vertex, normal));
  read(8, 2, offsetof(Vertex, uv));
  return gpu;
}

// Neither OpenGL 3.3 nor ES 3.0 can draw from a first instance on, so the array itself moves.
void GpuMeshes::point_at_instances(std::uint32_t first) {
  gl_.BindBuffer(GL_ARRAY_BUFFER, instances_);
  for (GLuint i = 0; i < sizeof(Instance) / (4 * sizeof(float)); ++i) {
    gl_.EnableVertexAttribArray(2 + i);
    gl_.VertexAttribPointer(2 + i, 4, GL_FLOAT, GL_FALSE, sizeof(Instance),
                            at(first * sizeof(Instance) + i * 4 * sizeof(float)));
    gl_.VertexAttribDivisor(2 + i, 1);
  }
}

}  // namespace tumble
